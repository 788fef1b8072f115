// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of a blow as curves over time, to be drawn or written.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times are global, in t0, forces in F0,
// impulses in I0. ξ = x/L: rear end 0, bit 1.

/// Curve as points to be joined by straight lines; a time occurs twice where the curve jumps.
struct SampledCurve {
    std::vector<double> time;  ///< [t0], not decreasing
    std::vector<double> value;
};

/// Wave N0p, N1n, N2p, N3n … at a section, over one round trip from its arrival (paper, Fig. 3).
struct SectionWave {
    int number = 0;  ///< 0, 1, 2, 3: even ones run to +x, odd ones to −x
    SampledCurve curve;
};

/// The first `count` waves at the section ξ. The chords follow the curve to about 1e-4 of its pieces' size.
std::vector<SectionWave> sectionWaves(const Impact& impact, double xi, int count = 4);

/// Returns one of them, until `end` at the latest.
SectionWave sampledWave(const Impact& impact, double xi, int number,
                        double end = std::numeric_limits<double>::infinity());

/// The wave of that number at the section ξ, exactly; NaN before its arrival and after that round trip.
double sectionWave(const Impact& impact, double xi, int number, double t);

/// ∫ of that wave up to t from some fixed time on; constant where there is no wave.
double sectionWaveImpulse(const Impact& impact, double xi, int number, double t);

/// Histories at the bit on common times.
struct SampledHistory {
    std::vector<double> time;   ///< [t0], not decreasing, from the first arrival to the end of the recording
    std::vector<double> force;  ///< F [F0]
    std::vector<double> impulse;   ///< ∫F so far [I0]
    std::vector<double> incident;  ///< g [F0]
};

/// Every breakpoint is included, jumps from both sides; the chords follow the curves to about 1e-4 of their
/// pieces' size, more coarsely in recordings of more than 10 000 pieces (at most a million chords, or one for
/// each piece). Periods that were not recorded (impact.skips) are left out.
SampledHistory sampleHistory(const Impact& impact);

// The normal force at a section over time, and the waves that make it.

// Everything here needs an impact solved with Detail::histories. Times are global, in t0, forces in F0,
// tension positive, impulses in I0. ξ = x/L: rear end 0, bit 1.

/// Force in a strain gauge at a section, and the waves after the first ones.
struct SectionForce {
    SampledCurve force;    ///< N = Np + Nn (T2), from time 0 or the first wave there if that is earlier
    SampledCurve toBit;    ///< waves N4p, N6p …, where four waves are known, one after the other
    SampledCurve fromBit;  ///< waves N5n, N7n …
};

/// Returns the force at the section ξ until the time `end` (at most half a million points); `first` are
/// sectionWaves() there, an even number of them, that end before.
SectionForce sectionForce(const Impact& impact, double xi, std::span<const SectionWave> first, double end);

/// Returns ∫N dt at the section from a fixed time to t.
double sectionImpulse(const Impact& impact, double xi, double t);

}  // namespace drillwave
