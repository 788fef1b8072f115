// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/drilling/drilling_problem.h"

#include <algorithm>

namespace drillwave {

bool losesWaves(const DrillingProblem& problem) {
    return std::ranges::any_of(problem.waveLosses, [](double loss) { return loss > 0; }) ||
           losesWaves(problem.blow);
}

}  // namespace drillwave
