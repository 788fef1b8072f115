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
/// typical value in SI (N, W or m/s), which sets the prefix of units that do not depend on the scenario's
/// scales.
ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size);

/// Returns true if an output of two blows can be compared. Dimensionless multiples of scales cannot be
/// compared between a rod and a drill string, whose scales differ.
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

/// Returns the hammer energy before the blow with its unit, for a hammer of sections.
QString hammerEnergyText(const SolvedBlow& blow);

/// Returns the error of the coefficient of restitution: "Numerical error ± 6·10⁻¹⁴".
QString corErrorText(const SolvedBlow& blow);

/// Returns where and when a largest force in the rod occurs, in words; empty if not known.
QString placeText(const Output& output, const SolvedBlow& blow);
/// Returns a position in the rod in words: "1.2 m from the struck end"; as x/L for a scenario without units.
/// `section` is x/L.
QString placeText(const SolvedBlow& blow, double section);
/// Returns "Largest compression 361 MPa, 0.52 m from the hammer, 1.9 ms; largest tension …"; empty if not
/// known.
QString largestStressText(const SolvedBlow& blow);
/// Returns where and when a largest stress occurs: x/L, negative in the hammer of a string, and t/t0. Nothing
/// if it is not known or zero.
std::optional<RodForce> placeOf(const Output& output, const SolvedBlow& blow);

}  // namespace drillwave
