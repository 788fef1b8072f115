// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the loading curve of the rock that are not in the table of parameters: its corners by number,
// and quantities in units of F0 or d0 for dimensionless scenarios.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Largest number of corners that a loading curve may have.
inline constexpr std::size_t mostRockCorners = 64;

/// Returns the parameter of a corner of the loading curve, such as "bit_rock.corner.2.force", in physical
/// units. Returns none for any other key. The corner need not exist: setting a number of the corner after the
/// last one adds that corner.
KeptParameter findLawParameter(std::string_view key);

/// Returns the parameter with the same key that a dimensionless scenario uses instead of `parameter`. Its
/// forces are in units of F0, its penetrations in units of d0. Empty if `parameter` is the same in both
/// forms.
KeptParameter inScales(const Parameter& parameter);

/// Returns the parameter that has the key of `parameter` in this scenario. A dimensionless scenario has its
/// own parameters for forces and penetrations of the loading curve, in units of F0 or d0. In all other cases
/// it is `parameter` itself.
KeptParameter inFormOf(const Scenario& scenario, const Parameter& parameter);

/// Returns those parameters of the loading curve that a dimensionless scenario gives in units of F0 or d0,
/// such as U1. Parameters of corners are left out. Empty for a scenario with units.
std::vector<KeptParameter> numbersInScales(const Scenario& scenario);

/// Returns the parameters of the loading curve that parameters() does not list: force and slope of every
/// corner, then numbersInScales().
std::vector<KeptParameter> loadingNumbers(const Scenario& scenario);

/// Returns the number of the corner of the loading curve that a parameter belongs to: 2 for
/// "bit_rock.corner.2.force". Returns 0 if it belongs to no corner.
std::size_t cornerOf(const Parameter& parameter);

/// Returns the key of a number of a corner of the loading curve, such as "bit_rock.corner.2.force". `place`
/// is the number of the corner, from 1.
std::string cornerKey(std::size_t place, std::string_view field);

// Change of the form of the loading curve.

/// Returns the rock with another form of the loading curve. Numbers that the new form does not use are reset
/// to their defaults.
BitRock withLaw(BitRock rock, RockLaw law);

/// Returns the rock with another form of the loading curve, with first values for the user to edit. The new
/// values describe a straight line: one corner at F0/2 without a change of slope, or the exponent 1.
BitRock proposedRock(const Scenario& scenario, RockLaw law);

}  // namespace drillwave
