// SPDX-License-Identifier: GPL-3.0-or-later
// Change of values in the text of a scenario file, which leaves everything else in place.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"

namespace drillwave {

/// Returns the text of a scenario file after edits that give it the values of `scenario` and `design`.
/// Changed values keep their unit in the file but lose the comment after them. New values get new lines;
/// absent ones are removed; a changed list of points or corners is replaced. Returns nullopt if such edits
/// are not enough, for example for another form of the scenario. The caller must check that reading the
/// result gives the scenario.
std::optional<std::string> patchedText(std::string_view text, const Scenario& scenario,
                                       const DesignSetup& design);

}  // namespace drillwave
