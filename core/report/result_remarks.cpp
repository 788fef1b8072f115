// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/result_remarks.h"

#include <algorithm>
#include <charconv>

#include "core/model/version.h"
#include "core/text/text_input.h"

namespace drillwave {
namespace {

constexpr std::string_view writtenBy = "# Written by Drillwave ";
constexpr std::string_view solvedBy = "# Solved by method ";
constexpr std::string_view columnsAre = "# Columns: ";

std::string versionIn(std::string_view line) {
    std::string_view version = line.substr(writtenBy.size());
    version = version.substr(0, std::min(version.find_first_of("; \r"), version.size()));
    while (version.ends_with('.')) version.remove_suffix(1);
    return std::string(version);
}

/// "lattice, 500 segments." as describe() says it.
std::optional<MethodChoice> methodIn(std::string_view line) {
    std::string_view words = line.substr(solvedBy.size());
    while (words.ends_with('\r') || words.ends_with('.')) words.remove_suffix(1);
    const std::size_t comma = std::min(words.find(", "), words.size());
    const std::optional<Method> method = findMethod(words.substr(0, comma));
    if (!method) return std::nullopt;
    MethodChoice choice;
    choice.method = *method;
    if (choice.method != Method::lattice) return choice;
    if (comma == words.size()) return std::nullopt;
    words.remove_prefix(comma + 2);
    int segments = 0;
    const auto read = std::from_chars(words.data(), words.data() + words.size(), segments);
    if (read.ec != std::errc() || segments < minimumSegments || segments > maximumSegments)
        return std::nullopt;
    choice.lattice.segments = segments;
    return choice;
}

}  // namespace

std::string remarksText(std::string_view about, std::string_view method, std::string_view columns) {
    std::string text = std::string(writtenBy) + versionText + std::string(about) + "\n";
    if (!method.empty()) text += "# Solved by " + std::string(method) + ".\n";
    if (!columns.empty()) text += std::string(columnsAre) + std::string(columns) + "\n";
    return text;
}

ResultRemarks remarksOf(std::string_view yaml) {
    ResultRemarks remarks;
    const std::size_t mark = byteOrderMarkLength(yaml);
    if (!yaml.substr(mark).starts_with(writtenBy)) return remarks;
    remarks.length = mark;
    for (;;) {
        const std::string_view rest = yaml.substr(remarks.length);
        const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
        if (line.starts_with(writtenBy))
            remarks.version = versionIn(line);
        else if (line.starts_with(solvedBy))
            remarks.method = methodIn(line);
        else if (!line.starts_with(columnsAre))
            return remarks;
        remarks.length += std::min(line.size() + 1, rest.size());
    }
}

}  // namespace drillwave
