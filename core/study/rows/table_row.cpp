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
Message textProblem(std::string_view cell) {
    const auto isPlain = [](char c) { return c >= 0x20 && c < 0x7F; };
    if (std::ranges::all_of(cell, isPlain)) return {};
    const TextProblem problem = checkText(cell);
    if (problem.reason.empty()) return {};
    return {translatable("has %1; save the table in UTF-8"), {Message::ofTable(problem.reason)}};
}

/// A reader of the result takes the unit of the header for that of every cell.
Message unitProblem(const CaseColumn& column, std::string_view cell) {
    if (!column.unit) return {};
    cell = trimmed(cell);
    if (numberLength(cell) == cell.size()) return {};
    const TypedQuantity typed =
        parseQuantity(cell, column.parameter->quantity, BareNumber::inDefaultUnit, column.unit);
    if (!typed.valid() || typed.unit == column.unit) return {};
    return refusedValue(
        column.key(), cell,
        {translatable("is in %1, the column in %2: write it in that, or the header without a unit"),
         {std::string(typed.unit->name), std::string(column.unit->name)}});
}

}  // namespace

Message cellCountProblem(std::size_t cells, std::size_t columns) {
    return {translatable("has %1 cells, the header has %2"),
            {std::to_string(cells), std::to_string(columns)}};
}

TableRowAssigner::TableRowAssigner(const Scenario& base, const std::string& source, const TableHeader& header)
    : m_base(base),
      m_source(source),
      m_header(header),
      m_assignments(header.assignments()),
      m_scenario(base) {}

std::vector<Message> TableRowAssigner::assign(const CsvRecord& row, int line) {
    std::vector<Message> problems = assignCells(row, line);
    if (!problems.empty()) return problems;
    for (const InputProblem& problem : validate(m_scenario))
        problems.push_back(about(place(line), problem.text));
    return problems;
}

std::vector<Message> TableRowAssigner::assignCells(const CsvRecord& row, int line) {
    const std::vector<std::string>& cells = row.cells;
    if (!row.problem.isEmpty()) return {about(place(line), row.problem)};
    if (cells.size() != m_header.columns.size())
        return {about(place(line), cellCountProblem(cells.size(), m_header.columns.size()))};
    std::vector<Message> problems;
    const auto add = [&](std::size_t i, const Message& problem) {
        if (!problem.isEmpty()) problems.push_back(about(place(line) + ":" + std::to_string(i + 1), problem));
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

Message TableRowAssigner::assignCell(const CaseColumn& column, const std::string& cell) {
    if (Message problem = unitProblem(column, cell); !problem.isEmpty()) return problem;
    return column.parameter ? assignText(m_scenario, *column.parameter, cell, column.unit)
                            : assignText(m_scenario, column.key(), cell);
}

Message TableRowAssigner::rivalText(const RivalPair& pair) const {
    return {translatable("%1 and %2 %3; leave one of the two cells empty"),
            {std::string(m_header.columns[pair.other].key()), std::string(m_header.columns[pair.one].key()),
             pair.problem}};
}

}  // namespace drillwave
