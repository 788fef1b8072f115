// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_report.h"

#include "core/blow/feed_estimate.h"

namespace drillwave {

namespace {

constexpr std::string_view frequencyKey = "drill.blow_frequency";

/// Shares of the progress: two curves of e, and one of all outputs, which takes about as long.
constexpr double shareOfThrust = 0.5;

/// A reason of a study, in a sentence; where the study was given up, how to have it all the same.
Message sentenceOf(const Message& reason, const Blow& blow, std::string_view command) {
    if (reason != tooManyPieces) return reason;
    return {translatable("The waves of this blow have %1 polynomial pieces, too many to study all gaps in a "
                         "report: run `drillwave %2` instead, which takes longer."),
            {std::to_string(blow.impact.pieces), std::string(command)}};
}

/// From `begin` to `end` of the whole.
GapProgress partOf(const GapProgress& whole, double begin, double end) {
    if (!whole) return {};
    return [whole, begin, end](double done) { whole(begin + (end - begin) * done); };
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
    if (!parsed.problem.isEmpty()) return std::nullopt;
    return std::move(parsed.axis);
}

void addThrust(BlowReport& report, const std::stop_token& stop, const GapProgress& progress) {
    const Scenario& scenario = report.blow.scenario;
    report.thrustProblem = thrustProblem(scenario);
    if (!report.thrustProblem.isEmpty()) return;
    ThrustReport thrust;
    thrust.scenario = scenario;
    thrust.study = studyThrust(scenario, stop, progress, mostPiecesInPassing);
    report.thrustProblem = sentenceOf(thrust.study.reason, report.blow, "thrust");
    if (!report.thrustProblem.isEmpty() || thrust.study.stopped) return;
    report.blow.feed = thrust.study.feed;
    // The frequency changes no blow, and nothing over the gap.
    GapReboundFinder finder;
    if (thrust.study.rebounds) finder.remember(report.blow.problem, *thrust.study.rebounds);
    if (const std::optional<SweepAxis> axis = frequencyAxis(scenario))
        thrust.along =
            ThrustAlong{*axis, thrustAlong(scenario, *axis->parameter, valuesOf(*axis), finder, stop)};
    report.thrust = std::move(thrust);
}

void addGap(BlowReport& report, const std::stop_token& stop, const GapProgress& progress) {
    GapStudy gap = studyGap(report.blow.scenario, std::nullopt, stop, progress, mostPiecesInPassing);
    if (!gap.curve.dependsOnGap)
        report.gapProblem = periodRemark(gap);
    else if (gap.curve.isComplete())
        report.gap = std::move(gap);
    else if (gap.curve.reason == tooManyPieces)
        report.gapProblem = sentenceOf(gap.curve.reason, report.blow, "gap");
    else
        report.gapProblem = {translatable("The blow could not be solved at all gaps: %1"),
                             {gap.curve.reason}};
}

}  // namespace

BlowReport studyReport(const Scenario& scenario, const std::stop_token& stop, const GapProgress& progress,
                       const WorkLimits& limits) {
    BlowReport report;
    MethodSolver solver(limits);
    report.blow = solveBlow(scenario, {}, Detail::histories, stop, Stresses::wanted, solver);
    if (!report.blow.isSolved()) return report;
    addThrust(report, stop, partOf(progress, 0, shareOfThrust));
    if (whyNoPeriod(scenario).isEmpty()) addGap(report, stop, partOf(progress, shareOfThrust, 1));
    return report;
}

}  // namespace drillwave
