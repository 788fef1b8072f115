// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a table of a study, named once, and how its rows are written for people, as CSV and as JSON.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/report_table.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// How a number is shown in the table.
enum class NumberStyle { error, time, count, factor, order };

/// For people; "-" for none.
std::string shownNumber(double value, NumberStyle form, const ReadingStyle& style = plainStyle());

template <class Row>
struct StudyColumn {
    std::string_view key;    ///< JSON key and CSV column
    std::string_view title;  ///< in a table for people; empty: not there
    NumberStyle style;
    double (*value)(const Row&);  ///< not a number: none
};

/// Behind the heading of what comes first.
std::vector<std::string> withTitles(std::string first, const auto& columns,
                                    const ReadingStyle& style = plainStyle()) {
    std::vector<std::string> titles{std::move(first)};
    for (const auto& column : columns)
        if (!column.title.empty()) titles.push_back(style.said(Message::ofTable(column.title)));
    return titles;
}

/// Behind what the row is called.
std::vector<std::string> withCells(std::string first, const auto& columns, const auto& row,
                                   const ReadingStyle& style = plainStyle()) {
    std::vector<std::string> cells{std::move(first)};
    for (const auto& column : columns)
        if (!column.title.empty()) cells.push_back(shownNumber(column.value(row), column.style, style));
    return cells;
}

/// Appends the headers of the columns in CSV.
void appendKeys(std::vector<std::string>& headers, const auto& columns) {
    for (const auto& column : columns) headers.emplace_back(column.key);
}

/// Appends the cells of a row; empty where there is no number, as all are of what was not solved.
void appendCells(Cells& cells, const auto& columns, const auto& row, bool isSolved = true) {
    for (const auto& column : columns) cells.push_back(isSolved ? Cell(column.value(row)) : Cell());
}

/// Adds members to a row in JSON, null where there is no number.
void addMembers(JsonObject& object, const auto& columns, const auto& row, bool isSolved = true) {
    for (const auto& column : columns) object[column.key] = isSolved ? Json(column.value(row)) : Json();
}

}  // namespace drillwave
