// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters set from text, and the words for what is wrong with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/model/parameter.h"

namespace drillwave {

/// What `true` and `false` mean, in the spellings of YAML; nothing for another word.
std::optional<bool> findTruth(std::string_view word);

/// "rectangular, triangular, …", for messages.
std::string pulseShapeList();

/// Why a scenario has no such shape of the force; empty when it may have it.
Message shapeRefusal(const Scenario& scenario, PulseShape shape);

/// Why a parameter has no meaning in this scenario and what to do instead; empty when it applies.
Message whyNotApplicable(const Parameter& parameter, const Scenario& scenario);

/// Sets a parameter to a number in SI. Returns why the scenario cannot have it, "has no meaning here: …" or
/// "must be in (0, 1]", and sets nothing then; empty when done.
Message assignNumber(Scenario& scenario, const Parameter& parameter, double si);

/// The known key (of parameters() and sections, or set by a word) most like a mistyped one; empty when none
/// is close.
std::string nearestKey(std::string_view key);

/// "`gama` is not a parameter; did you mean `gamma`?".
Message notAParameter(std::string_view key);

/// Sets `key` from text, as --set, table cells and sweep values do. Accepts every key of findParameter() with
/// a unit where it has one, of findWordParameter() with one of its words, and "hammer.restrike" with `true`
/// or `false`. `unit` is a default unit taken from a column header, or nullptr. Returns the reason why not
/// ("bit_rock.gamma = 1.3 (must be in (0, 1])"), or nothing when done; after a reason the scenario is
/// not to be used.
Message assignText(Scenario& scenario, std::string_view key, std::string_view text,
                   const Unit* unit = nullptr);
/// Likewise of a parameter.
Message assignText(Scenario& scenario, const Parameter& parameter, std::string_view text,
                   const Unit* unit = nullptr);

}  // namespace drillwave
