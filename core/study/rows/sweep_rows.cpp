// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep_rows.h"

namespace drillwave {

std::size_t lineAxis(const std::vector<SweepAxis>& axes) {
    std::size_t found = axes.size();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].words || axes[i].count < 2) continue;
        if (found == axes.size() || axes[i].count > axes[found].count) found = i;
    }
    return found;
}

std::string pictureProblem(const Sweep& sweep) {
    if (sweep.axes.size() > 2)
        return "pictures show one axis or two, not " + std::to_string(sweep.axes.size()) +
               "; vary fewer, or leave out --plots";
    const std::size_t along = lineAxis(sweep.axes);
    if (along == sweep.axes.size()) return "no axis has two numbers or more to draw a curve along";
    if (sweep.shard.count > 1) return "a part of the rows cannot be drawn; leave out --shard";
    if (pointCount(sweep) > mostDrawnRows)
        return "at most " + std::to_string(mostDrawnRows) + " rows can be drawn, not " +
               std::to_string(pointCount(sweep)) + "; take fewer";
    for (const SweepAxis& axis : sweep.axes)
        if (&axis != &sweep.axes[along] && axis.count > mostDrawnLines)
            return "at most " + std::to_string(mostDrawnLines) + " curves can be told apart, and " +
                   std::string(axis.key()) + " has " + std::to_string(axis.count) +
                   " values; take fewer, or draw a map (drillwave map)";
    if (sweep.columns.size() > mostDrawnOutputs)
        return "at most " + std::to_string(mostDrawnOutputs) + " outputs can be drawn, not " +
               std::to_string(sweep.columns.size()) + "; choose with --outputs";
    return {};
}

bool RowKeeper::take(const RowBlock& rows, std::string_view prepared) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        m_numbers.insert(m_numbers.end(), rows[i].begin(), rows[i].end());
    return m_next.take(rows, prepared);
}

}  // namespace drillwave
