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
    /// First line with samples, counted from 1; after the last line if there are none.
    std::size_t firstLine = 1;
    std::vector<TableColumn> columns;
    char groups = 0;  ///< sign between groups of three digits in the table, or 0 if none was seen
    /// Whether the decimal sign is ambiguous: each number may also be a whole one with groups, "1,234".
    bool isDecimalOpen = false;
    /// Whether the table must be transposed, because each channel is a row that begins with the channel's
    /// name.
    bool hasRows = false;
    /// Sampling rate [Hz], if the table states it with its unit above or beside the samples.
    std::optional<double> rate;
    std::string rateText;  ///< text in the table that states the sampling rate, with or without a unit
    /// Sampling rate stated without a unit [Hz]; Hz is assumed, or s for a sampling interval.
    std::optional<double> bareRate;
    bool operator==(const DetectedTable&) const = default;

    bool hasSamples() const { return !columns.empty(); }
};

/// Returns the format of a table from its first lines. Separator and decimal sign are those with which most
/// cells are numbers. The samples begin at the first line from which this holds; the line before is the
/// header.
DetectedTable detectTable(std::span<const std::string> lines);

/// Returns the format of a table from its first lines, with separator and decimal sign given.
DetectedTable detectTable(std::span<const std::string> lines, RowFormat format);

/// Returns the format of a table whose samples begin at `firstLine`, counted from 1. Lines of samples before
/// it are ignored, so that the header above them is found.
DetectedTable tableFrom(std::span<const std::string> lines, RowFormat format, std::size_t firstLine);

/// Returns the index of a column, from 0, or nullopt. The column `wanted` is given by its number from 1, its
/// name with or without the unit, or a unique beginning of its name. Capitals are ignored.
std::optional<std::size_t> columnNamed(std::span<const TableColumn> columns, const std::string& wanted);

}  // namespace drillwave
