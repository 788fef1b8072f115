// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thrust/thrust_picture.h"

#include <qcustomplot.h>

#include <algorithm>

#include "core/blow/feed_estimate.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/shown_text.h"

namespace drillwave {

// By what does not follow from e: the units do not flicker while the rock is changed.
ThrustUnits thrustUnits(const Scenario& scenario, const Unit& along, const ShownUnits& units) {
    return {.along = shownUnit(along),
            .force = units.of(UnitKind::force, *thrustNeeded(scenario, 0)),
            .frequency = units.of(UnitKind::frequency, *scenario.drill.blowFrequency)};
}

ThrustPicture thrustPicture(const ThrustAlong& along, const ThrustUnits& units) {
    ThrustPicture picture;
    picture.units = units;
    picture.along = parameterName(*along.axis.parameter);
    picture.key = along.axis.key();
    picture.isLogarithmic = along.axis.kind == SweepAxis::Kind::logarithmic;
    const std::vector<double> values = valuesOf(along.axis);
    const auto [first, last] = std::ranges::minmax(values);
    picture.from = first * units.along.factor;
    picture.to = last * units.along.factor;
    std::vector<ThrustPoint> points = along.curve.points;
    std::ranges::sort(points, {}, &ThrustPoint::value);
    std::array<QVector<QCPGraphData>, thrustCaseCount> lower, upper;
    for (const ThrustPoint& point : points) {
        if (!point.reason.isEmpty()) continue;
        const double x = point.value * units.along.factor;
        for (std::size_t i = 0; i < thrustCaseCount; ++i) {
            const ThrustNeed& need = point.feed.needs[i];
            if (!need.known) continue;
            picture.needs[i].known = true;
            appendFinite(lower[i], x, need.thrust * units.force.factor);
            appendFinite(upper[i], x, need.thrustUndamped * units.force.factor);
        }
        const ThrustNeed& largest = point.feed.largest();
        picture.balance.append({x, point.feed.balance * units.force.factor});
        picture.ofThisBlow.append({x, point.need(ThrustCase::scenario).thrust * units.force.factor});
        picture.largest.append({x, largest.thrust * units.force.factor});
        picture.largestReturn.append({x, largest.thrustUndamped * units.force.factor});
        if (const std::optional<FeedForce>& force = point.feed.force) {
            picture.feed.append({x, force->effective() * units.force.factor});
            picture.isWeighted |= force->weight.has_value();
        }
    }
    for (std::size_t i = 0; i < thrustCaseCount; ++i) {
        picture.needs[i].required = graphData(lower[i]);
        picture.needs[i].returnInTime = graphData(upper[i]);
    }
    return picture;
}

}  // namespace drillwave
