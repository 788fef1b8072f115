// SPDX-License-Identifier: GPL-3.0-or-later
// Histories that are constant in each step of the lattice.
#pragma once

#include <cstddef>
#include <span>

#include "core/wave/impact.h"

namespace drillwave {

/// Appends the steps of the front end to the histories of an impact; steps that are alike become one piece.
class StepHistory {
  public:
    void begin(double step) {
        m_step = step;
        m_count = 0;
        m_pieces = 0;
    }

    /// One more step with incident wave g and force F.
    void add(double g, double force, Impact& impact) {
        if (m_count > 0 && (g != m_incident || force != m_force)) flush(impact);
        m_incident = g;
        m_force = force;
        ++m_count;
    }
    /// Hands over the steps not yet in the histories.
    void flush(Impact& impact) {
        if (m_count == 0) return;
        const double length = double(m_count) * m_step;
        impact.incident.append(length, length, coefficients(m_incident));
        impact.force.append(length, length, coefficients(m_force));
        ++m_pieces;
        m_count = 0;
    }
    std::size_t pieces() const { return m_pieces; }

  private:
    static std::span<const double> coefficients(const double& value) {
        return {&value, value == 0 ? 0U : 1U};
    }

    double m_step = 1;
    double m_incident = 0, m_force = 0;
    long m_count = 0;
    std::size_t m_pieces = 0;
};

}  // namespace drillwave
