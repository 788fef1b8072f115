// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest complete study: the peak force over one parameter, for the rod and for one of another length.
#pragma once

#include "core/report/study.h"

namespace drillwave::test {

/// Peak forces [N] over equal steps of a parameter (`values`, SI): forces[rod][step]. NaN if a blow is not
/// solved.
struct PeakForces {
    std::vector<double> values;
    std::vector<std::vector<double>> forces;
    bool isStopped = false;
};

/// Returns the peak force of a blow for each scenario at 41 values of a parameter, from `start` to `stop`
/// (SI).
PeakForces peakForces(const std::vector<Scenario>& rods, const Parameter& parameter, double start,
                      double stop, const StudyWork& work);

const Study& toyStudy();

}  // namespace drillwave::test
