// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/draws.h"

#include "core/model/parameter.h"
#include "core/signal/case_records.h"
#include "core/study/rows/table_header.h"
#include "core/study/rows/table_row.h"
#include "core/text/csv.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

constexpr std::size_t mostMessages = 20;

void readHeader(const TableHeader& header, const std::string& place, ReadDraws& read) {
    for (const HeaderRemark& problem : header.problems)
        read.invalid.push_back(about(
            place, problem.column > 0
                       ? Message(translatable("column %1 %2"), {std::to_string(problem.column), problem.text})
                       : problem.text));
    if (!read.invalid.empty()) return;
    for (const CaseColumn& column : header.columns) {
        if (column.kind == CaseColumn::Kind::parameter && !column.parameter->rules.wholeNumber) {
            read.draws.parameters.push_back(column.parameter);
            continue;
        }
        const bool isKnown = column.kind != CaseColumn::Kind::other;
        read.invalid.push_back(about(
            place, {isKnown ? translatable("column `%1` is not a number that can be uncertain; leave it out")
                            : translatable("column `%1` is not a parameter; leave it out"),
                    {shortened(column.text)}}));
    }
    if (const auto pair = header.assignments().rivals(); pair && read.invalid.empty())
        read.invalid.push_back(
            about(place, {translatable("%1 and %2 %3; leave out one of them"),
                          {std::string(header.columns[pair->one].key()),
                           std::string(header.columns[pair->other].key()), pair->problem}}));
    read.draws.columns.resize(read.draws.parameters.size());
}

void readCell(const CaseColumn& column, const std::string& cell, const std::string& place, ReadDraws& read,
              double& value) {
    const Parameter& parameter = *column.parameter;
    if (trimmed(cell).empty()) {
        read.unreadable.push_back(
            about(place, {translatable("the cell of %1 is missing; every draw needs a value of every key"),
                          {std::string(parameter.key)}}));
        return;
    }
    const TypedQuantity typed =
        parseQuantity(cell, parameter.quantity, column.unit ? BareNumber::inDefaultUnit : BareNumber::refused,
                      column.unit ? column.unit : &parameter.displayUnit());
    value = typed.si;
    const Message problem = typed.valid() ? rangeProblem(parameter, typed.si) : typed.problem;
    if (!problem.isEmpty()) read.invalid.push_back(about(place, refusedValue(parameter.key, cell, problem)));
}

}  // namespace

ReadDraws readDraws(std::istream& table, const std::string& source) {
    ReadDraws read;
    CaseRecords reader(table);
    CsvRecord record;
    if (!reader.next(record)) {
        read.unreadable.push_back(
            about(source, translatable("has no header; write the keys into the first row")));
        return read;
    }
    const auto place = [&] { return source + ":" + std::to_string(reader.line()); };
    const TableHeader header = readTableHeader(record.cells, {});
    readHeader(header, place(), read);
    if (!read.invalid.empty()) return read;
    std::vector<double> values(header.columns.size());
    while (reader.next(record) && read.unreadable.size() + read.invalid.size() < mostMessages) {
        if (!record.problem.isEmpty() || record.cells.size() != values.size()) {
            read.unreadable.push_back(
                about(place(), record.problem.isEmpty() ? cellCountProblem(record.cells.size(), values.size())
                                                        : record.problem));
            continue;
        }
        for (std::size_t i = 0; i < values.size(); ++i)
            readCell(header.columns[i], record.cells[i], place() + ":" + std::to_string(i + 1), read,
                     values[i]);
        if (read.draws.rows() == mostDraws) {
            read.unreadable.push_back(about(source, {translatable("has more than %1 rows; leave some out"),
                                                     {std::to_string(mostDraws)}}));
            break;
        }
        for (std::size_t i = 0; i < values.size(); ++i) read.draws.columns[i].push_back(values[i]);
    }
    if (read.unreadable.empty() && read.invalid.empty() && read.draws.rows() == 0)
        read.unreadable.push_back(about(source, translatable("has no rows of draws")));
    return read;
}

}  // namespace drillwave
