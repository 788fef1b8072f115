// SPDX-License-Identifier: GPL-3.0-or-later
// The fronts of the blow in the rod, and when bit and rock touch: the lines of an x–t diagram.
#pragma once

#include <vector>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Times at which the force of the hammer begins, jumps or ends [t0], increasing: from each of them a front
/// starts that runs through the rod for ever. Jumps below a fiftieth of the peak are left out, and so is the
/// end of a force that only fades away. The reference case has one, at its first contact.
std::vector<double> pulseFronts(const PulseForce& pulse);

/// Bit and rock touch from one time to the other (global, t/t0).
struct ContactInterval {
    double begin = 0;
    double end = 0;
    bool operator==(const ContactInterval&) const = default;
};

/// In order of time. Needs an impact solved with Detail::summary or more.
std::vector<ContactInterval> contactIntervals(const Impact& impact);

}  // namespace drillwave
