// SPDX-License-Identifier: GPL-3.0-or-later
// The outputs of a curve fitted cell by cell, which is what threads share.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/study/curve/curve_sampler.h"
#include "core/text/message.h"

namespace drillwave {

/// The range of a question is cut in so many cells, where to look first: a feature that is narrower, and on
/// which nothing happens at the bit in another order, may be missed. More for many periods of the gap.
std::size_t cellCount(const CurveQuestion& question);

/// Returns why an output is only known at points everywhere; empty if it is fitted.
Message whyRough(const Output& output);

/// Output in one cell.
struct CellOutput {
    std::vector<FitPiece> pieces;  ///< open where it is not smooth
    Message reason;                ///< of those without a result
};

struct CellTask {
    std::size_t line = 0;
    double start = 0;  ///< shares of the way
    double end = 1;
    std::vector<CellOutput> outputs;
    std::uint64_t solves = 0;
    long effort = 0;  ///< of these
};

/// Returns a piece to be filled from points: it has a result, but no function yet.
FitPiece openPiece(double start, double end);
bool isOpen(const FitPiece& piece);

/// Fits the outputs of one cell after another. One for each thread.
class CellFitter {
  public:
    /// Requires that both outlive it.
    CellFitter(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    /// Fills a task of that line and those ends.
    void operator()(CellTask& task, const std::stop_token& stop) const;

  private:
    CellOutput fit(CurveSampler& sampler, const CellTask& task, std::size_t output,
                   const std::stop_token& stop) const;

    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// Appends the results of a cell to the pieces and stretches of the outputs. Requires the cells of a line in
/// their order.
void addCell(CurveLine& line, const CurveQuestion& question, CellTask& task);

/// Appends the stretch of a piece, or extends the last one if it continues.
void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                const Message& reason);

}  // namespace drillwave
