// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of many samples of an output, such as a mean or a quantile, with their errors.
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

/// Kind of a statistic of one output over all samples, such as the mean. For a quantile, it includes the
/// percentage.
struct Statistic {
    enum class Kind { mean, quantile, least, largest, nominal } kind = Kind::mean;
    int percent = 0;  ///< percentage of a quantile, 1 … 99; not used for other kinds

    /// Returns the name used on the command line: "mean", "q05", "min", "max" or "nominal".
    std::string name() const;
    /// Returns whether the statistic has a sampling error. Minimum and maximum are the extremes of the
    /// samples and `nominal` is a single blow; these have none.
    bool hasError() const { return kind == Kind::mean || kind == Kind::quantile; }
    auto operator<=>(const Statistic&) const = default;
};

/// Returns the statistic with a name such as "mean" or "q05"; empty if the name is unknown.
std::optional<Statistic> findStatistic(std::string_view name);

/// Returns the statistics reported for every output by default: mean, min, q05, q50, q95 and max.
std::span<const Statistic> customaryStatistics();

/// Value of a statistic over all samples, and over each replicate (one of eight independent parts of the
/// samples).
struct SampledValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::array<double, replicateCount> replicates{};

    /// Returns the 95 % error of the value: 2.4 sd/√8, with the standard deviation sd of the eight replicates
    /// (independent parts of the samples). The factor 2.4 is Student's t for 7 degrees of freedom.
    double error() const;
};

/// Returns the 95 % error of the mean of the eight replicates: 2.4 sd/√8 with their standard deviation sd.
/// Replicates are independent parts of the samples.
double errorOf(std::span<const double, replicateCount> replicates);
/// Returns the 95 % error of the difference of two statistics over the same sample points. It is computed
/// from the differences of their replicates (independent parts of the samples).
double errorOfDifference(const SampledValue& one, const SampledValue& other);
/// Returns whether two values are equally good within their sampling errors. The difference must be below its
/// 95 % error, or below 5 % of the smaller of the two errors. NaN equals only NaN.
bool areEqualWithinErrors(const SampledValue& one, const SampledValue& other);

/// Returns the quantile q, 0 … 1, of ascending numbers. It lies at the position n q + ½ of n numbers, counted
/// from 1 (Hazen), with linear interpolation, clamped to the ends. Requires at least one number.
double sortedQuantile(std::span<const double> sorted, double q);

/// Samples of one output, sorted once so that any statistic can be read from them. NaN values are left out.
class SortedSamples {
  public:
    /// Sorts the samples of an output. They must be grouped by replicate (independent part), with the same
    /// number in each.
    explicit SortedSamples(std::span<const double> samples);
    std::size_t count() const { return m_all.size(); }
    /// Returns a statistic over all samples and over each replicate; NaN if a replicate has no samples. The
    /// kind `nominal` is not allowed.
    SampledValue of(const Statistic& statistic) const;

  private:
    std::vector<double> m_all;
    std::array<std::vector<double>, replicateCount> m_replicates;
};

}  // namespace drillwave
