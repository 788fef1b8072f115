// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/manual/plain_text.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "core/manual/markdown.h"
#include "core/text/text_layout.h"

namespace drillwave {

namespace {

// A table of the manual as columns of a terminal.

using Row = std::vector<std::string>;

constexpr std::size_t between = 2;       // blanks between two columns
constexpr std::size_t leastColumn = 12;  // a wide column is not made narrower than that

std::vector<std::size_t> naturalWidths(std::span<const Row> rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const Row& row : rows)
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths[i] = std::max(widths[i], columnsOf(withoutMarks(row[i])));
    return widths;
}

// The widest ones give way, until all fit.
std::vector<std::size_t> fittedWidths(std::span<const Row> rows, std::size_t width) {
    std::vector<std::size_t> widths = naturalWidths(rows);
    std::size_t total = std::accumulate(widths.begin(), widths.end(), between * (widths.size() - 1));
    while (total > width) {
        const auto widest = std::ranges::max_element(widths);
        if (*widest <= leastColumn) break;
        --*widest;
        --total;
    }
    return widths;
}

std::string line(std::span<const std::vector<std::string>> cells, std::size_t at,
                 std::span<const std::size_t> widths) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string part = at < cells[i].size() ? cells[i][at] : std::string();
        text += part;
        const std::size_t columns = columnsOf(part);
        if (i + 1 < cells.size())
            text += std::string(between + (widths[i] > columns ? widths[i] - columns : 0), ' ');
    }
    while (text.ends_with(' ')) text.pop_back();
    return text + "\n";
}

// Rows of cells, the header first, in lines of at most `width` columns where its words let it: wide cells go
// on in the lines below.
std::string plainTable(std::span<const Row> rows, std::size_t width) {
    if (rows.empty()) return {};
    const std::vector<std::size_t> widths = fittedWidths(rows, width);
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<std::vector<std::string>> cells;
        std::size_t height = 1;
        for (std::size_t column = 0; column < widths.size(); ++column) {
            cells.push_back(wrapped(withoutMarks(rows[i][column]), widths[column]));
            height = std::max(height, cells.back().size());
        }
        for (std::size_t at = 0; at < height; ++at) text += line(cells, at, widths);
        if (i > 0) continue;
        std::vector<std::vector<std::string>> rule;
        for (const std::size_t columns : widths) rule.push_back({std::string(columns, '-')});
        text += line(rule, 0, widths);
    }
    return text;
}

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
