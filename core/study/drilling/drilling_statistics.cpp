// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/contact/contact_law.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr EnumNames<DrillingRegime> regimeNames{{{DrillingRegime::rest, "rest"},
                                                 {DrillingRegime::period, "period"},
                                                 {DrillingRegime::irregular, "irregular"}}};

/// Batches of consecutive blows at most, and the 97.5 % quantiles of Student's distribution for two batches,
/// three … (one degree of freedom, two …).
constexpr std::size_t batches = 20;
constexpr std::array<double, batches - 1> studentOfBatches{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                                           2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145,
                                                           2.131,  2.120, 2.110, 2.101, 2.093};

/// Motions repeat if they agree to this share of d0 and v0 over three periods; longest period searched for.
constexpr double sameMotion = 1e-6;
constexpr int longestPeriod = 16;

/// Share of blows in contact above which the bit rests.
constexpr double restShare = 0.95;

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double meanOf(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// By the means of so many batches at most; a rest of fewer blows than a batch is left out at the front.
std::optional<double> batchError(std::span<const double> values, std::size_t most) {
    if (values.size() < 2) return std::nullopt;
    const std::size_t count = std::min(most, values.size()), size = values.size() / count;
    const std::span<const double> counted = values.last(size * count);
    const double mean = meanOf(counted);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double off = meanOf(counted.subspan(i * size, size)) - mean;
        sum += off * off;
    }
    const double student = studentOfBatches[std::min(count, batches) - 2];
    return student * std::sqrt(sum / static_cast<double>((count - 1) * count));
}

/// Where nothing repeats: a few blows drift, or alternate so that batches have the same mean by chance.
double irregularError(std::span<const double> values) {
    double largest = 0;
    for (const std::size_t most : {values.size(), batches, batches / 2, batches / 4})
        largest = std::max(largest, batchError(values, most).value_or(0));
    return largest;
}

bool repeats(std::span<const DrillingBlow> blows, std::size_t period, double velocityScale) {
    const std::size_t window = 3 * period;
    if (blows.size() < window) return false;
    const double length = sameMotion / lawUnitOfPenetration;
    for (std::size_t i = blows.size() - window + period; i < blows.size(); ++i) {
        const DrillingBlow &now = blows[i], &before = blows[i - period];
        if (std::abs(now.gap - before.gap) > length) return false;
        if (std::abs(now.penetration - before.penetration) > length) return false;
        if (std::abs(now.velocity - before.velocity) > sameMotion * velocityScale) return false;
    }
    return true;
}

/// The largest distance of the shares below to those of an even distribution over 0 … 1.
double evenDistance(std::vector<double> parts) {
    std::ranges::sort(parts);
    double largest = 0;
    const auto count = static_cast<double>(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double below = static_cast<double>(i) / count, upTo = static_cast<double>(i + 1) / count;
        largest = std::max({largest, parts[i] - below, upTo - parts[i]});
    }
    return largest;
}

}  // namespace

std::string_view name(DrillingRegime regime) {
    return regimeNames[regime];
}

BlowSpread spreadOf(std::span<const double> values) {
    assert(!values.empty());
    BlowSpread spread;
    spread.mean = meanOf(values);
    spread.meanError = batchError(values, batches);
    double square = 0;
    for (const double value : values) square += (value - spread.mean) * (value - spread.mean);
    if (values.size() > 1) spread.deviation = std::sqrt(square / static_cast<double>(values.size() - 1));
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    spread.q05 = quantile(sorted, 0.05);
    spread.q50 = quantile(sorted, 0.5);
    spread.q95 = quantile(sorted, 0.95);
    spread.least = sorted.front();
    spread.largest = sorted.back();
    return spread;
}

DrillingStatistics statisticsOf(std::span<const DrillingBlow> blows, std::size_t settle,
                                double velocityScale) {
    assert(settle < blows.size());
    const std::span<const DrillingBlow> counted = blows.subspan(settle);
    DrillingStatistics statistics;
    std::vector<double> values(counted.size());
    for (std::size_t q = 0; q < blowQuantities.size(); ++q) {
        std::ranges::transform(counted, values.begin(), blowQuantities[q].value);
        statistics.spreads[q] = spreadOf(values);
        if (values.size() < 2 * batches) continue;
        const std::span<const double> all = values;
        const BlowSpread first = spreadOf(all.first(all.size() / 2)),
                         second = spreadOf(all.last(all.size() / 2));
        const double errors = std::hypot(*first.meanError, *second.meanError);
        const double rounding = 1e-9 * std::max(std::abs(first.mean), std::abs(second.mean));
        if (std::abs(first.mean - second.mean) > 3 * errors + rounding) statistics.isSettled = false;
    }
    std::vector<double> parts;
    std::size_t inContact = 0;
    for (const DrillingBlow& blow : counted) {
        const double gap = blow.gap * lawUnitOfPenetration;
        inContact += gap < contactLimit;
        parts.push_back(gap - std::floor(gap));
        const auto bin = static_cast<std::size_t>(parts.back() * 20);
        ++statistics.gapParts[std::min<std::size_t>(bin, 19)];
    }
    statistics.contactShare = static_cast<double>(inContact) / static_cast<double>(counted.size());
    statistics.ksDistance = evenDistance(std::move(parts));
    statistics.ksLevel = 1.36 / std::sqrt(static_cast<double>(counted.size()));
    for (int period = 1; period <= longestPeriod && statistics.period == 0; ++period)
        if (repeats(counted, static_cast<std::size_t>(period), velocityScale)) statistics.period = period;
    for (std::size_t q = 0; q < blowQuantities.size() && statistics.period == 0 && counted.size() > 1; ++q) {
        std::ranges::transform(counted, values.begin(), blowQuantities[q].value);
        statistics.spreads[q].meanError = irregularError(values);
    }
    if (statistics.contactShare >= restShare && statistics.period == 1)
        statistics.regime = DrillingRegime::rest;
    else if (statistics.period > 0)
        statistics.regime = DrillingRegime::period;
    return statistics;
}

}  // namespace drillwave
