// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the manual as columns of a terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace drillwave {

/// Rows of cells, the header first, in lines of at most `width` columns where its words let it: wide cells go
/// on in the lines below.
std::string plainTable(std::span<const std::vector<std::string>> rows, std::size_t width);

}  // namespace drillwave
