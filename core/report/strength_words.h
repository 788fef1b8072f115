// SPDX-License-Identifier: GPL-3.0-or-later
// The answer to which section breaks first, for people.
#pragma once

#include <vector>

#include "core/blow/string_blow.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// "First to break: 3rd rod, by a tension of 362 MPa, 90.4 % of its fatigue strength of 400 MPa.", and how
/// many sections of the string have no strength. Asks for strengths where no section has one. Empty without
/// stresses.
Message strengthSentence(const Scenario& scenario, const std::vector<SectionStress>& stresses,
                         const ReadingStyle& style);

}  // namespace drillwave
