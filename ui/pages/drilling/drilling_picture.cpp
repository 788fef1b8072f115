// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/drilling_picture.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "core/blow/feed_estimate.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

constexpr qsizetype joinedReturns = 20;
constexpr std::size_t gapPlace = quantityPlace(&DrillingBlow::gap),
                      penetrationPlace = quantityPlace(&DrillingBlow::penetration);

/// Shown value of 1 in units of Problem.
double lengthFactor(const DrillingUnits& units, const DrillingShown& shown) {
    return units.length() * shown.length.factor;
}

QVector<MarchPicture::Share> energyShares(const DrillingLedger& ledger) {
    const double given = ledger.hammer + ledger.feed;
    if (!(given > 0)) return {};
    QVector<MarchPicture::Share> shares{{tr("rock"), ledger.rock / given},
                                        {tr("damper"), ledger.damper / given},
                                        {tr("lost waves"), ledger.waves / given},
                                        {tr("new faces"), ledger.faces / given},
                                        {tr("remaining energy"), ledger.stored / given}};
    return shares;
}

/// A point without an answer does not interrupt the lines: its neighbours are joined.
void addPoint(ScanCurve& curve, const DrillingScanPoint& point, const DrillingShown& shown) {
    const DrillingResult& result = point.result;
    if (!result.statistics) return;
    const double x = point.value * shown.along.factor;
    const double factor = result.units.length() * result.frequencyUsed * shown.rate.factor;
    const double rate = result.spread(penetrationPlace).mean * factor;
    const bool isFromRest = point.start == DrillingStart::rest;
    appendFinite(isFromRest ? curve.rate : curve.otherRate, x, rate);
    if (isFromRest) {
        const double error = result.meanError(penetrationPlace).value_or(0) * factor;
        appendFinite(curve.low, x, rate - error);
        appendFinite(curve.high, x, rate + error);
        appendFinite(curve.contactShare, x, 100 * result.statistics->contactShare);
    }
    const double length = lengthFactor(result.units, shown);
    for (std::size_t i = static_cast<std::size_t>(result.settings.settle); i < result.blows.size(); ++i)
        appendFinite(isFromRest ? curve.gaps : curve.otherGaps, x, result.blows[i].gap * length);
}

ScanCurve scanCurve(const DrillingScan& scan, const DrillingShown& shown) {
    ScanCurve curve;
    std::vector<const DrillingScanPoint*> points;
    for (const DrillingScanPoint& point : scan.points) points.push_back(&point);
    std::ranges::stable_sort(points, {}, [](const DrillingScanPoint* point) { return point->value; });
    for (const DrillingScanPoint* point : points) addPoint(curve, *point, shown);
    return curve;
}

/// The weight along the hole is in the feed, too: what is left to the thrust.
QVector<ScanPicture::Mark> thrustMarks(const DrillingScan& scan, const DrillingShown& shown) {
    const auto found = std::ranges::find_if(
        scan.points, [](const DrillingScanPoint& point) { return point.result.statistics.has_value(); });
    if (found == scan.points.end() || !scan.cor) return {};
    const DrillingResult& result = found->result;
    const double needed = result.meanImpulse * result.units.impulse() * result.frequencyUsed;
    const double weight =
        feedForceOf(result.scenario)->effective() - result.scenario.drill.thrust.value_or(0);
    QVector<ScanPicture::Mark> marks;
    for (const auto& [times, words] :
         {std::pair{1.0, QStringLiteral("f I₀")}, std::pair{1 + *scan.cor, QStringLiteral("f I₀(1+e)")},
          std::pair{1 + 2 * *scan.cor, QStringLiteral("f I₀(1+2e)")}})
        marks.append({(times * needed - weight) * shown.along.factor, words});
    return marks;
}

}  // namespace

DrillingShown drillingShown(const Scenario& scenario, const Unit& along, const ShownUnits& units) {
    const Scales scales = scalesOf(scenario);
    return {.length = units.of(UnitKind::penetration, scales.penetration),
            .rate = units.of(UnitKind::rate, scales.penetration * scenario.drill.blowFrequency.value_or(1)),
            .along = shownUnit(along)};
}

BlowPoints blowPoints(const std::vector<DrillingBlow>& blows, const DrillingUnits& units,
                      const DrillingShown& shown) {
    BlowPoints points;
    const double length = lengthFactor(units, shown);
    for (std::size_t i = 0; i < blows.size(); ++i) {
        points.gaps.append({double(i + 1), blows[i].gap * length});
        points.penetrations.append({double(i + 1), blows[i].penetration * length});
    }
    return points;
}

MarchPicture marchPicture(const std::vector<DrillingBlow>& blows, const DrillingSettings& settings,
                          const DrillingUnits& units, const DrillingResult* result,
                          const QVector<QPointF>& corOverGap, const DrillingShown& shown) {
    MarchPicture picture;
    picture.now = blowPoints(blows, units, shown);
    picture.blows = settings.blows;
    picture.settle = settings.settle;
    const QVector<QPointF>& gaps = picture.now.gaps;
    for (qsizetype i = settings.settle; i + 1 < gaps.size(); ++i)
        picture.returns.append({gaps[i].y(), gaps[i + 1].y()});
    picture.lastReturns =
        picture.returns.sliced(std::max<qsizetype>(0, picture.returns.size() - joinedReturns));
    picture.summary = tr("Gap and penetration of %1 of %2 blows; the first %3 are transient and excluded.")
                          .arg(blows.size())
                          .arg(settings.blows)
                          .arg(settings.settle);
    if (!result) return picture;
    picture.energy = energyShares(result->ledger);
    picture.cor = corOverGap;
    if (result->statistics) {
        double counted = 0;
        for (const int count : result->statistics->gapParts) counted += count;
        for (const int count : result->statistics->gapParts)
            picture.parts.push_back(counted > 0 ? 100 * count / counted : 0);
    }
    return picture;
}

ScanPicture scanPicture(const DrillingScan& scan, const DrillingScan* constantForce,
                        const DrillingScan* strongDamper, const DrillingShown& shown) {
    ScanPicture picture;
    picture.along = parameterName(*scan.axis.parameter);
    picture.isLogarithmic = scan.axis.kind == SweepAxis::Kind::logarithmic;
    const double first = scan.axis.value(0), last = scan.axis.value(scan.axis.count - 1);
    picture.from = std::min(first, last) * shown.along.factor;
    picture.to = std::max(first, last) * shown.along.factor;
    picture.scan = scanCurve(scan, shown);
    if (constantForce) picture.constantForce = scanCurve(*constantForce, shown).rate;
    if (strongDamper) picture.strongDamper = scanCurve(*strongDamper, shown).rate;
    if (scan.axis.key() == "drill.thrust") picture.marks = thrustMarks(scan, shown);
    return picture;
}

}  // namespace drillwave
