// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/typed_text.h"

#include <QList>
#include <algorithm>

#include "core/text/handy_text.h"
#include "core/text/printed_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {

namespace {

// Digits of a mantissa in runs, and the sign that stands before each run but the first.
struct Mantissa {
    QStringList runs;
    QString separators;
    qsizetype length = 0;  // characters read

    bool separatedOnlyBy(QChar separator) const { return separators.count(separator) == separators.size(); }
    // Runs from the second up to `end` as groups of thousands.
    bool isGrouped(qsizetype end) const {
        if (runs.first().isEmpty() || runs.first().size() > 3) return false;
        for (qsizetype i = 1; i < end; ++i)
            if (runs[i].size() != 3) return false;
        return true;
    }
    QString joined(qsizetype end) const { return runs.first(end).join(QString()); }
};

// Blanks of any width, and the apostrophes of Switzerland, group digits everywhere. Tabs and line breaks do
// not: they stand between two numbers.
bool isNeutralGroup(QChar c) {
    return c.category() == QChar::Separator_Space || c == u'\'' || c == u'’';
}

bool holdsSeveralLines(const QString& text) {
    return std::ranges::any_of(text, [](QChar c) {
        return c == u'\n' || c == u'\r' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator;
    });
}

Mantissa readMantissa(QStringView text) {
    Mantissa read;
    read.runs.append(QString());
    while (read.length < text.size()) {
        const QChar c = text[read.length];
        const bool beforeDigit = read.length + 1 < text.size() && text[read.length + 1].isDigit();
        if (c.isDigit()) {
            read.runs.last().append(QChar(u'0' + c.digitValue()));
        } else if (c == u'.' || c == u',' ||
                   (isNeutralGroup(c) && beforeDigit && !read.runs.last().isEmpty())) {
            read.separators.append(isNeutralGroup(c) ? QChar(u' ') : c);
            read.runs.append(QString());
        } else {
            break;
        }
        ++read.length;
    }
    return read;
}

QString ambiguous(const Mantissa& number, const QLocale& locale) {
    const QString decimals = number.runs[0] + locale.decimalPoint() + number.runs[1];
    return tr("can mean %1 or %2: write it without the separator, or as %3")
        .arg(decimals, number.joined(2), decimals + QLatin1Char('0'));
}

// The mantissa with a point as its only separator; empty with a problem where it is not a number.
QString plainMantissa(const Mantissa& number, const QLocale& locale, QString& problem) {
    const qsizetype last = number.runs.size() - 1;
    if (last == 0) return number.runs[0];
    const QChar decimal = number.separators.back();
    const bool once = number.separators.count(decimal) == 1;
    const bool decimalSign = decimal != u' ' && once;
    if (!decimalSign) {
        if (number.separatedOnlyBy(decimal) && number.isGrouped(last + 1)) return number.joined(last + 1);
    } else if (last == 1) {
        const bool couldGroup =
            decimal != locale.decimalPoint() && number.isGrouped(2) && !number.runs[0].startsWith(u'0');
        if (!couldGroup) return number.runs[0] + u'.' + number.runs[1];
        problem = ambiguous(number, locale);
        return {};
    } else if (number.isGrouped(last) && number.separators.count(number.separators.front()) == last - 1) {
        return number.joined(last) + u'.' + number.runs[last];
    }
    problem = tr("is not one number: remove the separators of its digits");
    return {};
}

// "e-6" at the beginning of the text, empty if there is none.
QString exponentOf(QStringView text) {
    if (text.isEmpty() || text[0].toLower() != u'e') return {};
    qsizetype end = 1;
    const bool hasSign = text.size() > 1 && (text[1] == u'-' || text[1] == u'+' || text[1] == u'−');
    if (hasSign) ++end;
    const qsizetype digits = end;
    while (end < text.size() && text[end].isDigit()) ++end;
    return end == digits ? QString() : text.first(end).toString();
}

constexpr qsizetype exactTextLength = 10;  // longer ones are rounded for display
constexpr int displayDigits = 6;

}  // namespace

QString withoutInvisible(QString text) {
    return text.removeIf([](QChar c) { return c.category() == QChar::Other_Format; });
}

LeadingNumber leadingNumber(QStringView text, const QLocale& locale) {
    const Mantissa mantissa = readMantissa(text);
    LeadingNumber number;
    number.text = plainMantissa(mantissa, locale, number.problem);
    const QString exponent = exponentOf(text.mid(mantissa.length));
    number.text += exponent;
    number.length = mantissa.length + exponent.size();
    return number;
}

PlainText plainText(const QString& typed, const QLocale& locale) {
    QString text = withoutInvisible(typed).trimmed();
    if (holdsSeveralLines(text)) return {{}, tr("has more than one line: give one value")};
    text.replace(u'−', u'-');
    const bool hasSign = text.startsWith(u'-') || text.startsWith(u'+');
    const QString sign = hasSign ? text.left(1) : QString();
    const QStringView unsignedText = QStringView(text).mid(sign.size());
    const LeadingNumber number = leadingNumber(unsignedText, locale);
    PlainText plain;
    plain.problem = number.problem;
    if (!plain.problem.isEmpty()) return plain;
    const QStringView unit = unsignedText.mid(number.length).trimmed();
    plain.text = sign + number.text;
    if (!unit.isEmpty())
        plain.text += (plain.text.isEmpty() ? QString() : QStringLiteral(" ")) + unit.toString();
    return plain;
}

QString localText(const QString& plain, const QLocale& locale) {
    return QString(plain).replace(u'.', locale.decimalPoint());
}

QString shownUnitName(std::string_view name) {
    return QString::fromStdString(printedUnit(name));
}

QString fieldText(double si, Quantity quantity, const Unit& unit, const QLocale& locale) {
    const QString exact = QString::fromStdString(formatQuantity(si, quantity, unit));
    const qsizetype end = exact.indexOf(u' ');
    const QString number = end < 0 ? exact : exact.left(end);
    const bool inThisUnit = unit.name.empty() || exact.mid(end + 1).toStdString() == unit.name;
    const bool readable = inThisUnit && number.size() <= exactTextLength;
    return localText(readable ? number : QString::fromStdString(rounded(unit.fromSi(si), displayDigits)),
                     locale);
}

}  // namespace drillwave
