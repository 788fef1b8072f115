// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the loading curve of the rock that are no rows of the table of parameters: corners by their
// place, and what is measured in scales of the blow where a scenario is dimensionless.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Most corners that a law may have.
inline constexpr std::size_t mostRockCorners = 64;

/// Returns the parameter "bit_rock.corner.2.force", of a scenario with units if the key has a unit. The
/// corner need not exist: setting one after the last corner adds it. None for another key.
KeptParameter findLawParameter(std::string_view key);

/// Returns the same key in a dimensionless scenario: forces in F0, penetrations in d0. None if it has the
/// same meaning there, or no meaning.
KeptParameter inScales(const Parameter& parameter);

/// Returns the parameter that the same key means in that scenario.
KeptParameter inFormOf(const Scenario& scenario, const Parameter& parameter);

/// Returns the parameters in scales of the blow, except corners; none for a scenario with units.
std::vector<KeptParameter> numbersInScales(const Scenario& scenario);

/// Returns force and slope of every corner that the scenario has, then numbersInScales(). Other numbers of a
/// law are rows of the table of parameters.
std::vector<KeptParameter> loadingNumbers(const Scenario& scenario);

/// Returns the corner that a parameter belongs to, from 1; 0 for none.
std::size_t cornerOf(const Parameter& parameter);

/// "bit_rock.corner.2.force".
std::string cornerKey(std::size_t place, std::string_view field);

// A rock under another law.

/// Returns the rock with another law, without the numbers that only its present law has.
BitRock withLaw(BitRock rock, RockLaw law);

/// Returns the rock with another allowed law and the same curve at first: a corner without a change of slope,
/// a power of one.
BitRock proposedRock(const Scenario& scenario, RockLaw law);

}  // namespace drillwave
