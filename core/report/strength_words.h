// SPDX-License-Identifier: GPL-3.0-or-later
// Sentence for people that says which section breaks first.
#pragma once

#include <vector>

#include "core/blow/string_blow.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns a sentence such as "The most heavily loaded section (3rd rod) has a tension of 362 MPa, which is
/// 90.4 % of its fatigue strength of 400 MPa." The number of sections without a strength follows. If no
/// section has one, asks for strengths. Empty without stresses.
Message strengthSentence(const Scenario& scenario, const std::vector<SectionStress>& stresses,
                         const ReadingStyle& style);

}  // namespace drillwave
