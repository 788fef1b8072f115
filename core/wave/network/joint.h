// SPDX-License-Identifier: GPL-3.0-or-later
// Where one section meets the next: a step of impedance, a lumped mass, a loss (strings §3).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Two sections end to end; f1 and b2 arrive, b1 and f2 leave. With a mass
///
///     M v' + (Z1 + Z2) v = 2(f1 − b2),   b1 = f1 − Z1 v,   f2 = b2 + Z2 v
///
/// without one b1 = b2 + R(f1 − b2), f2 = f1 + R(f1 − b2), R = (Z2 − Z1)/(Z1 + Z2). A loss weakens the
/// transmitted wave on the far side by √(1 − η), in either direction.
class Joint {
  public:
    Joint() = default;
    Joint(const UniformSection& near, const UniformSection& far, double velocity)
        : m_impedance1(near.impedance),
          m_impedance2(far.impedance),
          m_toVelocity(2 / (near.impedance + far.impedance)),
          m_reflection((far.impedance - near.impedance) / (near.impedance + far.impedance)),
          m_mass(near.massAfter),
          m_passing(std::sqrt(1 - near.loss)),
          m_velocity(velocity) {}

    /// The cells that follow have these widths [t0], in turn.
    void setWidths(const std::vector<double>& widths) {
        m_maps.clear();
        if (m_mass > 0)
            for (const double width : widths) m_maps.emplace_back(rate() * width);
    }

    /// Takes the next `count` cells from part number `part` of `parts` on. f1 = f2 and b2 = b1 are allowed.
    void step(const WaveCell* f1, const WaveCell* b2, WaveCell* b1, WaveCell* f2, std::size_t count,
              std::size_t part, std::size_t parts);

    double reflection() const { return m_reflection; }
    /// Amplitude that passes the loss.
    double passing() const { return m_passing; }
    double mass() const { return m_mass; }
    double rate() const { return (m_impedance1 + m_impedance2) / m_mass; }
    double velocity() const { return m_velocity; }  ///< of the mass
    void setVelocity(double velocity) { m_velocity = velocity; }
    /// Takes a single cell, or part of a cell, of this width; requires a mass.
    void stepAlone(const WaveCell& f1, const WaveCell& b2, double width, WaveCell& b1, WaveCell& f2);

  private:
    void stepMass(const Relaxation& map, const WaveCell& f1, const WaveCell& b2, WaveCell& b1, WaveCell& f2);

    double m_impedance1 = 1, m_impedance2 = 1;
    double m_toVelocity = 1;  ///< 2/(Z1 + Z2)
    double m_reflection = 0;  ///< R
    double m_mass = 0;
    double m_passing = 1;
    double m_velocity = 0;
    std::vector<Relaxation> m_maps;
};

}  // namespace drillwave
