// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that the paper prints and that can be computed, beside what it really is.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// A number printed in the paper.
struct Discrepancy {
    std::string place;        ///< where in the paper
    std::string quantity;     ///< name of the quantity
    std::string printed;      ///< as printed, its digits telling how exact it is meant to be
    double computed = 0;      ///< NaN if it could not be computed
    std::string explanation;  ///< reason for a difference, or another remark; may be empty

    double printedValue() const;
    double difference() const { return computed - printedValue(); }
    /// Within half a unit of the last printed digit.
    bool agrees() const;
};

/// Returns them in the order of the paper. Fewer if a stop is requested.
std::vector<Discrepancy> discrepancies(std::stop_token stop = {});

/// place, quantity, printed, computed, difference, agrees, explanation.
std::string discrepanciesCsv(const std::vector<Discrepancy>& all);

}  // namespace drillwave
