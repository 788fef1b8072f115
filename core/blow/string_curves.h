// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string over time: at the bit, at the face of the hammer, and at a place in between.
#pragma once

#include <vector>

#include "core/model/drill_string.h"
#include "core/wave/impact.h"
#include "core/wave/network/string_waves.h"
#include "core/wave/problem.h"

namespace drillwave {

/// A place in hammer or string.
struct StringPlace {
    std::size_t section = 0;  ///< of allSections()
    double share = 0;         ///< ξ, 0 at its rear end … 1
    bool operator==(const StringPlace&) const = default;
};

/// Where the rear of the hammer is, in lengths of the string from the shank: below 0.
double hammerRear(const DrillString& drillString);

/// The place at a share of the length of the string, 0 at the shank … 1 at the bit, below 0 in the hammer.
StringPlace stringPlace(const DrillString& drillString, double share);

/// The other way round.
double shareOfString(const DrillString& drillString, const StringPlace& place);

/// The middle of the longest section of the string, of the first where several are as long.
StringPlace middleOfLongest(const DrillString& drillString);

/// What is at one time. Units as of a uniform rod: times t0, forces F0, impulses p0 of the hammer, velocities
/// v0, ways v0 t0. Normal forces are positive in tension, everything else towards the rock.
struct StringInstant {
    double time = 0;
    double impactForce = 0;    ///< F of bit and rock
    double impulse = 0;        ///< ∫F so far
    double momentum = 0;       ///< what the hammer has given less that: of the string where nothing is lost
    double penetration = 0;    ///< of the bit from the undisturbed rock; negative before the gap is closed
    double frontVelocity = 0;  ///< of the bit
    double faceForce = 0;      ///< of hammer and string
    double normalForce = 0;    ///< N at the place
    double positiveWave = 0;   ///< Np there, which runs to the bit
    double negativeWave = 0;   ///< Nn there, which comes back
    double velocity = 0;       ///< of the string there
};

/// Reads a blow whose waves were kept; it must outlive this.
class StringHistory {
  public:
    StringHistory(const Impact& impact, const Problem& problem, const StringPlace& place);

    StringInstant at(double time, TimeSide side = TimeSide::after) const;
    double end() const { return m_waves->end(); }
    /// From 0 to end(), a time twice where something jumps; chords follow the curves to about 1e-4 F0.
    std::vector<StringInstant> sampled() const;

  private:
    std::vector<double> pieceTimes() const;

    const Impact* m_impact;
    const Problem* m_problem;
    const StringWaves* m_waves;
    StringPlace m_place;
};

}  // namespace drillwave
