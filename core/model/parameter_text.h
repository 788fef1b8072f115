// SPDX-License-Identifier: GPL-3.0-or-later
// Setting parameters from text, and the messages on what is wrong with the text.
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

// Parameter whose value is a word from a list, such as the shape of the hammer force or the law of the rock.

struct WordParameter {
    std::string_view key;                          ///< key in files and on the command line, "pulse.shape"
    std::span<const std::string_view> (*words)();  ///< function that returns all allowed words
    std::string_view (*value)(const Scenario&);    ///< function that returns the word that a scenario has
    /// Function that sets the word with this index in words(). It returns an empty message when done, else
    /// why the scenario cannot have it: "only a drill string has it …".
    Message (*assign)(Scenario&, std::size_t word);

    /// Returns all allowed words separated by commas, for messages: "rectangular, triangular, …".
    std::string list() const;
};

std::span<const WordParameter> wordParameters();
/// Returns the parameter with this key whose value is a word, such as "pulse.shape"; nullptr if there is
/// none.
const WordParameter* findWordParameter(std::string_view key);

/// Returns the truth value of `true` or `false`, in the spellings of YAML (true, True, TRUE); nullopt for
/// another word.
std::optional<bool> findTruth(std::string_view word);

/// Returns the names of all shapes of the hammer force, for messages: "rectangular, triangular, …".
std::string pulseShapeList();

/// Returns why a scenario cannot have this shape of the hammer force; empty if it can.
Message shapeRefusal(const Scenario& scenario, PulseShape shape);

/// Returns why a parameter does not apply to this scenario and what to do instead; empty if it applies.
Message whyNotApplicable(const Parameter& parameter, const Scenario& scenario);

/// Sets a parameter to a number in SI. Returns an empty message when done. Otherwise sets nothing and returns
/// the reason: "does not apply here: …" or "must be in (0, 1]".
Message assignNumber(Scenario& scenario, const Parameter& parameter, double si);

/// Returns the known key that is most similar to a mistyped one, among all parameters and sections; empty if
/// none is similar.
std::string nearestKey(std::string_view key);

/// Returns the message on an unknown key: "`gama` is not a parameter; did you mean `gamma`?".
Message notAParameter(std::string_view key);

/// Sets the parameter `key` from `text`, which comes for example from the option --set or a table cell.
/// Accepts numbers with their unit (keys of findParameter()), words (keys of findWordParameter()), and `true`
/// or `false` for "hammer.restrike". `unit` is the unit of a number without one, for example from a column
/// header; nullptr if such numbers are refused. Returns an empty message when done, else the reason:
/// "bit_rock.gamma = 1.3 (must be in (0, 1])". The scenario must not be used after a failure.
Message assignText(Scenario& scenario, std::string_view key, std::string_view text,
                   const Unit* unit = nullptr);
/// Sets a numeric parameter from text, such as "38 mm". `unit` is the unit of a number without one; nullptr
/// if such numbers are refused. Returns an empty message when done, else the reason; the scenario must not be
/// used then.
Message assignText(Scenario& scenario, const Parameter& parameter, std::string_view text,
                   const Unit* unit = nullptr);

}  // namespace drillwave
