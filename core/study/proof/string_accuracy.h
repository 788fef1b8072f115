// SPDX-License-Identifier: GPL-3.0-or-later
// Error against computing time for a drill string: polynomial cells of several sizes compared with the plain
// lattice.
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/numeric/run_time.h"
#include "core/text/message.h"
#include "core/wave/network/network_solver.h"

namespace drillwave {

/// Method of computing a blow on a drill string.
enum class StringMethod {
    quick,  ///< polynomial cells, divided at jumps; used by studies
    sure,   ///< polynomial cells, divided at every corner of a wave; used by the command `run`
    plain,  ///< lattice of constant cells
};

/// Returns the name as in JSON: "cells", "cells_cut" or "plain".
std::string_view name(StringMethod method);

/// Error and computing time of one method for a blow on a drill string, with one cell size.
struct StringAccuracyRow {
    StringMethod method = StringMethod::quick;
    double cell = 0;    ///< Δ, cell size as a round-trip time [s]
    double error = 0;   ///< absolute difference of the efficiency from the reference
    double stated = 0;  ///< error of the efficiency as stated by the method itself; NaN if it states none
    /// Absolute difference of the impulse on the rock from that of the reference solution, in units of the
    /// hammer momentum p0.
    double impulseError = 0;
    long cells = 0;  ///< work of the solution: number of cells times number of nodes
    RunTime time;
};

struct StringAccuracy {
    Message reason;  ///< reason why there is no comparison; empty if there is one
    /// Efficiency of the blow in the reference solution. That solution has polynomial cells (time steps) of a
    /// quarter of the default size, divided at every corner of a wave.
    double efficiency = 0;
    double reference = 0;  ///< error of the reference efficiency, as stated by the reference solution itself
    std::vector<StringAccuracyRow> rows;
    bool isStopped = false;  ///< set if a stop request ended the comparison; rows are then missing
};

/// Callback for progress, called whenever the error and computing time of a method are known for one cell
/// size. It receives the rows so far and the completed share of the work, 0 … 1.
using StringAccuracyRows = std::function<void(const StringAccuracy& soFar, double done)>;

/// Returns the accuracy and computing time of the methods for a blow on a drill string; takes seconds. The
/// plain lattice is included only if the lengths of all sections are multiples of one cell. Rows that need
/// more than `mostCells` (time steps × nodes) are left out. If the reference solution needs more, the result
/// contains only the reason.
StringAccuracy measureStringAccuracy(const Scenario& scenario, const std::stop_token& stop = {},
                                     const StringAccuracyRows& onRow = {}, long mostCells = mostNetworkCells);

}  // namespace drillwave
