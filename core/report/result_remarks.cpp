// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/result_remarks.h"

#include <algorithm>

#include "core/model/version.h"
#include "core/text/decimal_text.h"
#include "core/text/text_input.h"
#include "core/yaml/scenario_file.h"

namespace drillwave {
namespace {

std::string versionIn(std::string_view line) {
    std::string_view version = line.substr(writtenRemark.size());
    version = version.substr(0, std::min(version.find_first_of("; \r"), version.size()));
    while (version.ends_with('.')) version.remove_suffix(1);
    return std::string(version);
}

/// Reads "lattice, 500 segments." as describe() says it.
void readMethod(std::string_view line, ResultRemarks& remarks) {
    constexpr std::string_view unit = " segments";
    std::string_view words = line.substr(solvedRemark.size());
    while (words.ends_with('\r') || words.ends_with('.')) words.remove_suffix(1);
    const std::size_t comma = std::min(words.find(", "), words.size());
    const std::string_view method = words.substr(0, comma);
    if (method == methodOfStrings) return;  // there is no choice
    remarks.problem = methodProblem(method);
    if (!remarks.problem.isEmpty()) {
        remarks.problem = {translatable("was solved by method %1 (%2)"),
                           {shortened(method), remarks.problem}};
        return;
    }
    MethodChoice choice;
    choice.method = *findMethod(method);
    if (choice.method == Method::lattice) {
        words.remove_prefix(std::min(comma + 2, words.size()));
        const std::size_t length = words.ends_with(unit) ? words.size() - unit.size() : 0;
        const std::optional<int> segments = segmentsIn(words.substr(0, length));
        if (!segments)
            remarks.problem = {translatable("was solved by a lattice of `%1` (%2)"),
                               {shortened(words), segmentsProblem()}};
        choice.lattice.segments = segments.value_or(choice.lattice.segments);
    }
    remarks.method = choice;
}

}  // namespace

std::string remarksText(std::string_view about, std::string_view method, std::string_view columns) {
    std::string text = std::string(writtenRemark) + versionText + std::string(about) + "\n";
    if (!method.empty()) text += "# Solved by " + std::string(method) + ".\n";
    if (!columns.empty()) text += std::string(columnsRemark) + std::string(columns) + "\n";
    return text;
}

ResultRemarks remarksOf(std::string_view yaml) {
    ResultRemarks remarks;
    remarks.length = remarksLength(yaml);
    std::string_view rest = yaml.substr(0, remarks.length);
    rest.remove_prefix(byteOrderMarkLength(rest));
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
        if (line.starts_with(writtenRemark))
            remarks.version = versionIn(line);
        else if (line.starts_with(solvedRemark))
            readMethod(line, remarks);
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
    return remarks;
}

}  // namespace drillwave
