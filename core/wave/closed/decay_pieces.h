// SPDX-License-Identifier: GPL-3.0-or-later
// Waves that decay with one rate, as pieces of a history.
#pragma once

#include <cmath>

#include "core/wave/impact.h"

namespace drillwave {

/// f(u) = A + (B + C u) e^(−βu), u ≥ 0.
struct Decay {
    double constant = 0;
    double amplitude = 0;
    double growth = 0;

    double value(double u, double beta) const {
        return constant + (amplitude + growth * u) * std::exp(-beta * u);
    }
    /// The same function with u counted from `start`.
    Decay from(double start, double beta) const {
        const double decay = std::exp(-beta * start);
        return {constant, (amplitude + growth * start) * decay, growth * decay};
    }
};

inline Decay operator-(const Decay& f, const Decay& g) {
    return {f.constant - g.constant, f.amplitude - g.amplitude, f.growth - g.growth};
}

/// Appends incident wave and force as power series, exact to rounding, and sums over them.
class DecayPieces {
  public:
    /// The pieces go to the histories of `impact`, if there is one.
    DecayPieces(double beta, Impact* impact) : m_beta(beta), m_impact(impact) {}

    /// A stretch of that length, both functions counted from its beginning. At most about fifty pieces,
    /// however large β is: then nothing is left of the decay.
    void append(double length, Decay incident, Decay force);

    /// From here on count the sums of momentum ∫g, energy ∫g² and work on the rock ∫F (2g − F).
    void beginSums() { m_momentum = m_energy = m_rockWork = 0; }
    double momentum() const { return m_momentum; }
    double energy() const { return m_energy; }
    double rockWork() const { return m_rockWork; }
    long count() const { return m_count; }

  private:
    void appendPiece(double length, const Decay& incident, const Decay& force);

    double m_beta;
    Impact* m_impact;
    double m_momentum = 0, m_energy = 0, m_rockWork = 0;
    long m_count = 0;
};

}  // namespace drillwave
