// SPDX-License-Identifier: GPL-3.0-or-later
// What many blows have in common: means with errors, contact share, period, how gaps scatter (drilling §5).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

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

/// What is told of every blow; in the order of their columns.
struct BlowQuantity {
    const char* name;
    double DrillingBlow::*value;
};
inline constexpr std::array<BlowQuantity, 9> blowQuantities{{
    {"gap", &DrillingBlow::gap},
    {"velocity", &DrillingBlow::velocity},
    {"rock_impulse", &DrillingBlow::rockImpulse},
    {"penetration", &DrillingBlow::penetration},
    {"peak_force", &DrillingBlow::peakForce},
    {"contact_time", &DrillingBlow::contactTime},
    {"contacts", &DrillingBlow::contacts},
    {"damper_peak_force", &DrillingBlow::damperPeak},
    {"face_impulse", &DrillingBlow::faceImpulse},
}};

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
