// SPDX-License-Identifier: GPL-3.0-or-later
// Changes in results since older versions (manual, upgrading).
#pragma once

#include <string_view>

#include "core/model/scenario.h"
#include "core/text/message.h"

namespace drillwave {

/// Says which numbers of a result that `version` ("0.2.0") wrote of this scenario have changed: "Written by
/// Drillwave 0.2.0. These results have changed since: … (manual, Upgrading)." Empty where none has, or the
/// version is not known.
Message changesSentence(std::string_view version, const Scenario& scenario);

}  // namespace drillwave
