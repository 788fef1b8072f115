// SPDX-License-Identifier: GPL-3.0-or-later
// Changed values put into the text of a scenario file, everything else in it left where it is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/model/design_setup.h"
#include "core/model/scenario.h"

namespace drillwave {

/// The text with the values of the scenario and its design: changed ones in the unit the file used and
/// without the comment behind them, which was about the value before, new ones on new lines, those that went
/// taken out. A list of points or of corners that changes is put in as lines of its own. nullopt where that
/// takes more than exchanging values, lines and such lists (another form, values that span lines). The caller
/// checks that the result says the scenario.
std::optional<std::string> patchedText(std::string_view text, const Scenario& scenario,
                                       const DesignSetup& design);

}  // namespace drillwave
