// SPDX-License-Identifier: GPL-3.0-or-later
// The hammer force as a dimensionless function of time with unit impulse, ready for the solvers.
#pragma once

#include <string_view>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// Smooth piece of Fa(t)/F0 on [start, start + length], times in t0, local time x = t − start ≥ 0:
///   linear       value + slope·x
///   sine         amplitude·sin(π(start + x))        (half_sine; `value` is the amplitude)
///   exponential  value·exp(−x)                       (rate 1/t0)
struct PulseSegment {
    enum class Kind { linear, sine, exponential };
    Kind kind = Kind::linear;
    double start = 0;          ///< t0
    double length = 0;         ///< t0, > 0
    double value = 0;          ///< F0, ≥ 0
    double slope = 0;          ///< F0/t0
    double impulseBefore = 0;  ///< ∫Fa from 0 to start, 0 … 1

    double forceAt(double x) const;                ///< Fa(start + x)/F0
    double impulseOf(double x) const;              ///< ∫Fa from start to start + x, 0 … 1
    double energyOf(double from, double x) const;  ///< ∫Fa² over x from start + from on [F0² t0]
    bool operator==(const PulseSegment&) const = default;
};

/// Fa/F0 ≥ 0 with ∫ = 1 over all segments, contiguous from 0. Empty for the reference case.
struct PulseForce {
    PulseShape shape = PulseShape::rectangular;
    std::vector<PulseSegment> segments;
    double end = 0;  ///< the force is zero from here on; beyond it less than 1e-20 of the impulse was cut off
    double peak = 0;  ///< largest value
    /// Upper bound of ∫|δFa| by rounding of given points of a table; 0 for other shapes.
    double rounding = 0;
    bool operator==(const PulseForce&) const = default;

    bool isRigidBody() const { return shape == PulseShape::rigidBody; }
    double operator()(double t) const;    ///< Fa(t)/F0, right-continuous; 0 outside
    double impulseUntil(double t) const;  ///< ∫0..t Fa, 0 … 1
};

/// A piston that needs more steps than this, or a table of more points, is refused by validate().
inline constexpr int maximumPulseSegments = 100000;

/// Steps of a piston's staircase until less than 1e-20 of the impulse is left, for any impedance ratio q > 0.
double pistonStepCount(double impedanceRatio);

/// Builds the force of a valid scenario; a piston's staircase is F_n ∝ R^n (T12), R = (q−1)/(q+1) for
/// impedance ratio q = Z_hammer/Z_rod > 1, a single step for q ≤ 1 (the hammer rebounds after it). Steps last
/// t0 each.
PulseForce pulseForceOf(const Scenario& scenario);

/// Returns whether the force over t/t0 of such a shape depends on a parameter; otherwise pulseForceOf() is
/// the same for all its values.
bool movesPulseForce(std::string_view key, PulseShape shape);

/// Returns the force of a shape with default parameters, as in a dimensionless scenario; not for `table`.
PulseForce pulseForceOf(PulseShape shape, double impedanceRatio = 1);

// Visible part of a hammer force: the tails of an exponential blow and of a staircase are long and empty.

/// Returns the times t/t0, ascending from 0, at which a curve of the impulse of the hammer is drawn: it is
/// smooth inside a segment. Only 0 in the reference case.
std::vector<double> impulseTimes(const PulseForce& pulse);

/// Returns the first of these times [t0] at which the rod has practically the whole impulse; later changes
/// are invisible in a curve of the impulse or the momentum. 0 in the reference case.
double visibleImpulseEnd(const PulseForce& pulse);

/// Returns the end [t0] of the segment in which that happens, or its time for an exponential segment; later
/// changes are invisible among the waves, which show whole segments. 0 in the reference case.
double visibleWavesEnd(const PulseForce& pulse);

/// Returns the time [t0] from which the curve of the force looks like zero. 0 in the reference case.
double visibleForceEnd(const PulseForce& pulse);

}  // namespace drillwave
