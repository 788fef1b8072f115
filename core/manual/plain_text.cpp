// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/plain_text.h"

#include "core/manual/inline_text.h"
#include "core/manual/plain_table.h"
#include "core/text/text_layout.h"

namespace drillwave {
namespace {

using Kind = ManualBlock::Kind;

constexpr std::size_t typedIndent = 4;  // what is to be typed, or a formula, stands out

std::string indented(std::span<const std::string> lines, std::size_t indent, std::string_view first) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == 0 ? std::string(first) : std::string(indent, ' ')) + lines[i] + "\n";
    return text;
}

std::string heading(const ManualBlock& block) {
    const std::string words = withoutMarks(block.text);
    if (block.level > 2) return words + "\n";
    return words + "\n" + std::string(columnsOf(words), block.level == 1 ? '=' : '-') + "\n";
}

std::string codeLines(const ManualBlock& block, std::size_t indent) {
    std::string text;
    std::string_view rest = block.text;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        text += line.empty() ? "\n" : std::string(indent, ' ') + std::string(line) + "\n";
        rest.remove_prefix(end + 1);
    }
    return text;
}

std::string plainBlock(const ManualBlock& block, std::size_t width) {
    const auto indent = static_cast<std::size_t>(block.level);
    switch (block.kind) {
        case Kind::heading:
            return heading(block);
        case Kind::paragraph:
            return indented(wrapped(withoutMarks(block.text), width - indent), indent,
                            std::string(indent, ' '));
        case Kind::item: {
            const std::size_t hang = indent + block.mark.size() + 1;
            return indented(wrapped(withoutMarks(block.text), width - hang), hang,
                            std::string(indent, ' ') + block.mark + " ");
        }
        case Kind::code:
            return codeLines(block, indent + typedIndent);
        case Kind::table:
            return plainTable(block.rows, width);
    }
    return {};
}

}  // namespace

std::string plainText(std::span<const ManualBlock> blocks, std::size_t width) {
    std::string text;
    const ManualBlock* before = nullptr;
    for (const ManualBlock& block : blocks) {
        const bool isList = before && before->kind == Kind::item && block.kind == Kind::item;
        if (before && !isList) text += "\n";
        text += plainBlock(block, width);
        before = &block;
    }
    return text;
}

}  // namespace drillwave
