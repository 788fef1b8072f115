// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's analytical solution for an elastic rock and reflections that do not overlap (theory §5).
#pragma once

#include <string>

#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

// All for γ = 1, whole δ and the rectangular pulse; forces in F0, impulses in I0, times in t0 from the
// arrival of each wave at the front end. β > 0.

/// F1, the first pulse of the impact force [paper (11)]; its impulse I1 is 2.
double firstForcePulse(double beta, double t);

/// Returns F3, the second pulse, due to the returning wave; 0 from ts on [paper (12)] [paper (14)].
double secondForcePulse(double beta, double t);

/// ts, the end of the second pulse [paper (12)] [paper (14)].
double secondPulseEnd(double beta);

/// I3, the impulse of the second pulse [paper (13)] [paper (15)].
double secondPulseImpulse(double beta);

/// e = 1 + I3 [paper (10)]; 4e^(−1/2) − 1 for β → 0. Accurate to rounding for every β.
double closedFormRestitution(double beta);

/// Returns the integral that the closed form leaves out, from the end of the second pulse on: the tail of the
/// first, (2/β)(1 − e^(−β)) e^(−β(2τ + ts − 1)) (T29). Where overlapIsSmall(), 0 ≤ closed form − e ≤ this:
/// the tail keeps the contact closed a little longer, while the second pulse by itself would pull and the
/// tail pushes more.
double neglectedOverlap(double beta, double tau);

/// Whether the contact ends before the next wave arrives, and none follows.
bool overlapIsSmall(double beta, double tau);

/// Returns why the closed form does not cover this blow: γ ≠ 1, a gap that is no whole δ, another pulse, or a
/// pulse longer than a round trip. Empty if it does.
Message closedFormRefusal(const Problem& problem);

/// Returns the closed form as an impact like that of the other solvers. `corError` is the neglected overlap.
/// Histories are those of the paper, each pulse by itself, so the balances of momentum and energy miss the
/// overlap. Not solved, with the reason, where it is refused or the overlap is not small.
Impact solveClosedForm(const Problem& problem, Detail detail = Detail::cor);

}  // namespace drillwave
