// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/parameter.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/model/scales.h"
#include "core/model/string_ranges.h"

namespace drillwave {
namespace {

using S = Scenario;
using Value = std::optional<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range positive{0, infinity, true};
constexpr Range notNegative{0, infinity};
/// Rounding of a gap or a transit time must stay a small part of a wave: at 1e9 two neighbouring doubles are
/// 1e-7 of a period or of t0 apart.
constexpr double largestTime = 1e9;
constexpr const char* lostPhase =
    translatable("in a larger one, double precision is too coarse to place a wave");
using enum SliderScale;

Value diameter(const S& s) {
    return s.rod.area ? std::nullopt : Value(s.rod.diameter);
}
void assignDiameter(S& s, double value) {
    s.rod.area.reset();
    s.rod.diameter = value;
}

/// Sets the duration; keeps the mean force if that was given, else the impulse.
void assignDuration(S& s, double value) {
    Pulse& pulse = s.pulse;
    if (pulse.impulseFromForce) pulse.impulse = meanForce(pulse) * value;
    pulse.duration = value;
}
void assignImpulse(S& s, double value) {
    s.pulse.impulse = value;
    s.pulse.impulseFromForce = false;
}
void assignForce(S& s, double value) {
    s.pulse.impulse = value * s.pulse.duration;
    s.pulse.impulseFromForce = true;
}

/// Sets a physical value so that its group, which is `groupOf` it, reads `wanted`, or what is nearest to it
/// where no double does that.
template <class GroupOf>
void assignGroup(double& physical, double scale, const GroupOf& groupOf, double wanted) {
    const double estimate = wanted * scale;
    double best = estimate;
    double smallestMiss = infinity;
    for (const double direction : {infinity, -infinity}) {
        physical = estimate;
        for (int step = 0; step < 3; ++step) {
            const double miss = std::abs(groupOf(physical) - wanted);
            if (miss == 0) return;
            if (miss < smallestMiss) {
                smallestMiss = miss;
                best = physical;
            }
            physical = std::nextafter(physical, direction);
        }
    }
    physical = best;
}
// The groups as groupsOf() has them: a map of two groups sets them as often as it solves.
void assignBeta(S& s, double value) {
    if (!hasUnits(s)) {
        s.groups.beta = value;
        return;
    }
    const double scale = scalesOf(s).stiffness;
    assignGroup(
        s.bitRock.stiffness, scale, [&](double stiffness) { return stiffness / scale; }, value);
}
void assignGamma(S& s, double value) {
    (hasUnits(s) ? s.bitRock.gamma : s.groups.gamma) = value;
}
void assignTau(S& s, double value) {
    if (s.form != ScenarioForm::dimensional) {
        s.groups.tau = value;
        return;
    }
    const double time = scalesOf(s).time, speed = propertiesOf(s.rod).waveSpeed;
    assignGroup(
        s.rod.length, time * speed, [&](double length) { return length / speed / time; }, value);
}
void assignDelta(S& s, double value) {
    if (!hasUnits(s)) {
        s.groups.delta = value;
        return;
    }
    const double scale = scalesOf(s).penetration;
    assignGroup(
        s.bitRock.gap, scale, [&](double gap) { return gap / scale; }, value);
}

// clang-format off
constexpr std::array parameterTable{
    Parameter{"rod.length", "length", "L", "Length of the rod or rod string, from the hammer to the bit",
              Quantity::length, "m", positive, {0.5, 40}, logarithmic, Scope::dimensional,
              [](const S& s) { return Value(s.rod.length); }, [](S& s, double v) { s.rod.length = v; }},
    Parameter{"rod.diameter", "diameter", "", "Outer diameter of the rod",
              Quantity::length, "mm", positive, {0.015, 0.15}, linear, Scope::dimensional, diameter, assignDiameter,
              {.presence = Presence::either, .rival = "rod.area"}},
    Parameter{"rod.area", "area", "A", "Cross-section of the rod, instead of diameter and bore",
              Quantity::area, "mm^2", positive, {2e-4, 2e-2}, logarithmic, Scope::dimensional,
              [](const S& s) { return s.rod.area; }, [](S& s, double v) { s.rod.area = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.rod.area.reset(); }}},
    Parameter{"rod.bore", "bore", "", "Diameter of the flushing hole, less than the outer diameter",
              Quantity::length, "mm", notNegative, {0, 0.05}, linear, Scope::withoutArea,
              [](const S& s) { return Value(s.rod.bore); }, [](S& s, double v) { s.rod.bore = v; },
              {.presence = Presence::unusual, .rival = "rod.area"}},
    Parameter{"rod.youngs_modulus", "Young's modulus", "E", "Young's modulus of the rod; sets its wave speed with the density",
              Quantity::stress, "GPa", positive, usual_ranges::modulus, linear, Scope::dimensional,
              [](const S& s) { return Value(s.rod.youngsModulus); }, [](S& s, double v) { s.rod.youngsModulus = v; }},
    Parameter{"rod.density", "density", "ρ", "Density of the rod",
              Quantity::density, "kg/m^3", positive, usual_ranges::density, linear, Scope::dimensional,
              [](const S& s) { return Value(s.rod.density); }, [](S& s, double v) { s.rod.density = v; }},
    Parameter{"rod.yield_strength", "yield strength", "", "Stress up to which the rod stays elastic; a larger one gives a warning",
              Quantity::stress, "MPa", positive, usual_ranges::yieldStrength, linear, Scope::dimensional,
              [](const S& s) { return s.rod.yieldStrength; }, [](S& s, double v) { s.rod.yieldStrength = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.rod.yieldStrength.reset(); }}},
    Parameter{"rod.fatigue_strength", "fatigue strength", "", "Tensile stress that the rod endures blow after blow; a larger one gives a warning",
              Quantity::stress, "MPa", positive, usual_ranges::fatigueStrength, linear, Scope::dimensional,
              [](const S& s) { return s.rod.fatigueStrength; }, [](S& s, double v) { s.rod.fatigueStrength = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.rod.fatigueStrength.reset(); }}},

    Parameter{"pulse.duration", "duration", "t0", "Duration of the hammer force; time constant of an exponential one",
              Quantity::time, "us", positive, {20e-6, 2e-3}, logarithmic, Scope::givenPulse,
              [](const S& s) { return Value(s.pulse.duration); }, assignDuration},
    Parameter{"pulse.impulse", "impulse", "I0", "Impulse of the hammer force",
              Quantity::impulse, "N s", positive, {1, 500}, logarithmic, Scope::givenPulse,
              [](const S& s) { return Value(s.pulse.impulse); }, assignImpulse,
              {.presence = Presence::either, .rival = "pulse.force"}},
    Parameter{"pulse.force", "mean force", "F0", "Mean hammer force, impulse over duration",
              Quantity::force, "kN", positive, {5e3, 3e6}, logarithmic, Scope::givenPulse,
              [](const S& s) { return Value(meanForce(s.pulse)); }, assignForce,
              {.presence = Presence::optional}},
    Parameter{"pulse.rise", "rise", "", "Time in which a trapezoid rises, as a fraction of the duration",
              Quantity::ratio, "", {0, 1}, {0, 1}, linear, Scope::trapezoid,
              [](const S& s) { return Value(s.pulse.rise); }, [](S& s, double v) { s.pulse.rise = v; },
              {.presence = Presence::assumed}},
    Parameter{"pulse.fall", "fall", "", "Time in which a trapezoid falls, as a fraction of the duration",
              Quantity::ratio, "", {0, 1}, {0, 1}, linear, Scope::trapezoid,
              [](const S& s) { return Value(s.pulse.fall); }, [](S& s, double v) { s.pulse.fall = v; },
              {.presence = Presence::assumed}},
    Parameter{"pulse.length", "hammer length", "", "Length of the elastic hammer; one step of the blow lasts one round trip in it",
              Quantity::length, "mm", positive, {0.1, 2}, logarithmic, Scope::pistonInSi,
              [](const S& s) { return Value(s.pulse.piston.length); }, [](S& s, double v) { s.pulse.piston.length = v; },
              {.shortLabel = "length"}},
    Parameter{"pulse.diameter", "hammer diameter", "", "Diameter of the elastic hammer",
              Quantity::length, "mm", positive, {0.015, 0.25}, linear, Scope::pistonInSi,
              [](const S& s) { return Value(s.pulse.piston.diameter); }, [](S& s, double v) { s.pulse.piston.diameter = v; },
              {.shortLabel = "diameter"}},
    Parameter{"pulse.velocity", "hammer velocity", "", "Velocity of the elastic hammer when it hits the rod",
              Quantity::velocity, "m/s", positive, {1, 20}, linear, Scope::pistonInSi,
              [](const S& s) { return Value(s.pulse.piston.velocity); }, [](S& s, double v) { s.pulse.piston.velocity = v; },
              {.shortLabel = "velocity"}},
    Parameter{"pulse.youngs_modulus", "hammer Young's modulus", "", "Young's modulus of the elastic hammer (default: that of the rod)",
              Quantity::stress, "GPa", positive, usual_ranges::modulus, linear, Scope::pistonInSi,
              [](const S& s) { return s.pulse.piston.youngsModulus; }, [](S& s, double v) { s.pulse.piston.youngsModulus = v; },
              {.presence = Presence::optional, .shortLabel = "Young's modulus", .clear = [](S& s) { s.pulse.piston.youngsModulus.reset(); }}},
    Parameter{"pulse.density", "hammer density", "", "Density of the elastic hammer (default: that of the rod)",
              Quantity::density, "kg/m^3", positive, usual_ranges::density, linear, Scope::pistonInSi,
              [](const S& s) { return s.pulse.piston.density; }, [](S& s, double v) { s.pulse.piston.density = v; },
              {.presence = Presence::optional, .shortLabel = "density", .clear = [](S& s) { s.pulse.piston.density.reset(); }}},
    Parameter{"pulse.impedance_ratio", "impedance ratio", "", "Impedance of the elastic hammer over that of the rod",
              Quantity::ratio, "", positive, {0.1, 10}, logarithmic, Scope::pistonByRatio,
              [](const S& s) { return Value(s.pulse.piston.impedanceRatio); }, [](S& s, double v) { s.pulse.piston.impedanceRatio = v; }},

    Parameter{"material.youngs_modulus", "Young's modulus", "E", "Young's modulus of all sections without one of their own",
              Quantity::stress, "GPa", string_ranges::modulus, usual_ranges::modulus, linear, Scope::string,
              [](const S& s) { return Value(s.drillString.material.youngsModulus); }, [](S& s, double v) { s.drillString.material.youngsModulus = v; },
              {.presence = Presence::assumed}},
    Parameter{"material.density", "density", "ρ", "Density of all sections without one of their own",
              Quantity::density, "kg/m^3", string_ranges::density, usual_ranges::density, linear, Scope::string,
              [](const S& s) { return Value(s.drillString.material.density); }, [](S& s, double v) { s.drillString.material.density = v; },
              {.presence = Presence::assumed}},
    Parameter{"hammer.velocity", "hammer velocity", "v0", "Velocity of the hammer when it strikes the string",
              Quantity::velocity, "m/s", string_ranges::velocity, {1, 20}, linear, Scope::hammer,
              [](const S& s) { return Value(s.drillString.hammer.velocity); }, [](S& s, double v) { s.drillString.hammer.velocity = v; },
              {.shortLabel = "velocity"}},
    Parameter{"hammer.face_stiffness", "contact stiffness", "", "Stiffness of the contact of hammer and string (default: rigid)",
              Quantity::stiffness, "GN/m", string_ranges::stiffness, {1e8, 1e11}, logarithmic, Scope::hammer,
              [](const S& s) { return s.drillString.hammer.faceStiffness; }, [](S& s, double v) { s.drillString.hammer.faceStiffness = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drillString.hammer.faceStiffness.reset(); }}},
    Parameter{"end_time", "end time", "", "Time until when the blow on a drill string is followed (default: to its end)",
              Quantity::time, "ms", string_ranges::endTime, {1e-4, 1}, logarithmic, Scope::string,
              [](const S& s) { return s.drillString.endTime; }, [](S& s, double v) { s.drillString.endTime = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drillString.endTime.reset(); }}},

    Parameter{"bit_rock.stiffness", "stiffness", "k", "Stiffness of bit and rock in primary loading",
              Quantity::stiffness, "MN/m", positive, {1e6, 1e10}, logarithmic, Scope::withUnits,
              [](const S& s) { return Value(s.bitRock.stiffness); }, [](S& s, double v) { s.bitRock.stiffness = v; }},
    Parameter{"bit_rock.gamma", "elasticity", "γ", "Elasticity parameter: loading over unloading stiffness; 1 is elastic",
              Quantity::ratio, "", {0, 1, true}, {0.01, 1}, linear, Scope::withUnits,
              [](const S& s) { return Value(s.bitRock.gamma); }, [](S& s, double v) { s.bitRock.gamma = v; }},
    Parameter{"bit_rock.gap", "gap", "d", "Gap between bit and rock when the hammer strikes",
              Quantity::length, "mm", notNegative, {0, 0.01}, linear, Scope::withUnits,
              [](const S& s) { return Value(s.bitRock.gap); }, [](S& s, double v) { s.bitRock.gap = v; },
              {.presence = Presence::assumed}},
    Parameter{"bit_rock.exponent", "exponent", "p", "Exponent of a power law F = k U (U/U1)^(p - 1) of loading; 1 is a straight line",
              Quantity::ratio, "", {0.3, 3}, {0.5, 2}, linear, Scope::all,
              [](const S& s) { return Value(s.bitRock.exponent); }, [](S& s, double v) { s.bitRock.exponent = v; },
              {.law = RockLaw::power}},
    Parameter{"bit_rock.reference_penetration", "reference penetration", "U1", "Penetration at which a power law gives F = k U1",
              Quantity::length, "mm", positive, {5e-5, 5e-3}, logarithmic, Scope::withUnits,
              [](const S& s) { return Value(s.bitRock.referencePenetration); }, [](S& s, double v) { s.bitRock.referencePenetration = v; },
              {.shortLabel = "penetration", .law = RockLaw::power}},

    Parameter{"drill.blow_frequency", "blow frequency", "f", "Blows per second of the rock drill",
              Quantity::frequency, "Hz", drill_ranges::frequency, {10, 150}, linear, Scope::withUnits,
              [](const S& s) { return s.drill.blowFrequency; }, [](S& s, double v) { s.drill.blowFrequency = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.blowFrequency.reset(); }}},
    Parameter{"drill.thrust", "installed feed force", "", "Feed force that the drill rig applies",
              Quantity::force, "kN", drill_ranges::thrust, {500, 50e3}, linear, Scope::withUnits,
              [](const S& s) { return s.drill.thrust; }, [](S& s, double v) { s.drill.thrust = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.thrust.reset(); }}},
    Parameter{"drill.machine_mass", "machine mass", "", "Mass that the feed moves besides the rod: its weight counts with an inclination, its inertia when consecutive blows are solved",
              Quantity::mass, "kg", drill_ranges::mass, {10, 5000}, logarithmic, Scope::withUnits,
              [](const S& s) { return s.drill.machineMass; }, [](S& s, double v) { s.drill.machineMass = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.machineMass.reset(); }}},
    Parameter{"drill.inclination", "inclination", "", "Angle of the hole below the horizontal. With it, the weight of machine and rod along the hole adds to the feed force.",
              Quantity::angle, "deg", {-90, 90}, {-90, 90}, linear, Scope::withUnits,
              [](const S& s) { return s.drill.inclination; }, [](S& s, double v) { s.drill.inclination = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.inclination.reset(); }}},
    Parameter{"drill.damper_damping", "dashpot", "c_d", "Damping between machine and rear end of the string, for many blows; needs a machine mass",
              Quantity::damping, "kN s/m", drill_ranges::damping, {500, 100e3}, logarithmic, Scope::manyBlows,
              [](const S& s) { return s.drill.damperDamping; }, [](S& s, double v) { s.drill.damperDamping = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.damperDamping.reset(); }}},
    Parameter{"drill.damper_stiffness", "spring", "k_d", "Stiffness of the damper's spring between machine and rear end of the string, for many blows; needs a machine mass",
              Quantity::stiffness, "MN/m", drill_ranges::stiffness, {0.1e6, 100e6}, logarithmic, Scope::manyBlows,
              [](const S& s) { return s.drill.damperStiffness; }, [](S& s, double v) { s.drill.damperStiffness = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.damperStiffness.reset(); }}},
    Parameter{"drill.wave_loss", "wave loss", "η", "Share of the residual waves lost per round trip, for many blows",
              Quantity::share, "%", {0, 1, false, translatable("a section that loses everything carries no wave"), true}, {0.01, 0.3}, linear, Scope::manyBlows,
              [](const S& s) { return s.drill.waveLoss; }, [](S& s, double v) { s.drill.waveLoss = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.waveLoss.reset(); }}},
    Parameter{"drill.blows", "blows", "N", "Number of consecutive blows (default: 1000)",
              Quantity::ratio, "", {1, 1'000'000}, {300, 5000}, logarithmic, Scope::manyBlows,
              [](const S& s) { return s.drill.blows; }, [](S& s, double v) { s.drill.blows = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.blows.reset(); }, .wholeNumber = true}},
    Parameter{"drill.settle", "transient blows", "", "Transient blows at the start, excluded from statistics (default: a fifth of all)",
              Quantity::ratio, "", {0, 999'999}, {0, 999'999}, linear, Scope::manyBlows,
              [](const S& s) { return s.drill.settle; }, [](S& s, double v) { s.drill.settle = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.settle.reset(); }, .wholeNumber = true}},
    Parameter{"drill.interval_scatter", "scatter", "", "Standard deviation of the time between two blows, as a share of its mean; cut off at three deviations",
              Quantity::share, "%", {0, 0.2}, {0, 0.03}, linear, Scope::manyBlows,
              [](const S& s) { return s.drill.intervalScatter; }, [](S& s, double v) { s.drill.intervalScatter = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.intervalScatter.reset(); }}},
    Parameter{"drill.seed", "seed", "", "Start of the random numbers for the scatter of the intervals",
              Quantity::ratio, "", {0, 2'147'483'647}, {0, 2'147'483'647}, linear, Scope::manyBlows,
              [](const S& s) { return s.drill.seed; }, [](S& s, double v) { s.drill.seed = v; },
              {.presence = Presence::optional, .clear = [](S& s) { s.drill.seed.reset(); }, .wholeNumber = true}},

    Parameter{"beta", "stiffness", "β", "Stiffness group k t0/Z; in a scenario with units it changes the stiffness",
              Quantity::ratio, "", positive, {0.01, 100}, logarithmic, Scope::all,
              [](const S& s) { return Value(groupsOf(s).beta); }, assignBeta,
              {.rival = "bit_rock.stiffness"}},
    Parameter{"gamma", "elasticity", "γ", "Elasticity parameter: loading over unloading stiffness; 1 is elastic",
              Quantity::ratio, "", {0, 1, true}, {0.01, 1}, linear, Scope::all,
              [](const S& s) { return Value(groupsOf(s).gamma); }, assignGamma,
              {.rival = "bit_rock.gamma"}},
    Parameter{"tau", "transit time", "τ", "Transit time of the rod over t0; in a scenario with units it changes the rod length",
              Quantity::ratio, "", {0, largestTime, true, lostPhase}, {0.5, 100}, logarithmic, Scope::uniformRod,
              [](const S& s) { return Value(groupsOf(s).tau); }, assignTau,
              {.rival = "rod.length"}},
    Parameter{"delta", "gap", "δ", "Gap over 2 I0/Z; in a scenario with units it changes the gap",
              Quantity::ratio, "", {0, largestTime, false, lostPhase}, {0, 10}, linear, Scope::all,
              [](const S& s) { return Value(groupsOf(s).delta); }, assignDelta,
              {.presence = Presence::assumed, .rival = "bit_rock.gap"}},
};
// clang-format on

}  // namespace

std::span<const Parameter> parameters() {
    return parameterTable;
}

}  // namespace drillwave
