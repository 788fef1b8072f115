// SPDX-License-Identifier: GPL-3.0-or-later
// The waves in the segments of the lattice: moved as the paper does, or standing in a ring.
#pragma once

#include <algorithm>
#include <vector>

#include "core/wave/lattice/hammer_cells.h"

namespace drillwave {

/// The rod of the paper's Appendix A: −Np and −Nn in each of L segments, all of them moved by one segment in
/// every step. Begins when the hammer strikes: the first wave arrives L steps later.
class MovedWaves {
  public:
    /// `uniform` is −Np = Nn everywhere at the beginning.
    void begin(int segments, double uniform, const PulseForce& pulse, double step) {
        m_positive.assign(static_cast<std::size_t>(segments), uniform);
        m_negative.assign(static_cast<std::size_t>(segments), -uniform);
        m_hammer = HammerCells(pulse, step);
    }
    /// Steps from the strike of the hammer to the first arrival at the front end.
    static long stepsAhead(int segments) { return segments; }
    /// Numbers moved in a step.
    static long movesPerStep(int segments) { return 2L * segments; }

    /// The incident wave g at the front end, which holds the hammer force that was added at the rear end.
    double arriving(double /*hammer*/) const { return m_positive.back(); }

    /// Moves every wave one segment on; `reflected` starts from the front end, the rear end is free apart
    /// from the hammer.
    void step(double reflected) {
        const double entering = m_hammer.next() - m_negative.front();
        std::copy_backward(m_positive.begin(), m_positive.end() - 1, m_positive.end());
        std::copy(m_negative.begin() + 1, m_negative.end(), m_negative.begin());
        m_positive.front() = entering;
        m_negative.back() = reflected;
    }

  private:
    std::vector<double> m_positive, m_negative;  ///< −Np, −Nn; the first segment is at the rear end
    HammerCells m_hammer;
};

/// The same numbers where they are: what leaves the front end is kept until it is back, 2L steps later.
class RingWaves {
  public:
    void begin(int segments, double uniform, const PulseForce&, double) {
        m_reflected.assign(2 * static_cast<std::size_t>(segments), -uniform);
        m_next = 0;
    }
    static long stepsAhead(int) { return 0; }
    static long movesPerStep(int) { return 1; }

    double arriving(double hammer) const { return hammer - m_reflected[m_next]; }
    void step(double reflected) {
        m_reflected[m_next] = reflected;
        if (++m_next == m_reflected.size()) m_next = 0;
    }

  private:
    std::vector<double> m_reflected;
    std::size_t m_next = 0;
};

}  // namespace drillwave
