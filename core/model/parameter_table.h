// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of parameters: a row each, to which a new one is added.
#pragma once

#include <span>

namespace drillwave {

struct Parameter;

/// All numeric parameters but those of sections, physical ones first, the groups last, in the order of
/// scenario files.
std::span<const Parameter> parameters();

}  // namespace drillwave
