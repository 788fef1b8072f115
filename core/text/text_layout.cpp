// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_layout.h"

#include <algorithm>

namespace drillwave {

namespace {

bool beginsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

std::string blanksUpTo(std::size_t columns, std::string_view text) {
    return std::string(columns - std::min(columns, columnsOf(text)), ' ');
}

}  // namespace

std::size_t columnsOf(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, beginsCharacter));
}

std::size_t byteOfColumn(std::string_view text, std::size_t column) {
    for (std::size_t at = 0; at < text.size(); ++at)
        if (beginsCharacter(text[at]) && column-- == 0) return at;
    return text.size();
}

std::string leftAligned(std::string_view text, std::size_t columns) {
    return std::string(text) + blanksUpTo(columns, text);
}

std::string rightAligned(std::string_view text, std::size_t columns) {
    return blanksUpTo(columns, text) + std::string(text);
}

std::string indented(std::string_view lines, std::size_t blanks) {
    const std::string before(blanks, ' ');
    std::string text = before;
    for (const char c : lines) text += c == '\n' ? "\n" + before : std::string(1, c);
    return text + "\n";
}

}  // namespace drillwave
