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

/// Returns the extent of a scalar, with its quotes; nothing if it is not on one line.
std::optional<TextExtent> extentOf(std::string_view text, const YamlNode& scalar);

/// The byte behind a value with the brackets that close it; nothing where its last scalar has no extent, and
/// for an absent value.
std::optional<std::size_t> endOf(std::string_view text, const YamlNode& value);

/// Returns the lines of an extent, from the first byte to after the line end.
TextExtent linesOf(std::string_view text, TextExtent extent);

/// The comment that follows behind blanks, from its `#` to the end of the line; empty extent without.
TextExtent commentBehind(std::string_view text, std::size_t place);

}  // namespace drillwave
