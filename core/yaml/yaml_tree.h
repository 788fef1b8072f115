// SPDX-License-Identifier: GPL-3.0-or-later
// A YAML text as a plain tree with byte positions: what is needed of YAML, and nothing that surprises.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

enum class YamlKind : std::uint8_t { null, scalar, sequence, map };

/// Value of a YAML text.
struct YamlNode {
    YamlKind kind = YamlKind::null;
    bool flow = false;         ///< written with brackets or braces
    std::uint32_t offset = 0;  ///< first byte in the text
    std::string text;          ///< of a scalar, unquoted
    /// Items of a sequence; key, value, key, value … of a map.
    std::vector<YamlNode> children;

    /// Returns the value of a key of a map, of the first one if it is given more than once; nullptr if there
    /// is none.
    const YamlNode* valueOf(std::string_view key) const;
    /// Returns the text of that value, if it is a scalar.
    const std::string* textOf(std::string_view key) const;
};

/// Something in the text that is not accepted although it may be YAML, and where.
struct YamlProblem {
    std::size_t offset = 0;
    Message text;        ///< empty when nothing is wrong
    bool isYaml = true;  ///< false: the text is not YAML at all
};

/// A tree, or the first thing that is wrong with the text.
struct YamlTree {
    YamlNode root;  ///< of kind null when the document is empty
    YamlProblem problem;
};

/// Parses one document. Refused: anchors, aliases, tags, more than one document, more than 32 levels of
/// nesting, more values than a megabyte of sensible text holds, keys that are not plain text.
YamlTree parseYaml(std::string_view text);

}  // namespace drillwave
