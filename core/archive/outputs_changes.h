// SPDX-License-Identifier: GPL-3.0-or-later
// Changes in results since older versions (manual, upgrading).
#pragma once

#include <string_view>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Which numbers of a result that `version` ("0.2.0") wrote of this scenario are others now, in the middle
/// of a sentence; empty where none is, or the version is not known.
Message changedNumbers(std::string_view version, const Scenario& scenario);

/// The same as a sentence: "Written by Drillwave 0.2.0. Since then … changed; see Upgrading in the manual."
Message changesSentence(std::string_view version, const Scenario& scenario);

}  // namespace drillwave
