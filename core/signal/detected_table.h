// SPDX-License-Identifier: GPL-3.0-or-later
// Format of a table of samples, detected from its first lines.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/signal/signal_unit.h"
#include "core/signal/table_row.h"

namespace drillwave {

struct DetectedTable {
    RowFormat format;
    std::size_t firstLine = 1;  ///< with samples, from 1; behind all lines where none has
    std::vector<TableColumn> columns;
    char groups = 0;             ///< sign between groups of three digits, where one was seen
    bool isDecimalOpen = false;  ///< each number with a sign could also be a whole one with groups: "1,234"
    bool hasRows = false;        ///< each channel is a row, its name first: the table is to be turned
    std::optional<double> rate;  ///< stated above or beside the samples [Hz], with its unit
    std::string rateText;        ///< the words that state it, or that state a rate without a unit
    std::optional<double> bareRate;  ///< stated without a unit: taken in Hz, or for an interval in s [Hz]
    bool operator==(const DetectedTable&) const = default;

    bool hasSamples() const { return !columns.empty(); }
};

/// Separator and decimal sign under which most cells are numbers; the first line from where they stay so; the
/// header before it.
DetectedTable detectTable(std::span<const std::string> lines);

/// Does the same with a given format.
DetectedTable detectTable(std::span<const std::string> lines, RowFormat format);

/// The columns of a table whose samples begin at that line; samples before it that are left out do not hide
/// the header.
DetectedTable tableFrom(std::span<const std::string> lines, RowFormat format, std::size_t firstLine);

/// Returns the place of a column by its number from 1, its name with or without the unit, or the beginning of
/// a name that no other has; case does not count.
std::optional<std::size_t> columnNamed(std::span<const TableColumn> columns, const std::string& wanted);

}  // namespace drillwave
