// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of hammer and string in a row, with the largest stresses at every place of them.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/blow/blow.h"
#include "core/wave/field/rod_envelope.h"

namespace drillwave {

/// Section of hammer or string with its ends, measured from the shank in string lengths, negative in the
/// hammer.
struct RodStretch {
    double rear = 0, front = 0;
    double toStress = 0;  ///< from a force [F0] on a square metre to stresses as scales have them
    Section section;
    int number = 0;  ///< in the string from 1, repeats written out; in the hammer downward from −1
    QString name;
    QString words;                                         ///< "3rd rod", "hammer 1"
    std::optional<double> yieldStrength, fatigueStrength;  ///< [Pa]

    /// ξ of a place in lengths of the string.
    double shareAt(double place) const;
};

/// Never changed once built. Stresses take the place of forces in F0: a RodForce has the stress in that of
/// the scales for its size, and the place in lengths of the string for its section.
struct StringRod {
    std::vector<RodStretch> stretches;         ///< from the rear of the hammer to the bit
    std::shared_ptr<const StringWaves> waves;  ///< empty where they were too many to be kept
    double endOfBlow = 0;                      ///< Impact::endOfBlow
    double forcesEnd = 0;                      ///< Impact::forcesEnd

    double rear() const { return stretches.front().rear; }
    /// Returns the section at a place; the front one where two sections meet.
    std::size_t sectionAt(double place) const;
    /// The largest stresses at a place, of both sections where two meet. Requires waves.
    RodForces largestAt(double place) const;
};

/// Returns the stress for a force [F0] at a place ξ of a section, in the unit of scales.
double stressOf(const RodStretch& section, double force, double share);

/// Returns the sections for a blow on a drill string.
StringRod stringRod(const Blow& blow);

/// Returns compression and tension during the blow, and later if it was followed so long; a place where
/// sections meet has both. Nothing if the waves were not kept. A stop ends the work early.
RodEnvelope stringRodEnvelope(const StringRod& rod, const Blow& blow, const std::stop_token& stop = {});

}  // namespace drillwave
