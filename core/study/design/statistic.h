// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of many samples of an output: a mean, a quantile, each with its error.
#pragma once

#include <array>
#include <compare>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/design/sobol_points.h"

namespace drillwave {

/// Which statistic.
struct Statistic {
    enum class Kind { mean, quantile, least, largest, nominal } kind = Kind::mean;
    int percent = 0;  ///< of a quantile, 1 … 99

    /// "mean", "q05", "min", "max", "nominal".
    std::string name() const;
    /// Returns whether it has an error: min and max are extremes seen, nominal is one blow.
    bool hasError() const { return kind == Kind::mean || kind == Kind::quantile; }
    auto operator<=>(const Statistic&) const = default;
};

/// Returns the statistic of that name; nothing if there is none.
std::optional<Statistic> findStatistic(std::string_view name);

/// Returns the statistics reported for every output: mean, min, q05, q50, q95, max.
std::span<const Statistic> customaryStatistics();

/// Statistic of all samples, and of each replicate by itself.
struct SampledValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::array<double, replicateCount> replicates{};

    /// 2.4 sd/√8 of the replicates, 95 %: t of 7 degrees of freedom.
    double error() const;
};

/// The 95 % error of a mean of eight.
double errorOf(std::span<const double, replicateCount> replicates);
/// Returns the error of the difference of two statistics over the same points, replicate by replicate.
double errorOfDifference(const SampledValue& one, const SampledValue& other);
/// Whether two values differ by no more than that error, or by so small a part of their own errors that no
/// digit of them shows it. NaN equals only NaN.
bool areEqualWithinErrors(const SampledValue& one, const SampledValue& other);

/// The quantile of sorted numbers, at least one: at the position q n + ½ (Hazen), linear between, clamped.
double sortedQuantile(std::span<const double> sorted, double q);

/// Samples of one output, sorted once for all statistics. NaN are left out.
class SortedSamples {
  public:
    /// Requires the samples of one replicate after another, equally many of each.
    explicit SortedSamples(std::span<const double> samples);
    std::size_t count() const { return m_all.size(); }
    /// Returns a statistic other than `nominal`; NaN if a replicate is empty.
    SampledValue of(const Statistic& statistic) const;

  private:
    std::vector<double> m_all;
    std::array<std::vector<double>, replicateCount> m_replicates;
};

}  // namespace drillwave
