// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of the wave in the rod, and how far joining it to its neighbours has displaced it.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/numeric/power_series.h"

namespace drillwave {

/// A wave force on a short interval, and what joining may have made of its integral, the way of the bit.
/// Joined pieces keep the impulse of both, so that the way is right before and behind them, and wrong
/// between.
template <class Real>
struct WavePiece : PowerSeries<Real> {
    Real displaced = 0;         ///< about the largest |∫(joined − exact)| up to any place in it, I0
    Real displacedAtStart = 0;  ///< the same at its start: 0 unless it was cut out of a joined piece

    WavePiece() = default;
    WavePiece(const PowerSeries<Real>& exact) : PowerSeries<Real>(exact) {}

    /// The interval [x, length]: it begins inside what was joined.
    void dropFront(Real x) {
        PowerSeries<Real>::dropFront(x);
        displacedAtStart = displaced;
    }
    /// Displaced like `other`, from which it is made.
    void displaceLike(const WavePiece& other) {
        displaced = other.displaced;
        displacedAtStart = other.displacedAtStart;
    }
    /// Joined to a piece behind it at the price of `more`. Displacements have either sign, and add up as
    /// such.
    void displace(const WavePiece& next, Real more) {
        const Real before = std::max(displaced, next.displaced);
        displaced = std::sqrt(before * before + more * more);
    }
};

}  // namespace drillwave
