// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/svg_text.h"

#include <algorithm>

#include "core/text/name_text.h"

namespace drillwave {
namespace {

enum class Level { line, below, above };

struct Sign {
    char16_t written;
    char16_t plain;
    Level level;
};

constexpr Sign signs[] = {
    {u'ₙ', u'n', Level::below}, {u'ₚ', u'p', Level::below}, {u'₊', u'+', Level::below},
    {u'₋', u'−', Level::below}, {u'⁰', u'0', Level::above}, {u'¹', u'1', Level::above},
    {u'²', u'2', Level::above}, {u'³', u'3', Level::above}, {u'⁺', u'+', Level::above},
    {u'⁻', u'−', Level::above}, {u'ⁿ', u'n', Level::above},
};

struct Letter {
    QChar plain;
    Level level = Level::line;
};

Letter letterOf(QChar c) {
    const char16_t code = c.unicode();
    if (code >= u'₀' && code <= u'₉') return {QChar(u'0' + (code - u'₀')), Level::below};
    if (code >= u'⁴' && code <= u'⁹') return {QChar(u'4' + (code - u'⁴')), Level::above};
    for (const Sign& sign : signs)
        if (code == sign.written) return {QChar(sign.plain), sign.level};
    return {c, Level::line};
}

// These are in every font.
bool isCommon(QChar c) {
    return c == u'¹' || c == u'²' || c == u'³';
}

// Shifts [em], of small letters and of what follows them on the line.
constexpr double size = 0.7;
double shift(Level level) {
    return level == Level::below ? 0.25 : -0.5;
}

QString element(double dy, const QString& attributes, const QString& text) {
    return QStringLiteral("<tspan dy=\"%1em\"%2>%3</tspan>")
        .arg(QString::number(dy, 'g', 4), attributes, text);
}

// Converts one text that has no markup in it.
QString withTspans(const QString& text) {
    QString result;
    double back = 0;  // of what is next on the line
    for (qsizetype i = 0; i < text.size();) {
        const Level level = letterOf(text[i]).level;
        qsizetype end = i;
        QString plain;
        while (end < text.size() && letterOf(text[end]).level == level) plain += letterOf(text[end++]).plain;
        const QString run = text.mid(i, end - i);
        i = end;
        if (level == Level::line || std::ranges::all_of(run, isCommon)) {
            result += back == 0 ? run : element(back, {}, run);
            back = 0;
            continue;
        }
        // Lengths in em are of the small letters here, and of the usual ones in what follows.
        const double dy = shift(level) + back / size;
        result += element(dy, QStringLiteral(" font-size=\"%1%\"").arg(100 * size), plain);
        back = -shift(level) * size;
    }
    return result;
}

}  // namespace

QByteArray withCommonText(const QByteArray& svg, const QString& family) {
    const QString all = QString::fromUtf8(svg);
    const QString end = QStringLiteral("</text>");
    QString result;
    qsizetype done = 0;
    for (qsizetype close = all.indexOf(end); close >= 0; close = all.indexOf(end, done)) {
        const qsizetype begin = all.lastIndexOf(u'>', close - 1) + 1;
        result += all.mid(done, begin - done) + withTspans(all.mid(begin, close - begin)) + end;
        done = close + end.size();
    }
    result += all.mid(done);
    const QString named = QStringLiteral("font-family=\"%1\"").arg(family);
    const QString common = QStringLiteral("font-family=\"%1, Arial, Helvetica, sans-serif\"").arg(family);
    return QByteArray::fromStdString(printableLines(result.replace(named, common).toStdString()));
}

}  // namespace drillwave
