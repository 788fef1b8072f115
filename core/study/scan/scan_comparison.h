// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the value of a scan with the best penetration rate, considering the errors.
#pragma once

#include <optional>
#include <vector>

#include "core/study/drilling/sequence.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// Comparison of the sequences of a scan that start from rest, by their penetration rates.
struct ScanComparison {
    struct Entry {
        double at = 0;  ///< value of the parameter, in SI units
        Sequence sequence;
    };
    std::vector<Entry> entries;  ///< sequences with statistics, in the order of the values; never empty
    std::size_t bestPlace = 0;   ///< index of the entry with the largest penetration rate
    /// Entry that may be the best one, because its mean penetration rate is too uncertain (see
    /// Sequence::isResolved()). Empty if the choice of the best entry is certain.
    std::optional<Entry> unresolved;

    const Entry& best() const { return entries[bestPlace]; }
    bool isResolved() const { return !unresolved; }
    /// Returns whether the penetration rate of a sequence is lower than the best by more than the errors of
    /// both.
    bool isLower(const Sequence& sequence) const;
    /// Returns whether any entry has a penetration rate lower than that of best() by more than the errors of
    /// both.
    bool isAnyLower() const;
    /// Returns the penetration rate of a sequence of blows divided by that of the best entry. Empty if it is
    /// uncertain which entry is best, or if the mean of the sequence is uncertain. See isResolved() of
    /// ScanComparison and of Sequence.
    std::optional<double> bestShare(const Sequence& sequence) const;
};

/// Returns which value of a scan has the highest penetration rate, with the errors considered. Empty if no
/// sequence of the scan that starts from rest has statistics.
std::optional<ScanComparison> compareScan(const DrillingScan& scan);

}  // namespace drillwave
