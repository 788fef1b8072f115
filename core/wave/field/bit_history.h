// SPDX-License-Identifier: GPL-3.0-or-later
// Waves, force and position of the bit at any time, read from the recorded histories of a blow on a uniform
// rod.
#pragma once

#include <functional>
#include <span>

#include "core/wave/field/wave_fronts.h"
#include "core/wave/impact.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times s are in t0 from the arrival of the
// first wave at the bit (impact.frontArrival), forces in F0, impulses in I0.

/// Returns the incident wave g(s) = −Np at the bit, in units of F0, compression positive, at any time s. s is
/// counted in t0 from the first arrival at the bit. Before, g is 0, or 1/(2τ) in the reference case (a rod
/// that arrives as a rigid body). After the end of the recording it repeats with period 2τ.
double incidentWave(const Impact& impact, double s);

/// Returns the impact force F(s) ≥ 0, in units of F0, at any time s, counted in t0 from the first arrival at
/// the bit. With the incident wave g, the reflected wave is r = F − g, which satisfies [paper (4)] and [paper
/// (7)].
double impactForce(const Impact& impact, double s);

/// Returns the impulse of the impact force up to the time s, ∫F ds, in units of I0. s is counted in t0 from
/// the first arrival at the bit; for s ≤ 0 the impulse is 0.
double impactImpulse(const Impact& impact, double s);

/// Returns the impulse that the incident wave has brought to the bit up to the time s, ∫g ds, in units of I0.
/// s is counted in t0 from the first arrival at the bit. In the reference case (a rod that arrives as a rigid
/// body) the impulse is negative before s = 0.
double incidentImpulse(const Impact& impact, double s);

/// Returns the time s [t0] since the first arrival at the bit, for the time `recorded` in the recording. It
/// adds the periods of free flight that were left out of the recording before.
double timeOfRecorded(const Impact& impact, double recorded);

// Position of the bit: its penetration into the rock, or its distance from the rock.

/// Returns the displacement of the front end of the rod towards the rock, u = ∫(2g − F) ds / 2, in units of
/// d0, at the time t/t0 since the start of the blow. In the reference case (a rod that arrives as a rigid
/// body) it is counted from first contact, and negative before.
double bitDisplacement(const Impact& impact, double t);

/// Contact state of bit and rock at one time.
struct BitState {
    /// Whether bit and rock are in contact.
    bool touching = false;
    /// Penetration U of the bit below the original surface of the rock, in units of d0; valid only in
    /// contact.
    double penetration = 0;
    /// Distance from the bit to the bottom of the crater, in units of d0, ≥ 0; 0 in contact.
    double gap = 0;
};

/// Returns the contact state of bit and rock at the time t/t0 since the start of the blow. `contacts` are the
/// contactIntervals() of the impact, `delta` is the initial gap δ in units of d0. The rounding error is 1e-15
/// of the displacement of the bit until then. Requires an impact with Detail::histories.
BitState bitState(const Impact& impact, std::span<const ContactInterval> contacts, double delta, double t);

/// Returns the contact state of bit and rock at the time t/t0. `displacementAt` is a function of time that
/// returns the displacement of the bit towards the rock, in units of d0. `contacts` are the intervals of
/// contact in order of time. `delta` is the initial gap δ, in units of d0.
BitState bitState(const std::function<double(double)>& displacementAt,
                  std::span<const ContactInterval> contacts, double delta, double t);

}  // namespace drillwave
