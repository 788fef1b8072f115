// SPDX-License-Identifier: GPL-3.0-or-later
// A bit mass on the rock: two quantities that drive each other.
#pragma once

#include <array>

#include "core/numeric/power_series.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// M V' + Z V + F = 2g, F' = κ V. All in units of the width of a cell where it is one.
struct OscillationRates {
    double impedance;  ///< Z
    double mass;       ///< M > 0
    double slope;      ///< κ > 0 of the law
    /// How fast the solution may change [1/time]: the scale of its series.
    double fastest() const;
};

/// Velocity and force over a piece of a cell: Taylor series in 0 ≤ v ≤ 1.
struct OscillationPiece {
    static constexpr int capacity = 24;
    double width = 1;  ///< of the piece [time]
    std::array<double, capacity> velocity;
    std::array<double, capacity> force;

    double velocityAt(double v) const { return polynomialValue(velocity.data(), capacity, v); }
    double forceAt(double v) const { return polynomialValue(force.data(), capacity, v); }
};

/// From `velocity` and `force` on over `width` [time] with `width · fastest()` ≤ 1; `g` are the powers of the
/// arriving wave over just that piece.
OscillationPiece oscillationPiece(const OscillationRates& rates, const WaveCell::Powers& g, double width,
                                  double velocity, double force);

/// The solution over a whole cell as a linear map.
class Oscillation {
  public:
    Oscillation() = default;
    Oscillation(const OscillationRates& rates, double width);

    /// The moments of V and F; `velocity` and `force` become those at the end.
    void follow(const WaveCell& g, double& velocity, double& force, WaveCell& velocities,
                WaveCell& forces) const;

  private:
    static constexpr int inputs = WaveCell::count + 2;  // g, V, F
    struct Column {
        WaveCell velocities, forces;
        double velocity = 0, force = 0;
    };
    static Column columnOf(const OscillationRates& rates, double width, const WaveCell& g, double velocity,
                           double force);
    std::array<Column, inputs> m_columns{};
};

}  // namespace drillwave
