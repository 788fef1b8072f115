// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/typed_quantity.h"

#include <QList>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"

namespace drillwave {
namespace {

constexpr int deepestBrackets = 8;

struct Word {
    const char16_t* written;
    std::string_view unit;
};

// In the plural, which stands for the singular too.
constexpr Word unitWords[] = {
    {u"'", "ft"},
    {u"′", "ft"},
    {u"’", "ft"},
    {u"foots", "ft"},
    {u"\"", "in"},
    {u"″", "in"},
    {u"”", "in"},
    {u"''", "in"},
    {u"inches", "in"},
    {u"inchs", "in"},
    {u"metres", "m"},
    {u"meters", "m"},
    {u"millimetres", "mm"},
    {u"millimeters", "mm"},
    {u"centimetres", "cm"},
    {u"centimeters", "cm"},
    {u"microns", "um"},
    {u"newtons", "N"},
    {u"kilonewtons", "kN"},
    {u"meganewtons", "MN"},
    {u"seconds", "s"},
    {u"secs", "s"},
    {u"milliseconds", "ms"},
    {u"msecs", "ms"},
    {u"microseconds", "us"},
    {u"hertzs", "Hz"},
    {u"joules", "J"},
    {u"kilojoules", "kJ"},
    {u"watts", "W"},
    {u"kilowatts", "kW"},
    {u"megapascals", "MPa"},
    {u"gigapascals", "GPa"},
    {u"degrees", "deg"},
    {u"kilograms", "kg"},
    {u"kgs", "kg"},
    {u"tonnes", "t"},
};

const Unit* unitOfWord(const QString& spelling, Quantity quantity) {
    const QString word = spelling.toLower();
    for (const Word& known : unitWords) {
        const QString written = QString::fromUtf16(known.written);
        if (word == written || word + u's' == written) return findUnit(quantity, known.unit);
    }
    return nullptr;
}

// Capitals and small letters alike, but for an M that would be read into an m: mega is no milli.
const Unit* unitInOtherCase(const QString& spelling, Quantity quantity) {
    const Unit* found = nullptr;
    for (const Unit& unit : unitsOf(quantity)) {
        const QString name = fromView(unit.name);
        if (name.compare(spelling, Qt::CaseInsensitive) != 0) continue;
        if (found || (name.startsWith(u'M') && spelling.startsWith(u'm'))) return nullptr;
        found = &unit;
    }
    return found;
}

// "5' 6 1/2\"" and "1 1/2 in", whose blank is a plus, as sums. So is the hyphen of "12'-3\"", which touches
// both; any other, as in "12 ft - 3 in", is a minus.
QString withSumsWrittenOut(QString text) {
    static const QString part = QStringLiteral(R"((?:\d+\s+\d+/\d+|\d+/\d+|\d+(?:[.,]\d+)?))");
    static const QRegularExpression feetAndInches(
        QStringLiteral(R"(^(\d+)(?:['′’]-|\s*(?:'|′|’|ft|feet)\s*)(%1)\s*(?:"|″|”|''|in|inch|inches)$)")
            .arg(part),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression mixed(QStringLiteral(R"((?<![\d/.,])(\d+)\s+(\d{1,2}/\d{1,3}))"));
    if (const auto match = feetAndInches.match(text); match.hasMatch())
        text = QStringLiteral("(%1*12 + %2) in").arg(match.captured(1), match.captured(2));
    return text.replace(mixed, QStringLiteral("(\\1+\\2)"));
}

// Value and unit of one summand; the unit empty where it has none.
struct Summand {
    double value = 0;
    QString unit;
};

// Reads by recursion, as deep as there are brackets. After a problem nothing counts any more.
class Arithmetic {
  public:
    Arithmetic(QStringView text, const QLocale& locale) : m_text(text), m_locale(locale) {}

    QString problem;

    QList<Summand> summands() {
        QList<Summand> read;
        do {
            const double sign = takeSign();
            const double value = sign * product();
            read.append({value, unit()});
        } while (problem.isEmpty() && m_at < m_text.size());
        return read;
    }

  private:
    QChar next() {
        while (m_at < m_text.size() && m_text[m_at].isSpace()) ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : QChar();
    }
    bool take(QStringView anyOf) {
        const QChar c = next();
        if (c.isNull() || !anyOf.contains(c)) return false;
        ++m_at;
        return true;
    }
    double takeSign() {
        const bool negative = next() == u'-';
        if (!negative) take(u"+");
        return negative && take(u"-") ? -1 : 1;
    }
    double fail(const QString& reason) {
        if (problem.isEmpty()) problem = reason;
        return 0;
    }
    // Up to the sign of the next summand, or the end.
    QString unit() {
        next();
        const qsizetype begin = m_at;
        while (m_at < m_text.size() && m_text[m_at] != u'+' && m_text[m_at] != u'-') ++m_at;
        return m_text.mid(begin, m_at - begin).trimmed().toString();
    }
    double product() {
        double value = factor();
        while (problem.isEmpty()) {
            if (take(u"*×·"))
                value *= factor();
            else if (take(u"/÷"))
                value = quotient(value, factor());
            else
                break;
        }
        return value;
    }
    double quotient(double value, double divisor) {
        return divisor == 0 ? fail(drillwave::tr("divides by zero")) : value / divisor;
    }
    double factor() {
        if (take(u"(")) return bracket();
        next();
        const LeadingNumber number = leadingNumber(m_text.mid(m_at), m_locale);
        m_at += number.length;
        if (!number.problem.isEmpty()) return fail(number.problem);
        const std::optional<double> value = parseNumber(number.text.toStdString());
        return value ? *value : fail(drillwave::tr("has no number where one is needed"));
    }
    double bracket() {
        if (++m_depth > deepestBrackets) return fail(drillwave::tr("has too many brackets in each other"));
        double value = takeSign() * product();
        while (problem.isEmpty() && (next() == u'+' || next() == u'-')) {
            const double sign = takeSign();
            value += sign * product();
        }
        --m_depth;
        if (!take(u")")) fail(drillwave::tr("lacks a closing bracket; a unit follows it"));
        return value;
    }

    QStringView m_text;
    const QLocale& m_locale;
    qsizetype m_at = 0;
    int m_depth = 0;
};

TypedQuantity refused(const QString& problem) {
    return {0, nullptr, problem.toStdString()};
}

TypedQuantity quantityOf(double value, const QString& unit, Quantity quantity, const Unit& defaultUnit) {
    if (!std::isfinite(value)) return refused(drillwave::tr("is too large"));
    const Unit* known = typedUnit(unit, quantity);
    const std::string name = known ? std::string(known->name) : unit.toStdString();
    return parseQuantity(formatNumber(value) + " " + name, quantity, BareNumber::inDefaultUnit, &defaultUnit);
}

// Numbers of one unit are summed before they are converted: 3 + 0.66 m is 3.66 m to the last digit.
TypedQuantity sum(QList<Summand> summands, Quantity quantity, const Unit& defaultUnit) {
    const QString unit = summands.last().unit;
    for (Summand& each : summands)
        if (each.unit.isEmpty()) each.unit = unit;
    const bool oneUnit = std::ranges::all_of(summands, [&](const Summand& s) { return s.unit == unit; });
    if (oneUnit) {
        double value = 0;
        for (const Summand& each : summands) value += each.value;
        return quantityOf(value, unit, quantity, defaultUnit);
    }
    TypedQuantity total;
    for (const Summand& each : summands) {
        const TypedQuantity read = quantityOf(each.value, each.unit, quantity, defaultUnit);
        if (!read.valid()) return read;
        total.si += read.si;
        total.unit = read.unit;
    }
    return total;
}

/// "0.002 1/m": the unit at the end whose name begins with a digit, which no number before it is to swallow.
const Unit* reciprocalUnit(const QString& text, Quantity quantity) {
    for (const Unit& unit : unitsOf(quantity)) {
        const QString name = fromView(unit.name);
        const qsizetype before = text.size() - name.size() - 1;
        if (name.startsWith(u'1') && before > 0 && text.endsWith(name) && text[before].isSpace())
            return &unit;
    }
    return nullptr;
}

}  // namespace

const Unit* typedUnit(const QString& spelling, Quantity quantity) {
    if (const Unit* unit = findUnit(quantity, spelling.toStdString())) return unit;
    const Unit* unit = unitOfWord(spelling, quantity);
    return unit ? unit : unitInOtherCase(spelling, quantity);
}

TypedQuantity typedQuantity(const QString& typed, Quantity quantity, const Unit& defaultUnit,
                            const QLocale& locale) {
    const QString whole = withoutInvisible(typed).trimmed();
    if (const Unit* unit = reciprocalUnit(whole, quantity)) {
        TypedQuantity read =
            typedQuantity(whole.chopped(qsizetype(unit->name.size())), quantity, *unit, locale);
        if (read.valid()) read.unit = unit;
        return read;
    }
    const PlainText plain = plainText(typed, locale);
    const TypedQuantity simple =
        plain.problem.isEmpty()
            ? parseQuantity(plain.text.toStdString(), quantity, BareNumber::inDefaultUnit, &defaultUnit)
            : refused(plain.problem);
    if (simple.valid()) return simple;
    QString text = whole;
    const bool hasDigit = std::ranges::any_of(text, [](QChar c) { return c.isDigit(); });
    if (!hasDigit || text.size() > longestArithmetic || text.contains(u'\n')) return simple;
    text = withSumsWrittenOut(text).replace(u'−', u'-');
    Arithmetic arithmetic(text, locale);
    const QList<Summand> summands = arithmetic.summands();
    static const QRegularExpression operators(QStringLiteral(R"([*×/÷(]|\d\s*[+-])"));
    const TypedQuantity result =
        arithmetic.problem.isEmpty() ? sum(summands, quantity, defaultUnit) : refused(arithmetic.problem);
    // Of one number with a wrong unit the plain reading has said what is wrong.
    return result.valid() || text.contains(operators) ? result : simple;
}

}  // namespace drillwave
