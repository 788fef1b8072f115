// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_report.h"

#include "core/blow/thrust.h"
#include "core/study/thrust/thrust_margins.h"

namespace drillwave {

namespace {

constexpr std::string_view frequencyKey = "drill.blow_frequency";

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
    if (!report.thrustProblem.empty()) return;
    ThrustReport thrust;
    thrust.scenario = scenario;
    thrust.study = studyThrust(scenario, stop);
    report.thrustProblem = thrust.study.reason;
    if (!report.thrustProblem.empty() || thrust.study.stopped) return;
    if (const std::optional<SweepAxis> axis = frequencyAxis(scenario))
        thrust.along = ThrustAlong{*axis, thrustAlong(scenario, *axis->parameter, valuesOf(*axis), 1, stop)};
    report.thrust = std::move(thrust);
}

void addGap(BlowReport& report, const std::stop_token& stop, const GapProgress& progress) {
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
    addThrustMargin(report.blow, stop);
    addThrust(report, stop);
    addGap(report, stop, progress);
    return report;
}

}  // namespace drillwave
