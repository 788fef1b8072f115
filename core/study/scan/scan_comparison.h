// SPDX-License-Identifier: GPL-3.0-or-later
// Which value of a scan gives the most, as far as the errors tell.
#pragma once

#include <optional>
#include <vector>

#include "core/study/drilling/sequence.h"
#include "core/study/scan/drilling_scan.h"

namespace drillwave {

/// The sequences of a scan, from rest, by their penetration rate.
struct ScanComparison {
    struct Entry {
        double at = 0;  ///< value of the parameter, SI
        Sequence sequence;
    };
    std::vector<Entry> entries;  ///< that have statistics, in the order of the values; never empty
    std::size_t bestPlace = 0;   ///< of the largest rate
    /// Entry whose error makes the best one uncertain; nothing if it is certain.
    std::optional<Entry> unresolved;

    const Entry& best() const { return entries[bestPlace]; }
    bool isResolved() const { return !unresolved; }
    /// Whether the rate of a sequence is lower than the best by more than the errors of both.
    bool isLower(const Sequence& sequence) const;
    /// Whether any of the scan is.
    bool isAnyLower() const;
    /// The rate of a sequence over the best; nothing where either is not resolved.
    std::optional<double> bestShare(const Sequence& sequence) const;
};

/// Returns nothing if no point has statistics.
std::optional<ScanComparison> compareScan(const DrillingScan& scan);

}  // namespace drillwave
