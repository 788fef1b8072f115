// SPDX-License-Identifier: GPL-3.0-or-later
// Every number that the paper prints and that can be computed, beside what it really is.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drillwave {

/// One printed number.
struct Discrepancy {
    std::string place;        ///< where in the paper
    std::string quantity;     ///< what it is
    std::string printed;      ///< as printed, its digits telling how exact it is meant to be
    double computed = 0;      ///< NaN if it could not be computed
    std::string explanation;  ///< why they differ, or what else there is to say; may be empty

    double printedValue() const;
    double difference() const { return computed - printedValue(); }
    /// Within half a unit of the last printed digit.
    bool agrees() const;
};

/// In the order of the paper. Fewer when a stop is requested.
std::vector<Discrepancy> discrepancies(std::stop_token stop = {});

/// place, quantity, printed, computed, difference, agrees, explanation.
std::string discrepanciesCsv(const std::vector<Discrepancy>& all);

}  // namespace drillwave
