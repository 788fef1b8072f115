// SPDX-License-Identifier: GPL-3.0-or-later
// In which unit an output is shown.
#pragma once

#include "core/blow/outputs.h"
#include "core/study/rows/output_column.h"
#include "ui/job/solved_blow.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Of an output's values in its measure (Output::measure). Plain numbers, works and shares, which are plain
/// in SI too, have none. `size` is that of the values where there is no dimensionless number: N, W or m/s.
ShownUnit outputUnit(const Output& output, const ShownUnits& units, double size);

/// The same for a column: an energy in SI has the unit of energies.
ShownUnit columnUnit(const OutputColumn& column, const ShownUnits& units, double size);

/// Whether the numbers of two blows mean as much: what is a multiple of scales, those of rods and of strings
/// are other ones.
bool haveSameUnit(const Output& output, const SolvedBlow& one, const SolvedBlow& other, UnitSystem units);

/// The number of a blow that can be compared with those of others: in SI, works in J, where `units` are
/// physical, else as outputs have it; shares in percent. Nothing where the blow has none, or no units.
std::optional<double> comparableNumber(const Output& output, const SolvedBlow& blow, UnitSystem units);

}  // namespace drillwave
