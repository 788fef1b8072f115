// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/stability_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/model/version.h"
#include "core/report/study_column.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"
#include "core/text/text_layout.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();  // where a check does not apply

/// Columns of the CSV and keys of the JSON.
constexpr auto stabilityColumns = std::to_array<StudyColumn<StabilityRow>>({
    {"cor", "", NumberStyle::error, [](const StabilityRow& r) { return r.cor; }},
    {"cor_error", "", NumberStyle::error, [](const StabilityRow& r) { return r.corError; }},
    {"pieces", "", NumberStyle::error, [](const StabilityRow& r) { return double(r.pieces); }},
    {"seconds", "", NumberStyle::error, [](const StabilityRow& r) { return r.seconds; }},
    {"momentum_residual", "", NumberStyle::error, [](const StabilityRow& r) { return r.momentumResidual; }},
    {"energy_residual", "", NumberStyle::error, [](const StabilityRow& r) { return r.energyResidual; }},
    {"least_force", "", NumberStyle::error,
     [](const StabilityRow& r) { return r.leastForce.value_or(none); }},
    {"reach_after_end", "", NumberStyle::error, [](const StabilityRow& r) { return r.reach.value_or(none); }},
    {"change_over_1e-10", "", NumberStyle::error, [](const StabilityRow& r) { return r.change; }},
    {"limit_distance", "", NumberStyle::error,
     [](const StabilityRow& r) { return r.limitDistance.value_or(none); }},
    {"lattice_distance", "", NumberStyle::error,
     [](const StabilityRow& r) { return r.latticeDistance.value_or(none); }},
    {"bound_distance", "", NumberStyle::error,
     [](const StabilityRow& r) { return r.boundDistance.value_or(none); }},
});

std::string describe(const StabilityRow& row, const ReadingStyle& style) {
    const Groups& g = row.stabilityCase.groups;
    const auto whole = [&](double value) { return style.withDecimalSign(formatNumber(value)); };
    return row.stabilityCase.name + " (" + std::string(name(row.stabilityCase.shape)) + ", beta " +
           whole(g.beta) + ", gamma " + whole(g.gamma) + ", tau " + whole(g.tau) + ", delta " +
           whole(g.delta) + ")";
}

std::string failuresOf(const StabilityRow& row, const ReadingStyle& style = plainStyle()) {
    if (row.outcome != Outcome::rebounded) return style.said({translatable("not solved: %1"), {row.reason}});
    std::string text;
    for (const Message& failure : row.failures) text += (text.empty() ? "" : "; ") + style.said(failure);
    return text;
}

JsonObject jsonOf(const StabilityRow& row) {
    const Groups& g = row.stabilityCase.groups;
    JsonObject object{{"case", row.stabilityCase.name},
                      {"shape", name(row.stabilityCase.shape)},
                      {"beta", g.beta},
                      {"gamma", g.gamma},
                      {"tau", g.tau},
                      {"delta", g.delta},
                      {"solved", row.outcome == Outcome::rebounded},
                      {"passed", row.passed()},
                      {"failures", failuresOf(row)}};
    addMembers(object, stabilityColumns, row, row.outcome == Outcome::rebounded);
    return object;
}

/// "1.2e-13".
std::string shortText(double value, const ReadingStyle& style) {
    return style.withDecimalSign(numberText(value, std::chars_format::scientific, 1));
}

std::string twoDigits(double value, const ReadingStyle& style) {
    return style.number(value, 2);
}

/// Returns a column of integers.
std::string wholeText(double value, const ReadingStyle&) {
    return std::to_string(std::llround(value));
}

/// Result of the cases of one kind.
struct KindOfCase {
    std::string name;  ///< that of the cases up to its first comma
    int cases = 0, passed = 0;
    long pieces = 0;
    double balance = 0, change = 0;
};

std::vector<KindOfCase> kindsOf(const StabilityReport& report) {
    std::vector<KindOfCase> kinds;
    for (const StabilityRow& row : report.rows) {
        const std::string name = row.stabilityCase.name.substr(0, row.stabilityCase.name.find(','));
        auto kind = std::ranges::find(kinds, name, &KindOfCase::name);
        if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {.name = name});
        ++kind->cases;
        kind->passed += row.passed();
        kind->pieces = std::max(kind->pieces, row.pieces);
        kind->balance =
            std::max({kind->balance, std::abs(row.momentumResidual), std::abs(row.energyResidual)});
        kind->change = std::max(kind->change, row.change);
    }
    return kinds;
}

/// One line for the cases of one kind.
std::string kindsText(const StabilityReport& report, const ReadingStyle& style) {
    struct Column {
        std::string title;
        std::size_t width;
    };
    const auto column = [&](const char* title, std::size_t least) {
        const std::string words = style.said(title);
        return Column{words, std::max(least, columnsOf(words))};
    };
    const std::array<Column, 6> columns{
        column(translatable("kind of case"), 46), column(translatable("cases"), 6),
        column(translatable("passed"), 7),        column(translatable("worst balance"), 14),
        column(translatable("continuity"), 12),   column(translatable("pieces"), 10)};
    const auto line = [&](const std::array<std::string, 6>& cells) {
        std::string text = leftAligned(cells[0], columns[0].width);
        for (std::size_t i = 1; i < cells.size(); ++i) text += " " + rightAligned(cells[i], columns[i].width);
        return text + "\n";
    };
    std::string text = line({columns[0].title, columns[1].title, columns[2].title, columns[3].title,
                             columns[4].title, columns[5].title});
    for (const KindOfCase& kind : kindsOf(report))
        text += line({kind.name, std::to_string(kind.cases), std::to_string(kind.passed),
                      shortText(kind.balance, style), shortText(kind.change, style),
                      std::to_string(kind.pieces)});
    return text;
}

/// A measure, of which the worst value is printed.
struct Measured {
    const char* title;
    std::optional<double> (*value)(const StabilityRow&);
    std::string (*shown)(double, const ReadingStyle&);
    std::optional<double> mark = {};
};

constexpr auto stabilityMeasures = std::to_array<Measured>({
    {translatable("momentum residual"),
     [](const StabilityRow& r) { return std::optional<double>(std::abs(r.momentumResidual)); }, shortText,
     stabilityMarks.momentum},
    {translatable("energy residual"),
     [](const StabilityRow& r) { return std::optional<double>(std::abs(r.energyResidual)); }, shortText,
     stabilityMarks.energy},
    {translatable("tension on the rock"),
     [](const StabilityRow& r) {
         return r.leastForce ? std::optional<double>(-*r.leastForce) : std::optional<double>();
     },
     shortText, stabilityMarks.pull},
    {translatable("return after the computed end"), [](const StabilityRow& r) { return r.reach; }, shortText,
     stabilityMarks.reach},
    // of blows whose e has its digits; the others are let off by their stated error
    {translatable("change over 1e-10"),
     [](const StabilityRow& r) {
         return r.corError < 1e-12 ? std::optional<double>(r.change) : std::optional<double>();
     },
     shortText, stabilityMarks.change},
    {translatable("distance from limit"), [](const StabilityRow& r) { return r.limitDistance; }, twoDigits,
     stabilityMarks.limit},
    {translatable("distance from lattice"), [](const StabilityRow& r) { return r.latticeDistance; },
     twoDigits, stabilityMarks.lattice},
    {translatable("distance from long double"), [](const StabilityRow& r) { return r.boundDistance; },
     twoDigits, stabilityMarks.bound},
    {translatable("stated error"),
     [](const StabilityRow& r) { return std::optional<double>(std::abs(r.corError)); }, shortText},
    {translatable("wave pieces"),
     [](const StabilityRow& r) { return std::optional<double>(double(r.pieces)); }, wholeText},
    {translatable("seconds"), [](const StabilityRow& r) { return std::optional<double>(r.seconds); },
     twoDigits},
});

const StabilityRow* worstBy(const Measured& measure, const StabilityReport& report) {
    const StabilityRow* most = nullptr;
    for (const StabilityRow& row : report.rows)
        if (const std::optional<double> value = measure.value(row);
            value && (!most || *value > *measure.value(*most)))
            most = &row;
    return most;
}

std::string worstText(const StabilityReport& report, const ReadingStyle& style) {
    std::size_t width = 26;
    for (const Measured& measure : stabilityMeasures)
        width = std::max(width, columnsOf(style.said(measure.title)));
    const auto line = [&](const std::string& title, const std::string& worst, const std::string& mark,
                          const std::string& where) {
        return leftAligned(title, width + 2) + " " + rightAligned(worst, 8) + " " + rightAligned(mark, 8) +
               "  " + where + "\n";
    };
    std::string text = "\n" + line(style.said(translatable("column")), style.said(translatable("worst")),
                                   style.said(translatable("mark")), style.said(translatable("place")));
    for (const Measured& measure : stabilityMeasures)
        if (const StabilityRow* most = worstBy(measure, report))
            text += line("  " + style.said(measure.title), measure.shown(*measure.value(*most), style),
                         measure.mark ? style.withDecimalSign(formatNumber(*measure.mark)) : std::string(),
                         describe(*most, style));
    return text;
}

}  // namespace

std::string stabilityText(const StabilityReport& report, const ReadingStyle& style) {
    std::string text = kindsText(report, style) + worstText(report, style);
    for (const StabilityRow& row : report.rows)
        if (!row.passed())
            text +=
                style.said({translatable("FAILED %1: %2"), {describe(row, style), failuresOf(row, style)}}) +
                "\n";
    const std::size_t bad = report.failed() + report.notSolved();
    return text + "\n" +
           style.said({translatable("%1 cases: %2 passed, %3 failed, %4 not solved"),
                       {std::to_string(report.rows.size()), std::to_string(report.rows.size() - bad),
                        std::to_string(report.failed()), std::to_string(report.notSolved())}}) +
           "\n";
}

std::string stabilityJson(const StabilityReport& report, double runTime) {
    JsonArray rows;
    for (const StabilityRow& row : report.rows) rows.emplace_back(jsonOf(row));
    const JsonObject object{{"version", versionText},
                            {"outputs", outputsVersion},
                            {"run_time", runTime},
                            {"cases", report.rows.size()},
                            {"not_solved", report.notSolved()},
                            {"failed", report.failed()},
                            {"rows", rows}};
    return Json(object).text();
}

std::string stabilityCsv(const StabilityReport& report) {
    std::vector<std::string> headers{"case", "pulse.shape", "beta", "gamma", "tau", "delta"};
    appendKeys(headers, stabilityColumns);
    headers.emplace_back("failures");
    return csvText(
        {headers, report.rows.size(), [&](std::size_t i) {
             const StabilityRow& row = report.rows[i];
             const Groups& g = row.stabilityCase.groups;
             Cells cells{
                 row.stabilityCase.name, name(row.stabilityCase.shape), g.beta, g.gamma, g.tau, g.delta};
             appendCells(cells, stabilityColumns, row, row.outcome == Outcome::rebounded);
             cells.push_back(failuresOf(row));
             return cells;
         }});
}

}  // namespace drillwave
