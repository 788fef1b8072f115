// SPDX-License-Identifier: GPL-3.0-or-later
// Analytical solution of the paper for elastic rock and reflections that do not overlap (theory §5).
#pragma once

#include <string>

#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// All functions hold for γ = 1, a whole number δ and a rectangular pulse; β > 0. Forces are in F0, impulses
// in I0, times in t0 from the arrival of each wave at the front end.

/// Returns F1(t)/F0 ≥ 0, the first pulse of the impact force [paper (11)], for β = `beta`. `t` is in t0 from
/// the arrival of the first wave at the front end. The impulse of this pulse is 2 I0.
double firstForcePulse(double beta, double t);

/// Returns F3(t)/F0 ≥ 0, the second pulse of the impact force, caused by the returning wave [paper (12)]
/// [paper (14)]. `t` is in t0 from the arrival of that wave at the front end. The pulse is 0 from its end ts
/// on.
double secondForcePulse(double beta, double t);

/// Returns ts/t0, the duration of the second pulse of the impact force, from the arrival of the returning
/// wave at the front end [paper (12)] [paper (14)].
double secondPulseEnd(double beta);

/// Returns I3/I0, the impulse of the second pulse of the impact force [paper (13)] [paper (15)].
double secondPulseImpulse(double beta);

/// Returns the coefficient of restitution e = 1 + I3/I0 of the closed form [paper (10)], accurate to rounding
/// for every β > 0. I3 is the impulse of the second force pulse. For β → 0, e approaches 4e^(−1/2) − 1.
double closedFormRestitution(double beta);

/// Returns the impulse that the closed form of the coefficient of restitution e neglects, in units of I0, for
/// β = `beta` and τ = `tau`. It is the tail of the first force pulse after the end of the second one, (2/β)(1
/// − e^(−β)) e^(−β(2τ + ts − 1)) (T29). If overlapIsSmall(), 0 ≤ closed form − e ≤ this value. The tail
/// prolongs the contact beyond the end of the second pulse. The true impact force during this time is smaller
/// than the tail, because the formula of the second pulse would give tension there.
double neglectedOverlap(double beta, double tau);

/// Returns whether the closed form is valid for β = `beta` and τ = `tau`. The two pulses of the impact force
/// must overlap little: the contact ends before the third wave arrives, and no further contact follows.
bool overlapIsSmall(double beta, double tau);

/// Returns the reason why the closed form cannot solve a blow; an empty message if it can. It requires a
/// uniform rod, a rock law of one line with γ = 1, and a gap δ = d/d0 that is a whole number. The pulse must
/// be rectangular and not longer than a round trip.
Message closedFormRefusal(const Problem& problem);

/// Returns the closed form as the result of a blow. `corError` contains the overlap that the closed form
/// neglects. The recorded impact force consists of the paper's two pulses without their overlap. Momentum and
/// energy are therefore not exactly balanced. The blow is not solved, with a reason, if closedFormRefusal()
/// gives one or the overlap is not small.
Impact solveClosedForm(const Problem& problem, Detail detail = Detail::cor);

}  // namespace drillwave
