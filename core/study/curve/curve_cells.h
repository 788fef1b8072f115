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

/// Returns the number of cells, 16 … 256, into which the parameter range is divided. Each cell is fitted by
/// one thread. If the gap is varied, there are 8 cells for each period of the results, within these limits. A
/// feature of the curve that is narrower than a cell may be missed, unless the order of events at the bit
/// changes there.
std::size_t cellCount(const CurveQuestion& question);

/// Returns why no smooth function can be fitted to an output, which is then only solved at points; empty if
/// it is fitted.
Message whyRough(const Output& output);

/// Fitted functions of one output in one cell (a part of the parameter range).
struct CellOutput {
    /// Pieces over shares of the range, ascending. A piece is open (has no function) where the output is not
    /// smooth.
    std::vector<FitPiece> pieces;
    Message reason;  ///< reason why pieces without a result have none; empty if all have results
};

/// Task of fitting one cell (a part of the parameter range) of one line of curves. CellFitter reads `line`,
/// `start` and `end`, and stores the fitted outputs and the computing work.
struct CellTask {
    std::size_t line = 0;
    /// Start of the cell as a share 0 … 1 of the parameter range. The end of the cell, `end`, is also such a
    /// share.
    double start = 0;
    double end = 1;
    std::vector<CellOutput> outputs;
    std::uint64_t solves = 0;
    /// Computing work of all blows of this cell: number of polynomial wave pieces, or time steps × nodes for
    /// drill strings.
    long effort = 0;
};

/// Returns an open piece from `start` to `end`: a part of a curve that has results but is not fitted by a
/// function. fillPieces() later replaces it with straight lines between solved points.
FitPiece openPiece(double start, double end);
bool isOpen(const FitPiece& piece);

/// Functor that fits functions to all outputs over one cell, a part of the parameter range. Each thread needs
/// its own object.
class CellFitter {
  public:
    /// Stores references to both arguments, which must outlive this object.
    CellFitter(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Fits functions to all outputs over the cell of a task, from its `start` to its `end`. Stores the
    /// functions, the number of solved blows and the computing work in the task.
    void operator()(CellTask& task, const std::stop_token& stop) const;

  private:
    CellOutput fit(CurveSampler& sampler, const CellTask& task, std::size_t output,
                   const std::stop_token& stop) const;

    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Appends the fitted outputs of a cell to the line of curves to which it belongs, and moves the pieces out
/// of `task`. Requires that the cells of a line are added in ascending order.
void addCell(CurveLine& line, const CurveQuestion& question, CellTask& task);

/// Appends the range of a piece, with the reason why it is not fitted or has no result, to a list of such
/// stretches. If the last stretch ends where the piece starts, extends that stretch instead. Stores parameter
/// values in SI units, converted from shares of the range.
void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                const Message& reason);

}  // namespace drillwave
