// SPDX-License-Identifier: GPL-3.0-or-later
// Parsers for the design variables, objectives and limits of a design study, as typed in options and files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/model/scenario.h"
#include "core/study/design/design_study.h"
#include "core/study/rows/sweep_axis.h"
#include "core/text/message.h"
#include "core/yaml/preset_file.h"

namespace drillwave {

/// Source of the presets, such as hammers or bits, that a design variable may name.
struct PresetLookup {
    /// Function that returns the presets. It is called only if a text names presets, because it may read a
    /// file.
    std::function<const PresetFile&()> presets;
    std::string listCommand = "drillwave presets";  ///< command that lists the presets, for use in messages
};

/// Returns a PresetLookup for the presets built into the program.
PresetLookup builtInLookup();

/// Returns the axis (design variable) of presets read from "rock=NAME,NAME" or "rock=all", also "hammer=",
/// "rod=" or "bit=". For other text, returns the axis of parseAxis(). Names must be presets that suit the
/// scenario; for drill strings, hammers are pistons. Names may be abbreviated if unique, and may contain
/// commas. Returns a problem if no preset can replace that component of the scenario.
ParsedAxis parseAxisOrPresets(std::string_view text, const Scenario& scenario, const PresetLookup& lookup);

/// Returns whether a text chooses presets: whether it begins with "hammer=", "rod=", "bit=" or "rock=".
bool choosesPresets(std::string_view text);

/// Returns the design variable read from text, in the syntax of parseAxisOrPresets(). Presets of a rock are
/// refused, because the rock cannot be designed.
ParsedAxis parseChoice(std::string_view text, const Scenario& scenario, const PresetLookup& lookup);

/// Objective of a design study read from text, or the reason why it could not be read.
struct ParsedAim {
    DesignAim aim;
    Message problem;
};

/// Returns whether a text begins like an objective: with "max:" or "min:".
bool beginsAsAim(std::string_view text);
/// Returns the objective of a design study read from "max:OUTPUT@STATISTIC" or "min:OUTPUT@STATISTIC", or the
/// problem of this text.
ParsedAim parseAim(std::string_view text);

/// Limit of a design study (a bound on an output) read from text, or the reason why it could not be read.
struct ParsedLimit {
    DesignLimit limit;
    bool isMistyped = false;  ///< whether the problem is a misspelt word rather than an invalid value
    Message problem;
};

/// Returns the limit of a design study read from "OUTPUT@STATISTIC=VALUE", or the problem of this text.
/// `atMost` selects an upper bound, otherwise a lower one. VALUE has a unit if the output has one.
ParsedLimit parseLimit(std::string_view text, bool atMost, const Scenario& scenario);

}  // namespace drillwave
