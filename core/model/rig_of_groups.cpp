// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/rig_of_groups.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/model/scales.h"

namespace drillwave {
namespace {

/// Returns a piston of the rod's material that has the duration and the impulse.
Piston pistonOf(const Piston& groups, const RodProperties& rod, double density, double duration,
                double impulse) {
    const double ratio = groups.impedanceRatio;
    Piston piston;
    piston.length = rod.waveSpeed * duration / 2;
    const double area = ratio * rod.area;
    piston.diameter = std::sqrt(4 * area / std::numbers::pi);
    const double momentum = ratio >= 1 ? impulse : impulse * (1 + ratio) / 2;
    piston.velocity = momentum / (density * area * piston.length);
    return piston;
}

/// Returns the points stretched to the duration and the impulse.
TablePoints stretched(const TablePoints& points, double duration, double impulse) {
    double area = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += (points[i].time - points[i - 1].time) * (points[i].force / 2 + points[i - 1].force / 2);
    const double first = points.front().time;
    const double toTime = duration / (points.back().time - first), toForce = impulse / (area * toTime);
    std::vector<TablePoint> list;
    for (const TablePoint& point : points)
        list.push_back({(point.time - first) * toTime, point.force * toForce});
    return list;
}

}  // namespace

Scenario rigOf(const Scenario& groups, const RigChoice& choice) {
    assert(groups.form == ScenarioForm::dimensionless);
    Scenario rig;
    rig.title = groups.title;
    rig.form = ScenarioForm::dimensional;
    rig.rod = choice.rod;
    const RodProperties rod = propertiesOf(choice.rod);
    const double duration = choice.duration, impulse = choice.meanForce * duration;
    rig.rod.length = groups.groups.tau * duration * rod.waveSpeed;
    rig.pulse = groups.pulse;
    rig.pulse.duration = duration;
    rig.pulse.impulse = impulse;
    rig.pulse.impulseFromForce = true;
    if (groups.pulse.shape == PulseShape::piston)
        rig.pulse.piston = pistonOf(groups.pulse.piston, rod, choice.rod.density, duration, impulse);
    if (groups.pulse.shape == PulseShape::table) {
        rig.pulse.tableFile.clear();
        rig.pulse.tablePoints = stretched(groups.pulse.tablePoints, duration, impulse);
    }
    const double penetration = 2 * impulse / rod.impedance;
    rig.bitRock = groups.bitRock;
    rig.bitRock.stiffness = groups.groups.beta * rod.impedance / duration;
    rig.bitRock.gamma = groups.groups.gamma;
    rig.bitRock.gap = groups.groups.delta * penetration;
    for (RockCorner& corner : rig.bitRock.corners) corner.force *= choice.meanForce;
    if (groups.bitRock.law == RockLaw::power) rig.bitRock.referencePenetration *= penetration;
    return rig;
}

}  // namespace drillwave
