// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of the numbers printed in the paper with the values that the program computes.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// Number printed in the paper, with the value computed by the program.
struct Discrepancy {
    std::string place;     ///< location in the paper, such as a section or figure
    std::string quantity;  ///< name of the quantity
    std::string printed;   ///< number as printed; the number of its digits shows the intended accuracy
    /// Computed value in the unit of the printed one; NaN if it could not be computed.
    double computed = 0;
    std::string explanation;  ///< reason for a difference, or another comment; may be empty

    double printedValue() const;
    double difference() const { return computed - printedValue(); }
    /// Returns whether the computed value agrees with the printed one within half a unit of its last digit.
    bool agrees() const;
};

/// Returns all comparisons of printed and computed numbers, in the order of the paper; fewer if a stop is
/// requested.
std::vector<Discrepancy> discrepancies(std::stop_token stop = {});

/// Returns the comparisons as CSV text with the columns place, quantity, printed, computed, difference,
/// agrees and explanation.
std::string discrepanciesCsv(const std::vector<Discrepancy>& all);

}  // namespace drillwave
