// SPDX-License-Identifier: GPL-3.0-or-later
// Table of correlated parameter values, such as the result of identifying a rock from measurements.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include "core/model/parameter.h"
#include "core/text/message.h"

namespace drillwave {

/// Maximum number of rows of a table of correlated values.
inline constexpr std::size_t mostDraws = 1'000'000;

/// Table of correlated parameter values. Each row is a possible set of values; all rows are equally likely.
struct Draws {
    std::vector<KeptParameter> parameters;
    std::vector<std::vector<double>> columns;  ///< values in SI units, indexed [parameter][row]
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    bool operator==(const Draws&) const = default;
};

/// Table of correlated parameter values read from a file, or the reasons why it could not be read.
struct ReadDraws {
    Draws draws;
    /// Errors of the file, such as missing cells or rows, each with its position: "posterior.csv:7: …".
    std::vector<Message> unreadable;
    std::vector<Message> invalid;  ///< columns and values that are not valid for any parameter
};

/// Returns the table of correlated values read from CSV text. The header has parameter keys with units, as
/// `drillwave table` requires. `source` is the name of the file for messages. At most twenty messages are
/// returned.
ReadDraws readDraws(std::istream& table, const std::string& source);

}  // namespace drillwave
