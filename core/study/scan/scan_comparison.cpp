// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scan/scan_comparison.h"

#include <algorithm>

namespace drillwave {

namespace {

double rateOf(const ScanComparison::Entry& entry) {
    return entry.sequence.penetrationRate.value;
}

double errorOf(const Sequence& sequence) {
    return sequence.penetrationRate.error.value_or(0);
}

/// Returns the unresolved entry that may exceed the best by most.
std::optional<ScanComparison::Entry> obstacleOf(const ScanComparison& comparison) {
    const auto most = [](const ScanComparison::Entry& entry) {
        return rateOf(entry) + errorOf(entry.sequence);
    };
    const ScanComparison::Entry* obstacle = nullptr;
    for (const ScanComparison::Entry& entry : comparison.entries) {
        if (entry.sequence.isResolved() || comparison.isLower(entry.sequence)) continue;
        if (!obstacle || most(entry) > most(*obstacle)) obstacle = &entry;
    }
    return obstacle ? std::optional(*obstacle) : std::nullopt;
}

}  // namespace

bool ScanComparison::isLower(const Sequence& sequence) const {
    const double errors = errorOf(sequence) + errorOf(best().sequence);
    return sequence.penetrationRate.value < rateOf(best()) - errors;
}

bool ScanComparison::isAnyLower() const {
    return std::ranges::any_of(entries, [&](const Entry& entry) { return isLower(entry.sequence); });
}

std::optional<double> ScanComparison::bestShare(const Sequence& sequence) const {
    if (!isResolved() || !sequence.isResolved()) return std::nullopt;
    return sequence.penetrationRate.value / rateOf(best());
}

std::optional<ScanComparison> compareScan(const DrillingScan& scan) {
    ScanComparison comparison;
    for (const DrillingScanPoint& point : scan.points) {
        if (point.start != DrillingStart::rest) continue;
        if (std::optional<Sequence> sequence = sequenceOf(point.result))
            comparison.entries.push_back({point.value, std::move(*sequence)});
    }
    if (comparison.entries.empty()) return std::nullopt;
    const auto best = std::ranges::max_element(comparison.entries, {}, rateOf);
    comparison.bestPlace = static_cast<std::size_t>(best - comparison.entries.begin());
    comparison.unresolved = obstacleOf(comparison);
    return comparison;
}

}  // namespace drillwave
