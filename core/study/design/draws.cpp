// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/draws.h"

#include "core/model/parameter.h"
#include "core/study/rows/table_header.h"
#include "core/text/csv.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

constexpr std::size_t mostMessages = 20;

void readHeader(const TableHeader& header, const std::string& place, ReadDraws& read) {
    for (const HeaderRemark& problem : header.problems)
        read.invalid.push_back(place + ": " +
                               (problem.column > 0 ? "column " + std::to_string(problem.column) + " " : "") +
                               problem.text);
    if (!read.invalid.empty()) return;
    for (const CaseColumn& column : header.columns) {
        if (column.kind == CaseColumn::Kind::parameter && !column.parameter->rules.wholeNumber) {
            read.draws.parameters.push_back(column.parameter);
            continue;
        }
        const bool isKnown = column.kind != CaseColumn::Kind::other;
        read.invalid.push_back(place + ": column `" + shortened(column.text) + "` is " +
                               (isKnown ? "no number that can be uncertain" : "not a parameter") +
                               "; leave it out of the draws");
    }
    if (const auto pair = header.assignments().rivals(); pair && read.invalid.empty())
        read.invalid.push_back(place + ": " + std::string(header.columns[pair->one].key()) + " and " +
                               std::string(header.columns[pair->other].key()) + " " + pair->problem +
                               "; leave out one of them");
    read.draws.columns.resize(read.draws.parameters.size());
}

void readCell(const CaseColumn& column, const std::string& cell, const std::string& place, ReadDraws& read,
              double& value) {
    const Parameter& parameter = *column.parameter;
    if (trimmed(cell).empty()) {
        read.unreadable.push_back(place + ": the cell of " + std::string(parameter.key) +
                                  " is missing; every draw needs a value of every key");
        return;
    }
    const TypedQuantity typed =
        parseQuantity(cell, parameter.quantity, column.unit ? BareNumber::inDefaultUnit : BareNumber::refused,
                      column.unit ? column.unit : &parameter.displayUnit());
    value = typed.si;
    const Message problem = typed.valid() ? rangeProblem(parameter, typed.si) : typed.problem;
    if (!problem.isEmpty())
        read.invalid.push_back(place + ": " + std::string(parameter.key) + " = " + shortened(cell) + " (" +
                               problem.text() + ")");
}

}  // namespace

ReadDraws readDraws(std::istream& table, const std::string& source) {
    ReadDraws read;
    CsvReader reader(table);
    CsvRecord record;
    if (!reader.next(record)) {
        read.unreadable.push_back(source + ": has no header; write the keys into the first row");
        return read;
    }
    const auto place = [&] { return source + ":" + std::to_string(reader.line()); };
    const TableHeader header = readTableHeader(record.cells, {});
    readHeader(header, place(), read);
    if (!read.invalid.empty()) return read;
    std::vector<double> values(header.columns.size());
    while (reader.next(record) && read.unreadable.size() + read.invalid.size() < mostMessages) {
        if (!record.problem.empty() || record.cells.size() != values.size()) {
            read.unreadable.push_back(place() + ": " +
                                      (record.problem.empty()
                                           ? "has " + std::to_string(record.cells.size()) +
                                                 " cells, the header has " + std::to_string(values.size())
                                           : record.problem));
            continue;
        }
        for (std::size_t i = 0; i < values.size(); ++i)
            readCell(header.columns[i], record.cells[i], place() + ":" + std::to_string(i + 1), read,
                     values[i]);
        if (read.draws.rows() == mostDraws) {
            read.unreadable.push_back(source + ": has more than " + std::to_string(mostDraws) +
                                      " rows; leave some out");
            break;
        }
        for (std::size_t i = 0; i < values.size(); ++i) read.draws.columns[i].push_back(values[i]);
    }
    if (read.unreadable.empty() && read.invalid.empty() && read.draws.rows() == 0)
        read.unreadable.push_back(source + ": has no rows of draws");
    return read;
}

}  // namespace drillwave
