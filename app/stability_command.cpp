// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave stability
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/command.h"
#include "app/interruption.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "core/study/proof/stability.h"
#include "core/text/csv.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr char csvName[] = "stability.csv";

/// A column of the CSV and a key of the JSON; no number where the check does not apply.
struct Measure {
    const char* name;
    std::optional<double> (*value)(const StabilityRow&);
};

constexpr Measure measures[] = {
    {"cor", [](const StabilityRow& r) { return std::optional(r.cor); }},
    {"cor_error", [](const StabilityRow& r) { return std::optional(r.corError); }},
    {"pieces", [](const StabilityRow& r) { return std::optional(static_cast<double>(r.pieces)); }},
    {"seconds", [](const StabilityRow& r) { return std::optional(r.seconds); }},
    {"momentum_residual", [](const StabilityRow& r) { return std::optional(r.momentumResidual); }},
    {"energy_residual", [](const StabilityRow& r) { return std::optional(r.energyResidual); }},
    {"least_force", [](const StabilityRow& r) { return r.leastForce; }},
    {"reach_after_end", [](const StabilityRow& r) { return r.reach; }},
    {"change_over_1e-10", [](const StabilityRow& r) { return std::optional(r.change); }},
    {"limit_distance", [](const StabilityRow& r) { return r.limitDistance; }},
    {"lattice_distance", [](const StabilityRow& r) { return r.latticeDistance; }},
    {"bound_distance", [](const StabilityRow& r) { return r.boundDistance; }},
};

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

std::string csvOf(const StabilityReport& report) {
    std::string csv = "case,pulse.shape,beta,gamma,tau,delta";
    for (const Measure& measure : measures) csv += std::string(",") + measure.name;
    csv += ",failures\n";
    for (const StabilityRow& row : report.rows) {
        const Groups& g = row.stabilityCase.groups;
        csv += csvCell(row.stabilityCase.name) + "," + std::string(name(row.stabilityCase.shape));
        for (const double group : {g.beta, g.gamma, g.tau, g.delta}) csv += "," + formatNumber(group);
        for (const Measure& measure : measures) {
            const std::optional<double> value = measure.value(row);
            csv += value && row.outcome == Outcome::rebounded ? "," + formatNumber(*value) : ",";
        }
        csv += "," + csvCell(failuresOf(row)) + "\n";
    }
    return csv;
}

QJsonObject jsonOf(const StabilityRow& row) {
    const Groups& g = row.stabilityCase.groups;
    QJsonObject object{{"case", QString::fromStdString(row.stabilityCase.name)},
                       {"shape", QString::fromStdString(std::string(name(row.stabilityCase.shape)))},
                       {"beta", g.beta},
                       {"gamma", g.gamma},
                       {"tau", g.tau},
                       {"delta", g.delta},
                       {"solved", row.outcome == Outcome::rebounded},
                       {"passed", row.passed()},
                       {"failures", QString::fromStdString(failuresOf(row))}};
    for (const Measure& measure : measures) {
        const std::optional<double> value = measure.value(row);
        const bool given = value && row.outcome == Outcome::rebounded && std::isfinite(*value);
        object[measure.name] = given ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
    }
    return object;
}

void printJson(const StabilityReport& report) {
    QJsonArray rows;
    for (const StabilityRow& row : report.rows) rows.append(jsonOf(row));
    const QJsonObject object{{"cases", static_cast<qint64>(report.rows.size())},
                             {"not_solved", static_cast<qint64>(report.notSolved())},
                             {"failed", static_cast<qint64>(report.failed())},
                             {"rows", rows}};
    std::fputs(QJsonDocument(object).toJson().constData(), stdout);
}

/// One line for the cases of one kind: the name up to its first comma.
void printKinds(const StabilityReport& report) {
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
    std::printf("%-46s %6s %7s %14s %12s %10s\n", "kind of case", "cases", "passed", "worst balance",
                "continuity", "pieces");
    for (const std::string& name : order) {
        const Kind& kind = kinds[name];
        std::printf("%-46s %6d %7d %14.1e %12.1e %10ld\n", name.c_str(), kind.cases, kind.passed,
                    kind.balance, kind.change, kind.pieces);
    }
}

void printWorst(const StabilityReport& report) {
    using Value = std::optional<double>;
    const auto worst = [&](const char* title, auto measure, const char* format, Value mark = {}) {
        const StabilityRow* most = nullptr;
        for (const StabilityRow& row : report.rows)
            if (const Value value = measure(row); value && (!most || *value > *measure(*most))) most = &row;
        if (!most) return;
        std::printf("  %-26s ", title);
        std::printf(format, *measure(*most));
        std::printf(" %8s  %s\n", mark ? formatNumber(*mark).c_str() : "", describe(*most).c_str());
    };
    constexpr StabilityMarks marks = stabilityMarks;
    const auto error = [](auto value) {
        return [value](const StabilityRow& row) { return Value(std::abs(value(row))); };
    };
    std::printf("\n%-28s %8s %8s  %s\n", "measure", "worst", "mark", "where");
    worst("momentum residual", error([](const auto& r) { return r.momentumResidual; }), "%8.1e",
          marks.momentum);
    worst("energy residual", error([](const auto& r) { return r.energyResidual; }), "%8.1e", marks.energy);
    worst(
        "pull of the rock",
        [](const StabilityRow& r) { return r.leastForce ? Value(-*r.leastForce) : Value(); }, "%8.1e",
        marks.pull);
    worst(
        "return after the end", [](const StabilityRow& r) { return r.reach; }, "%8.1e", marks.reach);
    worst(
        "change over 1e-10",  // of blows whose e has its digits; the others are let off by their stated error
        [](const StabilityRow& r) { return r.corError < 1e-12 ? Value(r.change) : Value(); }, "%8.1e",
        marks.change);
    worst(
        "distance from limit", [](const StabilityRow& r) { return r.limitDistance; }, "%8.2g", marks.limit);
    worst(
        "distance from lattice", [](const StabilityRow& r) { return r.latticeDistance; }, "%8.2g",
        marks.lattice);
    worst(
        "distance from long double", [](const StabilityRow& r) { return r.boundDistance; }, "%8.2g",
        marks.bound);
    worst("stated error", error([](const auto& r) { return r.corError; }), "%8.1e");
    worst("wave pieces", error([](const auto& r) { return double(r.pieces); }), "%8.0f");
    worst("seconds", error([](const auto& r) { return r.seconds; }), "%8.2g");
}

void printText(const StabilityReport& report) {
    printKinds(report);
    printWorst(report);
    for (const StabilityRow& row : report.rows)
        if (!row.passed()) std::printf("FAILED %s: %s\n", describe(row).c_str(), failuresOf(row).c_str());
    std::printf("\n%zu cases: %zu passed, %zu failed, %zu not solved\n", report.rows.size(),
                report.rows.size() - report.failed() - report.notSolved(), report.failed(),
                report.notSolved());
}

ExitCode runStability(const Arguments& arguments) {
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    const std::optional<std::string> directory = arguments.value("o");
    if (directory) checkFolder(*directory, {csvName}, overwrite);
    const Interruption interruption;
    const std::vector<StabilityCase> cases = stabilityCases();
    ProgressBar bar(cases.size(), "cases");
    const int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const StabilityReport report =
        checkStability(cases, jobs, interruption.token(), [&bar](std::uint64_t done) { bar.show(done); });
    interruption.check();
    if (directory)
        writeFolder(*directory, {{{csvName, QByteArray::fromStdString(csvOf(report))}}, {}}, overwrite,
                    interruption);
    if (arguments.has("json"))
        printJson(report);
    else
        printText(report);
    return report.failed() + report.notSolved() > 0 ? ExitCode::unsolvedOrFailed : ExitCode::done;
}

}  // namespace

const Command& stabilityCommand() {
    static const Command command{
        .name = "stability",
        .operands = "",
        .summary = "check the solver on stiff and extreme cases",
        .details =
            "Solves some thousand cases: the published ones, the known traps of such solvers, each "
            "parameter\n"
            "through its whole range, and products of extremes for every shape. Each is checked for the "
            "balance\n"
            "of momentum and of energy, for pulling rock, for contacts missed after the end, for continuity\n"
            "(e over changes of 1e-10 in each parameter), against its limits on soft and rigid rock and, "
            "where\n"
            "its steps resolve the contact, against the lattice solver; its stated error against a solution "
            "in\n"
            "long double. Exit code 6 if any check fails.\n"
            "Not covered, as it needs more than 30 million wave pieces: beta below 1e-6 with gamma below 1, "
            "and\n"
            "tau below 0.1 with exponential and piston blows.",
        .options = {{"json", "", "print one JSON object with all cases"},
                    {"o", "DIR", "write stability.csv into this folder"},
                    {"force", "", "overwrite an existing file"}},
        .leastOperands = 0,
        .mostOperands = 0,
        .draws = [](const Arguments&) { return false; },
        .run = runStability,
    };
    return command;
}

}  // namespace drillwave
