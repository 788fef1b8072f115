// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep with its rows in memory, for drawing.
#pragma once

#include <string>
#include <vector>

#include "core/study/rows/sweep.h"

namespace drillwave {

/// Axes, outputs and values of all rows of a sweep.
struct SweepRows {
    std::string title;
    std::vector<SweepAxis> axes;
    std::vector<OutputColumn> columns;
    /// Numbers of all rows, one row after another: the axis values (SI), then the outputs. Outputs are NaN if
    /// the row was not solved.
    std::vector<double> numbers;

    std::size_t width() const { return axes.size() + columns.size(); }
};

/// Maximum numbers of rows, outputs and lines (values of the second axis) of a sweep for a readable plot.
inline constexpr std::uint64_t mostDrawnRows = 100'000;
inline constexpr std::size_t mostDrawnOutputs = 8;
inline constexpr std::uint64_t mostDrawnLines = 16;

/// Returns the index of the axis along which the curves of a sweep are drawn: the numeric axis with the most
/// values, at least two. If there is none, returns the number of axes.
std::size_t lineAxis(const std::vector<SweepAxis>& axes);

/// Returns why the rows of a sweep cannot be drawn as a diagram, and what the user can do. Empty if they can
/// be drawn.
Message pictureProblem(const Sweep& sweep);

/// Sink that stores the values of all rows, for drawing, and passes the rows on to another sink.
class RowKeeper : public RowSink {
  public:
    /// Stores references to both arguments, which must outlive this object.
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
