// SPDX-License-Identifier: GPL-3.0-or-later
// What a drill string adds to the numbers of a blow (files §4).
#pragma once

#include <optional>
#include <vector>

#include "core/wave/network/network_impact.h"

namespace drillwave {

/// Dimensionless: energies in E0, the hammer's, momenta in p0, its too, velocities in v0, times in t0.
struct StringSummary {
    NetworkEnd end = NetworkEnd::notSolved;
    double endTime = 0;
    double efficiency = 0;             ///< work on the rock
    double efficiencyError = 0;        ///< of that
    double efficiencyRecovered = 0;    ///< and what the hammer takes back with it
    double hammerReboundVelocity = 0;  ///< away from the rock
    double hammerReboundEnergy = 0;    ///< of that
    double hammerWaveEnergy = 0;       ///< of waves left in the hammer
    double stringMomentum = 0;         ///< towards the rock
    double stringEnergy = 0;
    double jointLoss = 0;    ///< energy lost in joints
    double rodLoss = 0;      ///< energy lost on the way through sections
    double faceImpulse = 0;  ///< what the hammer has handed to the string
    double faceEnergy = 0;
    double pistonSeparationTime = 0;  ///< when hammer and string first part; not a number: never
    /// Largest stresses over all sections of hammer and string [F0/A of the rod], where they were asked for:
    /// while the blow lasts, and later where it was followed so long.
    std::optional<double> largestCompression = {}, largestTension = {};
    std::optional<double> largestCompressionAfter = {}, largestTensionAfter = {};
};

}  // namespace drillwave
