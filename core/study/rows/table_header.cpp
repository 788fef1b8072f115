// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/table_header.h"

#include <algorithm>
#include <optional>

#include "core/model/parameter_text.h"
#include "core/text/decimal_text.h"
#include "core/text/text_input.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

bool isOutput(std::string_view name) {
    const auto names = outputNames();
    return std::ranges::find(names, name) != names.end();
}

/// A name without what people and spreadsheets write differently: case, dots, underscores, hyphens, blanks,
/// and a unit in parentheses.
std::string bare(std::string_view name) {
    std::string letters;
    for (const char c : name.substr(0, name.find('('))) {
        if (c >= 'A' && c <= 'Z')
            letters += static_cast<char>(c - 'A' + 'a');
        else if (std::string_view("._- \t").find(c) == std::string_view::npos)
            letters += c;
    }
    return letters;
}

/// The key that is meant by a name that is almost it; empty when there is none.
std::string meantKey(std::string_view name) {
    const std::string wanted = bare(name);
    for (const WordParameter& word : wordParameters())
        if (wanted == bare(word.key)) return std::string(word.key);
    const auto found =
        std::ranges::find_if(parameters(), [&](const Parameter& p) { return bare(p.key) == wanted; });
    if (found != parameters().end()) return std::string(found->key);
    // Of a section: names keep their blanks.
    std::string small(name);
    for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return findParameter(small) ? small : std::string();
}

/// The character that holds keys together in one cell, as spreadsheets of some countries write it.
std::optional<char> otherSeparator(std::string_view cell) {
    for (const char separator : {';', '\t'}) {
        for (std::string_view rest = cell; rest.find(separator) != std::string_view::npos;) {
            const std::size_t at = rest.find(separator);
            if (!meantKey(splitHeading(rest.substr(0, at)).name).empty()) return separator;
            rest.remove_prefix(at + 1);
            if (!meantKey(splitHeading(rest.substr(0, rest.find(separator))).name).empty()) return separator;
        }
    }
    return std::nullopt;
}

const char* wrongSeparator(char separator) {
    return separator == '\t' ? translatable(
                                   "cells are separated by tabs, not by `,`; save the table with "
                                   "`,` between them and `.` in numbers")
                             : translatable(
                                   "cells are separated by `;`, not by `,`; save the table with `,` "
                                   "between them and `.` in numbers");
}

/// The beginning of keys that a name has, "rod.": nothing but a key of theirs is meant by it.
std::string_view groupOf(std::string_view name) {
    const std::string_view group = name.substr(0, name.find('.') + 1);
    const auto isOf = [&](const Parameter& parameter) { return parameter.key.starts_with(group); };
    return group == "string." || (!group.empty() && std::ranges::any_of(parameters(), isOf))
               ? group
               : std::string_view();
}

Message misspelt(std::string_view name, std::string_view group) {
    const std::string near = nearestKey(name), others = std::string(group) + "…";
    if (near.empty())
        return {translatable("`%1` is not a parameter; write a known key, or another name than `%2` for a "
                             "column that is only passed through"),
                {shortened(name), others}};
    return {translatable("`%1` is not a parameter; did you mean `%2`? A column that is only passed through "
                         "needs another name than `%3`"),
            {shortened(name), near, others}};
}

/// Why a column that is none of a parameter may not just be passed through; empty when it may.
Message misnamed(std::string_view cell, std::string_view name) {
    if (const TextProblem problem = checkText(cell); !problem.reason.empty())
        return {translatable("has %1; save the table as CSV in UTF-8"), {Message::ofTable(problem.reason)}};
    if (const auto separator = otherSeparator(cell)) return wrongSeparator(*separator);
    if (name == restrikeKey)
        return {translatable("`%1` is no number; give it with --set for all rows"), {std::string(name)}};
    const std::string key = meantKey(name);
    if (const std::string_view group = groupOf(name); key.empty() && !group.empty())
        return misspelt(name, group);
    if (key.empty()) return {};
    const bool unitInParentheses = name.find('(') != std::string_view::npos;
    return {unitInParentheses
                ? translatable("`%1` is not a parameter; write `%2`, with its unit in square brackets, or "
                               "another name for a column that is only passed through")
                : translatable("`%1` is not a parameter; write `%2`, or another name for a column that is "
                               "only passed through"),
            {shortened(name), key}};
}

Message passedThrough(std::string_view name) {
    const std::string near = nearestKey(name);
    if (near.empty())
        return {translatable("`%1` is not a parameter and only passed through"), {shortened(name)}};
    return {translatable("`%1` is not a parameter and only passed through; did you mean `%2`?"),
            {shortened(name), near}};
}

void readUnit(CaseColumn& column, std::string_view unit, std::size_t number, TableHeader& header) {
    if (unit.empty()) return;
    const Quantity quantity = column.parameter->quantity;
    column.unit = findUnit(quantity, unit);
    if (column.unit) return;
    const std::string key(column.key());
    header.problems.push_back(
        {number,
         quantity == Quantity::ratio
             ? Message(translatable("%1 has no unit; write it without `[%2]`"), {key, shortened(unit)})
             : Message(translatable("%1: unit `%2` is not known here; allowed units: %3"),
                       {key, shortened(unit), unitList(quantity)})});
}

void checkTwice(const CaseColumn& column, std::size_t number, TableHeader& header) {
    const auto earlier = std::ranges::find(header.columns, column.key(), &CaseColumn::key);
    if (earlier == header.columns.end()) return;
    header.problems.push_back(
        {number,
         {translatable("sets %1, which column %2 also sets; keep one of them"),
          {std::string(column.key()), std::to_string(earlier - header.columns.begin() + 1)}}});
}

/// A column that sets nothing.
void judgeOther(std::string_view cell, std::size_t number, std::span<const OutputColumn> outputs,
                TableHeader& header) {
    const std::string_view name = splitHeading(cell).name;
    if (Message problem = misnamed(cell, name); !problem.isEmpty())
        header.problems.push_back({number, std::move(problem)});
    else if (std::ranges::find(outputs, trimmed(cell), &OutputColumn::header) != outputs.end())
        header.warnings.push_back(
            {number,
             {translatable(
                  "`%1` is passed through unchanged; the computed column with the same name follows"),
              {shortened(trimmed(cell))}}});
    else if (!isOutput(name))
        header.warnings.push_back({number, passedThrough(name)});
}

void checkSetsSomething(TableHeader& header) {
    const auto sets = [](const CaseColumn& column) { return column.kind != CaseColumn::Kind::other; };
    if (!header.problems.empty() || std::ranges::any_of(header.columns, sets)) return;
    header.problems.push_back(
        {0, translatable("no column is a parameter, so every row would be the same blow; name parameters in "
                         "the first row, such as `beta` or `rod.length [m]`")});
}

}  // namespace

std::string_view CaseColumn::key() const {
    if (kind == Kind::word) return words->key;
    return kind == Kind::parameter ? parameter->key : std::string_view();
}

Assignments TableHeader::assignments() const {
    Assignments assignments;
    for (const CaseColumn& column : columns)
        column.kind == CaseColumn::Kind::other ? assignments.skip() : assignments.add(column.key());
    return assignments;
}

TableHeader readTableHeader(std::span<const std::string> cells, std::span<const OutputColumn> outputs) {
    TableHeader header;
    for (const std::string& cell : cells) {
        const std::size_t number = header.columns.size() + 1;
        const auto [name, unit] = splitHeading(cell);
        CaseColumn column{.text = cell};
        column.parameter = findParameter(name);
        if (column.parameter)
            column.kind = CaseColumn::Kind::parameter;
        else if ((column.words = findWordParameter(name)))
            column.kind = CaseColumn::Kind::word;
        else
            judgeOther(cell, number, outputs, header);
        if (column.parameter) readUnit(column, unit, number, header);
        if (column.kind != CaseColumn::Kind::other) checkTwice(column, number, header);
        header.columns.push_back(std::move(column));
    }
    checkSetsSomething(header);
    return header;
}

}  // namespace drillwave
