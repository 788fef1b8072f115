// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/table_row.h"

#include <algorithm>

#include "core/model/parameter_text.h"
#include "core/model/validation.h"
#include "core/text/decimal_text.h"
#include "core/text/text_input.h"

namespace drillwave {

namespace {

/// Cells go into the result as they are: what is no text must not.
std::string textProblem(std::string_view cell) {
    const auto isPlain = [](char c) { return c >= 0x20 && c < 0x7F; };
    if (std::ranges::all_of(cell, isPlain)) return {};
    const TextProblem problem = checkText(cell);
    return problem.reason.empty() ? std::string() : "has " + problem.reason + "; save the table in UTF-8";
}

/// A reader of the result takes the unit of the header for that of every cell.
std::string unitProblem(const CaseColumn& column, std::string_view cell) {
    if (!column.unit) return {};
    cell = trimmed(cell);
    if (numberLength(cell) == cell.size()) return {};
    const TypedQuantity typed =
        parseQuantity(cell, column.parameter->quantity, BareNumber::inDefaultUnit, column.unit);
    if (!typed.valid() || typed.unit == column.unit) return {};
    return std::string(column.key()) + " = " + shortened(cell) + " (is in " + std::string(typed.unit->name) +
           ", the column in " + std::string(column.unit->name) +
           ": write it in that, or the header without a unit)";
}

}  // namespace

TableRowAssigner::TableRowAssigner(const Scenario& base, const std::string& source, const TableHeader& header)
    : m_base(base),
      m_source(source),
      m_header(header),
      m_assignments(header.assignments()),
      m_scenario(base) {}

std::vector<std::string> TableRowAssigner::assign(const CsvRecord& row, int line) {
    std::vector<std::string> problems = assignCells(row, line);
    if (!problems.empty()) return problems;
    for (const InputProblem& problem : validate(m_scenario))
        problems.push_back(place(line) + ": " + problem.text.text());
    return problems;
}

std::vector<std::string> TableRowAssigner::assignCells(const CsvRecord& row, int line) {
    const std::vector<std::string>& cells = row.cells;
    if (!row.problem.empty()) return {place(line) + ": " + row.problem};
    if (cells.size() != m_header.columns.size())
        return {place(line) + ": has " + std::to_string(cells.size()) + " cells, the header has " +
                std::to_string(m_header.columns.size())};
    std::vector<std::string> problems;
    const auto add = [&](std::size_t i, const std::string& problem) {
        if (!problem.empty()) problems.push_back(place(line) + ":" + std::to_string(i + 1) + ": " + problem);
    };
    for (std::size_t i = 0; i < cells.size(); ++i) add(i, textProblem(cells[i]));
    if (!problems.empty()) return problems;
    const auto isSet = [&](std::size_t i) { return !cells[i].empty(); };
    if (const auto pair = m_assignments.rivals(isSet)) add(pair->other, rivalText(*pair));
    m_scenario = m_base;
    for (const std::size_t i : m_assignments.order())
        if (isSet(i)) add(i, assignCell(m_header.columns[i], cells[i]));
    if (!problems.empty()) return problems;
    if (const auto pair = m_assignments.meeting(m_scenario, isSet)) add(pair->other, rivalText(*pair));
    return problems;
}

std::string TableRowAssigner::assignCell(const CaseColumn& column, const std::string& cell) {
    if (std::string problem = unitProblem(column, cell); !problem.empty()) return problem;
    return column.parameter ? assignText(m_scenario, *column.parameter, cell, column.unit)
                            : assignText(m_scenario, column.key(), cell);
}

std::string TableRowAssigner::rivalText(const RivalPair& pair) const {
    return std::string(m_header.columns[pair.other].key()) + " and " +
           std::string(m_header.columns[pair.one].key()) + " " + pair.problem +
           "; leave one of the two cells empty";
}

}  // namespace drillwave
