// SPDX-License-Identifier: GPL-3.0-or-later
// Probability distribution of an uncertain input, given by its quantile function.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace drillwave {

/// Shape of a distribution, and the meaning of LOW and HIGH in the range typed for it.
enum class DistributionKind {
    uniform,    ///< uniform; LOW and HIGH are the ends
    log,        ///< uniform in the logarithm; LOW and HIGH are the ends
    normal,     ///< normal; LOW and HIGH are the 2.5 % and 97.5 % quantiles
    lognormal,  ///< lognormal; LOW and HIGH are the 2.5 % and 97.5 % quantiles
    percent,    ///< uniform; the ends lie P per cent below and above the value of the design
    draws,      ///< random row of a table; the value is the row index, from 0
};

/// Returns the name of a distribution as used on the command line and in JSON, such as "uniform".
std::string_view name(DistributionKind kind);

/// Half-width of the central 95 % of a normal distribution, in standard deviations.
inline constexpr double normalHalfWidth = 1.959964;
/// Distance from the mean at which a normal distribution is truncated, in standard deviations.
inline constexpr double normalCut = 4;

/// Distribution of one independent uncertain input. All values are in the unit of `low` and `high`.
class Distribution {
  public:
    Distribution() : Distribution(DistributionKind::uniform, 0, 1) {}
    /// Requires low < high; for `log` and `lognormal` both must be > 0. Normal and lognormal distributions
    /// are also truncated at `least` and `most`, the allowed range of the parameter, and rescaled.
    Distribution(DistributionKind kind, double low, double high,
                 double least = -std::numeric_limits<double>::infinity(),
                 double most = std::numeric_limits<double>::infinity());
    /// Returns the distribution of a random row index of a table of correlated values. All indices 0 … rows −
    /// 1 are equally likely.
    static Distribution ofRows(std::uint64_t rows);

    DistributionKind kind() const { return m_kind; }
    double low() const { return m_low; }
    double high() const { return m_high; }
    /// Returns whether the distribution has a continuous range in which worst cases can be searched; false
    /// for rows of a table.
    bool hasBox() const { return m_kind != DistributionKind::draws; }

    /// Returns the value below which the distribution has the probability u, 0 < u < 1.
    double quantile(double u) const;
    /// Returns the value at a position b of the range, from low (b = 0) to high (b = 1). The scale is
    /// logarithmic for `log` and `lognormal`. For rows of a table, returns quantile(b).
    double inBox(double b) const;
    /// Returns the position of a value in the range, from 0 (low) to 1 (high); the ends for values outside.
    /// Inverse of inBox().
    double boxPlace(double value) const;
    /// Returns the smallest possible value of the uncertain input; most() returns the largest.
    double least() const;
    double most() const;

  private:
    bool isLogarithmic() const;

    DistributionKind m_kind;
    double m_low, m_high;
    // Mean and standard deviation of normal distributions, of the logarithm for lognormal ones.
    double m_mean = 0, m_deviation = 0;
    double m_shareBelow = 0, m_share = 1;  // probability below the truncated range; probability within it
};

}  // namespace drillwave
