// SPDX-License-Identifier: GPL-3.0-or-later
// Choices, aims and limits of a design study read from the words that options and files share.
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

/// Source of the names of presets for a choice.
struct PresetLookup {
    std::function<const PresetFile&()> presets;     ///< called only for names of presets
    std::string listCommand = "drillwave presets";  ///< for messages
};

/// Returns the lookup in the built-in presets.
PresetLookup builtInLookup();

/// Returns whether the text chooses presets: "hammer=…", "rod=…" or "bit=…".
bool choosesPresets(std::string_view text);

/// Reads "hammer=NAME,NAME", also for rod and bit, or what parseAxis() reads. The names are those of presets
/// that suit the scenario; for drill strings, hammers are pistons. A name may be cut short where only one
/// begins so, and may have commas. Refuses a part that no preset can replace in the scenario.
ParsedAxis parseChoice(std::string_view text, const Scenario& scenario, const PresetLookup& lookup);

/// An aim read from text, or why not.
struct ParsedAim {
    DesignAim aim;
    Message problem;
};

/// Returns whether the text begins as an aim does: "max:" or "min:".
bool beginsAsAim(std::string_view text);
/// Reads "max:OUTPUT@STATISTIC" or "min:OUTPUT@STATISTIC".
ParsedAim parseAim(std::string_view text);

/// A limit read from text, or why not.
struct ParsedLimit {
    DesignLimit limit;
    bool isMistyped = false;  ///< the problem is one of the words, not of the value
    Message problem;
};

/// Reads "OUTPUT@STATISTIC=VALUE", at most or at least; the value has a unit where the output has one.
ParsedLimit parseLimit(std::string_view text, bool atMost, const Scenario& scenario);

}  // namespace drillwave
