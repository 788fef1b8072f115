// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_input.h"

#include <algorithm>

#include "core/text/message.h"

namespace drillwave {
namespace {

unsigned char byteAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

/// Length of the well-formed UTF-8 sequence at that place, 0 if there is none.
std::size_t sequenceLength(std::string_view text, std::size_t at) {
    const unsigned char lead = byteAt(text, at);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byteAt(text, at + i) & 0xC0) != 0x80) return 0;
    const unsigned char second = byteAt(text, at + 1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool surrogateOrBeyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
    return overlong || surrogateOrBeyond ? 0 : length;
}

std::string_view controlProblem(std::string_view text, std::size_t at) {
    const unsigned char c = byteAt(text, at);
    if (c == '\r')
        return byteAt(text, at + 1) == '\n' ? "" : translatable("a carriage return without a line feed");
    if (c == '\n' || c == '\t' || (c >= 0x20 && c != 0x7F)) return "";
    return c == 0 ? translatable("a NUL byte") : translatable("a control character");
}

}  // namespace

TextProblem checkText(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequenceLength(text, at);
        if (length == 0) return {at, translatable("a byte that is not UTF-8")};
        const std::string_view control = length == 1 ? controlProblem(text, at) : "";
        if (!control.empty()) return {at, std::string(control)};
        at += length;
    }
    return {};
}

std::size_t utf8Length(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = sequenceLength(text, at);
        if (length == 0) break;
        at += length;
    }
    return at;
}

bool isUtf8(std::string_view text) {
    return utf8Length(text) == text.size();
}

std::size_t byteOrderMarkLength(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

TextPosition positionOf(std::string_view text, std::size_t offset) {
    // A byte order mark is no character of the first line.
    if (const std::size_t mark = byteOrderMarkLength(text); offset >= mark) {
        text.remove_prefix(mark);
        offset -= mark;
    }
    const std::string_view before = text.substr(0, offset);
    const std::size_t lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    TextPosition position;
    position.line += static_cast<int>(std::ranges::count(before, '\n'));
    position.column += static_cast<int>(std::ranges::count_if(before.substr(lineStart), startsCharacter));
    return position;
}

}  // namespace drillwave
