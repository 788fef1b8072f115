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

/// Section of hammer or string in the plot of stresses. Its ends are measured from the shank in lengths of
/// the string, negative in the hammer.
struct RodStretch {
    double rear = 0, front = 0;
    /// Reference area [m²]: stress in the unit of Scales = force [F0] · toStress / area of the section.
    double toStress = 0;
    Section section;
    /// Number of the section: in the string from 1, with repeats written out; in the hammer from −1
    /// downwards.
    int number = 0;
    QString name;
    /// Name for sentences, such as "3rd rod" or "hammer 1".
    QString words;
    std::optional<double> yieldStrength, fatigueStrength;  ///< strengths of the section [Pa]

    /// Returns the position within the section, from 0 (rear end) to 1; `place` is in lengths of the string.
    double shareAt(double place) const;
};

/// Hammer and drill string of a blow; never changed once built. In each RodForce here, `size` is a stress in
/// the unit of Scales and `section` a position in lengths of the string.
struct StringRod {
    std::vector<RodStretch> stretches;         ///< sections from the rear of the hammer to the bit
    std::shared_ptr<const StringWaves> waves;  ///< waves of the blow; empty if there were too many to keep
    double endOfBlow = 0;                      ///< end of the blow [t0], Impact::endOfBlow
    double forcesEnd = 0;                      ///< end of the recorded forces [t0], Impact::forcesEnd

    /// Returns the position of the hammer's rear end in lengths of the string; negative or 0.
    double rear() const { return stretches.front().rear; }
    /// Returns the index of the section at a position (lengths of the string); where two sections meet, the
    /// one nearer to the hammer.
    std::size_t sectionAt(double place) const;
    /// Returns the largest stresses at a position (lengths of the string); where two sections meet, the
    /// larger of both. Requires waves.
    RodForces largestAt(double place) const;
};

/// Returns the stress of a force [F0] in a section, in the unit of Scales. `share` is the position within the
/// section (0 … 1).
double stressOf(const RodStretch& section, double force, double share);

/// Returns hammer and drill string of a blow with their sections and waves.
StringRod stringRod(const Blow& blow);

/// Returns the largest compression and tension along hammer and string, for the blow and for later times if
/// computed. Positions where sections meet have a value for each section. Empty if the waves were not kept; a
/// stop ends the work early.
RodEnvelope stringRodEnvelope(const StringRod& rod, const Blow& blow, const std::stop_token& stop = {});

}  // namespace drillwave
