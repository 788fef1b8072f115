// SPDX-License-Identifier: GPL-3.0-or-later
// "Did you mean …?" for mistyped names.
#pragma once

#include <span>
#include <string_view>

namespace drillwave {

/// The candidate within a few typing errors of `name` (insertions, deletions, replacements, swapped
/// neighbours; about one in three characters), or empty when none is that close. Also finds "stiffness" for
/// "bit_rock.stiffness".
std::string_view nearestName(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace drillwave
