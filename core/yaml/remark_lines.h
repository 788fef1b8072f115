// SPDX-License-Identifier: GPL-3.0-or-later
// The comment lines at the top of a scenario's text that tell of a result: who wrote it, and how it was
// solved.
#pragma once

#include <cstddef>
#include <string_view>

namespace drillwave {

/// How they begin, in this order; all but the first may be absent.
inline constexpr std::string_view writtenRemark = "# Written by Drillwave ";
inline constexpr std::string_view solvedRemark = "# Solved by method ";
inline constexpr std::string_view columnsRemark = "# Columns: ";

/// Bytes of these lines, with a byte order mark in front of them; 0 for a text that does not begin with them.
std::size_t remarksLength(std::string_view yaml);

}  // namespace drillwave
