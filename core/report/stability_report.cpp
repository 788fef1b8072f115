// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/stability_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/report/study_column.h"
#include "core/text/csv.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"
#include "core/text/number_text.h"
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

std::string describe(const StabilityRow& row) {
    const Groups& g = row.stabilityCase.groups;
    return row.stabilityCase.name + " (" + std::string(name(row.stabilityCase.shape)) + ", beta " +
           formatNumber(g.beta) + ", gamma " + formatNumber(g.gamma) + ", tau " + formatNumber(g.tau) +
           ", delta " + formatNumber(g.delta) + ")";
}

std::string failuresOf(const StabilityRow& row) {
    if (row.outcome != Outcome::rebounded) return "not solved: " + row.reason;
    std::string text;
    for (const std::string& failure : row.failures) text += (text.empty() ? "" : "; ") + failure;
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
std::string shortText(double value) {
    return numberText(value, std::chars_format::scientific, 1);
}

std::string twoDigits(double value) {
    return rounded(value, 2);
}

/// Of a number that is whole.
std::string wholeText(double value) {
    return std::to_string(std::llround(value));
}

std::string rightAligned(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string leftAligned(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
}

/// One line for the cases of one kind: the name up to its first comma.
std::string kindsText(const StabilityReport& report) {
    struct Kind {
        int cases = 0, passed = 0;
        long pieces = 0;
        double balance = 0, change = 0;
    };
    std::vector<std::string> order;
    std::map<std::string, Kind> kinds;
    for (const StabilityRow& row : report.rows) {
        const std::string name = row.stabilityCase.name.substr(0, row.stabilityCase.name.find(','));
        if (!kinds.contains(name)) order.push_back(name);
        Kind& kind = kinds[name];
        ++kind.cases;
        kind.passed += row.passed();
        kind.pieces = std::max(kind.pieces, row.pieces);
        kind.balance = std::max({kind.balance, std::abs(row.momentumResidual), std::abs(row.energyResidual)});
        kind.change = std::max(kind.change, row.change);
    }
    const auto line = [](const std::array<std::string, 6>& cells) {
        return leftAligned(cells[0], 46) + " " + rightAligned(cells[1], 6) + " " + rightAligned(cells[2], 7) +
               " " + rightAligned(cells[3], 14) + " " + rightAligned(cells[4], 12) + " " +
               rightAligned(cells[5], 10) + "\n";
    };
    std::string text = line({"kind of case", "cases", "passed", "worst balance", "continuity", "pieces"});
    for (const std::string& name : order) {
        const Kind& kind = kinds[name];
        text += line({name, std::to_string(kind.cases), std::to_string(kind.passed), shortText(kind.balance),
                      shortText(kind.change), std::to_string(kind.pieces)});
    }
    return text;
}

std::string worstText(const StabilityReport& report) {
    using Value = std::optional<double>;
    std::string text = "\n" + leftAligned("column", 28) + " " + rightAligned("worst", 8) + " " +
                       rightAligned("mark", 8) + "  where\n";
    const auto worst = [&](const char* title, auto column, auto shown, Value mark = {}) {
        const StabilityRow* most = nullptr;
        for (const StabilityRow& row : report.rows)
            if (const Value value = column(row); value && (!most || *value > *column(*most))) most = &row;
        if (!most) return;
        text += "  " + leftAligned(title, 26) + " " + rightAligned(shown(*column(*most)), 8) + " " +
                rightAligned(mark ? formatNumber(*mark) : std::string(), 8) + "  " + describe(*most) + "\n";
    };
    constexpr StabilityMarks marks = stabilityMarks;
    const auto error = [](auto value) {
        return [value](const StabilityRow& row) { return Value(std::abs(value(row))); };
    };
    worst("momentum residual", error([](const auto& r) { return r.momentumResidual; }), shortText,
          marks.momentum);
    worst("energy residual", error([](const auto& r) { return r.energyResidual; }), shortText, marks.energy);
    worst(
        "pull of the rock",
        [](const StabilityRow& r) { return r.leastForce ? Value(-*r.leastForce) : Value(); }, shortText,
        marks.pull);
    worst(
        "return after the end", [](const StabilityRow& r) { return r.reach; }, shortText, marks.reach);
    worst(
        "change over 1e-10",  // of blows whose e has its digits; the others are let off by their stated error
        [](const StabilityRow& r) { return r.corError < 1e-12 ? Value(r.change) : Value(); }, shortText,
        marks.change);
    worst(
        "distance from limit", [](const StabilityRow& r) { return r.limitDistance; }, twoDigits, marks.limit);
    worst(
        "distance from lattice", [](const StabilityRow& r) { return r.latticeDistance; }, twoDigits,
        marks.lattice);
    worst(
        "distance from long double", [](const StabilityRow& r) { return r.boundDistance; }, twoDigits,
        marks.bound);
    worst("stated error", error([](const auto& r) { return r.corError; }), shortText);
    worst("wave pieces", error([](const auto& r) { return double(r.pieces); }), wholeText);
    worst("seconds", error([](const auto& r) { return r.seconds; }), twoDigits);
    return text;
}

}  // namespace

std::string stabilityText(const StabilityReport& report) {
    std::string text = kindsText(report) + worstText(report);
    for (const StabilityRow& row : report.rows)
        if (!row.passed()) text += "FAILED " + describe(row) + ": " + failuresOf(row) + "\n";
    const std::size_t bad = report.failed() + report.notSolved();
    return text + "\n" + std::to_string(report.rows.size()) +
           " cases: " + std::to_string(report.rows.size() - bad) + " passed, " +
           std::to_string(report.failed()) + " failed, " + std::to_string(report.notSolved()) +
           " not solved\n";
}

std::string stabilityJson(const StabilityReport& report) {
    JsonArray rows;
    for (const StabilityRow& row : report.rows) rows.emplace_back(jsonOf(row));
    const JsonObject object{{"cases", report.rows.size()},
                            {"not_solved", report.notSolved()},
                            {"failed", report.failed()},
                            {"rows", rows}};
    return Json(object).text();
}

std::string stabilityCsv(const StabilityReport& report) {
    std::string csv = "case,pulse.shape,beta,gamma,tau,delta";
    appendKeys(csv, stabilityColumns);
    csv += ",failures\n";
    for (const StabilityRow& row : report.rows) {
        const Groups& g = row.stabilityCase.groups;
        csv += csvCell(row.stabilityCase.name) + "," + std::string(name(row.stabilityCase.shape));
        for (const double group : {g.beta, g.gamma, g.tau, g.delta}) csv += "," + formatNumber(group);
        appendCells(csv, stabilityColumns, row, row.outcome == Outcome::rebounded);
        csv += "," + csvCell(failuresOf(row)) + "\n";
    }
    return csv;
}

}  // namespace drillwave
