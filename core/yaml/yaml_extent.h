// SPDX-License-Identifier: GPL-3.0-or-later
// Where the values of a YAML text stand in it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/yaml/yaml_tree.h"

namespace drillwave {

/// Bytes [begin, end) of a text.
struct TextExtent {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Where a scalar stands, with its quotes; nothing where it does not stand there literally.
std::optional<TextExtent> extentOf(std::string_view text, const YamlNode& scalar);

/// The comment that follows behind blanks, from its `#` to the end of the line; empty extent without.
TextExtent commentBehind(std::string_view text, std::size_t place);

}  // namespace drillwave
