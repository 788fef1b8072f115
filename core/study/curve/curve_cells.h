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

/// Returns the number of cells, 16 … 256, into which the parameter range is divided. If the gap is varied,
/// there are 8 cells for each period of the results, within these limits. A feature narrower than a cell may
/// be missed if the order of events at the bit does not change there.
std::size_t cellCount(const CurveQuestion& question);

/// Returns why an output cannot be fitted and is only solved at points; empty if it is fitted.
Message whyRough(const Output& output);

/// Fitted functions of one output in one cell.
struct CellOutput {
    /// Ascending pieces over shares of the range; a piece is open (has no function) where the output is not
    /// smooth.
    std::vector<FitPiece> pieces;
    Message reason;  ///< reason why pieces without a result have none; empty if all have results
};

/// One cell of one line: its position, and after CellFitter has run, its fitted outputs and their cost.
struct CellTask {
    std::size_t line = 0;
    /// Start of the cell as a share of the parameter range, 0 … 1; `end` is in the same measure.
    double start = 0;
    double end = 1;
    std::vector<CellOutput> outputs;
    std::uint64_t solves = 0;
    /// Work of all blows of this cell: wave pieces, or cells of the method of drill strings.
    long effort = 0;
};

/// Returns a piece of a curve without a function. The output has a result there, and fillPieces() later adds
/// straight lines between solved points.
FitPiece openPiece(double start, double end);
bool isOpen(const FitPiece& piece);

/// Functor that fits all outputs of a cell. Each thread needs its own object.
class CellFitter {
  public:
    /// Stores references to both arguments, which must outlive this object.
    CellFitter(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Fits all outputs over the range from `start` to `end` of a task. Stores the fits, and the number and
    /// work of the blows, in the task.
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

/// Appends the range of a piece to a list of stretches, or extends the last stretch if the piece continues
/// it. Converts shares of the range to parameter values in SI units.
void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                const Message& reason);

}  // namespace drillwave
