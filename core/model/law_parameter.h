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
/// units; empty for any other key. The corner need not exist: setting the one after the last adds it.
KeptParameter findLawParameter(std::string_view key);

/// Returns the parameter that the key of `parameter` denotes in a dimensionless scenario, with forces in
/// units of F0 and penetrations in units of d0. Empty if `parameter` needs no such conversion.
KeptParameter inScales(const Parameter& parameter);

/// Returns the parameter that the key of `parameter` denotes in this scenario: in SI, or for a dimensionless
/// scenario in units of F0 or d0.
KeptParameter inFormOf(const Scenario& scenario, const Parameter& parameter);

/// Returns the parameters of the loading curve that a dimensionless scenario gives in units of F0 or d0,
/// except those of corners. Empty for a scenario with units.
std::vector<KeptParameter> numbersInScales(const Scenario& scenario);

/// Returns the force and slope of every corner of the scenario, followed by numbersInScales(). Other
/// parameters of the loading curve are in the table of parameters.
std::vector<KeptParameter> loadingNumbers(const Scenario& scenario);

/// Returns the number, from 1, of the corner of the loading curve that a parameter belongs to; 0 if it
/// belongs to none.
std::size_t cornerOf(const Parameter& parameter);

/// Returns the key of a number of a corner, such as "bit_rock.corner.2.force". `place` counts from 1.
std::string cornerKey(std::size_t place, std::string_view field);

// Change of the form of the loading curve.

/// Returns the rock with another form of the loading curve. Numbers that only its previous form has get their
/// default values.
BitRock withLaw(BitRock rock, RockLaw law);

/// Returns the rock with another form of the loading curve but initially the same curve: a corner without a
/// change of slope, or the exponent 1.
BitRock proposedRock(const Scenario& scenario, RockLaw law);

}  // namespace drillwave
