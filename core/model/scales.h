// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensionless groups of a scenario, and the scales that convert dimensionless results to SI.
#pragma once

#include <optional>

#include "core/model/scenario.h"

namespace drillwave {

/// Scales that convert dimensionless results to SI: dimensionless number × scale = value in SI (paper,
/// section 5.1; theory §2). They are defined differently for a prescribed force and for a simulated hammer.
/// For a drill string, impedance Z and area A are those of one section (see ruleSection()). Mass m and length
/// L are those of the whole string.
struct Scales {
    /// Scale of time t0 [s]: the duration of the force, or twice the transit time of a simulated hammer.
    double time = 1;
    /// Scale of impulse I0 [N s]: impulse of the prescribed force, or momentum of a simulated hammer at
    /// impact.
    double impulse = 1;
    double force = 1;   ///< scale of force: I0/t0 [N] under a force, Z v0/2 for a simulated hammer
    double stress = 1;  ///< scale of stress F0/A [Pa]
    /// Scale of velocity v0 [m/s]: I0/m under a prescribed force, with m the mass of rod or string; else the
    /// impact velocity of the hammer.
    double velocity = 1;
    /// Scale of particle velocity [m/s]: F0/Z, the particle velocity in a wave of the force F0. For a uniform
    /// rod it is τ v0.
    double particleVelocity = 1;
    /// Scale of penetration: 2 I0/Z [m] under a force (paper, eq. 3), v0 t0 for a simulated hammer.
    double penetration = 1;
    double stiffness = 1;  ///< scale of stiffness k0 = Z/t0 [N/m]
    /// Scale of energy [J]: I0 v0/2 with the scales I0 and v0 of impulse and velocity. For a simulated hammer
    /// it is the kinetic energy at impact.
    double energy = 1;
    double length = 1;  ///< scale of length L [m], that of the rod or drill string
    bool operator==(const Scales&) const = default;
};

/// Properties derived from the dimensions and material of a rod or section, such as its impedance, in SI.
struct RodProperties {
    double area = 0;         ///< cross-section A [m²]
    double waveSpeed = 0;    ///< wave speed c = √(E/ρ) [m/s]
    double impedance = 0;    ///< characteristic impedance Z = AE/c [kg/s = N s/m]
    double transitTime = 0;  ///< transit time T = L/c of a wave, one way [s]
    double mass = 0;         ///< mass m = ρAL [kg]
};
RodProperties propertiesOf(const Rod& rod);

/// Returns the properties of a section of a hammer or drill string, in SI. The mass does not include the
/// lumped mass at the end of the section towards the rock.
RodProperties propertiesOf(const Section& section, const Material& material);

/// Total length, transit time and mass of a hammer, or of a drill string with its repeats expanded.
struct ChainProperties {
    double length = 0;       ///< total length [m]
    double transitTime = 0;  ///< total transit time of a wave, one way [s]
    double mass = 0;         ///< total mass, including lumped masses [kg]
};
ChainProperties hammerProperties(const DrillString& drillString);
ChainProperties stringProperties(const DrillString& drillString);
/// Returns total length, transit time and mass of the uniform rod, or of the drill string without its hammer.
ChainProperties chainProperties(const Scenario& scenario);

/// Returns the impedance of a uniform piston divided by that of the rod, or of the rear end of the drill
/// string. For a dimensionless scenario it is `impedanceRatio`.
double pistonImpedanceRatio(const Scenario& scenario);

/// Returns the duration t0 of the hammer force [s]; 1 for a dimensionless scenario. For a piston it is
/// 2·length/c, for a table its time span, and for a hammer of sections twice its transit time.
double pulseDuration(const Scenario& scenario);

/// Returns the impulse I0 of the hammer force [N s]; 1 for a dimensionless scenario. For a hammer of sections
/// it is its momentum at impact. The force of a piston and of a table is integrated.
double pulseImpulse(const Scenario& scenario);

/// Returns the mean force I0/t0 [N] of a pulse given by duration and impulse. If possible, it is rounded so
/// that force × duration is exactly the impulse. A mean force that the user entered then reads back
/// unchanged.
double meanForce(const Pulse& pulse);

/// Returns the dimensionless groups β = k t0/Z, γ, τ = T/t0 and δ = d/d0. Here T is the transit time of the
/// whole rod or string. The scale d0 is 2 I0/Z, or v0 t0 for a hammer of sections. Groups of a dimensionless
/// scenario are returned unchanged.
Groups groupsOf(const Scenario& scenario);

/// Returns the scales of a scenario with units; all are 1, without meaning, for a dimensionless one. A drill
/// string must have at least one section, and so must its hammer unless the force is prescribed.
Scales scalesOf(const Scenario& scenario);

/// Returns d0 [m] for a uniform rod (1 for a dimensionless scenario), the advance of the free rod in one
/// round trip of its waves. For τ ≥ 1/2, a gap that is larger by d0 only delays the blow by one round trip
/// (theory §4). Results as functions of the gap then have this period. Returns nullopt for a drill string,
/// whose results have no such period.
std::optional<double> gapPeriod(const Scenario& scenario);

// Round trips of waves in the rod between two blows.

/// Returns the number n_b = 1/(2 T f) of round trips of a wave in the rod between two blows (T37). Returns
/// nullopt without units or without a blow frequency f.
std::optional<double> roundTripsBetweenBlows(const Scenario& scenario);

/// Returns the whole number n = 1 … 5 that differs from n_b = `roundTrips` by at most 0.1; nullopt if there
/// is none. Here n_b is the number of round trips of a wave between two blows. If it is nearly whole,
/// residual waves of the last blow coincide with the waves of the new one (theory §10).
std::optional<int> stepOfWaves(double roundTrips);

/// Smallest number n_b of round trips of a wave between two blows at which residual waves need no warning
/// (theory §10).
inline constexpr double enoughRoundTrips = 6;

}  // namespace drillwave
