// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_csv.h"

#include "core/report/report_table.h"

namespace drillwave {

std::vector<double> valuesOf(const SweepAxis& axis) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < axis.count; ++i) values.push_back(axis.value(i));
    return values;
}

std::string thrustCsv(const ThrustAlong& along) {
    const RowColumn column = along.axis.column();
    std::vector<std::string> headers{column.header};
    for (const char* end : {"", "_undamped"})
        for (const ThrustCase which : thrustCases) headers.push_back(std::string(name(which)) + end + " [N]");
    append(headers, {"effective_force [N]", "thrust_margin", "gap_at_blow [m]", "round_trips", "feed"});
    return csvText({headers, along.curve.points.size(), [&](std::size_t row) {
                        const ThrustPoint& point = along.curve.points[row];
                        Cells cells{column.cell(point.value)};
                        if (!point.reason.isEmpty()) return cells;
                        const auto addNeeds = [&](double ThrustNeed::*force) {
                            for (const ThrustNeed& need : point.feed.needs)
                                cells.push_back(need.known ? Cell(need.*force) : Cell());
                        };
                        addNeeds(&ThrustNeed::thrust);
                        addNeeds(&ThrustNeed::thrustUndamped);
                        const std::optional<GapAtBlow>& gap = point.need(ThrustCase::scenario).gapAtBlow;
                        const bool hasGap = gap && gap->motion.kind != UndampedMotion::Kind::pushedBack;
                        const std::optional<FeedState> state = point.feed.state();
                        append(cells,
                               {point.feed.effective(), point.feed.margin(), hasGap ? Cell(gap->gap) : Cell(),
                                point.feed.roundTrips, state ? Cell(name(*state)) : Cell()});
                        return cells;
                    }});
}

}  // namespace drillwave
