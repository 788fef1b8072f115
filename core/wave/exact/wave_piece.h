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

    /// What free flight asks of every piece in every round trip: computed once.
    struct Way {
        Real whole;  ///< ∫ over the length
        Real most;   ///< an upper bound of ∫ over [0, x] for every x up to the length, and 0
        Real size;   ///< ≥ ∫|·|, what the rounding of the first is relative to
    };
    const Way& way() const {
        if (m_hasWay) return m_way;
        m_way = {this->integral(this->length), this->mostIntegral(), this->integralOfSizes()};
        m_hasWay = true;
        return m_way;
    }
    /// To be called when coefficients have been changed from outside.
    void forgetWay() { m_hasWay = false; }

    /// The interval [x, length]: it begins inside what was joined.
    void dropFront(Real x) {
        PowerSeries<Real>::dropFront(x);
        displacedAtStart = displaced;
        forgetWay();
    }
    /// Ends the interval at x.
    void shorten(Real x) {
        if (x == this->length) return;
        this->length = x;
        forgetWay();
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

  private:
    mutable Way m_way{};
    mutable bool m_hasWay = false;
};

}  // namespace drillwave
