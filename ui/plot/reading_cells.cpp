// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/reading_cells.h"

#include <cmath>

#include "core/text/units.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr qsizetype longestLabel = 4;

// Joins two units by a sign, such as a quotient or a product; nothing for mere numbers.
QString joined(const QString& left, QChar sign, const QString& right) {
    if (right.isEmpty()) return left;
    return (left.isEmpty() && sign == QLatin1Char('/') ? QStringLiteral("1") : left) +
           (left.isEmpty() && sign != QLatin1Char('/') ? QString() : QString(sign)) + right;
}

QString slopeUnitOf(const CurveMeaning& meaning) {
    return meaning.slopeUnit.isEmpty() ? joined(meaning.yUnit, QLatin1Char('/'), meaning.xUnit)
                                       : meaning.slopeUnit;
}

QString integralUnitOf(const CurveMeaning& meaning) {
    return meaning.integralUnit.isEmpty() ? joined(meaning.yUnit, QChar(0x00b7), meaning.xUnit)
                                          : meaning.integralUnit;
}

// A place on the horizontal axis.
ReadingCell placeCell(const QString& name, const QString& label, double x, const CurveMeaning& meaning) {
    return {name, label, x, meaning.xUnit, meaning.wordAt(x)};
}

// A symbol; words would leave no room for the number.
QString shortLabel(const QString& name) {
    return name.size() <= longestLabel ? name : QString();
}

}  // namespace

QString ReadingCell::text(const QLocale& locale, int digits) const {
    if (!words.isEmpty()) return words;
    if (!std::isfinite(value)) return noNumber;
    const QString number = numberText(value, digits, locale);
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

ReadingCells cursorCells(const CursorReading& reading, const CurveMeaning& meaning) {
    const bool isSummed = meaning.integralFactor != 0, ofWords = !meaning.xWords.isEmpty();
    const QString& x = meaning.xName;
    const QString& y = meaning.yName;
    const QString yLabel = shortLabel(y);
    const bool both = !std::isnan(reading.a) && !std::isnan(reading.b);
    const double none = std::nan("");
    return {
        placeCell(tr("%1 at A").arg(x), tr("A"), reading.a, meaning),
        {tr("%1 at A").arg(y), yLabel, std::isnan(reading.a) ? none : reading.yA, meaning.yUnit},
        placeCell(tr("%1 at B").arg(x), tr("B"), reading.b, meaning),
        {tr("%1 at B").arg(y), yLabel, std::isnan(reading.b) ? none : reading.yB, meaning.yUnit},
        ofWords ? ReadingCell{}
                : ReadingCell{tr("%1 from A to B").arg(x), tr("B − A"), reading.b - reading.a, meaning.xUnit},
        {tr("%1 from A to B").arg(y), QStringLiteral("Δ") + yLabel, both ? reading.yB - reading.yA : none,
         meaning.yUnit},
        isSummed ? ReadingCell{tr("mean"), tr("mean"), both ? reading.mean : none, meaning.yUnit}
                 : ReadingCell{},
        ofWords ? ReadingCell{}
                : ReadingCell{tr("slope"), tr("slope"), both ? reading.slope : none, slopeUnitOf(meaning)},
        isSummed
            ? ReadingCell{tr("integral"), tr("∫"), both ? reading.integral : none, integralUnitOf(meaning)}
            : ReadingCell{}};
}

ReadingCells viewCells(const ViewStatistics& statistics, const CurveMeaning& meaning) {
    const bool isSummed = meaning.integralFactor != 0, ofWords = !meaning.xWords.isEmpty();
    const QString& x = meaning.xName;
    const QString& y = meaning.yName;
    return {
        {tr("least %1 in view").arg(y), tr("min"), statistics.least, meaning.yUnit},
        placeCell(tr("%1 of the least").arg(x), tr("at"), statistics.leastAt, meaning),
        {tr("largest %1 in view").arg(y), tr("max"), statistics.largest, meaning.yUnit},
        placeCell(tr("%1 of the largest").arg(x), tr("at"), statistics.largestAt, meaning),
        ofWords ? ReadingCell{}
                : ReadingCell{tr("%1 from").arg(x), tr("from"), statistics.begin, meaning.xUnit},
        ofWords ? ReadingCell{} : ReadingCell{tr("%1 to").arg(x), tr("to"), statistics.end, meaning.xUnit},
        isSummed ? ReadingCell{tr("mean in view"), tr("mean"), statistics.mean, meaning.yUnit}
                 : ReadingCell{},
        {},
        isSummed ? ReadingCell{tr("integral in view"), tr("∫"), statistics.integral, integralUnitOf(meaning)}
                 : ReadingCell{}};
}

QString readingText(const ReadingCells& cells, const QLocale& locale) {
    QStringList parts;
    for (const ReadingCell& cell : cells)
        if (!cell.name.isEmpty())
            parts.append(cell.name + QChar(QChar::Nbsp) + cell.text(locale, readingDigits));
    return parts.join(QStringLiteral(" · "));
}

QString readingTable(const QString& curve, const ReadingCells& cells) {
    QString table = curve.simplified() + QLatin1Char('\n');
    for (const ReadingCell& cell : cells) {
        if (cell.name.isEmpty()) continue;
        const QString number =
            std::isfinite(cell.value) ? QString::fromStdString(formatNumber(cell.value)) : QString();
        table += cell.name + QLatin1Char('\t') + (cell.words.isEmpty() ? number : cell.words) +
                 QLatin1Char('\t') + cell.unit + QLatin1Char('\n');
    }
    return table;
}

}  // namespace drillwave
