// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/pulse_force.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/model/scales.h"
#include "core/numeric/compensated_sum.h"

namespace drillwave {

namespace {

using Kind = PulseSegment::Kind;

/// Natural logarithm of the share of the impulse at which an endless pulse is cut off: e^−46.06.
constexpr double cutOff = 46.06;

/// Scales the forces, whose largest is 1, so that the impulse is 1, and completes what follows from the
/// segments.
void finish(PulseForce& force) {
    if (force.segments.empty()) return;
    CompensatedSum<double> total;
    for (const PulseSegment& segment : force.segments) total += segment.impulseOf(segment.length);
    CompensatedSum<double> before;
    for (PulseSegment& segment : force.segments) {
        segment.value /= total;
        segment.slope /= total;
        segment.impulseBefore = before;
        before += segment.impulseOf(segment.length);
    }
    force.peak = 1 / total;
    force.end = force.segments.back().start + force.segments.back().length;
}

/// A straight line from (t0, f0) to (t1, f1); nothing for a jump.
void appendLine(PulseForce& force, double t0, double f0, double t1, double f1) {
    const double length = t1 - t0;
    if (length > 0) force.segments.push_back({Kind::linear, t0, length, f0, (f1 - f0) / length});
}

void appendTrapezoid(PulseForce& force, double rise, double fall) {
    appendLine(force, 0, 0, rise, 1);
    // With rise + fall = 1 but for rounding there is no plateau.
    const double fallStart = std::max(1 - fall, rise);
    appendLine(force, rise, 1, fallStart, 1);
    appendLine(force, fallStart, 1, 1, 0);
}

void appendStaircase(PulseForce& force, double impedanceRatio) {
    // R^n from the logarithm of R = 1 − 2/(q + 1), which keeps its digits where R is close to 1.
    const double logarithm = std::log1p(-2 / (impedanceRatio + 1));
    const int steps = static_cast<int>(pistonStepCount(impedanceRatio));
    for (int n = 0; n < steps; ++n)
        force.segments.push_back(
            {Kind::linear, static_cast<double>(n), 1, n == 0 ? 1 : std::exp(n * logarithm), 0});
}

/// Times of the points, from 0 to 1. Points that are closer than rounding have the same time: a jump, which a
/// file gives by two values at one time.
std::vector<double> timesOf(const TablePoints& points) {
    constexpr double rounding = 1e-15;  // share of the duration
    const double least = rounding * (points.back().time - points.front().time);
    std::vector<double> times{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double time = points[i].time - points.front().time;
        times.push_back(time - times.back() > least ? time : times.back());
    }
    const double duration = times.back();
    for (double& time : times) time /= duration;
    return times;
}

/// The table from time 0 to 1; forces relative to the largest, so that no sum can overflow.
void appendTable(PulseForce& force, const TablePoints& points) {
    const double largest = std::ranges::max(points, {}, &TablePoint::force).force;
    const std::vector<double> times = timesOf(points);
    for (std::size_t i = 1; i < points.size(); ++i)
        appendLine(force, times[i - 1], points[i - 1].force / largest, times[i], points[i].force / largest);
}

/// A time from the first point on in units of the last is wrong by two roundings and the slope to it by as
/// much more, of the change of force there; a force in units of the largest and the impulse by six of itself.
double roundingOfPoints(const PulseForce& force) {
    double moved = 0;
    for (const PulseSegment& segment : force.segments)
        moved += (segment.start + segment.length) * std::abs(segment.slope) * segment.length;
    return std::numeric_limits<double>::epsilon() * (3 + 2 * moved);
}

using Kind = PulseSegment::Kind;

/// Share of the impulse after which momentum and waves look as they do at the end: 3 % are a few pixels of a
/// plot.
constexpr double visibleShare = 0.97;

/// The force e^−t is below one percent of its peak from here on, in t0.
constexpr double decayed = 5;

/// Share of the peak below which a step of a staircase is cut off: a pixel of a small plot.
constexpr double negligibleStep = 0.02;

/// Chords to a curved segment: their bends cannot be seen.
constexpr int chords = 48;

/// How far into a segment a share of its samples lies, as a fraction of its length or, where the force
/// decays, of its impulse.
double localTime(const PulseSegment& segment, double share) {
    if (segment.kind != Kind::exponential) return segment.length * share;
    return share < 1 ? std::min(-std::log1p(-share), segment.length) : segment.length;
}

}  // namespace

double PulseSegment::forceAt(double x) const {
    switch (kind) {
        case Kind::linear:
            return value + slope * x;
        case Kind::sine:
            return value * std::sin(std::numbers::pi * (start + x));
        case Kind::exponential:
            return value * std::exp(-x);
    }
    return 0;
}

double PulseSegment::impulseOf(double x) const {
    switch (kind) {
        case Kind::linear:
            return x * (value + slope * x / 2);
        case Kind::sine: {
            // cos a − cos b as a product, which keeps its digits for short x.
            const double a = std::numbers::pi * start;
            const double half = std::numbers::pi * x / 2;
            return value * 2 / std::numbers::pi * std::sin(a + half) * std::sin(half);
        }
        case Kind::exponential:
            return -value * std::expm1(-x);
    }
    return 0;
}

double PulseSegment::energyOf(double from, double x) const {
    switch (kind) {
        case Kind::linear: {
            const double first = value + slope * from, rise = slope * x;
            return x * (first * (first + rise) + rise * rise / 3);
        }
        case Kind::sine: {
            const double middle = 2 * start + 2 * from + x;  // sin 2b − sin 2a = 2 cos(a + b) sin(b − a)
            const double swing = std::cos(std::numbers::pi * middle) * std::sin(std::numbers::pi * x);
            return value * value * (x - swing / std::numbers::pi) / 2;
        }
        case Kind::exponential:
            return -value * value * std::exp(-2 * from) * std::expm1(-2 * x) / 2;
    }
    return 0;
}

double pistonStepCount(double impedanceRatio) {
    if (!(impedanceRatio > 1)) return 1;
    return std::max(1.0, std::ceil(-cutOff / std::log1p(-2 / (impedanceRatio + 1))));
}

PulseForce pulseForceOf(const Scenario& scenario) {
    const Pulse& pulse = scenario.pulse;
    PulseForce force;
    force.shape = pulse.shape;
    switch (pulse.shape) {
        case PulseShape::rectangular:
            appendLine(force, 0, 1, 1, 1);
            break;
        case PulseShape::triangular:
            appendTrapezoid(force, 0.5, 0.5);
            break;
        case PulseShape::halfSine:
            force.segments.push_back({Kind::sine, 0, 1, 1, 0});
            break;
        case PulseShape::trapezoid:
            appendTrapezoid(force, pulse.rise, pulse.fall);
            break;
        case PulseShape::exponential:
            force.segments.push_back({Kind::exponential, 0, cutOff, 1, 0});
            break;
        case PulseShape::piston:
            appendStaircase(force, pistonImpedanceRatio(scenario));
            break;
        case PulseShape::table:
            appendTable(force, pulse.tablePoints);
            break;
        case PulseShape::rigidBody:
            break;
    }
    finish(force);
    if (pulse.shape == PulseShape::table) force.rounding = roundingOfPoints(force);
    return force;
}

bool movesPulseForce(std::string_view key, PulseShape shape) {
    if (shape == PulseShape::trapezoid) return key == "pulse.rise" || key == "pulse.fall";
    if (shape != PulseShape::piston) return false;
    // The ratio of two impedances.
    constexpr std::array keys{"pulse.diameter", "pulse.youngs_modulus",
                              "pulse.density",  "pulse.impedance_ratio",
                              "rod.diameter",   "rod.area",
                              "rod.bore",       "rod.youngs_modulus",
                              "rod.density"};
    return std::ranges::find(keys, key) != keys.end();
}

double PulseForce::operator()(double t) const {
    if (segments.empty() || !(t >= 0) || t >= end) return 0;
    const auto next = std::ranges::upper_bound(segments, t, {}, &PulseSegment::start);
    const PulseSegment& segment = *std::prev(next);
    return std::max(0.0, segment.forceAt(t - segment.start));
}

double PulseForce::impulseUntil(double t) const {
    if (segments.empty() || !(t > 0)) return 0;
    if (t >= end) return 1;
    const auto next = std::ranges::upper_bound(segments, t, {}, &PulseSegment::start);
    const PulseSegment& segment = *std::prev(next);
    return std::min(1.0, segment.impulseBefore + segment.impulseOf(t - segment.start));
}

PulseForce pulseForceOf(PulseShape shape, double impedanceRatio) {
    assert(shape != PulseShape::table && impedanceRatio > 0);
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = shape;
    scenario.pulse.piston.impedanceRatio = impedanceRatio;
    return pulseForceOf(scenario);
}

std::vector<double> impulseTimes(const PulseForce& pulse) {
    std::vector<double> times{0};
    for (const PulseSegment& segment : pulse.segments) {
        const bool straight = segment.kind == Kind::linear && segment.slope == 0;
        const int samples = straight ? 1 : chords;
        for (int i = 1; i <= samples; ++i)
            times.push_back(segment.start + localTime(segment, static_cast<double>(i) / samples));
    }
    return times;
}

double visibleImpulseEnd(const PulseForce& pulse) {
    for (const double time : impulseTimes(pulse))
        if (pulse.impulseUntil(time) >= visibleShare) return time;
    return pulse.end;
}

double visibleWavesEnd(const PulseForce& pulse) {
    for (const PulseSegment& segment : pulse.segments)
        if (segment.kind == Kind::exponential)
            return segment.start - std::log1p(-visibleShare);
        else if (pulse.impulseUntil(segment.start + segment.length) >= visibleShare)
            return segment.start + segment.length;
    return pulse.end;
}

double visibleForceEnd(const PulseForce& pulse) {
    if (pulse.shape == PulseShape::exponential) return decayed;
    if (pulse.shape != PulseShape::piston) return pulse.end;
    const auto small = std::ranges::find_if(
        pulse.segments, [&](const PulseSegment& step) { return step.value < negligibleStep * pulse.peak; });
    return small == pulse.segments.end() ? pulse.end : small->start;
}

}  // namespace drillwave
