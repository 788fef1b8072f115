// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of values in a YAML text.
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

/// Returns the bytes of a scalar including its quotes; nullopt if it is not on one line.
std::optional<TextExtent> extentOf(std::string_view text, const YamlNode& scalar);

/// Returns the position just after a value in the text, including the brackets that close it. Returns nullopt
/// if the value is absent, or if its last scalar is not on one line.
std::optional<std::size_t> endOf(std::string_view text, const YamlNode& value);

/// Returns the complete lines that contain these bytes, including the last line end.
TextExtent linesOf(std::string_view text, TextExtent extent);

/// Returns the comment on the same line after the byte `place`, from its `#` to the end of the line. Empty if
/// there is none, or if other text is between the byte and the `#`.
TextExtent commentBehind(std::string_view text, std::size_t place);

}  // namespace drillwave
