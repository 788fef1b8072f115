// SPDX-License-Identifier: GPL-3.0-or-later
// YAML text as a simple tree with byte positions. Only the part of YAML that files of this program need.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/message.h"

namespace drillwave {

enum class YamlKind : std::uint8_t { null, scalar, sequence, map };

/// Value in a YAML text: absent, a scalar, a sequence or a map.
struct YamlNode {
    YamlKind kind = YamlKind::null;
    bool flow = false;         ///< whether a sequence or map is written in brackets or braces
    std::uint32_t offset = 0;  ///< position of its first byte in the text
    std::string text;          ///< text of a scalar, without quotes
    /// Items of a sequence; for a map its keys and values in turn.
    std::vector<YamlNode> children;

    /// Returns the value of a key of a map, of the first one if it occurs more than once; nullptr if there is
    /// none.
    const YamlNode* valueOf(std::string_view key) const;
    /// Returns the text of the value of a key, or nullptr if there is none or it is not a scalar.
    const std::string* textOf(std::string_view key) const;
};

/// First part of a YAML text that this parser does not accept, with its byte offset. The part may be valid
/// YAML that this program does not support; see `isYaml`.
struct YamlProblem {
    std::size_t offset = 0;
    Message text;        ///< description of the problem; empty if there is none
    bool isYaml = true;  ///< whether the text is valid YAML in spite of the problem
};

/// Parsed YAML text, or the first problem in it.
struct YamlTree {
    YamlNode root;  ///< root of the tree; of the kind `null` for an empty document
    YamlProblem problem;
};

/// Parses one YAML document. Refuses anchors, aliases, tags, several documents, more than 32 levels of
/// nesting, unreasonably many values, and keys that are not plain text.
YamlTree parseYaml(std::string_view text);

}  // namespace drillwave
