// SPDX-License-Identifier: GPL-3.0-or-later
// The manual as text for a terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/manual/markdown.h"

namespace drillwave {

/// Blocks in lines of at most `width` columns, code and formulas as they stand.
std::string plainText(std::span<const ManualBlock> blocks, std::size_t width);

}  // namespace drillwave
