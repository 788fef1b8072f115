// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/blow/measured_force.h"

#include <algorithm>

#include "core/blow/blow_waves.h"
#include "ui/pages/blow/blow_curves.h"

namespace drillwave {

double shareAt(const Scenario& scenario, double x) {
    return std::clamp(x / chainProperties(scenario).length, hammerRear(scenario.drillString), 1.0);
}

ComputedForce computedForce(const Blow& blow, const MeasuredSignal& signal, const BlowCurves& curves) {
    const Scales scales = scalesOf(blow.scenario);
    const double share = shareAt(blow.scenario, signal.place);
    const bool isInside = signal.quantity == MeasuredQuantity::normalForce;
    const auto force = [=, waves = BlowWaves(blow)](double time) {
        const double t = std::min(time / scales.time, waves.end());
        return scales.force * (isInside ? waves.value(WaveQuantity::force, share, t) : waves.impactForce(t));
    };
    return {force, curves.timeEnd / curves.units.time.factor * scales.time};
}

std::optional<Misfit> misfitOf(const MeasuredSignal& signal, const ComputedForce& computed) {
    return misfitOf(signal.points, signal.timeShift, computed.at, computed.end);
}

}  // namespace drillwave
