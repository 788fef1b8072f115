// SPDX-License-Identifier: GPL-3.0-or-later
// Solutions within a cell (time step) of y' = rate (q − y), for the force on the rock, the force of the
// hammer face and lumped masses.
#pragma once

#include <array>

#include "core/numeric/power_series.h"
#include "core/wave/network/wave_cell.h"

namespace drillwave {

/// Taylor series of the solution of y' = rate (q − y) over a part of a cell (time step).
struct RelaxationPiece {
    /// Maximum number of terms of the Taylor series.
    static constexpr int capacity = 20;
    /// Start of this part of the cell (time step), as a fraction of the cell, 0 … 1.
    double from = 0;
    /// Width of the part, as a fraction of the cell (time step): u = from + width v, 0 ≤ v ≤ 1.
    double width = 1;
    /// Number of terms of the Taylor series, ≤ capacity.
    int count = 0;
    /// Coefficients of the series y = Σ c_k v^k, where v is the fraction of the part, 0 ≤ v ≤ 1.
    std::array<double, capacity> c;

    /// Returns the solution y at v, a fraction of the part from 0 to 1.
    double value(double v) const { return polynomialValue(c.data(), count, v); }
};

/// Returns the coefficients of a polynomial p(u) for a new variable v with u = from + width v. `p` holds its
/// coefficients of powers of u; the result holds those of powers of v.
WaveCell::Powers seenFrom(const WaveCell::Powers& p, double from, double width);

/// Returns the Taylor series of y for y' = rate (q − y) with y = `start` at the fraction `from` of the cell
/// (time step). It ends at the fraction `to`, or earlier where it would become inaccurate. If `rate` is large
/// and y already follows q, it is q − q'/rate + …, which is exact for a cubic q. `input` holds the
/// coefficients of powers of q over the cell; `rate` is per width of the cell.
RelaxationPiece relaxationPiece(const WaveCell::Powers& input, double rate, double start, double from,
                                double to = 1);

/// Linear map from the input q to the solution y of y' = rate (q − y) over a whole cell (time step), exact
/// except for rounding.
class Relaxation {
  public:
    Relaxation() = default;
    /// Creates the linear map for one cell (time step). `rate` > 0 is dimensionless: the rate times the width
    /// of the cell.
    explicit Relaxation(double rate);

    /// Returns the solution y over the cell for the input q, both as Legendre coefficients. `y` is the value
    /// at the start of the cell, and becomes the value at its end.
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

    /// Legendre coefficients of the solution y for each Legendre coefficient of the input q; indices [of
    /// q][of y]
    std::array<std::array<double, WaveCell::count>, WaveCell::count> m_ofInput{};
    std::array<double, WaveCell::count> m_ofStart{};
    std::array<double, WaveCell::count> m_endOfInput{};
    double m_kept = 1;  ///< factor e^−rate of the initial value
};

// Motion of a bit with mass on the rock, within a cell

/// Coefficients of M V' + Z V + F = 2g, F' = κ V, for the velocity V of a bit with mass M and the force F of
/// the rock. Times may be in any unit, such as the width of a cell.
struct OscillationRates {
    /// Impedance Z of the last section of the string.
    double impedance;
    /// Mass M of the bit; > 0.
    double mass;
    /// Stiffness κ of the present line of the rock law; > 0.
    double slope;
    /// Returns the fastest rate of the solution, max(Z/M, √(κ/M)), per unit of time. The Taylor series
    /// converges fast over widths up to its inverse.
    double fastest() const;
};

/// Taylor series of velocity and force of a bit with mass over a part of a cell (time step), for 0 ≤ v ≤ 1.
struct OscillationPiece {
    /// Number of terms of the Taylor series of velocity and of force.
    static constexpr int capacity = 24;
    /// Width of the part of the cell (time step), in the unit of time of OscillationRates.
    double width = 1;
    /// Coefficients c_k of the bit velocity V = Σ c_k v^k, where v is the fraction of the part of the cell, 0
    /// ≤ v ≤ 1.
    std::array<double, capacity> velocity;
    /// Coefficients c_k of the force on the rock, F = Σ c_k v^k, where v is the fraction of the part of the
    /// cell, 0 ≤ v ≤ 1.
    std::array<double, capacity> force;

    /// Returns the velocity of the bit, positive towards the rock, at the fraction v of the part of the cell,
    /// 0 ≤ v ≤ 1.
    double velocityAt(double v) const { return polynomialValue(velocity.data(), capacity, v); }
    /// Returns the force on the rock at the fraction v of the part of the cell, 0 ≤ v ≤ 1.
    double forceAt(double v) const { return polynomialValue(force.data(), capacity, v); }
};

/// Returns the Taylor series of velocity and force of a bit with mass over a part of a cell (time step). It
/// starts with the given `velocity` and `force`; width · rates.fastest() ≤ 1 is required. `g` holds the
/// coefficients of powers of the arriving wave over this part only.
OscillationPiece oscillationPiece(const OscillationRates& rates, const WaveCell::Powers& g, double width,
                                  double velocity, double force);

/// Linear map from the arriving wave and the state at the start of a cell (time step) to velocity and force
/// over the cell. It describes a bit with mass on the rock.
class Oscillation {
  public:
    Oscillation() = default;
    /// Creates the map for a cell (time step) of this width, in the unit of time of `rates`.
    Oscillation(const OscillationRates& rates, double width);

    /// Computes velocity and force of the bit over one cell (time step) from the arriving wave `g`, and
    /// writes them to `velocities` and `forces`. `velocity` and `force` are the values at its start; they are
    /// replaced by those at its end.
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
