// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_csv.h"

#include "core/text/number_text.h"

namespace drillwave {

namespace {

std::string headerOf(const ThrustAlong& along) {
    std::string header = along.axis.column().header;
    for (const char* end : {"", "_undamped"})
        for (const ThrustCase which : thrustCases) header += "," + std::string(name(which)) + end + " [N]";
    return header + ",effective_force [N],thrust_margin,gap_at_blow [m],round_trips,feed\n";
}

/// Behind the value of the parameter.
void appendCells(std::string& row, const ThrustPoint& point) {
    const auto add = [&](const std::optional<double>& number) {
        row += ',';
        if (number) appendNumber(row, *number);
    };
    const auto known = [](const ThrustNeed& need, double value) {
        return need.known ? std::optional(value) : std::nullopt;
    };
    for (const ThrustNeed& need : point.feed.needs) add(known(need, need.thrust));
    for (const ThrustNeed& need : point.feed.needs) add(known(need, need.thrustUndamped));
    add(point.feed.effective());
    add(point.feed.margin());
    const std::optional<GapAtBlow>& gap = point.need(ThrustCase::scenario).gapAtBlow;
    const bool hasGap = gap && gap->motion.kind != UndampedMotion::Kind::pushedBack;
    add(hasGap ? std::optional(gap->gap) : std::nullopt);
    add(point.feed.roundTrips);
    const std::optional<FeedState> state = point.feed.state();
    row += "," + std::string(state ? name(*state) : "");
}

}  // namespace

std::vector<double> valuesOf(const SweepAxis& axis) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < axis.count; ++i) values.push_back(axis.value(i));
    return values;
}

std::string thrustCsv(const ThrustAlong& along) {
    constexpr std::size_t columnsBehind = 2 * thrustCaseCount + 5;
    const RowColumn column = along.axis.column();
    std::string csv = headerOf(along);
    for (const ThrustPoint& point : along.curve.points) {
        column.appendText(csv, point.value);
        if (point.reason.isEmpty())
            appendCells(csv, point);
        else
            csv.append(columnsBehind, ',');
        csv += '\n';
    }
    return csv;
}

}  // namespace drillwave
