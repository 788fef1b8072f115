// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/yaml_extent.h"

#include <algorithm>

namespace drillwave {

std::optional<TextExtent> extentOf(std::string_view text, const YamlNode& scalar) {
    if (scalar.kind != YamlKind::scalar) return std::nullopt;
    const std::string_view rest = text.substr(scalar.offset);
    const bool quoted = rest.starts_with('"') || rest.starts_with('\'');
    const std::size_t begin = quoted ? 1 : 0;
    const bool literal =
        rest.substr(begin).starts_with(scalar.text) && scalar.text.find('\n') == std::string::npos;
    const std::size_t end = begin + scalar.text.size();
    if (!literal || (quoted && (end >= rest.size() || rest[end] != rest[0]))) return std::nullopt;
    return TextExtent{scalar.offset, scalar.offset + end + begin};
}

TextExtent commentBehind(std::string_view text, std::size_t place) {
    const std::size_t behind = text.find_first_not_of(" \t", place);
    if (behind == std::string_view::npos || text[behind] != '#') return {place, place};
    return {behind, std::min(text.find_first_of("\r\n", behind), text.size())};
}

}  // namespace drillwave
