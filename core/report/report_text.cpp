// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_text.h"

#include "core/model/chain_words.h"
#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"
#include "core/text/handy_text.h"
#include "core/text/name_text.h"
#include "core/text/text_layout.h"

namespace drillwave {

std::string titleLine(const Scenario& scenario) {
    return scenario.title.empty() ? std::string() : printableLine(scenario.title) + "\n";
}

std::string groupsLine(const Scenario& scenario, const ReadingStyle& style) {
    const Groups groups = groupsOf(scenario);
    std::string line = "  beta " + style.number(groups.beta) + "  gamma " + style.number(groups.gamma) +
                       "  tau " + style.number(groups.tau) + "  delta " + style.number(groups.delta);
    if (const char* pulse = chainWords(scenario).pulse; *pulse)
        line += "  " + style.said({pulse, {style.name(name(scenario.pulse.shape))}});
    return line + "\n";
}

namespace {

std::string lawQuantity(const Scenario& scenario, double value, Quantity of, const ReadingStyle& style) {
    if (hasUnits(scenario) && of != Quantity::ratio) return style.quantity(value, of);
    const char* scale = of == Quantity::force ? " F0" : of == Quantity::length ? " d0" : "";
    return style.number(value) + scale;
}

/// "slope 0.5 k from 20 kN, 0.25 k from 40 kN, and 2 more".
std::string cornersText(const Scenario& scenario, const ReadingStyle& style) {
    const std::vector<RockCorner>& corners = scenario.bitRock.corners;
    constexpr std::size_t enough = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(enough, corners.size()); ++i)
        text += (i == 0 ? "" : ", ") +
                style.said({i == 0 ? translatable("slope %1 k from %2") : translatable("%1 k from %2"),
                            {style.number(corners[i].slope),
                             lawQuantity(scenario, corners[i].force, Quantity::force, style)}});
    if (corners.size() > enough)
        text += ", " + style.said({translatable("and %1 more"), {std::to_string(corners.size() - enough)}});
    return text;
}

}  // namespace

std::string lawLine(const Scenario& scenario, const ReadingStyle& style) {
    const BitRock& rock = scenario.bitRock;
    std::string numbers;
    for (const Parameter& row : parameters())
        if (row.rules.law == rock.law)
            numbers += (numbers.empty() ? " " : ", ") + style.said(Message::ofTable(row.label)) + " " +
                       lawQuantity(scenario, *inFormOf(scenario, row)->value(scenario), row.quantity, style);
    if (!rock.corners.empty()) numbers += " " + cornersText(scenario, style);
    if (numbers.empty()) return numbers;
    return "  " + style.said({translatable("rock: %1,"), {Message::ofTable(phrase(rock.law))}}) + numbers +
           "\n";
}

std::string headingOf(const Scenario& scenario, const ReadingStyle& style) {
    return titleLine(scenario) + groupsLine(scenario, style) + lawLine(scenario, style);
}

namespace {

/// Where the first line of such words ends: at a blank, and not behind a number, which stays with its unit.
std::size_t lineEnd(std::string_view words) {
    constexpr std::size_t columns = 98;
    const std::size_t width = byteOfColumn(words, columns);
    if (width == words.size()) return width;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    for (std::size_t end = words.rfind(' ', width); end != words.npos && end > 0;
         end = words.rfind(' ', end - 1))
        if (!isDigit(words[end - 1])) return end;
    return std::min(words.find(' ', width), words.size());
}

}  // namespace

std::string inOneParagraph(const std::vector<Message>& sentences, const ReadingStyle& style) {
    std::string text;
    for (const Message& sentence : sentences) text += (text.empty() ? "" : " ") + style.said(sentence);
    return text;
}

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
    const std::vector<std::size_t> widths = this->widths();
    std::string text;
    for (const auto& row : m_rows) {
        std::string line = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const bool left = c == 0 || m_alignment == CellAlignment::left;
            line += " " + (left ? leftAligned(row[c], widths[c]) : rightAligned(row[c], widths[c])) + " ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::vector<std::size_t> TextGrid::widths() const {
    std::vector<std::size_t> widths;
    for (const auto& row : m_rows) {
        widths.resize(std::max(widths.size(), row.size()));
        const std::size_t aligned =
            row.size() > 2 ? row.size() : row.size() - std::min<std::size_t>(row.size(), 1);
        for (std::size_t c = 0; c < aligned; ++c) widths[c] = std::max(widths[c], columnsOf(row[c]));
    }
    return widths;
}

}  // namespace drillwave
