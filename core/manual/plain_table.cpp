// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/plain_table.h"

#include <algorithm>
#include <numeric>

#include "core/manual/inline_text.h"
#include "core/text/text_layout.h"

namespace drillwave {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t between = 2;       // blanks between two columns
constexpr std::size_t leastColumn = 12;  // a wide column is not made narrower than that

std::vector<std::size_t> naturalWidths(std::span<const Row> rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const Row& row : rows)
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths[i] = std::max(widths[i], columnsOf(withoutMarks(row[i])));
    return widths;
}

// The widest ones give way, until all fit.
std::vector<std::size_t> fittedWidths(std::span<const Row> rows, std::size_t width) {
    std::vector<std::size_t> widths = naturalWidths(rows);
    std::size_t total = std::accumulate(widths.begin(), widths.end(), between * (widths.size() - 1));
    while (total > width) {
        const auto widest = std::ranges::max_element(widths);
        if (*widest <= leastColumn) break;
        --*widest;
        --total;
    }
    return widths;
}

std::string line(std::span<const std::vector<std::string>> cells, std::size_t at,
                 std::span<const std::size_t> widths) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string part = at < cells[i].size() ? cells[i][at] : std::string();
        text += part;
        const std::size_t columns = columnsOf(part);
        if (i + 1 < cells.size())
            text += std::string(between + (widths[i] > columns ? widths[i] - columns : 0), ' ');
    }
    while (text.ends_with(' ')) text.pop_back();
    return text + "\n";
}

}  // namespace

std::string plainTable(std::span<const Row> rows, std::size_t width) {
    if (rows.empty()) return {};
    const std::vector<std::size_t> widths = fittedWidths(rows, width);
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<std::vector<std::string>> cells;
        std::size_t height = 1;
        for (std::size_t column = 0; column < widths.size(); ++column) {
            cells.push_back(wrapped(withoutMarks(rows[i][column]), widths[column]));
            height = std::max(height, cells.back().size());
        }
        for (std::size_t at = 0; at < height; ++at) text += line(cells, at, widths);
        if (i > 0) continue;
        std::vector<std::vector<std::string>> rule;
        for (const std::size_t columns : widths) rule.push_back({std::string(columns, '-')});
        text += line(rule, 0, widths);
    }
    return text;
}

}  // namespace drillwave
