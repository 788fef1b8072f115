// SPDX-License-Identifier: GPL-3.0-or-later
// What many blows have in common: means with errors, contact share, period, how gaps scatter (drilling §5).
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

/// A number of every blow over all blows that count.
struct BlowSpread {
    double mean = 0;
    std::optional<double> meanError;  ///< 95 %, by up to 20 batches of consecutive blows; nothing of one blow
    double deviation = 0;
    double q05 = 0, q50 = 0, q95 = 0;
    double least = 0, largest = 0;
};

/// Requires values.
BlowSpread spreadOf(std::span<const double> values);

/// What a number of a blow is, and of what it is a multiple: times, gaps, impulses, forces, velocities.
enum class DrillingMeasure { count, time, length, velocity, impulse, force, energy };

/// A number of every blow.
struct BlowQuantity {
    const char* name = nullptr;  ///< of its column, and its key in JSON
    DrillingMeasure measure = DrillingMeasure::count;
    double DrillingBlow::*value = nullptr;
    bool hasSpread = false;         ///< its mean, deviation and quantiles are results
    const char* title = nullptr;    ///< where tables that people read show its spread
    const char* meaning = nullptr;  ///< of such a row, in a sentence
};

/// All of them, in the order of the columns of blows.csv.
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

/// Quantities whose spread is a result, in the order of `blowColumns`.
inline constexpr auto blowQuantities = [] {
    constexpr auto count = std::ranges::count_if(blowColumns, &BlowQuantity::hasSpread);
    std::array<BlowQuantity, static_cast<std::size_t>(count)> quantities;
    std::ranges::copy_if(blowColumns, quantities.begin(), &BlowQuantity::hasSpread);
    return quantities;
}();

/// Where it is in blowQuantities. Requires that it is there.
constexpr std::size_t quantityPlace(double DrillingBlow::*value) {
    std::size_t place = 0;
    while (blowQuantities[place].value != value) ++place;
    return place;
}

enum class DrillingRegime {
    rest,       ///< the bit is on the rock before every blow
    period,     ///< gap, velocity and penetration repeat
    irregular,  ///< single blows are no result
};
std::string_view name(DrillingRegime regime);

/// A blow whose gap is less than that counts as one that begins in contact [d0].
inline constexpr double contactLimit = 0.05;

/// Of the blows that count.
struct DrillingStatistics {
    std::array<BlowSpread, blowQuantities.size()> spreads;  ///< of blowQuantities, in units of Problem
    double contactShare = 0;                                ///< blows with a gap below contactLimit
    int period = 0;                                         ///< 1 … 16; 0: it does not repeat
    DrillingRegime regime = DrillingRegime::irregular;
    std::array<int, 20> gapParts{};  ///< gap/d0 modulo 1
    double ksDistance = 0;           ///< of those to an even distribution
    double ksLevel = 0;              ///< that is exceeded in 5 % of even samples
    bool isSettled = true;           ///< the halves of the blows agree to three errors
};

/// Requires settle < blows.size(). `velocityScale` is v0 in units of Problem.
DrillingStatistics statisticsOf(std::span<const DrillingBlow> blows, std::size_t settle,
                                double velocityScale);

}  // namespace drillwave
