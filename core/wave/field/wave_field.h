// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of a blow at any section and at any time (theory §3).
#pragma once

#include "core/wave/field/rod_delays.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Looks up what the rod does. t is the global time in t0 from the beginning of the hammer force (from first
/// contact in the reference case), any time; ξ = x/L, rear end 0 … bit 1. Forces in F0, impulses in I0.
///
/// Needs an impact solved with Detail::histories, which must outlive the field; arrival() and roundTrip() are
/// known with Detail::summary.
class WaveField {
  public:
    explicit WaveField(const Impact& impact) : m_impact(&impact), m_delays(impact) {}

    /// When the first wave reaches the bit; 0 in the reference case, which begins there.
    double arrival() const { return m_delays.arrival(); }
    /// How long a wave takes there and back through the rod. Waves that are left alone repeat themselves.
    double roundTrip() const { return m_delays.roundTrip(); }

    double impactForce(double t) const;    ///< F(t) ≥ 0 of bit and rock
    double impactImpulse(double t) const;  ///< ∫F up to t

    double positiveWave(double xi, double t) const;  ///< Np, which runs to +x, the bit; tension positive
    double negativeWave(double xi, double t) const;  ///< Nn, which runs to −x; tension positive
    double force(double xi, double t) const;         ///< N = Np + Nn, tension positive
    double velocity(double xi, double t) const;      ///< v = (Nn − Np)/Z [F0/Z], positive towards the rock

  private:
    const Impact* m_impact;
    RodDelays m_delays;
};

}  // namespace drillwave
