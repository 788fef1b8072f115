// SPDX-License-Identifier: GPL-3.0-or-later
// The fronts of the blow in the rod, and when bit and rock touch: the lines of an x–t diagram.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/field/wave_field.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Times at which the force of the hammer begins, jumps or ends [t0], increasing: from each of them a front
/// starts that runs through the rod for ever. Jumps below a fiftieth of the peak are left out, and so is the
/// end of a force that only fades away. The reference case has one, at its first contact.
std::vector<double> pulseFronts(const PulseForce& pulse);

/// Path of a front through the rod, or through a section of a string: a straight line in the x–t diagram.
struct FrontRun {
    long number = 0;  ///< of the wave that begins with it, as SectionWave::number
    Heading heading = Heading::toBit;
    double timeAtFront = 0;      ///< at the end towards the bit, global [t0]
    double transitTime = 0;      ///< [t0]
    double rear = 0, front = 1;  ///< where it begins and ends, x/L

    /// Return the time when it passes the section ξ, and its place at the global time t (beyond its ends
    /// before and after it).
    double timeAt(double xi) const {
        return timeAtFront - direction() * (front - xi) / (front - rear) * transitTime;
    }
    double sectionAt(double t) const {
        return front + direction() * (t - timeAtFront) / transitTime * (front - rear);
    }

  private:
    double direction() const { return heading == Heading::toBit ? 1 : -1; }
};

/// The ways of the front that the hammer sends off at the time `start` (one of pulseFronts()) which are under
/// way between two global times, in the order in which they reach or leave the bit.
std::vector<FrontRun> frontRuns(const Impact& impact, double start, double begin, double end);

/// Bit and rock touch from one time to the other (global, t/t0).
struct ContactInterval {
    double begin = 0;
    double end = 0;
    bool operator==(const ContactInterval&) const = default;
};

/// Returns the contacts in order of time. Requires an impact solved with Detail::events or more.
std::vector<ContactInterval> contactIntervals(const Impact& impact);

}  // namespace drillwave
