// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the histories of an impact at many times, each near the one before.
#pragma once

#include <cstddef>

#include "core/wave/impact.h"

namespace drillwave {

/// Gives exactly what incidentWave() and impactForce() give, but walks from piece to piece instead of
/// searching for each time. Needs an impact solved with Detail::histories, which must outlive the reader.
class HistoryReader {
  public:
    explicit HistoryReader(const Impact& impact);

    /// g(s), any s [t0 → F0].
    double incident(double s);
    /// r(s) = F(s) − g(s), any s [t0 → F0].
    double reflected(double s);
    /// Pieces looked at on the way so far.
    long steps() const { return m_steps; }

  private:
    bool seek(double s);
    bool holds(std::size_t index, double recorded) const;
    std::size_t find(double recorded);

    const Impact& m_impact;
    const double m_before;  // g at s < 0
    std::size_t m_index = 0;
    double m_local = 0;  // time since the piece began
    long m_steps = 0;
};

}  // namespace drillwave
