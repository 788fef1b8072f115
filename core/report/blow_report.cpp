// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_report.h"

#include "core/blow/thrust.h"

namespace drillwave {

namespace {

constexpr std::string_view frequencyKey = "drill.blow_frequency";

/// A study solves blows by the thousand, in proportion to their pieces: up to here in seconds, that of all
/// outputs and that of e alone. Counted, not timed, so that the report does not depend on the machine.
constexpr long mostPiecesOverGaps = 2'000;
constexpr long mostPiecesForThrust = 10'000;

/// Why a study is left out; empty where it is not.
std::string tooLarge(const Blow& blow, long mostPieces, std::string_view command) {
    if (blow.impact.pieces <= mostPieces) return {};
    return "This blow has " + std::to_string(blow.impact.pieces) +
           " pieces, too many to be followed over all gaps in a report: `drillwave " + std::string(command) +
           "` does that, and takes its time.";
}

/// From half the blow frequency to half as much again, as far as it may go.
std::optional<SweepAxis> frequencyAxis(const Scenario& scenario) {
    constexpr std::uint64_t points = 41;  // of curves that are straight
    const Parameter& parameter = *findParameter(frequencyKey);
    const double frequency = *scenario.drill.blowFrequency;
    const auto value = [&](double si) {
        return formatQuantity(si, parameter.quantity, parameter.displayUnit());
    };
    ParsedAxis parsed = parseAxis(
        std::string(frequencyKey) + "=" + value(frequency / 2) + ":" + value(frequency * 1.5), points);
    if (!parsed.problem.empty()) return std::nullopt;
    return std::move(parsed.axis);
}

void addThrust(BlowReport& report, const std::stop_token& stop) {
    const Scenario& scenario = report.blow.scenario;
    report.thrustProblem = thrustProblem(scenario);
    if (report.thrustProblem.empty())
        report.thrustProblem = tooLarge(report.blow, mostPiecesForThrust, "thrust");
    if (!report.thrustProblem.empty()) return;
    ThrustReport thrust;
    thrust.scenario = scenario;
    thrust.study = studyThrust(scenario, stop);
    report.thrustProblem = thrust.study.reason;
    if (!report.thrustProblem.empty() || thrust.study.stopped) return;
    report.blow.thrustMargin = thrust.study.margin();
    if (const std::optional<SweepAxis> axis = frequencyAxis(scenario))
        thrust.along = ThrustAlong{*axis, thrustAlong(scenario, *axis->parameter, valuesOf(*axis), 1, stop)};
    report.thrust = std::move(thrust);
}

void addGap(BlowReport& report, const std::stop_token& stop, const GapProgress& progress) {
    report.gapProblem = tooLarge(report.blow, mostPiecesOverGaps, "gap");
    if (!report.gapProblem.empty()) return;
    GapReport gap = studyGap(report.blow.scenario, std::nullopt, stop, progress);
    if (!gap.curve.dependsOnGap)
        report.gapProblem = gap.periodRemark();
    else if (!gap.curve.isComplete())
        report.gapProblem = "The blow could not be solved at all gaps: " + gap.curve.reason;
    else
        report.gap = std::move(gap);
}

}  // namespace

BlowReport studyReport(const Scenario& scenario, const std::stop_token& stop, const GapProgress& progress) {
    BlowReport report;
    report.blow = solveBlow(scenario, {}, Detail::histories, stop, Stresses::wanted);
    if (!report.blow.isSolved()) return report;
    addThrust(report, stop);
    addGap(report, stop, progress);
    return report;
}

}  // namespace drillwave
