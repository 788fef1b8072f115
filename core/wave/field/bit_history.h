// SPDX-License-Identifier: GPL-3.0-or-later
// The waves at the bit at any time: the record of the contact read beyond its end and across what it leaves
// out.
#pragma once

#include <functional>
#include <span>

#include "core/wave/field/wave_fronts.h"
#include "core/wave/impact.h"

namespace drillwave {

// Everything here needs an impact solved with Detail::histories. Times s are in t0 from the arrival of the
// first wave at the bit (impact.frontArrival), forces in F0, impulses in I0.

/// Incident wave g(s) = −Np at the bit for any s: before the first front 0 (1/(2τ) in the reference case),
/// then the recorded history, after its end periodic with 2τ.
double incidentWave(const Impact& impact, double s);

/// Impact force F(s) ≥ 0 for any s. The reflected wave is r = F − g, which satisfies [paper (4)] and [paper
/// (7)].
double impactForce(const Impact& impact, double s);

/// Impulse of the impact force up to s, ∫F.
double impactImpulse(const Impact& impact, double s);

/// Impulse that the incident wave has brought to the bit up to s, ∫g, for any s; less than 0 before s = 0 in
/// the reference case.
double incidentImpulse(const Impact& impact, double s);

/// The time s at which a point of the recording was reached: later by the periods left out before it.
double timeOfRecorded(const Impact& impact, double recorded);

// Where the bit is: how deep in the rock, or how far from it.

/// Displacement of the front end towards the rock since the beginning of the blow (since first contact in the
/// reference case, negative before it), u = ∫(2g − F) ds / 2 [d0], at the global time t/t0.
double bitDisplacement(const Impact& impact, double t);

struct BitState {
    bool touching = false;
    double penetration = 0;  ///< U [d0] below the first surface of the rock; meaningful while touching
    double gap = 0;          ///< to the bottom of the crater [d0], while apart
};

/// Returns the state at the global time t/t0; `contacts` are contactIntervals() of the impact, `delta` the
/// first gap δ [d0]. Accurate to 1e-15 of the displacement so far. Requires an impact with Detail::histories.
BitState bitState(const Impact& impact, std::span<const ContactInterval> contacts, double delta, double t);

/// Returns the same for a bit with this displacement towards the rock at each time.
BitState bitState(const std::function<double(double)>& displacementAt,
                  std::span<const ContactInterval> contacts, double delta, double t);

}  // namespace drillwave
