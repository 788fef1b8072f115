// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of hammer and string in a row, with the largest stresses at every position.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/blow/blow.h"
#include "core/wave/field/rod_envelope.h"

namespace drillwave {

/// Section of hammer or string in the plot of stresses. `rear` and `front` are the positions of its ends:
/// distance from the shank divided by the length of the string, negative in the hammer.
struct RodStretch {
    double rear = 0, front = 0;
    /// Reference area [m²], which converts force to stress: stress [F0/A] = force [F0] · toStress /
    /// (cross-section of the section).
    double toStress = 0;
    Section section;
    /// Number of the section. In the string it counts from 1, with every copy of a repeated section. In the
    /// hammer it is −1, −2, … from the rear.
    int number = 0;
    QString name;
    /// Name of the section as used in sentences, such as "3rd rod" or "hammer 1".
    QString words;
    std::optional<double> yieldStrength, fatigueStrength;  ///< strengths of the section [Pa]

    /// Returns the position within the section, from 0 (rear end) to 1 (front end). `place` is the distance
    /// from the shank divided by the length of the string.
    double shareAt(double place) const;
};

/// Hammer and drill string of a blow; never changed once built. In each RodForce here, `size` is a stress as
/// a multiple of the scale of stress. `section` is the distance from the shank divided by the length of the
/// string.
struct StringRod {
    std::vector<RodStretch> stretches;         ///< sections from the rear of the hammer to the bit
    std::shared_ptr<const StringWaves> waves;  ///< waves of the blow; empty if there were too many to keep
    double endOfBlow = 0;                      ///< end of the blow [t0], Impact::endOfBlow
    double forcesEnd = 0;                      ///< end of the recorded forces [t0], Impact::forcesEnd

    /// Returns the position of the hammer's rear end, divided by the length of the string and counted from
    /// the shank; negative or 0.
    double rear() const { return stretches.front().rear; }
    /// Returns the index of the section at a position (distance from the shank divided by the length of the
    /// string). Where two sections meet, it is the one nearer to the hammer.
    std::size_t sectionAt(double place) const;
    /// Returns the largest stresses at a position (distance from the shank divided by the length of the
    /// string). Where two sections meet, it returns the larger of the two values. Requires waves.
    RodForces largestAt(double place) const;
};

/// Returns the stress of a force [F0] in a section, as a multiple of the scale of stress F0/A. `share` is the
/// position within the section (0 … 1).
double stressOf(const RodStretch& section, double force, double share);

/// Returns hammer and drill string of a blow with their sections and waves.
StringRod stringRod(const Blow& blow);

/// Returns the largest compression and tension along hammer and string, in the blow and, if computed, after
/// it. Positions where two sections meet have a value for each of them. Empty if the waves were not kept. A
/// stop ends the work early.
RodEnvelope stringRodEnvelope(const StringRod& rod, const Blow& blow, const std::stop_token& stop = {});

}  // namespace drillwave
