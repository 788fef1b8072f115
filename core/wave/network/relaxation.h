// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity that follows another one at a rate: rock force, face force, lumped mass.
#pragma once

#include <array>

#include "core/numeric/power_series.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// A Taylor series of the solution of y' = rate (q − y) from one point of a cell on.
struct RelaxationPiece {
    static constexpr int capacity = 20;
    double from = 0;   ///< where in the cell it begins, in its width
    double width = 1;  ///< u = from + width v, 0 ≤ v ≤ 1
    int count = 0;
    std::array<double, capacity> c;  ///< y = Σ c_k v^k

    double value(double v) const { return polynomialValue(c.data(), count, v); }
};

/// p(from + width v) of the powers p of u.
WaveCell::Powers seenFrom(const WaveCell::Powers& p, double from, double width);

/// Returns the next piece from `from` on, where y is `start`; it ends at `to`, or where the series ends to be
/// accurate. After the layer of a fast rate it is the slow solution q − q'/rate + …, exact for a cubic.
/// `input` are the powers of q over the cell, `rate` is in units of one over the width of the cell.
RelaxationPiece relaxationPiece(const WaveCell::Powers& input, double rate, double start, double from,
                                double to = 1);

/// Solution over a whole cell as a linear map, exact except for rounding: y' = rate (q − y).
class Relaxation {
  public:
    Relaxation() = default;
    /// `rate` > 0 in units of one over the width of the cell.
    explicit Relaxation(double rate);

    /// The moments of y for an input q and y at the start, which becomes y at the end.
    WaveCell follow(const WaveCell& q, double& y) const {
        WaveCell out;
        for (int k = 0; k < WaveCell::count; ++k) {
            double sum = m_ofStart[k] * y;
            for (int l = 0; l < WaveCell::count; ++l) sum += m_ofInput[l][k] * q.c[l];
            out.c[k] = sum;
        }
        double last = m_kept * y;
        for (int l = 0; l < WaveCell::count; ++l) last += m_endOfInput[l] * q.c[l];
        y = last;
        return out;
    }

  private:
    void makeFast(double rate);

    std::array<std::array<double, WaveCell::count>, WaveCell::count> m_ofInput{};  ///< [of q][of y]
    std::array<double, WaveCell::count> m_ofStart{};
    std::array<double, WaveCell::count> m_endOfInput{};
    double m_kept = 1;  ///< e^−rate
};

// A bit mass on the rock: two quantities that drive each other.

/// M V' + Z V + F = 2g, F' = κ V. All in units of the width of a cell where it is one.
struct OscillationRates {
    double impedance;  ///< Z
    double mass;       ///< M > 0
    double slope;      ///< κ > 0 of the law
    /// Returns the rate at which the solution may change [1/time]: the scale of its series.
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

/// Returns the piece from `velocity` and `force` over `width` [time] with `width · fastest()` ≤ 1; `g` are
/// the powers of the arriving wave over just that piece.
OscillationPiece oscillationPiece(const OscillationRates& rates, const WaveCell::Powers& g, double width,
                                  double velocity, double force);

/// The solution over a whole cell as a linear map.
class Oscillation {
  public:
    Oscillation() = default;
    Oscillation(const OscillationRates& rates, double width);

    /// Writes the moments of V and F; `velocity` and `force` become those at the end.
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
