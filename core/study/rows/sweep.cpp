// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep.h"

#include <algorithm>
#include <utility>

#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/study/rows/row_run.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Points of one chunk: enough to make handing over cheap, few enough to end soon when stopped.
constexpr std::uint64_t chunkPoints = 512;

/// Which value each axis has at a point of the grid.
class GridPoint {
  public:
    GridPoint(const std::vector<SweepAxis>& axes, std::uint64_t number) : m_axes(axes), m_index(axes.size()) {
        for (std::size_t a = axes.size(); a-- > 0; number /= axes[a].count)
            m_index[a] = number % axes[a].count;
    }

    /// Moves to the next point and returns the first axis whose value changed.
    std::size_t advance() {
        std::size_t a = m_axes.size() - 1;
        while (++m_index[a] == m_axes[a].count && a > 0) m_index[a--] = 0;
        return a;
    }

    std::uint64_t operator[](std::size_t axis) const { return m_index[axis]; }

  private:
    const std::vector<SweepAxis>& m_axes;
    std::vector<std::uint64_t> m_index;
};

struct GridChunk : RowChunk {
    RowRange points;
};

/// Turns points of the grid into rows. One for each thread.
class GridRowMaker {
  public:
    explicit GridRowMaker(const Sweep& sweep)
        : m_sweep(sweep),
          m_scenario(sweep.base, sweep.axes),
          m_solver(sweep.columns, sweep.method, sweep.workLimit),
          m_values(sweep.axes.size()) {}

    void operator()(GridChunk& chunk, std::stop_token stop) {
        chunk.rows.restart(chunk.points.begin, m_values.size() + m_sweep.columns.size());
        GridPoint point(m_sweep.axes, chunk.points.begin);
        std::size_t changed = 0;
        for (std::uint64_t n = chunk.points.begin; n < chunk.points.end; ++n) {
            if (stop.stop_requested()) return;
            const std::span<double> row = chunk.rows.add();
            moveTo(point, changed);
            std::ranges::copy(m_values, row.begin());
            Message reason = m_scenario.obstacle()
                                 ? m_scenario.obstacle()->reason
                                 : m_solver.solve(m_scenario.scenario(), row.subspan(m_values.size()), stop);
            if (!reason.isEmpty()) chunk.rows.fail(std::move(reason));
            changed = point.advance();
        }
    }

  private:
    /// `changed` is the first axis whose value is not that of the point before.
    void moveTo(const GridPoint& point, std::size_t changed) {
        for (std::size_t a = changed; a < m_values.size(); ++a) m_values[a] = m_sweep.axes[a].value(point[a]);
        m_scenario.set(m_values);
        if (m_scenario.movesPulse(changed)) m_hasPulse = false;
        if (m_hasPulse || m_scenario.obstacle()) return;
        m_solver.setPulse(m_scenario.scenario());
        m_hasPulse = true;
    }

    const Sweep& m_sweep;
    AxisScenario m_scenario;
    CaseSolver m_solver;
    std::vector<double> m_values;  // of the axes at the point
    bool m_hasPulse = false;
};

RowHeader headerOf(const Sweep& sweep) {
    RowHeader header{.copied = {}, .columns = {}, .isFirstPart = sweep.shard.hasHeader() && sweep.done == 0};
    for (const SweepAxis& axis : sweep.axes) header.columns.push_back(axis.column());
    for (const OutputColumn& column : sweep.columns) header.columns.push_back({.header = column.header()});
    return header;
}

}  // namespace

std::uint64_t pointCount(const Sweep& sweep) {
    std::uint64_t points = 1;
    for (const SweepAxis& axis : sweep.axes) {
        if (axis.count > maximumSweepPoints / points) return 0;
        points *= axis.count;
    }
    return points;
}

RowCounts runSweep(const Sweep& sweep, int jobs, std::stop_token stop, RowSink& sink,
                   const RowProgress& progress) {
    if (Message refusal = inOneLine(problemsOf(sweep)); !refusal.isEmpty())
        return {.failures = {}, .refusal = std::move(refusal)};
    const RowRange part = rowsOf(sweep.shard, pointCount(sweep));
    std::uint64_t next = std::min(part.begin + sweep.done, part.end);
    const auto fill = [&](GridChunk& chunk) {
        chunk.points = {next, std::min(next + chunkPoints, part.end)};
        next = chunk.points.end;
        return chunk.points.size() > 0;
    };
    return runRows<GridChunk>(
        jobs, stop, fill, [&] { return GridRowMaker(sweep); }, headerOf(sweep), sink, progress);
}

}  // namespace drillwave
