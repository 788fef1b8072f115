// SPDX-License-Identifier: GPL-3.0-or-later
// How long waves take between a section of the uniform rod and the bit: the one place where that is known.
#pragma once

#include "core/wave/impact.h"

namespace drillwave {

/// Which way a wave runs.
enum class Heading { toBit, fromBit };

/// The delays of one blow, for the files of this folder only. s is the time at the bit since the arrival of
/// the first wave there, t the global time, ξ = x/L: rear end 0, bit 1; times in t0.
class RodDelays {
  public:
    explicit RodDelays(const Impact& impact)
        : m_arrival(impact.frontArrival), m_roundTrip(impact.roundTrip) {}

    double arrival() const { return m_arrival; }            ///< global time of s = 0
    double roundTrip() const { return m_roundTrip; }        ///< 2τ
    double transitTime() const { return m_roundTrip / 2; }  ///< τ

    /// When what is at ξ at time t gets to the bit, s = t + (1 − ξ)τ − arrival, or left it, t − (1 − ξ)τ −
    /// arrival.
    double atBit(Heading heading, double xi, double t) const {
        const double way = (1 - xi) * m_roundTrip / 2;
        return heading == Heading::toBit ? t - m_arrival + way : t - m_arrival - way;
    }
    /// What must be added to s to get the time t at which the same wave is at ξ.
    double shift(Heading heading, double xi) const {
        return m_arrival + (heading == Heading::toBit ? -1 : 1) * (1 - xi) * transitTime();
    }

  private:
    double m_arrival, m_roundTrip;
};

}  // namespace drillwave
