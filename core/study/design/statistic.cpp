// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/statistic.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/numeric/compensated_sum.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

constexpr std::array<Statistic, 6> customary{{{Statistic::Kind::mean},
                                              {Statistic::Kind::least},
                                              {Statistic::Kind::quantile, 5},
                                              {Statistic::Kind::quantile, 50},
                                              {Statistic::Kind::quantile, 95},
                                              {Statistic::Kind::largest}}};

double ofSorted(std::span<const double> sorted, const Statistic& statistic) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    switch (statistic.kind) {
        case Statistic::Kind::mean: {
            // About one of them: equal numbers have exactly themselves as their mean.
            CompensatedSum<double> sum;
            for (const double value : sorted) sum += value - sorted.front();
            return sorted.front() + sum / static_cast<double>(sorted.size());
        }
        case Statistic::Kind::quantile:
            return sortedQuantile(sorted, statistic.percent / 100.0);
        case Statistic::Kind::least:
            return sorted.front();
        case Statistic::Kind::largest:
            return sorted.back();
        case Statistic::Kind::nominal:
            break;
    }
    assert(false);
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::string Statistic::name() const {
    switch (kind) {
        case Kind::mean:
            return "mean";
        case Kind::least:
            return "min";
        case Kind::largest:
            return "max";
        case Kind::nominal:
            return "nominal";
        case Kind::quantile:
            break;
    }
    return (percent < 10 ? "q0" : "q") + std::to_string(percent);
}

std::optional<Statistic> findStatistic(std::string_view name) {
    using Kind = Statistic::Kind;
    if (name == "mean") return Statistic{Kind::mean};
    if (name == "min") return Statistic{Kind::least};
    if (name == "max") return Statistic{Kind::largest};
    if (name == "nominal") return Statistic{Kind::nominal};
    if (name.size() != 3 || name.front() != 'q') return std::nullopt;
    const auto percent = wholeNumberIn<unsigned>(name.substr(1));
    if (!percent || *percent < 1 || *percent > 99) return std::nullopt;
    return Statistic{Kind::quantile, static_cast<int>(*percent)};
}

std::span<const Statistic> customaryStatistics() {
    return customary;
}

double errorOf(std::span<const double, replicateCount> replicates) {
    constexpr double student = 2.4;  // of 7 degrees of freedom, 95 %
    constexpr double count = replicateCount;
    double mean = 0, squares = 0;
    for (const double value : replicates) mean += (value - replicates[0]) / count;
    for (const double value : replicates) {
        const double deviation = value - replicates[0] - mean;
        squares += deviation * deviation;
    }
    return student * std::sqrt(squares / (count - 1)) / std::sqrt(count);
}

double SampledValue::error() const {
    return errorOf(replicates);
}

double errorOfDifference(const SampledValue& one, const SampledValue& other) {
    std::array<double, replicateCount> differences{};
    for (std::size_t r = 0; r < replicateCount; ++r) differences[r] = one.replicates[r] - other.replicates[r];
    return errorOf(differences);
}

bool areEqualWithinErrors(const SampledValue& one, const SampledValue& other) {
    // Over the same points a difference can be certain and yet nothing to anyone: the error of a value is
    // shown in one digit.
    constexpr double shownPart = 0.05;
    if (std::isnan(one.value) || std::isnan(other.value))
        return std::isnan(one.value) && std::isnan(other.value);
    const double difference = std::abs(one.value - other.value);
    return difference < errorOfDifference(one, other) ||
           difference < shownPart * std::min(one.error(), other.error());
}

double sortedQuantile(std::span<const double> sorted, double q) {
    assert(!sorted.empty());
    const double position = q * static_cast<double>(sorted.size()) - 0.5;  // from 0
    if (position <= 0) return sorted.front();
    const auto below = static_cast<std::size_t>(position);
    if (below + 1 >= sorted.size()) return sorted.back();
    return sorted[below] + (position - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

SortedSamples::SortedSamples(std::span<const double> samples) {
    assert(samples.size() % replicateCount == 0);
    const std::size_t each = samples.size() / replicateCount;
    for (std::size_t r = 0; r < replicateCount; ++r) {
        std::ranges::copy_if(samples.subspan(r * each, each), std::back_inserter(m_replicates[r]),
                             [](double value) { return !std::isnan(value); });
        std::ranges::sort(m_replicates[r]);
        const auto middle = static_cast<std::ptrdiff_t>(m_all.size());
        m_all.insert(m_all.end(), m_replicates[r].begin(), m_replicates[r].end());
        std::inplace_merge(m_all.begin(), m_all.begin() + middle, m_all.end());
    }
}

SampledValue SortedSamples::of(const Statistic& statistic) const {
    SampledValue found{.value = ofSorted(m_all, statistic)};
    for (std::size_t r = 0; r < replicateCount; ++r)
        found.replicates[r] = ofSorted(m_replicates[r], statistic);
    return found;
}

}  // namespace drillwave
