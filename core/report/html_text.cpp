// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_text.h"

namespace drillwave {

namespace {

std::string unbroken(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == ' ' ? std::string("\u00a0") : std::string(1, c);
    return result;
}

}  // namespace

std::string escapedHtml(std::string_view text) {
    std::string result;
    for (const char c : text) {
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

std::string htmlRows(const std::vector<std::vector<std::string>>& rows) {
    std::string html;
    for (const std::vector<std::string>& row : rows) {
        const bool isHead = &row == &rows.front();
        // A class as well: paper breaks words where no blank lets it.
        html += isHead ? "<tr>" : "<tr class=\"whole\">";
        for (const std::string& cell : row) {
            html += isHead ? htmlHead(cell) : htmlElement("td", unbroken(cell));
        }
        html += "</tr>\n";
    }
    return html;
}

}  // namespace drillwave
