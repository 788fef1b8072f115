// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters set from text, and the words for what is wrong with it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

// Parameters whose value is a word from a list: the shape of the blow, the law of the rock.

struct WordParameter {
    std::string_view key;                          ///< "pulse.shape"
    std::span<const std::string_view> (*words)();  ///< all there are
    std::string_view (*value)(const Scenario&);    ///< the one of a scenario
    /// Sets the word of that number. Returns why the scenario has none of this key, or not that one: "only a
    /// drill string has it …"; empty when done.
    Message (*assign)(Scenario&, std::size_t word);

    /// "rectangular, triangular, …", for messages.
    std::string list() const;
};

std::span<const WordParameter> wordParameters();
/// Returns the parameter of that key, or nullptr.
const WordParameter* findWordParameter(std::string_view key);

/// Returns the value of `true` or `false`, in the spellings of YAML; nothing for another word.
std::optional<bool> findTruth(std::string_view word);

/// "rectangular, triangular, …", for messages.
std::string pulseShapeList();

/// Why a scenario has no such shape of the force; empty when it may have it.
Message shapeRefusal(const Scenario& scenario, PulseShape shape);

/// Returns why a parameter has no meaning in this scenario and what to do instead; empty if it applies.
Message whyNotApplicable(const Parameter& parameter, const Scenario& scenario);

/// Sets a parameter to a number in SI. Returns why the scenario cannot have it, "has no meaning here: …" or
/// "must be in (0, 1]", and sets nothing then; empty when done.
Message assignNumber(Scenario& scenario, const Parameter& parameter, double si);

/// The known key (of parameters() and sections, or set by a word) most like a mistyped one; empty when none
/// is close.
std::string nearestKey(std::string_view key);

/// "`gama` is not a parameter; did you mean `gamma`?".
Message notAParameter(std::string_view key);

/// Sets `key` from text, as --set, table cells and sweep values do. Accepts every key of findParameter()
/// with a unit if it has one, of findWordParameter() with one of its words, and "hammer.restrike" with
/// `true` or `false`. `unit` is a default unit taken from a column header, or nullptr. Returns the reason
/// for a failure ("bit_rock.gamma = 1.3 (must be in (0, 1])"), after which the scenario must not be used;
/// else nothing.
Message assignText(Scenario& scenario, std::string_view key, std::string_view text,
                   const Unit* unit = nullptr);
/// Assigns a text to a parameter in the same way.
Message assignText(Scenario& scenario, const Parameter& parameter, std::string_view text,
                   const Unit* unit = nullptr);

}  // namespace drillwave
