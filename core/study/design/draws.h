// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of values that belong together, as an identification of a rock leaves them.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include "core/model/parameter.h"
#include "core/text/message.h"

namespace drillwave {

/// Most rows.
inline constexpr std::size_t mostDraws = 1'000'000;

/// Rows of which one is true, with equal probability: the columns vary together.
struct Draws {
    std::vector<KeptParameter> parameters;
    std::vector<std::vector<double>> columns;  ///< SI, of each parameter
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    bool operator==(const Draws&) const = default;
};

/// Draws read from a table, or why not.
struct ReadDraws {
    Draws draws;
    std::vector<Message> unreadable;  ///< cells missing, no rows, no text: "posterior.csv:7: …"
    std::vector<Message> invalid;     ///< columns and values that no parameter takes
};

/// Reads a CSV table with a header of keys and units, as of `drillwave table`; `source` names it in messages,
/// of which there are at most twenty.
ReadDraws readDraws(std::istream& table, const std::string& source);

}  // namespace drillwave
