// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/yaml_extent.h"

#include <algorithm>

namespace drillwave {
namespace {

/// The byte behind the closing quote of a scalar that begins with one; npos where it is not on that line.
std::size_t behindQuote(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    for (std::size_t at = begin + 1; at < text.size() && text[at] != '\n'; ++at) {
        const bool isEscape = quote == '"' ? text[at] == '\\' : text.substr(at).starts_with("''");
        if (isEscape)
            ++at;
        else if (text[at] == quote)
            return at + 1;
    }
    return std::string_view::npos;
}

}  // namespace

std::optional<TextExtent> extentOf(std::string_view text, const YamlNode& scalar) {
    if (scalar.kind != YamlKind::scalar || scalar.offset >= text.size()) return std::nullopt;
    const std::size_t begin = scalar.offset;
    if (text[begin] == '"' || text[begin] == '\'') {
        const std::size_t end = behindQuote(text, begin);
        return end == std::string_view::npos ? std::nullopt : std::optional(TextExtent{begin, end});
    }
    const bool literal =
        text.substr(begin).starts_with(scalar.text) && scalar.text.find('\n') == std::string::npos;
    return literal ? std::optional(TextExtent{begin, begin + scalar.text.size()}) : std::nullopt;
}

std::optional<std::size_t> endOf(std::string_view text, const YamlNode& value) {
    if (value.kind == YamlKind::scalar) {
        const std::optional<TextExtent> extent = extentOf(text, value);
        return extent ? std::optional(extent->end) : std::nullopt;
    }
    if (value.kind == YamlKind::null) return std::nullopt;
    if (value.children.empty()) {
        const std::size_t close =
            value.flow ? text.find_first_of("]}", value.offset) : std::string_view::npos;
        return close == std::string_view::npos ? std::nullopt : std::optional(close + 1);
    }
    // The key stands for a last value that is absent.
    const bool isAbsent = value.kind == YamlKind::map && value.children.back().kind == YamlKind::null;
    const std::optional<std::size_t> last =
        endOf(text, isAbsent ? value.children[value.children.size() - 2] : value.children.back());
    if (!last || !value.flow) return last;
    std::size_t at = *last;
    // Over commas, colons, line ends and comments to the bracket that closes the value.
    while ((at = text.find_first_of("]}#", at)) != std::string_view::npos && text[at] == '#')
        at = std::min(text.find('\n', at), text.size());
    return at == std::string_view::npos ? std::nullopt : std::optional(at + 1);
}

TextExtent linesOf(std::string_view text, TextExtent extent) {
    const std::size_t before =
        extent.begin == 0 ? std::string_view::npos : text.rfind('\n', extent.begin - 1);
    const std::size_t after = text.find('\n', extent.end);
    return {before == std::string_view::npos ? 0 : before + 1,
            after == std::string_view::npos ? text.size() : after + 1};
}

TextExtent commentBehind(std::string_view text, std::size_t place) {
    const std::size_t behind = text.find_first_not_of(" \t", place);
    if (behind == std::string_view::npos || text[behind] != '#') return {place, place};
    return {behind, std::min(text.find_first_of("\r\n", behind), text.size())};
}

}  // namespace drillwave
