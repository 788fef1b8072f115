// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the outputs of a curve in cells. A cell is one part of the parameter range and is computed by one
// thread.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve_sampler.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the number of cells, 16 … 256, into which the parameter range is divided; a cell is fitted by one
/// thread. If the gap is varied, there are 8 cells for each period of the results, within these limits. A
/// feature narrower than a cell may be missed if the order of events at the bit does not change there.
std::size_t cellCount(const CurveQuestion& question);

/// Returns why an output cannot be fitted and is only solved at points; empty if it is fitted.
Message whyRough(const Output& output);

/// Fitted functions of one output in one cell.
struct CellOutput {
    /// Pieces over shares of the range, ascending. A piece is open (has no function) where the output is not
    /// smooth.
    std::vector<FitPiece> pieces;
    Message reason;  ///< reason why pieces without a result have none; empty if all have results
};

/// Task of fitting one cell (one part of the range) of one line. CellFitter reads the position and stores the
/// fitted outputs and their cost.
struct CellTask {
    std::size_t line = 0;
    /// Start of the cell as a share of the parameter range, 0 … 1; `end` is such a share, too.
    double start = 0;
    double end = 1;
    std::vector<CellOutput> outputs;
    std::uint64_t solves = 0;
    /// Computing work of all blows of this cell: polynomial pieces of waves, or for drill strings time steps
    /// times nodes.
    long effort = 0;
};

/// Returns an open piece: a part of a curve that has results but is not fitted by a function. fillPieces()
/// later replaces it with straight lines between solved points.
FitPiece openPiece(double start, double end);
bool isOpen(const FitPiece& piece);

/// Functor that fits all outputs of a cell. Each thread needs its own object.
class CellFitter {
  public:
    /// Stores references to both arguments, which must outlive this object.
    CellFitter(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Fits all outputs over the cell of a task, from `start` to `end`. Stores the fits, and the number and
    /// computing work of the blows, in the task.
    void operator()(CellTask& task, const std::stop_token& stop) const;

  private:
    CellOutput fit(CurveSampler& sampler, const CellTask& task, std::size_t output,
                   const std::stop_token& stop) const;

    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Appends the fitted outputs of a cell to those of its line, and moves the pieces out of `task`. Requires
/// that the cells of a line are added in ascending order.
void addCell(CurveLine& line, const CurveQuestion& question, CellTask& task);

/// Appends the range of a piece, with a reason, to a list of stretches. Extends the last stretch instead if
/// the piece continues it. Converts shares of the range to parameter values in SI units.
void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                const Message& reason);

}  // namespace drillwave
