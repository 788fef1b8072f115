// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/sample_guess.h"

#include <algorithm>

#include "core/text/name_text.h"

namespace drillwave {
namespace {

/// Only for what needs a number: hasRate says whether the table states it.
constexpr double placeholderInterval = 1e-6;

bool saysTime(const TableColumn& column) {
    return column.isStamp || findTimeUnit(column.unit) || isTimeName(column.name);
}

bool nameHas(const TableColumn& column, std::initializer_list<std::string_view> words) {
    const std::string name = lowerCase(column.name);
    return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != name.npos; });
}

bool saysStrain(const TableColumn& column) {
    return nameHas(column, {"strain", "dehnung", "t\u00f6jning"});
}

bool saysSignal(const TableColumn& column) {
    return saysStrain(column) || column.name == "F" || column.name == "N" ||
           nameHas(column, {"force", "kraft", "load", "stress", "spannung", "volt", "gauge"});
}

std::optional<std::size_t> timeColumn(const std::vector<TableColumn>& columns) {
    std::optional<std::size_t> first, index;
    std::size_t count = 0;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].isStamp) return i;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!columns[i].isNumeric) continue;
        if (saysTime(columns[i])) return i;
        if (columns[i].isIndex) {
            index = i;
            continue;
        }
        if (count++ == 0 && !findSignalUnit(columns[i].unit)) first = i;
    }
    // Whole numbers that count on may be times where there is no heading; below a name they are an index, and
    // no other column is taken for times that does not say so.
    if (index && (!first || *index < *first)) {
        const bool isNameless =
            std::ranges::all_of(columns, [](const TableColumn& column) { return column.name.empty(); });
        return isNameless ? index : std::nullopt;
    }
    return count > 1 ? first : std::nullopt;
}

/// How much speaks for a column as the signal.
int rank(const TableColumn& column) {
    if (column.isIndex) return 0;
    if (findSignalUnit(column.unit)) return 4;
    if (!column.unit.empty()) return 1;  // of another quantity
    return saysSignal(column) ? 3 : 2;
}

}  // namespace

SignalKind likelyKind(const TableColumn& column) {
    return saysStrain(column) ? SignalKind::strain : SignalKind::force;
}

std::optional<double> statedTimeUnit(const TableColumn& column) {
    return column.isStamp ? std::optional(1.0) : findTimeUnit(column.unit);
}

std::optional<NamedSignalUnit> statedUnit(const TableColumn& column) {
    return findSignalUnit(column.unit);
}

SampleGuess guessedSource(const DetectedTable& table) {
    SampleGuess guess;
    guess.source.format = table.format;
    guess.source.firstLine = table.firstLine;
    guess.source.interval = table.rate ? 1 / *table.rate : placeholderInterval;
    guess.hasRate = table.rate.has_value();
    guess.source.timeColumn = timeColumn(table.columns);
    if (guess.source.timeColumn) {
        const std::optional<double> unit = statedTimeUnit(table.columns[*guess.source.timeColumn]);
        guess.hasTimeUnit = unit.has_value();
        guess.source.timeUnit = unit.value_or(1);
    }
    int best = -1;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (!table.columns[i].isNumeric || guess.source.timeColumn == i) continue;
        const int now = rank(table.columns[i]);
        if (now == best) ++guess.rivals;
        if (now <= best) continue;
        best = now;
        guess.rivals = 0;
        guess.source.valueColumn = i;
    }
    if (best == 0 && guess.rivals > 0) guess.rivals = 0;
    if (guess.source.valueColumn < table.columns.size())
        guess.unit = statedUnit(table.columns[guess.source.valueColumn]);
    return guess;
}

}  // namespace drillwave
