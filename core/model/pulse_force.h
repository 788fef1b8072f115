// SPDX-License-Identifier: GPL-3.0-or-later
// Hammer force as a dimensionless function of time with unit impulse, as the solvers use it.
#pragma once

#include <string_view>
#include <vector>

#include "core/model/scenario.h"

namespace drillwave {

/// Smooth part of the hammer force Fa(t)/F0 on [start, start + length], times in t0, local time
/// x = t − start ≥ 0:
///   linear       value + slope·x
///   sine         amplitude·sin(π(start + x))        (half_sine; `value` is the amplitude)
///   exponential  value·exp(−x)                       (rate 1/t0)
struct PulseSegment {
    enum class Kind { linear, sine, exponential };
    Kind kind = Kind::linear;
    double start = 0;          ///< start of the segment, in units of t0
    double length = 0;         ///< length of the segment, in units of t0, > 0
    double value = 0;          ///< force at the start, or amplitude of a sine, in units of F0, ≥ 0
    double slope = 0;          ///< slope of a linear segment, in units of F0/t0
    double impulseBefore = 0;  ///< impulse of the force before the segment, as a share of I0, 0 … 1

    /// Returns the force at the time x (in t0) after the start of the segment, in units of F0.
    double forceAt(double x) const;
    /// Returns the impulse from the start of the segment to the time x (in t0) after it, as a share of I0, 0
    /// … 1.
    double impulseOf(double x) const;
    /// Returns ∫Fa² of this segment from the time `from` to the time from + x, in units of F0² t0. Both times
    /// are in units of t0 and count from the start of the segment.
    double energyOf(double from, double x) const;
    bool operator==(const PulseSegment&) const = default;
};

/// Hammer force Fa/F0 ≥ 0 over time. Its segments follow one another from time 0 without gaps. The total
/// impulse, in units of I0, is 1. The reference case of a rod that arrives with uniform velocity has no
/// segments.
struct PulseForce {
    PulseShape shape = PulseShape::rectangular;
    std::vector<PulseSegment> segments;
    /// Time after which the force is zero, in units of t0. An endless force is cut off there, which neglects
    /// less than 1e-20 of its impulse.
    double end = 0;
    /// Largest force, in units of the mean force F0.
    double peak = 0;
    /// Upper bound of ∫|δFa| as a share of I0, where δFa is the error of the force due to rounding of the
    /// points of a table. It is 0 for other shapes.
    double rounding = 0;
    bool operator==(const PulseForce&) const = default;

    bool isRigidBody() const { return shape == PulseShape::rigidBody; }
    /// Returns the force Fa(t)/F0 at a time t in units of t0. At a jump it is the value after the jump; 0
    /// before time 0 and after the end.
    double operator()(double t) const;
    /// Returns the impulse from time 0 to t (in units of t0), as a share of the total impulse I0 of the
    /// hammer force.
    double impulseUntil(double t) const;
};

/// Largest number of steps of the force of a piston, and of points of a force table. validate() reports an
/// error if there are more.
inline constexpr int maximumPulseSegments = 100000;

/// Returns the number of steps that the force of a piston needs to give all but 1e-20 of its impulse. The
/// force is constant during a step, which lasts t0. Requires an impedance ratio q > 0.
double pistonStepCount(double impedanceRatio);

/// Returns the hammer force of a valid scenario. A piston gives steps of the duration t0 with F_n ∝ R^n
/// (T12), where R = (q − 1)/(q + 1) and q = Z_hammer/Z_rod > 1. For q ≤ 1 there is a single step, after which
/// the hammer stops (q = 1) or rebounds.
PulseForce pulseForceOf(const Scenario& scenario);

/// Returns whether the parameter `key` changes the dimensionless force F/F0 over t/t0 of this shape. If
/// false, pulseForceOf() is the same for all values of the parameter and need not be called again.
bool movesPulseForce(std::string_view key, PulseShape shape);

/// Returns the force of a shape with default parameters, as in a dimensionless scenario. The shape must not
/// be `table`.
PulseForce pulseForceOf(PulseShape shape, double impedanceRatio = 1);

// Visible part of a hammer force: an exponential force and the steps of a piston end with a long, almost
// empty tail.

/// Returns the times, in units of t0 and ascending from 0, at which a plot shows the impulse of the hammer
/// force. They are close together where the impulse over time is curved. Returns only 0 without a hammer
/// force.
std::vector<double> impulseTimes(const PulseForce& pulse);

/// Returns the time, in units of t0, up to which plots of impulse and momentum over time are needed. It is
/// the first of impulseTimes() at which the force has given 97 % of its impulse. Returns 0 without a hammer
/// force.
double visibleImpulseEnd(const PulseForce& pulse);

/// Returns the time, in units of t0, after which a plot no longer shows changes of the waves caused by the
/// hammer force. It is the end of the segment in which the impulse reaches 97 %. For an exponential force it
/// is the time at which 97 % is reached. Returns 0 without a hammer force.
double visibleWavesEnd(const PulseForce& pulse);

/// Returns the time, in units of t0, from which the force is too small to be seen in a plot. Returns 0
/// without a hammer force.
double visibleForceEnd(const PulseForce& pulse);

}  // namespace drillwave
