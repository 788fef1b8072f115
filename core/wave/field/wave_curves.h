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

/// Returns one of the waves that pass the section ξ = x/L, the one with the index `number` in order of
/// arrival. It consists of points to be joined by straight lines. It ends one round trip after its arrival,
/// or at the time `end` [t0] if that is earlier.
SectionWave sampledWave(const Impact& impact, double xi, int number,
                        double end = std::numeric_limits<double>::infinity());

/// Returns the exact value of the wave with index `number` at the section ξ and time t, in units of F0,
/// tension positive; NaN before its arrival and after one round trip from then.
double sectionWave(const Impact& impact, double xi, int number, double t);

/// Returns the time integral up to t of the wave with index `number` at the section ξ, in units of I0. Only
/// differences between two times are meaningful. The integral is constant before the wave arrives and after
/// it has passed.
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

/// Returns the recorded histories at the bit as points to be joined by straight lines. At a jump there are
/// two points of equal time. The lines deviate from the curves by about 1e-4 of the size of each polynomial
/// piece. Recordings of more than 10 000 pieces have fewer lines in each piece: about a million in all, or
/// one for each piece. Periods that were not recorded (impact.skips) have no points.
SampledHistory sampleHistory(const Impact& impact);

// Normal force at a section over time, and the waves whose sum it is.

// Everything here needs an impact solved with Detail::histories. Times are in t0 since the start of the blow,
// forces in F0, tension positive, impulses in I0. ξ = x/L: rear end 0, bit 1.

/// Normal force at a section of the rod, as a strain gauge measures it there, and the waves that pass the
/// section after the waves `first` of sectionForce().
struct SectionForce {
    /// Normal force N = Np + Nn (T2), in units of F0, tension positive. The curve starts at time 0, or with
    /// the first wave at the section if that is earlier.
    SampledCurve force;
    /// Waves towards the bit that pass the section after the waves `first` of sectionForce(), as one curve,
    /// in units of F0, tension positive. If `first` holds four waves (N0p … N3n), these are N4p, N6p …
    SampledCurve toBit;
    /// Waves away from the bit that pass the section after the waves `first` of sectionForce(), as one curve,
    /// in units of F0, tension positive. If `first` holds four waves (N0p … N3n), these are N5n, N7n …
    SampledCurve fromBit;
};

/// Returns the normal force at the section ξ = x/L up to the time `end` [t0], and the waves that pass it
/// after the waves `first`. `first` is the result of sectionWaves() for this section: an even number of waves
/// that are over before `end`. The force has at most half a million points.
SectionForce sectionForce(const Impact& impact, double xi, std::span<const SectionWave> first, double end);

/// Returns the integral of the normal force at the section ξ over time up to t, in units of I0, tension
/// positive. Only differences between two times are meaningful.
double sectionImpulse(const Impact& impact, double xi, double t);

}  // namespace drillwave
