// SPDX-License-Identifier: GPL-3.0-or-later
// How a blow was solved, for reports, records and remarks.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/blow.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the method as JSON names it: "polynomial_cells" of a drill string, whichever is given.
std::string_view methodKey(const Scenario& scenario, Method method);

struct SolverWords {
    std::string key;     ///< in JSON: "polynomial_cells"
    Message name;        ///< "lattice of 1000 segments"
    Message asked;       ///< in prose: "method lattice, 1000 segments", "polynomial cells"
    std::string remark;  ///< in files, as remarksOf() reads it again: "method polynomial_cells"
    Message pieces;      ///< what Impact::pieces counts: "11 cells"
};
SolverWords solverWords(const Blow& blow);

}  // namespace drillwave
