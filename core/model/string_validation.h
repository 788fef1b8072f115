// SPDX-License-Identifier: GPL-3.0-or-later
// What can be wrong with the sections of a hammer and a string.
#pragma once

#include <cstdint>
#include <vector>

#include "core/model/drill_string.h"
#include "core/model/validation.h"
#include "core/text/message.h"

namespace drillwave {

/// Every problem of the sections: none at all, too many, numbers out of range, names that are places, a bore
/// as wide as the section, derived values that overflow. Keys are by place ("string.3.bore").
std::vector<InputProblem> sectionProblems(const DrillString& drillString);

/// Returns the message on more than maximumSections of a string or a hammer.
Message tooManySections(std::uint64_t count);

}  // namespace drillwave
