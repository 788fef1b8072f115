// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time for a drill string: polynomial cells of several sizes beside the plain lattice.
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

enum class StringMethod {
    quick,  ///< polynomial cells, cut at jumps: used by studies
    sure,   ///< cut at every corner of a wave: used by `run`
    plain,  ///< a lattice of constant cells
};

/// "cells", "cells_cut", "plain".
std::string_view name(StringMethod method);

/// A method with one size of cell.
struct StringAccuracyRow {
    StringMethod method = StringMethod::quick;
    double cell = 0;          ///< Δ of the round trip [s]
    double error = 0;         ///< difference of the efficiency from that of the reference
    double stated = 0;        ///< error stated by the method; NaN: none
    double impulseError = 0;  ///< difference of the impulse on the rock from that of the reference [p0]
    long cells = 0;           ///< times nodes
    RunTime time;
};

struct StringAccuracy {
    Message reason;         ///< why there is nothing
    double efficiency = 0;  ///< of the reference: cut at every corner, cells half as large as usual
    double reference = 0;   ///< stated error of that
    std::vector<StringAccuracyRow> rows;
    bool isStopped = false;  ///< rows are missing
};

/// Called with the rows so far whenever one is done, and the share of the work that is done, 0 … 1.
using StringAccuracyRows = std::function<void(const StringAccuracy& soFar, double done)>;

/// Solves a drill string, and measures; the plain lattice where all lengths share a cell. Takes seconds. A
/// row that takes more than `mostCells` is left out; where the reference does, that is the reason.
StringAccuracy measureStringAccuracy(const Scenario& scenario, const std::stop_token& stop = {},
                                     const StringAccuracyRows& onRow = {}, long mostCells = mostNetworkCells);

}  // namespace drillwave
