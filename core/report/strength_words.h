// SPDX-License-Identifier: GPL-3.0-or-later
// Sentence for people that says which section breaks first.
#pragma once

#include <vector>

#include "core/blow/string_blow.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns a sentence on the section that is nearest to its strength. Example: "The most heavily loaded
/// section (3rd rod) has a tension of 362 MPa, which is 90.4 % of its fatigue strength of 400 MPa." The
/// number of sections of the string without a strength follows. If no section has one, the sentence asks for
/// strengths. Empty without stresses.
Message strengthSentence(const Scenario& scenario, const std::vector<SectionStress>& stresses,
                         const ReadingStyle& style);

}  // namespace drillwave
