// SPDX-License-Identifier: GPL-3.0-or-later
// Manual as text for a terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/manual/markdown.h"

namespace drillwave {

/// Returns Markdown blocks as text with lines of at most `width` columns. Code and formulas are not wrapped.
std::string plainText(std::span<const ManualBlock> blocks, std::size_t width);

}  // namespace drillwave
