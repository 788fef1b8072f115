// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of a blow as curves over time, to be drawn or written.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/wave/impact.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times are in t0 since the start of the blow,
// forces in F0, impulses in I0. ξ = x/L: rear end 0, bit 1.

/// Curve as points to be joined by straight lines. A time occurs twice where the curve jumps.
struct SampledCurve {
    std::vector<double> time;  ///< Times of the points in units of t0, not decreasing.
    /// Values of the curve at the times of `time`, one for each.
    std::vector<double> value;
};

/// One of the waves that pass a section of the rod one after the other (N0p, N1n, N2p, N3n … in Fig. 3 of the
/// paper). It lasts one round trip from its arrival at the section.
struct SectionWave {
    /// Number of the wave in order of arrival, from 0: even waves run to +x (the bit), odd ones to −x.
    int number = 0;
    /// The wave as a normal force over time, in units of F0, tension positive.
    SampledCurve curve;
};

/// Returns the first `count` waves that pass the section ξ = x/L, as points to be joined by straight lines.
/// The lines deviate from the curve by about 1e-4 of the size of each polynomial piece.
std::vector<SectionWave> sectionWaves(const Impact& impact, double xi, int count = 4);

/// Returns the wave with index `number` that passes the section ξ = x/L, as points to be joined by straight
/// lines. It ends one round trip after its arrival, or at the time `end` [t0] if that is earlier.
SectionWave sampledWave(const Impact& impact, double xi, int number,
                        double end = std::numeric_limits<double>::infinity());

/// Returns the exact value of the wave with index `number` at the section ξ and time t, in units of F0,
/// tension positive; NaN before its arrival and after one round trip from then.
double sectionWave(const Impact& impact, double xi, int number, double t);

/// Returns the time integral of the wave with index `number` up to t, in units of I0; only differences
/// between two times are meaningful. It is constant while the wave is not at the section ξ.
double sectionWaveImpulse(const Impact& impact, double xi, int number, double t);

/// Histories of force, impulse and incident wave at the bit, sampled at the same times.
struct SampledHistory {
    /// Times in units of t0, not decreasing, from the first arrival at the bit to the end of the recording.
    std::vector<double> time;
    /// Impact force F of bit and rock at the times of `time`, in units of F0; ≥ 0.
    std::vector<double> force;
    /// Impulse of the impact force, ∫F, from the first arrival to each time of `time`, in units of I0.
    std::vector<double> impulse;
    /// Incident wave g at the bit at the times of `time`, in units of F0, compression positive.
    std::vector<double> incident;
};

/// Returns the recorded histories at the bit as points to be joined by straight lines. At a jump there is a
/// point on either side. The lines deviate from the curves by about 1e-4 of the size of each polynomial
/// piece. Recordings of more than 10 000 pieces have fewer lines in each piece: about a million in all, or
/// one for each piece. Periods that were not recorded (impact.skips) have no points.
SampledHistory sampleHistory(const Impact& impact);

// Normal force at a section over time, and the waves whose sum it is.

// Everything here needs an impact solved with Detail::histories. Times are in t0 since the start of the blow,
// forces in F0, tension positive, impulses in I0. ξ = x/L: rear end 0, bit 1.

/// Normal force that a strain gauge measures at a section of the rod, and its later waves: those that follow
/// the waves given as `first` to sectionForce().
struct SectionForce {
    /// Normal force N = Np + Nn (T2), in units of F0, tension positive. The curve starts at time 0, or with
    /// the first wave at the section if that is earlier.
    SampledCurve force;
    /// Later waves towards the bit, joined in order of time, in units of F0, tension positive. They follow
    /// the waves given as `first` to sectionForce(): after four such waves they are N4p, N6p …
    SampledCurve toBit;
    /// Later waves away from the bit, joined in order of time, in units of F0, tension positive. They follow
    /// the waves given as `first` to sectionForce(): after four such waves they are N5n, N7n …
    SampledCurve fromBit;
};

/// Returns the normal force at the section ξ = x/L up to the time `end`, with at most half a million points.
/// `first` are the sectionWaves() of this section, an even number of waves that end before `end`.
SectionForce sectionForce(const Impact& impact, double xi, std::span<const SectionWave> first, double end);

/// Returns the integral of the normal force at the section ξ over time up to t, in units of I0, tension
/// positive. Only differences between two times are meaningful.
double sectionImpulse(const Impact& impact, double xi, double t);

}  // namespace drillwave
