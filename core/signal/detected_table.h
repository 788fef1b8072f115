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
    /// Number of the first line with samples, counted from 1. If there are none, it is one more than the
    /// number of lines.
    std::size_t firstLine = 1;
    std::vector<TableColumn> columns;
    char groups = 0;  ///< sign between groups of three digits in the table, or 0 if none was seen
    /// Whether the decimal sign is uncertain: no number shows whether the sign in "1,234" is decimal or
    /// separates thousands.
    bool isDecimalOpen = false;
    /// Whether the table must be transposed, because each channel is a row that begins with the channel's
    /// name.
    bool hasRows = false;
    /// Sampling rate [Hz], if the table states it with its unit above or beside the samples.
    std::optional<double> rate;
    std::string rateText;  ///< text in the table that states the sampling rate, with or without a unit
    /// Sampling rate [Hz] that the table states without a unit. The number is assumed to be in Hz, or in s if
    /// it is a sampling interval.
    std::optional<double> bareRate;
    bool operator==(const DetectedTable&) const = default;

    bool hasSamples() const { return !columns.empty(); }
};

/// Returns the format of a table from its first lines. Separator and decimal sign are those with which most
/// cells are numbers. The samples begin at the first line with numbers in the same columns as most lines.
/// Names and units of the columns are from the lines above.
DetectedTable detectTable(std::span<const std::string> lines);

/// Returns the format of a table from its first lines, with separator and decimal sign given.
DetectedTable detectTable(std::span<const std::string> lines, RowFormat format);

/// Returns the format of a table whose samples begin at the given line, counted from 1. If the lines directly
/// above are numbers too, they are skipped to find the header above them.
DetectedTable tableFrom(std::span<const std::string> lines, RowFormat format, std::size_t firstLine);

/// Returns the index of a column, from 0, or nullopt. The column `wanted` is given by its number from 1, its
/// name with or without the unit, or a unique beginning of its name. Capitals are ignored.
std::optional<std::size_t> columnNamed(std::span<const TableColumn> columns, const std::string& wanted);

}  // namespace drillwave
