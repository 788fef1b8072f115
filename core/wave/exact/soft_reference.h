// SPDX-License-Identifier: GPL-3.0-or-later
// The reference case on very soft rock: a rigid mass on a spring, with the first correction for its waves.
#pragma once

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Whether softReference() gives every digit: βτ/γ is so small that the waves take millions of round trips
/// through a contact, and matter less than rounding.
bool isSoftReference(const Problem& problem);

/// The reference case for βτ → 0, expanded to the first order (the next, (βτ)^(3/2), is below rounding):
///   e = √γ + (1 − γ)βτ/(6√γ),   Fm = √(β/τ)(1 − βτ/6)      (T30),
/// loading for (π/2)√(τ/β)(1 + βτ/6), unloading for √γ times as long with βτ/γ instead of βτ (T31). |error of
/// e| ≤ corError = (βτ)^(3/2)/γ + rounding, checked against the march where both exist. Has no histories:
/// Detail::histories is refused as not solved.
Impact softReference(const Problem& problem, Detail detail);

}  // namespace drillwave
