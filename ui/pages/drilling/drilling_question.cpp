// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/drilling/drilling_question.h"

#include <algorithm>

#include "core/blow/blow.h"
#include "core/numeric/available_threads.h"
#include "core/report/drilling_figure.h"
#include "core/study/drilling/quick_march.h"

namespace drillwave {
namespace {

/// The window looks at so many blows more each time, or at a share of those that there are: each look is a
/// copy.
constexpr std::size_t blowsAtATime = 5, shareAtATime = 8;

/// Longer marches are not kept: a million of blows are a hundred megabytes.
constexpr std::size_t mostKeptBlows = 20'000;

void forgetStrengths(std::vector<Section>& sections) {
    for (Section& section : sections) {
        section.yieldStrength.reset();
        section.fatigueStrength.reset();
    }
}

Scenario withoutWords(Scenario scenario) {
    scenario.title.clear();
    scenario.rod.yieldStrength.reset();
    scenario.rod.fatigueStrength.reset();
    forgetStrengths(scenario.drillString.hammer.sections);
    for (StringPart& part : scenario.drillString.parts) forgetStrengths(part.sections);
    return scenario;
}

/// The dashpot of a bracket and no spring.
Scenario withStrongDashpot(Scenario scenario) {
    const Problem blow = problemOf(scenario);
    const DrillingUnits units = drillingUnitsOf(scenario);
    const double impedance = blow.sections[blow.hammerSections()].impedance * units.force / units.velocity;
    scenario.drill.damperDamping = strongDashpot * impedance;
    scenario.drill.damperStiffness.reset();
    return scenario;
}

Scenario withConstantForce(Scenario scenario) {
    scenario.drill.damperDamping.reset();
    scenario.drill.damperStiffness.reset();
    return scenario;
}

}  // namespace

DrillingQuestion drillingQuestion(const Scenario& scenario) {
    return {withoutWords(scenario), windowSettingsOf(scenario)};
}

DrillingAnswer DrillingCache::answer(const DrillingQuestion& question,
                                     const StudyFeed<DrillingAnswer>& feed) {
    const auto known =
        std::ranges::find(m_known, question, [](const DrillingAnswer& each) { return each.question; });
    if (known != m_known.end()) {
        m_known.splice(m_known.begin(), m_known, known);
        return m_known.front();
    }
    DrillingAnswer found{.question = question,
                         .refusals = drillingRefusals(question.scenario, question.settings),
                         .growing = {},
                         .result = nullptr,
                         .corOverGap = {}};
    if (!found.refusals.empty()) return found;
    DrillingRequest wants;
    const auto wanted = static_cast<std::size_t>(foreseenBlows(question.settings, wants));
    std::size_t done = 0, shown = 0;
    wants.onBlow = [&](const DrillingBlow& blow) {
        found.growing.push_back(blow);
        if (found.growing.size() < shown + std::max(blowsAtATime, shown / shareAtATime)) return;
        shown = found.growing.size();
        feed.show(found);
    };
    auto result = std::make_shared<DrillingResult>(
        studyDrilling(question.scenario, question.settings, wants, feed.stop, [&](long more) {
            done += static_cast<std::size_t>(more);
            feed.tell({std::min(done, wanted), wanted});
        }));
    found.result = std::move(result);
    found.growing.clear();
    if (!found.isComplete() || feed.stop.stop_requested()) return found;
    feed.show(found);
    found.corOverGap = corOverPeriod(question.scenario, feed.stop);
    if (feed.stop.stop_requested() || found.result->blows.size() > mostKeptBlows) return found;
    m_known.push_front(found);
    if (m_known.size() > keptAnswers) m_known.pop_back();
    return found;
}

std::string scanAxisText(const StudyRange& range) {
    return range.text() + ":" + std::to_string(range.pointsWithin(scanPoints)) + range.tail();
}

DrillingScanQuestion drillingScanQuestion(const Scenario& scenario, const StudyRange& range,
                                          bool hasBracket) {
    DrillingScanQuestion question{withoutWords(scenario), range, drillingQuestion(scenario).settings,
                                  hasBracket};
    question.settings.cells = scanCells;
    // The present value of the parameter does not matter.
    if (range.parameter && range.parameter->applies(scenario))
        range.parameter->assign(question.scenario, range.start);
    return question;
}

double scanSeconds(const DrillingScanQuestion& question) {
    constexpr double startsOfValue = 2;  // at rest and bouncing
    const double scans = question.hasBracket ? 3 : 1;
    const double values = double(question.range.pointsWithin(scanPoints));
    return scans * values * startsOfValue * drillingWork(question.scenario, question.settings, quickWants()) /
           workOfSecond / availableThreads();
}

DrillingScanAnswer answerDrillingScan(const DrillingScanQuestion& question,
                                      const StudyFeed<DrillingScanAnswer>& feed) {
    DrillingScanAnswer found;
    const ParsedAxis parsed = parseAxis(scanAxisText(question.range));
    if (!parsed.problem.isEmpty()) {
        found.refusals = {parsed.problem};
        return found;
    }
    found.refusals = scanRefusals(question.scenario, parsed.axis, question.settings);
    if (!found.refusals.empty()) return found;
    const bool hasStrong = question.hasBracket && question.scenario.drill.machineMass.value_or(0) > 0;
    const std::size_t scans = 1 + (question.hasBracket ? 1 : 0) + (hasStrong ? 1 : 0);
    const std::size_t wanted = scans * parsed.axis.count;
    std::size_t done = 0;
    const auto scan = [&](const Scenario& base, std::shared_ptr<const DrillingScan>& into) {
        if (feed.stop.stop_requested()) return;
        auto end = std::make_shared<const DrillingScan>(
            scanDrilling(base, parsed.axis, question.settings,
                         {.jobs = availableThreads(),
                          .stop = feed.stop,
                          .progress =
                              [&](long more) {
                                  feed.tell({done += std::size_t(more), wanted});
                              },
                          .onValue =
                              [&](const DrillingScan& soFar) {
                                  into = std::make_shared<const DrillingScan>(soFar);
                                  feed.show(found);
                              }}));
        if (!feed.stop.stop_requested()) into = std::move(end);
    };
    scan(question.scenario, found.scan);
    if (question.hasBracket) scan(withConstantForce(question.scenario), found.constantForce);
    if (hasStrong) scan(withStrongDashpot(question.scenario), found.strongDamper);
    return found;
}

}  // namespace drillwave
