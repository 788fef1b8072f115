// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a study's table, and how its rows are written for people, as CSV and as JSON.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/report_table.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// Kind of a number in a table for people, which selects its format: numerical error, time [s], count,
/// factor, or order of convergence.
enum class NumberStyle { error, time, count, factor, order };

/// Returns a number as text for people; "-" if it is NaN.
std::string shownNumber(double value, NumberStyle form, const ReadingStyle& style = plainStyle());

/// Column of a study's table, whose rows have the type Row.
template <class Row>
struct StudyColumn {
    std::string_view key;    ///< JSON key and name of the CSV column
    std::string_view title;  ///< heading in the table for people; empty if the column is not shown there
    NumberStyle style;
    double (*value)(const Row&);  ///< function that returns the number of a row; NaN if there is none
};

/// Returns the headings of a table for people: `first`, then the titles of all columns that have one.
std::vector<std::string> withTitles(std::string first, const auto& columns,
                                    const ReadingStyle& style = plainStyle()) {
    std::vector<std::string> titles{std::move(first)};
    for (const auto& column : columns)
        if (!column.title.empty()) titles.push_back(style.said(Message::ofTable(column.title)));
    return titles;
}

/// Returns the cells of one row of a table for people: `first`, then the number of every column that has a
/// title.
std::vector<std::string> withCells(std::string first, const auto& columns, const auto& row,
                                   const ReadingStyle& style = plainStyle()) {
    std::vector<std::string> cells{std::move(first)};
    for (const auto& column : columns)
        if (!column.title.empty()) cells.push_back(shownNumber(column.value(row), column.style, style));
    return cells;
}

/// Appends the CSV headers of the columns to `headers`.
void appendKeys(std::vector<std::string>& headers, const auto& columns) {
    for (const auto& column : columns) headers.emplace_back(column.key);
}

/// Appends the CSV cells of a row. Missing numbers are empty cells, as are all cells of a row that was not
/// solved.
void appendCells(Cells& cells, const auto& columns, const auto& row, bool isSolved = true) {
    for (const auto& column : columns) cells.push_back(isSolved ? Cell(column.value(row)) : Cell());
}

/// Adds the numbers of a row to a JSON object, one member per column. A number is null if it is missing or if
/// the row was not solved.
void addMembers(JsonObject& object, const auto& columns, const auto& row, bool isSolved = true) {
    for (const auto& column : columns) object[column.key] = isSolved ? Json(column.value(row)) : Json();
}

}  // namespace drillwave
