// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_text.h"

#include <algorithm>

#include "core/model/blow_traits.h"
#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/text/handy_text.h"

namespace drillwave {

std::string titleLine(const Scenario& scenario) {
    std::string title = scenario.title;  // a title may hold anything, a terminal not
    std::ranges::replace_if(
        title, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return title.empty() ? std::string() : title + "\n";
}

std::string groupsLine(const Scenario& scenario) {
    const Groups groups = groupsOf(scenario);
    return "  beta " + rounded(groups.beta) + "  gamma " + rounded(groups.gamma) + "  tau " +
           rounded(groups.tau) + "  delta " + rounded(groups.delta) +
           (followsFromGroups(scenario) ? "  pulse " + std::string(name(scenario.pulse.shape)) : "") + "\n";
}

std::string lawLine(const Scenario& scenario) {
    const BitRock& rock = scenario.bitRock;
    const auto quantity = [&](double value, Quantity of) {
        if (hasUnits(scenario) && of != Quantity::ratio) return inHandyUnit(value, of);
        const char* scale = of == Quantity::force ? " F0" : of == Quantity::length ? " d0" : "";
        return rounded(value) + scale;
    };
    std::string numbers;
    for (const Parameter& row : parameters())
        if (row.rules.law == rock.law)
            numbers += (numbers.empty() ? " " : ", ") + std::string(row.label) + " " +
                       quantity(*inFormOf(scenario, row)->value(scenario), row.quantity);
    constexpr std::size_t enough = 4;
    for (std::size_t i = 0; i < std::min(enough, rock.corners.size()); ++i)
        numbers += (i == 0 ? " slope " : ", ") + rounded(rock.corners[i].slope) + " k from " +
                   quantity(rock.corners[i].force, Quantity::force);
    if (rock.corners.size() > enough)
        numbers += ", and " + std::to_string(rock.corners.size() - enough) + " more";
    return numbers.empty() ? numbers : "  rock law " + std::string(name(rock.law)) + " " + numbers + "\n";
}

std::string headingOf(const Scenario& scenario) {
    return titleLine(scenario) + groupsLine(scenario) + lawLine(scenario);
}

namespace {

/// Where the first line of such words ends: at a blank, and not behind a number, which stays with its unit.
std::size_t lineEnd(std::string_view words) {
    constexpr std::size_t width = 98;
    if (words.size() <= width) return words.size();
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    for (std::size_t end = words.rfind(' ', width); end != words.npos && end > 0;
         end = words.rfind(' ', end - 1))
        if (!isDigit(words[end - 1])) return end;
    return std::min(words.find(' ', width), words.size());
}

}  // namespace

std::string paragraph(std::string_view words) {
    std::string text;
    while (!words.empty()) {
        const std::size_t end = lineEnd(words);
        text += "  " + std::string(words.substr(0, end)) + "\n";
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return text;
}

void TextGrid::addTitles(const std::vector<const char*>& titles, const ReadingStyle& style) {
    std::vector<std::string> cells;
    for (const char* title : titles) cells.push_back(style.said(title));
    add(std::move(cells));
}

std::string TextGrid::text() const {
    std::string text;
    for (const auto& row : m_rows) {
        std::string line = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string space(width(c) - std::min(width(c), row[c].size()), ' ');
            const bool left = c == 0 || m_alignment == CellAlignment::left;
            line += " " + (left ? row[c] + space : space + row[c]) + " ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::size_t TextGrid::width(std::size_t column) const {
    std::size_t widest = 0;
    for (const auto& row : m_rows)
        if (column < row.size() && (row.size() > 2 || column + 1 < row.size()))
            widest = std::max(widest, row[column].size());
    return widest;
}

}  // namespace drillwave
