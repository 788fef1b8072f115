// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive/identified_document.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/archive/result_scenario.h"
#include "core/model/parameter.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {

namespace {

/// Returns a comment about an identified parameter, such as "identified from string.csv: 127.1 to 135.4 MN/m
/// (95 %)".
std::string identifiedComment(const IdentifyReport& report, const IdentifiedParameter& parameter) {
    const KeptParameter known = findParameter(parameter.key);
    const Unit& unit = known->displayUnit();
    const auto shown = [&](double value) {
        return rounded(unit.fromSi(value), known->quantity == Quantity::stiffness ? 4 : 3);
    };
    const std::string unitName = unit.name.empty() ? "" : " " + std::string(unit.name);
    std::string from = report.findings.main().file;
    from.erase(0, from.find_last_of('/') + 1);  // npos + 1 is 0
    if (const std::size_t count = report.findings.agreeingCount(); count > 1)
        from = std::to_string(count) + " records";
    std::optional<double> low = parameter.low, high = parameter.high;
    for (const NextBlowParameter& next : report.findings.nextBlow)
        if (next.key == parameter.key) low = next.low, high = next.high;
    const std::string comment = "identified from " + from + ": ";
    if (low && high) return comment + shown(*low) + " to " + shown(*high) + unitName + " (95 %)";
    if (low) return comment + "at least " + shown(*low) + unitName;
    if (high) return comment + "at most " + shown(*high) + unitName;
    return comment + "not seen";
}

}  // namespace

ScenarioDocument identifiedDocument(const IdentifyReport& report, ScenarioDocument document) {
    document.scenario = identifiedScenario(document.scenario, report.findings);
    std::string rock;
    const std::string section = sectionText(document.scenario, "bit_rock");
    for (std::size_t from = 0; from < section.size();) {
        const std::size_t end = std::min(section.find('\n', from), section.size());
        std::string line = section.substr(from, end - from);
        const RecordAnswer& answer = report.findings.main();
        for (const char* field : {"stiffness", "gamma", "gap"}) {
            const IdentifiedParameter* parameter = answer.find(std::string("bit_rock.") + field);
            if (parameter && line.starts_with("  " + std::string(field) + ":"))
                line += "  # " + identifiedComment(report, *parameter);
        }
        rock += line + "\n";
        from = end + 1;
    }
    // The block of the file goes from its key to the next line that begins one.
    const std::string& text = document.text;
    std::size_t begin = text.starts_with("bit_rock:") ? 0 : text.find("\nbit_rock:");
    if (begin != std::string::npos) {
        if (begin != 0) ++begin;
        std::size_t end = text.find('\n', begin);
        while (end != std::string::npos && end + 1 < text.size() &&
               (text[end + 1] == ' ' || text[end + 1] == '}' || text[end + 1] == '\t'))
            end = text.find('\n', end + 1);
        const std::string patched =
            text.substr(0, begin) + rock + (end == std::string::npos ? "" : text.substr(end + 1));
        try {
            if (withoutUnusedValues(parseScenario(patched, document.source).scenario) ==
                withoutUnusedValues(document.scenario)) {
                document.text = patched;
                return document;
            }
        } catch (const ScenarioError&) {
            // an unusual layout: the file is written as usual, without the comments
        }
    }
    document.text = completeScenarioText(document);
    return document;
}

}  // namespace drillwave
