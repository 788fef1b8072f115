// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_report.h"

#include "core/model/scales.h"
#include "core/model/version.h"
#include "core/report/feed_words.h"
#include "core/report/json_value.h"
#include "core/report/report_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

constexpr ThrustCase allCases[] = {ThrustCase::scenario, ThrustCase::gapQuantile, ThrustCase::rigidRock,
                                   ThrustCase::elasticWorst};

const char* label(ThrustCase which) {
    switch (which) {
        case ThrustCase::scenario:
            return "this blow";
        case ThrustCase::gapQuantile:
            return "95 % of all gaps";
        case ThrustCase::rigidRock:
            return "rigid rock";
        case ThrustCase::elasticWorst:
            return "elastic rock, worst gap";
    }
    return "";
}

std::string force(double newton) {
    return inHandyUnit(newton, Quantity::force, 4);
}

std::string bracket(const ThrustNeed& need) {
    return force(need.thrust) + " ... " + force(need.thrustUndamped);
}

std::string signedPercent(double share) {
    return (share < 0 ? "" : "+") + rounded(share * 100, 3) + " %";
}

std::string hertz(double frequency) {
    return rounded(frequency, 4) + " Hz";
}

std::string needsTable(const ThrustReport& report) {
    const bool judged = report.scenario.drill.thrust.has_value();
    TextGrid grid;
    std::vector<std::string> titles{"thrust needed for", "e", "f I0 (1+e) ... (1+2e)"};
    if (judged) titles.insert(titles.end(), {"margin", "full rate up to", "feed"});
    grid.add(titles);
    for (const ThrustCase which : allCases) {
        const ThrustNeed& need = report.study.need(which);
        std::vector<std::string> cells{label(which), rounded(need.cor.value), bracket(need)};
        if (judged)
            cells.insert(cells.end(), {signedPercent(*need.margin), hertz(*need.frequencyLimit),
                                       std::string(feedWord(need.feed))});
        grid.add(cells);
    }
    return grid.text();
}

std::string frequencyTable(const ThrustReport& report) {
    TextGrid grid;
    std::vector<std::string> titles{"blow frequency"};
    for (const ThrustCase which : allCases) titles.emplace_back(label(which));
    grid.add(titles);
    for (std::uint64_t i = 0; i < report.frequencies->count; ++i) {
        const double frequency = report.frequencies->value(i);
        std::vector<std::string> cells{hertz(frequency)};
        for (const ThrustCase which : allCases) cells.push_back(force(report.thrustAt(frequency, which)));
        grid.add(cells);
    }
    return grid.text();
}

/// Broken into lines of at most 100 characters, two blanks before each.
std::string paragraph(std::string_view words) {
    constexpr std::size_t width = 98;
    std::string text;
    while (!words.empty()) {
        std::size_t end = words.size();
        if (end > width) end = words.rfind(' ', width);
        text += "  " + std::string(words.substr(0, end)) + "\n";
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return text;
}

std::string verdict(const ThrustReport& report) {
    std::string text = paragraph(feedSentence(report.study.verdict));
    if (const std::optional<double> share = report.study.shareFull)
        text += paragraph("It is at least f I0 (1+e) at " + rounded(*share * 100, 4) +
                          " % of all gaps in this rock. Margin over the largest of the four needs: " +
                          signedPercent(*report.study.margin()) + ".");
    return text;
}

JsonObject needJson(const ThrustNeed& need) {
    return {{"cor", need.cor.value},  {"cor_error", need.cor.error},
            {"thrust", need.thrust},  {"thrust_undamped", need.thrustUndamped},
            {"margin", need.margin},  {"frequency_limit", need.frequencyLimit},
            {"feed", name(need.feed)}};
}

JsonArray frequenciesJson(const ThrustReport& report) {
    JsonArray array;
    for (std::uint64_t i = 0; i < report.frequencies->count; ++i) {
        const double frequency = report.frequencies->value(i);
        JsonObject row{{"blow_frequency", frequency}};
        for (const ThrustCase which : allCases) row[name(which)] = report.thrustAt(frequency, which);
        array.emplace_back(row);
    }
    return array;
}

}  // namespace

double ThrustReport::thrustAt(double frequency, ThrustCase which) const {
    return study.need(which).thrust * (frequency / *scenario.drill.blowFrequency);
}

std::string thrustText(const ThrustReport& report) {
    const Drill& drill = report.scenario.drill;
    std::string text = headingOf(report.scenario) + "  " + hertz(*drill.blowFrequency) + " of " +
                       inHandyUnit(pulseImpulse(report.scenario), Quantity::impulse, 4);
    if (drill.thrust) text += ", installed thrust " + force(*drill.thrust);
    text += "\n\n" + needsTable(report);
    if (report.frequencies) text += "\n" + frequencyTable(report);
    return text + "\n" + verdict(report);
}

std::string thrustJson(const ThrustReport& report) {
    const Drill& drill = report.scenario.drill;
    JsonObject needs;
    for (const ThrustCase which : allCases) needs[name(which)] = needJson(report.study.need(which));
    JsonObject object{
        {"version", versionText},
        {"title", report.scenario.title},
        {"scenario", report.scenarioText},
        {"units", JsonObject{{"thrust", unitJson(Quantity::force)},
                             {"installed_thrust", unitJson(Quantity::force)},
                             {"impulse", unitJson(Quantity::impulse)},
                             {"frequency_limit", unitJson(Quantity::frequency)},
                             {"blow_frequency", unitJson(Quantity::frequency)}}},
        {"groups", groupsJson(groupsOf(report.scenario))},
        {"blow_frequency", *drill.blowFrequency},
        {"impulse", pulseImpulse(report.scenario)},
        {"installed_thrust", drill.thrust},
        {"thrust_balance", report.study.verdict.balance},
        {"needs", needs},
        {"share_of_gaps_held", report.study.shareFull},
        {"thrust_margin", report.study.margin()},
        {"feed", name(report.study.verdict.feed)},
        {"advice", feedAdvice(report.study.verdict.feed)},
        {"verdict", feedSentence(report.study.verdict)},
    };
    if (report.frequencies) object["frequencies"] = frequenciesJson(report);
    return Json(object).text();
}

std::string thrustCsv(const ThrustReport& report) {
    const RowColumn column = report.frequencies->column();
    std::string csv = column.header;
    for (const ThrustCase which : allCases) csv += "," + std::string(name(which)) + " [N]";
    csv += "\n";
    for (std::uint64_t i = 0; i < report.frequencies->count; ++i) {
        const double frequency = report.frequencies->value(i);
        column.appendText(csv, frequency);
        for (const ThrustCase which : allCases) {
            csv += ',';
            appendNumber(csv, report.thrustAt(frequency, which));
        }
        csv += '\n';
    }
    return csv;
}

}  // namespace drillwave
