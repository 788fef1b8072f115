// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_picture.h"

#include <qcustomplot.h>

#include <algorithm>

#include "core/blow/thrust.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"
#include "ui/text/translation.h"

namespace drillwave {

QString thrustCaseName(ThrustCase which) {
    switch (which) {
        case ThrustCase::scenario:
            return tr("this blow");
        case ThrustCase::gapQuantile:
            return tr("95 % of all gaps");
        case ThrustCase::rigidRock:
            return tr("rigid rock");
        case ThrustCase::elasticWorst:
            break;
    }
    return tr("elastic rock, worst gap");
}

// By what does not follow from e: the units do not flicker while the rock is changed.
ThrustUnits thrustUnits(const Scenario& scenario, const Unit& along, const ShownUnits& units) {
    return {.along = shownUnit(along),
            .force = units.of(UnitKind::force, *thrustNeeded(scenario, 0)),
            .length = units.of(UnitKind::penetration, scalesOf(scenario).penetration),
            .frequency = units.of(UnitKind::frequency, *scenario.drill.blowFrequency)};
}

ThrustPicture thrustPicture(const ThrustAlong& along, const ThrustUnits& units) {
    ThrustPicture picture;
    picture.units = units;
    picture.along = parameterName(*along.axis.parameter);
    picture.key = along.axis.key();
    picture.isLogarithmic = along.axis.kind == SweepAxis::Kind::logarithmic;
    const std::vector<double> values = valuesOf(along.axis);
    const auto [least, largest] = std::ranges::minmax(values);
    picture.from = least * units.along.factor;
    picture.to = largest * units.along.factor;
    std::vector<ThrustPoint> points = along.curve.points;
    std::ranges::sort(points, {}, &ThrustPoint::value);
    std::array<QVector<QCPGraphData>, thrustCaseCount> lower, upper;
    for (const ThrustPoint& point : points) {
        if (!point.reason.isEmpty()) continue;
        const double x = point.value * units.along.factor;
        for (std::size_t i = 0; i < thrustCaseCount; ++i) {
            if (!point.needs[i].known) continue;
            picture.needs[i].known = true;
            appendFinite(lower[i], x, point.needs[i].thrust * units.force.factor);
            appendFinite(upper[i], x, point.needs[i].thrustUndamped * units.force.factor);
        }
        picture.balance.append({x, point.verdict.balance * units.force.factor});
        picture.fullRate.append({x, point.verdict.fullRate * units.force.factor});
        picture.returned.append({x, point.verdict.returned * units.force.factor});
        picture.resting.append({x, point.verdict.resting * units.force.factor});
        if (const std::optional<FeedForce>& force = point.verdict.force) {
            picture.feed.append({x, force->effective() * units.force.factor});
            picture.isWeighted |= force->weight.has_value();
        }
    }
    for (std::size_t i = 0; i < thrustCaseCount; ++i) {
        picture.needs[i].fullRate = graphData(lower[i]);
        picture.needs[i].returned = graphData(upper[i]);
    }
    return picture;
}

}  // namespace drillwave
