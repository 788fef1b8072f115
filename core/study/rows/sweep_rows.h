// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep with its rows in memory, to be drawn.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// Axes, outputs, and the numbers of all rows as RowBlock has them.
struct SweepRows {
    std::string title;
    std::vector<SweepAxis> axes;
    std::vector<OutputColumn> columns;
    std::vector<double> numbers;  ///< row by row, axes (SI) before outputs; NaN where a row was not solved

    std::size_t width() const { return axes.size() + columns.size(); }
};

/// Most rows, outputs, and lines in one plot, that a picture of a sweep can show so that it can be read.
inline constexpr std::uint64_t mostDrawnRows = 100'000;
inline constexpr std::size_t mostDrawnOutputs = 8;
inline constexpr std::uint64_t mostDrawnLines = 16;

/// Returns the index of the axis along which curves of a sweep are drawn: the one with most values among axes
/// of numbers with at least two. Without such an axis, the number of axes.
std::size_t lineAxis(const std::vector<SweepAxis>& axes);

/// Returns why a sweep has no picture and what to do; empty if it has one.
Message pictureProblem(const Sweep& sweep);

/// Keeps the numbers of rows on their way to another sink.
class RowKeeper : public RowSink {
  public:
    /// Requires that both outlive it.
    RowKeeper(RowSink& next, std::vector<double>& numbers) : m_next(next), m_numbers(numbers) {}

    bool begin(const RowHeader& header) override { return m_next.begin(header); }
    void prepare(const RowBlock& rows, std::string& prepared) const override {
        m_next.prepare(rows, prepared);
    }
    bool take(const RowBlock& rows, std::string_view prepared) override;

  private:
    RowSink& m_next;
    std::vector<double>& m_numbers;
};

}  // namespace drillwave
