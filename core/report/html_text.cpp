// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_text.h"

#include <algorithm>

#include "core/text/name_text.h"

namespace drillwave {

namespace {

/// Letters of a word up to a place, or from it on.
std::size_t lettersBefore(std::string_view text, std::size_t end) {
    std::size_t count = 0;
    while (count < end && text[end - count - 1] != ' ') ++count;
    return count;
}
std::size_t lettersFrom(std::string_view text, std::size_t begin) {
    return std::min(text.find(' ', begin), text.size()) - begin;
}

/// A line may end between two words, and not at a number, nor in "N s", nor at the blanks before a text.
bool mayBreakAt(std::string_view text, std::size_t blank) {
    constexpr std::size_t leastWord = 3;
    const auto hasDigit = [](std::string_view word) { return word.find_first_of("0123456789") != word.npos; };
    const std::size_t before = lettersBefore(text, blank), behind = lettersFrom(text, blank + 1);
    return before >= leastWord && behind >= leastWord && !hasDigit(text.substr(blank - before, before)) &&
           !hasDigit(text.substr(blank + 1, behind));
}

std::string unbroken(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i)
        result += text[i] == ' ' && !mayBreakAt(text, i) ? std::string("\u00a0") : std::string(1, text[i]);
    return result;
}

}  // namespace

std::string escapedHtml(std::string_view text) {
    std::string result;
    for (const char c : printableLines(text)) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string htmlElement(std::string_view tag, std::string_view text) {
    const std::string name(tag);
    return "<" + name + ">" + escapedHtml(text) + "</" + name + ">";
}

std::string htmlHead(std::string_view text) {
    const bool isWord = text.find(' ') == text.npos;
    return isWord ? "<th class=\"whole\">" + escapedHtml(text) + "</th>" : htmlElement("th", text);
}

std::string htmlHeads(const std::vector<std::string>& names) {
    std::string html = "<thead><tr>";
    for (const std::string& name : names) html += htmlHead(name);
    return html + "</tr></thead>\n";
}

std::string htmlRows(const std::vector<std::vector<std::string>>& rows) {
    std::string html;
    for (const std::vector<std::string>& row : rows) {
        if (&row == &rows.front()) {
            html += htmlHeads(row);
            continue;
        }
        html += "<tr>";
        for (const std::string& cell : row) {
            const std::string text = unbroken(cell);
            // A class as well: paper breaks words where no blank lets it.
            const bool isWhole = text.find(' ') == text.npos;
            html += (isWhole ? "<td class=\"whole\">" : "<td>") + escapedHtml(text) + "</td>";
        }
        html += "</tr>\n";
    }
    return html;
}

}  // namespace drillwave
