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

/// Source of presets that a design variable may name, such as hammers or bits.
struct PresetLookup {
    /// Function that loads the presets; called only if the text names presets.
    std::function<const PresetFile&()> presets;
    std::string listCommand = "drillwave presets";  ///< command that lists the presets, for use in messages
};

/// Returns a lookup that uses the presets built into the program.
PresetLookup builtInLookup();

/// Returns the axis of presets read from "rock=NAME,NAME" or "rock=all" (also "hammer=", "rod=" or "bit="),
/// or the axis of parseAxis() for other text. Names must be presets that suit the scenario; for drill
/// strings, hammers are pistons. Names may be abbreviated if unique, and may contain commas. Returns a
/// problem if no preset can replace that component of the scenario.
ParsedAxis parseAxisOrPresets(std::string_view text, const Scenario& scenario, const PresetLookup& lookup);

/// Returns whether a text chooses presets: whether it begins with "hammer=", "rod=", "bit=" or "rock=".
bool choosesPresets(std::string_view text);

/// Returns the design variable read from text, in the syntax of parseAxisOrPresets(). Presets of a rock are
/// refused, because a user cannot choose the rock.
ParsedAxis parseChoice(std::string_view text, const Scenario& scenario, const PresetLookup& lookup);

/// Objective read from text, or the problem why it could not be read.
struct ParsedAim {
    DesignAim aim;
    Message problem;
};

/// Returns whether a text begins like an objective: with "max:" or "min:".
bool beginsAsAim(std::string_view text);
/// Returns the objective read from "max:OUTPUT@STATISTIC" or "min:OUTPUT@STATISTIC", or a problem.
ParsedAim parseAim(std::string_view text);

/// Limit read from text, or the problem why it could not be read.
struct ParsedLimit {
    DesignLimit limit;
    bool isMistyped = false;  ///< whether the problem is a misspelt word rather than an invalid value
    Message problem;
};

/// Returns the limit read from "OUTPUT@STATISTIC=VALUE", or a problem. `atMost` selects an upper bound,
/// otherwise a lower one. VALUE has a unit if the output has one.
ParsedLimit parseLimit(std::string_view text, bool atMost, const Scenario& scenario);

}  // namespace drillwave
