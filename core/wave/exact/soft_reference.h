// SPDX-License-Identifier: GPL-3.0-or-later
// Reference case on very soft rock: a rigid mass on a spring, with the first-order correction for its waves.
#pragma once

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Returns whether softReference() is exact to rounding for a blow: the reference case (a rod that arrives as
/// a rigid body) with βτ/γ ≤ 1e-12. Waves then make millions of round trips in one contact, and have less
/// effect than rounding.
bool isSoftReference(const Problem& problem);

/// Returns the solution of the reference case (a rod that arrives as a rigid body) on very soft rock, βτ → 0.
/// It is expanded to the first order; the next order, (βτ)^(3/2), is below rounding:
///
///     e = √γ + (1 − γ)βτ/(6√γ),   Fm = √(β/τ)(1 − βτ/6)      (T30).
///
/// Loading takes (π/2)√(τ/β)(1 + βτ/6), unloading √γ times as long with βτ/γ instead of βτ (T31). The error
/// of e is at most corError = (βτ)^(3/2)/γ + rounding, checked against ExactSolver where both exist. There
/// are no histories: Detail::histories gives a blow that is not solved.
Impact softReference(const Problem& problem, Detail detail);

}  // namespace drillwave
