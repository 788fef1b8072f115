// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of a sequence of blows: means with errors, contact share, period, scatter of gaps (drilling §5).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/text/message.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

/// Statistics of one quantity over all counted blows (those after the transient blows).
struct BlowSpread {
    double mean = 0;
    /// 95 % error of the mean, from up to 20 batches of consecutive blows; empty for a single blow. If the
    /// motion does not repeat, it is the largest error from several batch sizes.
    std::optional<double> meanError;
    double deviation = 0;
    double q05 = 0, q50 = 0, q95 = 0;
    double least = 0, largest = 0;
};

/// Returns the statistics of the values of one quantity, one value for each blow. Requires at least one
/// value.
BlowSpread spreadOf(std::span<const double> values);

/// Kind of physical quantity, from which the unit of a value follows.
enum class DrillingMeasure { count, time, length, velocity, impulse, force, energy };

/// Quantity recorded for every blow, with its name and unit.
struct BlowQuantity {
    const char* name = nullptr;  ///< name of the quantity's CSV column, and its key in JSON
    DrillingMeasure measure = DrillingMeasure::count;
    double DrillingBlow::*value = nullptr;
    bool hasSpread = false;  ///< whether mean, standard deviation and quantiles of the quantity are results
    /// Heading of the quantity in tables that people read; nullptr if these tables do not show it.
    const char* title = nullptr;
    const char* meaning = nullptr;  ///< explanation of that table row, as a sentence
};

/// All quantities of a blow, in the order of the columns of blows.csv.
inline constexpr std::array<BlowQuantity, 13> blowColumns{{
    {"time", DrillingMeasure::time, &DrillingBlow::time},
    {"gap", DrillingMeasure::length, &DrillingBlow::gap, true, translatable("gap at the blow"),
     translatable("Between bit and rock when the hammer strikes")},
    {"velocity", DrillingMeasure::velocity, &DrillingBlow::velocity, true},
    {"rock_impulse", DrillingMeasure::impulse, &DrillingBlow::rockImpulse, true, translatable("rock impulse"),
     translatable("Impulse on the rock in a cycle; its mean is the feed force times the interval")},
    {"penetration", DrillingMeasure::length, &DrillingBlow::penetration, true, translatable("penetration"),
     translatable("Per blow; an upper limit: all rock under the bit breaks")},
    {"hole_depth", DrillingMeasure::length, &DrillingBlow::holeDepth},
    {"peak_force", DrillingMeasure::force, &DrillingBlow::peakForce, true, translatable("peak force"),
     translatable("Largest force on the rock in a cycle")},
    {"contacts", DrillingMeasure::count, &DrillingBlow::contacts, true, translatable("contacts"),
     translatable("Number of contacts in a cycle")},
    {"contact_time", DrillingMeasure::time, &DrillingBlow::contactTime, true},
    {"damper_peak_force", DrillingMeasure::force, &DrillingBlow::damperPeak, true},
    {"face_impulse", DrillingMeasure::impulse, &DrillingBlow::faceImpulse, true},
    {"hammer_rebound_velocity", DrillingMeasure::velocity, &DrillingBlow::hammerRebound},
    {"shank_offset", DrillingMeasure::length, &DrillingBlow::shankOffset},
}};

/// Quantities of a blow for which mean, standard deviation and quantiles are computed. They are a part of
/// `blowColumns`, in the same order.
inline constexpr auto blowQuantities = [] {
    constexpr auto count = std::ranges::count_if(blowColumns, &BlowQuantity::hasSpread);
    std::array<BlowQuantity, static_cast<std::size_t>(count)> quantities;
    std::ranges::copy_if(blowColumns, quantities.begin(), &BlowQuantity::hasSpread);
    return quantities;
}();

/// Returns the index in blowQuantities of the quantity that a member of DrillingBlow holds. Requires that
/// blowQuantities contains this quantity.
constexpr std::size_t quantityPlace(double DrillingBlow::*value) {
    std::size_t place = 0;
    while (blowQuantities[place].value != value) ++place;
    return place;
}

enum class DrillingRegime {
    rest,       ///< period 1, with the bit on the rock at the start of at least 95 % of the blows
    period,     ///< gap, velocity and penetration repeat after 1 … 16 blows
    irregular,  ///< no repetition; only statistics are results, not single blows
};
std::string_view name(DrillingRegime regime);

/// Gap below which a blow counts as starting in contact, in units of d0.
inline constexpr double contactLimit = 0.05;

/// Statistics of the counted blows of a sequence.
struct DrillingStatistics {
    /// Statistics of the quantities in blowQuantities, in the dimensionless units of Problem.
    std::array<BlowSpread, blowQuantities.size()> spreads;
    double contactShare = 0;  ///< share of blows that start with a gap below contactLimit, 0 … 1
    int period = 0;           ///< number of blows after which the motion repeats, 1 … 16; 0 if it does not
    DrillingRegime regime = DrillingRegime::irregular;
    std::array<int, 20> gapParts{};  ///< histogram of the fractional part of gap/d0, in 20 equal bins
    /// Kolmogorov–Smirnov distance, 0 … 1, of the fractional parts of gap/d0 from a uniform distribution. A
    /// small value means that all gaps within a period are equally likely.
    double ksDistance = 0;
    /// Critical value of ksDistance: only 5 % of samples of this size from a uniform distribution exceed it.
    /// If ksDistance is larger, the gaps are probably not uniformly distributed.
    double ksLevel = 0;
    bool isSettled = true;  ///< whether the first and second half of the blows agree within three errors
};

/// Returns the statistics of a sequence of blows without its first `settle` blows, which are transient.
/// Requires settle < blows.size(). `velocityScale` is the reference velocity v0 in the dimensionless units of
/// Problem (see Problem::velocity()). Differences of velocity are judged relative to it.
DrillingStatistics statisticsOf(std::span<const DrillingBlow> blows, std::size_t settle,
                                double velocityScale);

}  // namespace drillwave
