// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave gap FILE
#include "app/command.h"
#include "app/input_text.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/progress_bar.h"
#include "app/scenario_argument.h"
#include "app/study_plots.h"
#include "core/archive/result_scenario.h"
#include "core/model/blow_traits.h"
#include "core/model/scales.h"
#include "core/report/blow_csv.h"
#include "core/report/gap_report.h"
#include "core/text/decimal_text.h"

namespace drillwave {

namespace {

/// The value of a gap option in d0. Dimensional scenarios take a length, the others a multiple of d0.
double gapOf(const Arguments& arguments, const char* option, const Scenario& scenario, double least,
             double most) {
    const std::string text = *arguments.value(option);
    const bool dimensional = hasUnits(scenario);
    const Quantity quantity = dimensional ? Quantity::length : Quantity::ratio;
    const TypedQuantity typed = parseQuantity(text, quantity, BareNumber::refused, findUnit(quantity, "mm"));
    const auto refuse = [&](const Message& reason) {
        throw CommandError(ExitCode::invalidScenario, refusedValue(std::string("--") + option, text, reason));
    };
    if (!typed.valid()) refuse(typed.problem);
    const double scale = dimensional ? scalesOf(scenario).penetration : 1;
    const auto shown = [&](double gap) {
        return dimensional ? formatNumber(gap * scale * 1000) + " mm" : formatNumber(gap);
    };
    const double gap = typed.si / scale;
    if (gap >= least && gap <= most) return gap;
    if (dimensional)
        refuse({translatable("must be from %1 to %2, d0 being %3"), {shown(least), shown(most), shown(1)}});
    refuse({translatable("must be from %1 to %2"), {shown(least), shown(most)}});
    return gap;
}

std::optional<NormalGap> normalOf(const Arguments& arguments, const Scenario& scenario) {
    constexpr double mostMean = 1e6;
    if (!arguments.has("gap-deviation")) {
        if (arguments.has("gap-mean"))
            throw CommandError(
                ExitCode::usage,
                translatable("--gap-mean needs --gap-deviation, how far gaps scatter about it"));
        return std::nullopt;
    }
    NormalGap normal;
    normal.deviation =
        gapOf(arguments, "gap-deviation", scenario, NormalGap::leastDeviation, NormalGap::mostDeviation);
    normal.mean = arguments.has("gap-mean") ? gapOf(arguments, "gap-mean", scenario, 0, mostMean)
                                            : groupsOf(scenario).delta;
    return normal;
}

GapReport study(const Scenario& scenario, const std::optional<NormalGap>& normal, const ReadingStyle& style,
                const Interruption& interruption) {
    ShareBar bar(style);
    GapReport report = studyGap(scenario, normal, interruption.token(), bar.progress());
    interruption.check();
    return report;
}

ExitCode runGap(const Arguments& arguments, const Drawing* drawing) {
    const std::string& path = arguments.operands().front();
    const std::optional<std::string> csvPath = arguments.value("o");
    const Overwrite overwrite = arguments.has("force") ? Overwrite::allowed : Overwrite::refused;
    checkAboutFiles(arguments, {"force", "si", "decimal-comma"}, "FILE.csv");
    arguments.checkOnePrinted();
    const StudyPlots plots = StudyPlots::besideFile(arguments);
    const OutputUnits units = arguments.has("si") ? OutputUnits::si : OutputUnits::dimensionless;
    const ScenarioDocument document = loadScenarioArgument(path, arguments);
    if (!gapHasPeriod(document.scenario))
        throw CommandError(
            ExitCode::invalidScenario,
            about(inputName(path),
                  translatable(
                      "is a drill string, and this command solves uniform rods alone (`drillwave: 1`); "
                      "`drillwave curve FILE --along bit_rock.gap=0mm:2mm` follows a string along its gap")));
    if (units == OutputUnits::si && !hasUnits(document.scenario))
        throw CommandError(
            ExitCode::usage,
            Message(translatable("--si: %1 is given by its dimensionless groups and has no SI units"),
                    {path}));
    const std::optional<NormalGap> normal = normalOf(arguments, document.scenario);
    if (csvPath) {
        checkOutputIsNoInput(*csvPath, arguments, document);
        checkOutput(*csvPath, overwrite);
        plots.check(arguments, document, overwrite);
    }

    if (csvPath != "-") checkStandardOutput();
    const Interruption interruption;
    remarkOnValues(document.scenario, path, arguments.style());
    GapReport report = study(document.scenario, normal, arguments.style(), interruption);
    report.scenarioText = completeScenarioText(document);
    if (!report.curve.isComplete())
        throw CommandError(
            ExitCode::unsolvedOrFailed,
            Message(translatable("%1: could not be solved at all gaps: %2"), {path, report.curve.reason}));
    if (csvPath)
        writeStudy(*csvPath, scenarioHeader(report.scenarioText) + gapCsv(report, units),
                   plots.draw(&report, drawing, interruption), overwrite, interruption);
    if (csvPath == "-") return ExitCode::done;
    printText(arguments.has("json") ? gapJson(report) : gapText(report, arguments.style()));
    return ExitCode::done;
}

}  // namespace

const Command& gapCommand() {
    static const Command command{
        .name = "gap",
        .operands = "FILE",
        .summary = "restitution, forces and efficiency over all gaps between bit and rock",
        .details =
            "Results have a period in the gap, d0 = 2 I0/Z, which nobody controls at the rig: extremes and\n"
            "where they lie, mean, 5, 50 and 95 % quantiles, and the share of gaps with e > 1, for all gaps "
            "of\n"
            "a period alike and, with --gap-deviation, for a gap scattered normally (cut off at no gap).",
        .options = scenarioOptions(
            {{"gap-mean", "GAP",
              "mean of the scattered gap, as 0.5mm or, in d0, 0.2; that of FILE if not given"},
             {"gap-deviation", "GAP", "standard deviation of the scattered gap"},
             {"json", "", "print one JSON object in place of the table"},
             {"o", "FILE.csv", "also write the results along the gap; - prints them instead of the table"},
             {"si", "", "with -o, columns in SI, with units in the header"},
             plotsOptionSpec(),
             {"force", "", "overwrite an existing file"},
             decimalCommaSpec()}),
        .leastOperands = 1,
        .mostOperands = 1,
        .draws = asksForPlots,
        .run = runGap,
    };
    return command;
}

}  // namespace drillwave
