// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/sweep_rows.h"

namespace drillwave {

std::size_t lineAxis(const std::vector<SweepAxis>& axes) {
    std::size_t found = axes.size();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (!axes[i].parameter || axes[i].count < 2) continue;
        if (found == axes.size() || axes[i].count > axes[found].count) found = i;
    }
    return found;
}

Message pictureProblem(const Sweep& sweep) {
    if (sweep.axes.size() > 2)
        return {translatable("pictures show one axis or two, not %1; vary fewer, or leave out --plots"),
                {std::to_string(sweep.axes.size())}};
    const std::size_t along = lineAxis(sweep.axes);
    if (along == sweep.axes.size())
        return translatable("no axis has two or more numeric values to draw a curve along");
    if (sweep.shard.count > 1) return translatable("pictures need all rows; leave out --shard");
    if (pointCount(sweep) > mostDrawnRows)
        return {translatable("at most %1 rows can be drawn, not %2; take fewer"),
                {std::to_string(mostDrawnRows), std::to_string(pointCount(sweep))}};
    for (const SweepAxis& axis : sweep.axes)
        if (&axis != &sweep.axes[along] && axis.count > mostDrawnLines)
            return {translatable("at most %1 curves can be distinguished, and %2 has %3 values; take fewer, "
                                 "or draw a map (drillwave map)"),
                    {std::to_string(mostDrawnLines), std::string(axis.key()), std::to_string(axis.count)}};
    if (sweep.columns.size() > mostDrawnOutputs)
        return {translatable("at most %1 outputs can be drawn, not %2; choose with --outputs"),
                {std::to_string(mostDrawnOutputs), std::to_string(sweep.columns.size())}};
    return {};
}

bool RowKeeper::take(const RowBlock& rows, std::string_view prepared) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        m_numbers.insert(m_numbers.end(), rows[i].begin(), rows[i].end());
    return m_next.take(rows, prepared);
}

}  // namespace drillwave
