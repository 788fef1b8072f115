// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a blow as the window writes them.
#pragma once

#include <QString>

#include "core/blow/outputs.h"
#include "core/study/rows/output_column.h"
#include "ui/job/solved_blow.h"
#include "ui/text/shown_units.h"

namespace drillwave {

// Units of outputs on show.

/// Returns the unit of an output's values in its measure (Output::measure). Plain numbers, works and shares
/// have none, also in SI. `size` is the size of values without a dimensionless number: N, W or m/s.
ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size);

/// Returns the unit of a column: an energy in SI has the unit of energies.
ShownUnit columnUnit(const OutputColumn& column, const ShownUnits& units, double size);

/// Whether the numbers of two blows mean as much: what is a multiple of scales, those of rods and of strings
/// are other ones.
bool haveSameUnit(const Output& output, const SolvedBlow& one, const SolvedBlow& other, UnitSystem units);

/// Returns the number of a blow for comparison with others: in SI, works in J, if `units` are physical, else
/// as outputs have it; shares in percent. Nothing if the blow has none, or no units.
std::optional<double> comparableNumber(const Output& output, const SolvedBlow& blow, UnitSystem units);

/// An output in the units of the blow; empty where there is none.
QString outputText(const Output& output, const SolvedBlow& blow);

/// An impulse in its unit, and as a multiple of that of the hammer: "72.92 N s = 1.43 I₀".
QString impulseText(const Output& output, const SolvedBlow& blow);

/// The energy of a hammer that is followed, before the blow.
QString hammerEnergyText(const SolvedBlow& blow);

/// "numerical error ± 6·10⁻¹⁴".
QString corErrorText(const SolvedBlow& blow);

/// Describes place and time of a largest force in the rod. Empty if there is none.
QString placeText(const Output& output, const SolvedBlow& blow);
/// "Largest compression 361 MPa, 0.52 m from the hammer, 1.9 ms; largest tension …"; empty where they are not
/// known.
QString largestStressText(const SolvedBlow& blow);
/// The place itself: x/L, below 0 in the hammer of a string, and t/t0; nothing where it is not known, or
/// where there is no such stress.
std::optional<RodForce> placeOf(const Output& output, const SolvedBlow& blow);

}  // namespace drillwave
