// SPDX-License-Identifier: GPL-3.0-or-later
// Wave fronts of the blow in the rod, and intervals of contact between bit and rock: the lines of an x–t
// diagram.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Returns the times at which the hammer force begins, jumps or ends, in units of t0, increasing. At each of
/// these times a wave front starts that runs to and fro in the rod. Jumps below a fiftieth of the peak are
/// left out. The end of an exponential force or a piston is also left out if the force there is below this
/// value. In the reference case (a rod that arrives as a rigid body) the only time is 0, its first contact.
std::vector<double> pulseFronts(const PulseForce& pulse);

/// Path of a wave front through the rod, or through one section of a string: a straight line in the x–t
/// diagram.
struct FrontRun {
    /// Number of the wave that begins with this front, counted from 0. Waves with even numbers run towards
    /// the bit, those with odd numbers away from it.
    long number = 0;
    /// Direction in which the wave front runs, towards the bit or away from it.
    Heading heading = Heading::toBit;
    /// Time t/t0 at which the wave front is at the section `front`, the end of the path nearer the bit.
    double timeAtFront = 0;
    /// Time that the wave front needs from one end of the path to the other, in units of t0; > 0.
    double transitTime = 0;
    /// Sections x/L of both ends of the path: `rear` is the end nearer the hammer, `front` the end nearer the
    /// bit.
    double rear = 0, front = 1;

    /// Returns the time t/t0 at which the front passes the section ξ = x/L.
    double timeAt(double xi) const {
        return timeAtFront - direction() * (front - xi) / (front - rear) * transitTime;
    }
    /// Returns the section ξ = x/L at which the front is at the time t/t0. For times before or after the
    /// path, its straight line is extended.
    double sectionAt(double t) const {
        return front + direction() * (t - timeAtFront) / transitTime * (front - rear);
    }

  private:
    double direction() const { return heading == Heading::toBit ? 1 : -1; }
};

/// Returns the straight paths in the x–t diagram of one wave front that runs along the rod, towards the bit
/// and back. There is one path for each passage between the times `begin` and `end`, in order of time. The
/// front leaves the struck end at the time `start`, one of pulseFronts(). Times are in t0 since the start of
/// the blow.
std::vector<FrontRun> frontRuns(const Impact& impact, double start, double begin, double end);

/// Interval of time during which bit and rock are in contact, in units of t0 since the start of the blow.
struct ContactInterval {
    double begin = 0;
    double end = 0;
    bool operator==(const ContactInterval&) const = default;
};

/// Returns the intervals of contact of bit and rock in order of time. Requires an impact solved with
/// Detail::events or more.
std::vector<ContactInterval> contactIntervals(const Impact& impact);

}  // namespace drillwave
