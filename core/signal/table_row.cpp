// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/table_row.h"

#include <algorithm>
#include <array>

#include "core/text/decimal_text.h"
#include "core/text/lower_case.h"
#include "core/text/units.h"

namespace drillwave {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::size_t afterBlanks(std::string_view line, std::size_t at) {
    while (at < line.size() && isBlank(line[at])) ++at;
    return at;
}

}  // namespace

// From behind the opening quote; a doubled quote is one of the text. Ends behind the closing quote.
std::string_view TableRow::quotedCell(std::string_view line, std::size_t& at) {
    std::string& text = m_unquoted.emplace_back();
    for (++at; at < line.size(); ++at) {
        if (line[at] == '"' && (++at >= line.size() || line[at] != '"')) break;
        text += line[at];
    }
    return trimmed(text);
}

const std::vector<std::string_view>& TableRow::split(std::string_view line, char separator,
                                                     std::size_t most) {
    m_cells.clear();
    m_unquoted.clear();
    const bool blanks = separator == ' ';
    std::size_t at = 0;
    if (blanks) line = trimmed(line);
    while (m_cells.size() < most) {
        if (separator != '\t') at = afterBlanks(line, at);
        const auto ends = [&](char c) { return blanks ? isBlank(c) : c == separator; };
        if (at < line.size() && line[at] == '"') {
            m_cells.push_back(quotedCell(line, at));
            while (at < line.size() && !ends(line[at])) ++at;
        } else {
            const std::size_t begin = at;
            while (at < line.size() && !ends(line[at])) ++at;
            m_cells.push_back(trimmed(line.substr(begin, at - begin)));
        }
        if (at >= line.size()) break;
        ++at;
    }
    return m_cells;
}

std::optional<double> cellNumber(std::string_view cell, DecimalSign decimal) {
    if (decimal == DecimalSign::point) return parseNumber(cell);
    std::array<char, 64> text{};
    if (cell.size() > text.size() || cell.find('.') != std::string_view::npos) return std::nullopt;
    std::ranges::replace_copy(cell, text.begin(), ',', '.');
    return parseNumber({text.data(), cell.size()});
}

bool isMissing(std::string_view cell) {
    constexpr std::string_view words[] = {"",    "nan",  "-nan", "+nan", "inf", "-inf", "+inf",
                                          "n/a", "#n/a", "na",   "-",    "--",  "---",  "null"};
    if (cell.size() > 4) return false;
    const std::string lower = lowerCase(std::string(cell));
    return std::ranges::find(words, std::string_view(lower)) != std::end(words);
}

}  // namespace drillwave
