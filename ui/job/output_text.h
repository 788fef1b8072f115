// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a blow's outputs in the window.
#pragma once

#include <QString>

#include "core/blow/outputs.h"
#include "ui/job/solved_blow.h"
#include "ui/text/shown_units.h"

namespace drillwave {

// Units in which outputs are shown.

/// Returns the unit in which an output is shown; none for plain numbers, works and shares. `size` is a
/// typical value in SI (N, W or m/s). Units that do not depend on the scales of the scenario get a prefix
/// (such as k) that suits it.
ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size);

/// Returns true if an output can be compared between two blows. Dimensionless outputs of a rod and of a drill
/// string cannot be compared, because their scales differ.
bool haveSameUnit(const Output& output, const SolvedBlow& one, const SolvedBlow& other, UnitSystem units);

/// Returns an output of a blow as a number for comparison. If `units` are physical, it is in SI, with works
/// in J; otherwise it is dimensionless. Shares are always in per cent. Nothing if the blow has no such value,
/// or if `units` are physical and its scenario is dimensionless.
std::optional<double> comparableNumber(const Output& output, const SolvedBlow& blow, UnitSystem units);

/// Returns the value of an output as text with its unit, in the units chosen for the blow; empty if it has no
/// value.
QString outputText(const Output& output, const SolvedBlow& blow);

/// Returns an impulse with its unit, and as a multiple of the hammer's impulse: "72.92 N s = 1.43 I₀".
QString impulseText(const Output& output, const SolvedBlow& blow);

/// Returns the kinetic energy of the hammer before the blow, with its unit. Requires a hammer that is
/// simulated by sections.
QString hammerEnergyText(const SolvedBlow& blow);

/// Returns the error of the coefficient of restitution: "Numerical error ± 6·10⁻¹⁴".
QString corErrorText(const SolvedBlow& blow);

/// Returns position and time in words at which `output`, a largest force in the rod, occurs; empty if not
/// known.
QString placeText(const Output& output, const SolvedBlow& blow);
/// Returns a position in the rod in words: "1.2 m from the struck end"; as x/L for a scenario without units.
/// `section` is x/L.
QString placeText(const SolvedBlow& blow, double section);
/// Returns "Largest compression 361 MPa, 0.52 m from the hammer, 1.9 ms; largest tension …"; empty if not
/// known.
QString largestStressText(const SolvedBlow& blow);
/// Returns position x/L and time t/t0 at which `output`, a largest stress, occurs. x/L is negative in the
/// hammer of a drill string. Nothing if the place is not known or the stress is zero.
std::optional<RodForce> placeOf(const Output& output, const SolvedBlow& blow);

}  // namespace drillwave
