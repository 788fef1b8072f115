// SPDX-License-Identifier: GPL-3.0-or-later
// How an uncertain number scatters, as its quantile function.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace drillwave {

/// Meaning of LOW and HIGH of a range.
enum class DistributionKind {
    uniform,    ///< the ends
    log,        ///< the ends, even in the logarithm
    normal,     ///< the 2.5 % and 97.5 % quantiles
    lognormal,  ///< the 2.5 % and 97.5 % quantiles, of the logarithm
    percent,    ///< the ends, so many per cent below and above the value of the design
    draws,      ///< rows of a table, from 0 up to their number
};

/// "uniform", …, as on the command line and in JSON.
std::string_view name(DistributionKind kind);

/// Half the width of 95 % of a normal distribution, in its standard deviations.
inline constexpr double normalHalfWidth = 1.959964;
/// Deviation from its mean where a normal distribution is cut, in standard deviations.
inline constexpr double normalCut = 4;

/// Independent uncertain number, in the unit of low and high.
class Distribution {
  public:
    Distribution() : Distribution(DistributionKind::uniform, 0, 1) {}
    /// low < high, both > 0 of `log` and `lognormal`. Normal ones are cut at `least` and `most`, the range
    /// of the parameter, too, and rescaled.
    Distribution(DistributionKind kind, double low, double high,
                 double least = -std::numeric_limits<double>::infinity(),
                 double most = std::numeric_limits<double>::infinity());
    /// Which of so many rows, all alike: whole numbers.
    static Distribution ofRows(std::uint64_t rows);

    DistributionKind kind() const { return m_kind; }
    double low() const { return m_low; }
    double high() const { return m_high; }
    /// Whether there is a box to look for worst cases in.
    bool hasBox() const { return m_kind != DistributionKind::draws; }

    /// Returns the value below which the share u lies, 0 < u < 1.
    double quantile(double u) const;
    /// Returns the value at the share b of the range, 0 (low) … 1 (high), along the logarithm for `log` and
    /// `lognormal`. Rows of draws are as in quantile().
    double inBox(double b) const;
    /// Returns the share of the range at which a value is.
    double boxPlace(double value) const;
    /// Return the least and the largest possible value.
    double least() const;
    double most() const;

  private:
    bool isLogarithmic() const;

    DistributionKind m_kind;
    double m_low, m_high;
    double m_mean = 0, m_deviation = 0;    // of normal ones, of the logarithm of lognormal ones
    double m_shareBelow = 0, m_share = 1;  // cut off below; kept
};

}  // namespace drillwave
