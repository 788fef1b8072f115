// SPDX-License-Identifier: GPL-3.0-or-later
// Waves anywhere in the rod, by shifted look-up in the histories of the front end (theory §3).
#pragma once

#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times are in t0, forces in F0, impulses in
// I0; s = t − impact.frontArrival is the time at the front end, t the global time. ξ = x/L: rear end 0, front
// end 1.

/// Incident wave g(s) = −Np at the front end for any s: before the first front 0 (1/(2τ) in the reference
/// case), then the recorded history, after its end periodic with 2τ.
double incidentWave(const Impact& impact, double s);

/// Impact force F(s) ≥ 0 for any s.
double impactForce(const Impact& impact, double s);

/// Impulse of the impact force up to s, ∫F.
double impactImpulse(const Impact& impact, double s);

/// Impulse that the incident wave has brought to the front end up to s, ∫g, for any s; less than 0 before
/// s = 0 in the reference case.
double incidentImpulse(const Impact& impact, double s);

/// The time s at which a point of the recording was reached: later by the periods left out before it.
double timeOfRecorded(const Impact& impact, double recorded);

/// Np(ξ, t) = −g(s = t − ξτ): the wave to +x, tension positive.
double positiveWave(const Impact& impact, double xi, double t);

/// Nn(ξ, t) = −r(s = t − (2 − ξ)τ), r = F − g: the wave to −x, tension positive.
double negativeWave(const Impact& impact, double xi, double t);

/// A curve as points to be joined by straight lines; a time occurs twice where the curve jumps.
struct SampledCurve {
    std::vector<double> time;  ///< global, not decreasing
    std::vector<double> value;
};

/// One of the waves N0p, N1n, N2p, N3n … at a section, over one round trip from its arrival (paper, Fig. 3).
struct SectionWave {
    int number = 0;  ///< 0, 1, 2, 3: even ones run to +x, odd ones to −x
    SampledCurve curve;
};

/// The first `count` waves at the section ξ. The chords follow the curve to about 1e-4 of its pieces' size.
std::vector<SectionWave> sectionWaves(const Impact& impact, double xi, int count = 4);

/// Histories at the front end on common times.
struct SampledHistory {
    std::vector<double> time;      ///< global, not decreasing, from frontArrival to the end of the recording
    std::vector<double> force;     ///< F
    std::vector<double> impulse;   ///< ∫F so far
    std::vector<double> incident;  ///< g
};

/// Every breakpoint is included, jumps from both sides; the chords follow the curves to about 1e-4 of their
/// pieces' size, more coarsely in recordings of more than 10 000 pieces (at most a million chords, or one for
/// each piece). Periods that were not recorded (impact.skips) are left out.
SampledHistory sampleHistory(const Impact& impact);

}  // namespace drillwave
