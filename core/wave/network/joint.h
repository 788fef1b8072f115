// SPDX-License-Identifier: GPL-3.0-or-later
// Joint of two sections: a step of impedance, a lumped mass, a loss (strings §3).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/wave/network/relaxation.h"
#include "core/wave/network/wave_cell.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Joint of two sections with impedances Z1 (hammer side) and Z2. The waves f1 and b2 arrive, b1 and f2
/// leave. With a lumped mass M of the velocity v:
///
///     M v' + (Z1 + Z2) v = 2(f1 − b2),   b1 = f1 − Z1 v,   f2 = b2 + Z2 v
///
/// Without a mass: b1 = b2 + R(f1 − b2), f2 = f1 + R(f1 − b2), R = (Z2 − Z1)/(Z1 + Z2). With a loss η, both
/// waves on the side of Z2 are multiplied by √(1 − η).
class Joint {
  public:
    Joint() = default;
    /// Creates the joint between the section `near` (hammer side) and the section `far`. Its mass and loss
    /// are those given for `near`. `velocity` is the initial velocity of the mass, in units of F0/Zr.
    Joint(const UniformSection& near, const UniformSection& far, double velocity)
        : m_impedance1(near.impedance),
          m_impedance2(far.impedance),
          m_toVelocity(2 / (near.impedance + far.impedance)),
          m_reflection((far.impedance - near.impedance) / (near.impedance + far.impedance)),
          m_mass(near.massAfter),
          m_passing(std::sqrt(1 - near.loss)),
          m_velocity(velocity) {}

    /// Sets the widths of the parts of a cell (time step), in order, in units of t0.
    void setWidths(const std::vector<double>& widths) {
        m_maps.clear();
        if (m_mass > 0)
            for (const double width : widths) m_maps.emplace_back(rate() * width);
    }

    /// Computes the leaving waves b1 and f2 from the arriving waves f1 and b2 for the next `count` time
    /// steps. The first of them is part number `part` of the `parts` parts of a cell. The results may
    /// overwrite the input: f2 = f1 and b1 = b2 are allowed.
    void step(const WaveCell* f1, const WaveCell* b2, WaveCell* b1, WaveCell* f2, std::size_t count,
              std::size_t part, std::size_t parts);

    /// Returns the reflection coefficient R of the joint for a wave from the hammer side, −1 … 1.
    double reflection() const { return m_reflection; }
    /// Returns the factor √(1 − η) by which the loss η of the joint reduces the amplitude of a transmitted
    /// wave.
    double passing() const { return m_passing; }
    /// Returns the lumped mass of the joint, M/(Zr t0); ≥ 0.
    double mass() const { return m_mass; }
    /// Returns the rate at which the velocity of the mass follows the waves, in units of 1/t0; requires a
    /// mass.
    double rate() const { return (m_impedance1 + m_impedance2) / m_mass; }
    /// Returns the velocity of the lumped mass, in units of F0/Zr, positive towards the rock.
    double velocity() const { return m_velocity; }
    /// Sets the velocity of the lumped mass, in units of F0/Zr, positive towards the rock.
    void setVelocity(double velocity) { m_velocity = velocity; }
    /// Computes the leaving waves b1 and f2 from the arriving waves f1 and b2 over one time step (a cell or a
    /// part of one) of the given width [t0]. Requires a lumped mass.
    void stepAlone(const WaveCell& f1, const WaveCell& b2, double width, WaveCell& b1, WaveCell& f2);

  private:
    void stepMass(const Relaxation& map, const WaveCell& f1, const WaveCell& b2, WaveCell& b1, WaveCell& f2);

    double m_impedance1 = 1, m_impedance2 = 1;
    double m_toVelocity = 1;  ///< factor 2/(Z1 + Z2) from waves to velocity
    double m_reflection = 0;  ///< reflection coefficient R of the joint, −1 … 1
    double m_mass = 0;
    double m_passing = 1;
    double m_velocity = 0;
    std::vector<Relaxation> m_maps;
};

}  // namespace drillwave
