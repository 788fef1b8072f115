// SPDX-License-Identifier: GPL-3.0-or-later
// From a scenario to its dimensionless groups and the scales that lead back to SI.
#pragma once

#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

/// Characteristic quantities (paper, section 5.1; theory §2), SI. Dimensionless × scale = SI. After a
/// semicolon: the meaning for a followed hammer. For a string, Z and A are those of its ruleSection(), m and
/// L those of the whole string.
struct Scales {
    double time = 1;              ///< t0 [s]; twice the transit time of the hammer
    double impulse = 1;           ///< I0 [N s]; momentum of the hammer
    double force = 1;             ///< F0 = I0/t0 [N]; Z v0/2
    double stress = 1;            ///< F0/A [Pa]
    double velocity = 1;          ///< v0 = I0/m [m/s]; of the hammer
    double particleVelocity = 1;  ///< F0/Z [m/s], of a wave of the force F0; τ v0 of a uniform rod
    double penetration = 1;       ///< d0 = 2 I0/Z [m] [paper (3)]; v0 t0
    double stiffness = 1;         ///< k0 = Z/t0 [N/m]
    double energy = 1;            ///< W0 = m v0²/2 [J]; of the hammer
    double length = 1;            ///< L [m]
    bool operator==(const Scales&) const = default;
};

/// Derived properties of the rod, SI.
struct RodProperties {
    double area = 0;         ///< A [m²]
    double waveSpeed = 0;    ///< c = √(E/ρ) [m/s]
    double impedance = 0;    ///< Z = AE/c [kg/s]
    double transitTime = 0;  ///< T = L/c, one way [s]
    double mass = 0;         ///< m = ρAL [kg]
};
RodProperties propertiesOf(const Rod& rod);

/// Returns the properties of a section of a hammer or a string, without the mass lumped at its far end.
RodProperties propertiesOf(const Section& section, const Material& material);

/// Sums over the sections of a hammer, or of a string with its repeats written out.
struct ChainProperties {
    double length = 0;       ///< [m]
    double transitTime = 0;  ///< one way [s]
    double mass = 0;         ///< with lumped masses [kg]
};
ChainProperties hammerProperties(const DrillString& drillString);
ChainProperties stringProperties(const DrillString& drillString);
/// Returns the sums of the uniform rod, or of the string.
ChainProperties chainProperties(const Scenario& scenario);

/// Returns the impedance of the hammer of a piston pulse over that of the section it pushes (the
/// `impedanceRatio` itself in a dimensionless scenario).
double pistonImpedanceRatio(const Scenario& scenario);

/// t0 [s]: the duration; 2·length/c of a piston; the length of a table; twice the transit time of a hammer
/// that is followed. 1 for a dimensionless scenario.
double pulseDuration(const Scenario& scenario);

/// I0 [N s]: the impulse; of the staircase of a piston; of a table; momentum of a hammer that is followed. 1
/// for a dimensionless scenario.
double pulseImpulse(const Scenario& scenario);

/// Mean force I0/t0 [N] of a pulse given by duration and impulse; where some double times the duration is
/// exactly the impulse, that one, so that a force that was given reads back unchanged.
double meanForce(const Pulse& pulse);

/// Returns β = k t0/Z, γ, τ = T/t0, δ = d Z/(2 I0), or d/(v0 t0) for a followed hammer, T being the whole
/// transit time; the given groups for a dimensionless scenario.
Groups groupsOf(const Scenario& scenario);

/// The scales of a scenario with units; all 1 for a dimensionless one (not meaningful there). Requires a
/// hammer and a string that are not empty where it is a string.
Scales scalesOf(const Scenario& scenario);

/// Returns the period of the gap with which blows repeat (theory §4) because waves return as they left: d0
/// [m], 1 for a dimensionless scenario. nullopt for a drill string: only of a period are shares of all gaps
/// and the worst gap known.
std::optional<double> gapPeriod(const Scenario& scenario);

// Round trips of waves in the rod between two blows.

/// n_b = 1/(2 T f), round trips of a wave between two blows (T37). nullopt without units or a blow frequency.
std::optional<double> roundTripsBetweenBlows(const Scenario& scenario);

/// Waves of the last blow that are still felt, n_b < 6, meet the new one in step where n_b is within 0.1 of a
/// whole number below that, which is returned: 1 … 5 (theory §10).
std::optional<int> stepOfWaves(double roundTrips);

/// Round trips after which the waves of the last blow need no alert (theory §10).
inline constexpr double enoughRoundTrips = 6;

}  // namespace drillwave
