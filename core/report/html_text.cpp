// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_text.h"

namespace drillwave {

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

std::string htmlTable(const std::vector<std::vector<std::string>>& rows) {
    std::string html = "<table>\n";
    for (const std::vector<std::string>& row : rows) {
        html += "<tr>";
        for (const std::string& cell : row) html += htmlElement(&row == &rows.front() ? "th" : "td", cell);
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

}  // namespace drillwave
