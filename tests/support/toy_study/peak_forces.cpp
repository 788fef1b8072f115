// SPDX-License-Identifier: GPL-3.0-or-later
// The numerics of the toy study.
#include <limits>

#include "core/blow/blow.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "tests/support/toy_study/toy_study.h"

namespace drillwave::test {

PeakForces peakForces(const std::vector<Scenario>& rods, const Parameter& parameter, double start,
                      double stop, const StudyWork& work) {
    constexpr int steps = 40;
    PeakForces found;
    found.forces.resize(rods.size());
    for (int step = 0; step <= steps; ++step) {
        found.values.push_back(start + (stop - start) * step / steps);
        for (std::size_t rod = 0; rod < rods.size(); ++rod) {
            if (work.stop.stop_requested()) {
                found.isStopped = true;
                return found;
            }
            Scenario scenario = rods[rod];
            parameter.assign(scenario, found.values.back());
            const Blow blow = solveBlow(scenario, {}, Detail::events, work.stop);
            found.forces[rod].push_back(blow.isSolved() ? blow.summary.peakForce * scalesOf(scenario).force
                                                        : std::numeric_limits<double>::quiet_NaN());
        }
        work.progress(double(step) / steps);
    }
    return found;
}

}  // namespace drillwave::test
