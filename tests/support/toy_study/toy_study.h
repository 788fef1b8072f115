// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest study that is whole: peak force over a parameter, of the rod and of one of another length.
#pragma once

#include "core/report/study.h"

namespace drillwave::test {

/// [N], of `rods` rods of equal steps of a parameter [SI]: forces[rod][step]. NaN where a blow is not solved.
struct PeakForces {
    std::vector<double> values;
    std::vector<std::vector<double>> forces;
    bool isStopped = false;
};

/// Solves a blow of each scenario at 41 values of a parameter.
PeakForces peakForces(const std::vector<Scenario>& rods, const Parameter& parameter, double start,
                      double stop, const StudyWork& work);

const Study& toyStudy();

}  // namespace drillwave::test
