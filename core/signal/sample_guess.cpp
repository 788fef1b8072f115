// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/sample_guess.h"

#include "core/text/lower_case.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

/// Without a time column nothing tells the rate: a common one.
constexpr double usualInterval = 1e-6;

/// Of a table without a header: a record of milliseconds would be one of seconds.
bool saysNothing(const TableColumn& column) {
    return column.name.empty() && column.unit.empty();
}

bool saysTime(const TableColumn& column) {
    return findUnit(Quantity::time, column.unit) || isTimeName(column.name);
}

bool saysStrain(const TableColumn& column) {
    const std::string name = lowerCase(column.name);
    return name.find("strain") != std::string::npos || name.find("dehnung") != std::string::npos;
}

std::optional<std::size_t> timeColumn(const std::vector<TableColumn>& columns) {
    std::optional<std::size_t> first;
    std::size_t count = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].isNumeric) continue;
        if (saysTime(columns[i])) return i;
        if (count++ == 0) first = i;
    }
    return count > 1 ? first : std::nullopt;
}

std::size_t valueColumn(const std::vector<TableColumn>& columns, std::optional<std::size_t> time) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].isNumeric || time == i) continue;
        if (findSignalUnit(columns[i].unit)) return i;
        if (!first) first = i;
    }
    return first.value_or(0);
}

}  // namespace

std::optional<double> guessedTimeUnit(const TableColumn& column) {
    if (saysNothing(column)) return std::nullopt;
    if (column.unit.empty()) return 1;
    const Unit* unit = findUnit(Quantity::time, column.unit);
    return unit ? std::optional(unit->factor()) : std::nullopt;
}

std::optional<NamedSignalUnit> guessedUnit(const TableColumn& column) {
    if (saysNothing(column)) return std::nullopt;
    if (!column.unit.empty()) return findSignalUnit(column.unit);
    const SignalKind kind = saysStrain(column) ? SignalKind::strain : SignalKind::force;
    return NamedSignalUnit{kind, signalUnits(kind).front()};
}

SampleGuess guessedSource(const DetectedTable& table) {
    SampleGuess guess;
    guess.source.format = table.format;
    guess.source.firstLine = table.firstLine;
    guess.source.interval = usualInterval;
    guess.source.timeColumn = timeColumn(table.columns);
    if (guess.source.timeColumn)
        guess.source.timeUnit = guessedTimeUnit(table.columns[*guess.source.timeColumn]).value_or(1);
    guess.source.valueColumn = valueColumn(table.columns, guess.source.timeColumn);
    if (guess.source.valueColumn < table.columns.size())
        guess.unit = guessedUnit(table.columns[guess.source.valueColumn]);
    return guess;
}

}  // namespace drillwave
