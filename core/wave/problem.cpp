// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/problem.h"

#include <cassert>
#include <numeric>
#include <utility>

#include "core/contact/bit_rock_law.h"
#include "core/model/blow_traits.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

UniformSection uniformSection(const Section& section, const DrillString& drill, double impedance,
                              double time) {
    const RodProperties properties = propertiesOf(section, drill.material);
    return {.impedance = properties.impedance / impedance,
            .transitTime = properties.transitTime / time,
            .decay = section.attenuation * section.length,
            .massAfter = section.massAfter / (impedance * time),
            .loss = section.loss};
}

Problem stringProblem(const Scenario& scenario, const std::vector<int>& pieces) {
    const DrillString& drill = scenario.drillString;
    const double impedance = propertiesOf(*ruleSection(drill), drill.material).impedance;
    const double time = pulseDuration(scenario);
    const double slope = time / impedance;

    Problem problem;
    const std::size_t hammerCount = isForced(scenario) ? 0 : drill.hammer.sections.size();
    if (isForced(scenario)) {
        problem.drive = pulseForceOf(scenario);
    } else {
        ElasticHammer hammer{.sections = hammerCount, .face = {}};
        if (!pieces.empty())
            hammer.sections = std::accumulate(pieces.begin(),
                                              pieces.begin() + static_cast<std::ptrdiff_t>(hammerCount), 0UL);
        if (drill.hammer.faceStiffness) hammer.face.stiffness = *drill.hammer.faceStiffness * slope;
        hammer.face.restrike = drill.hammer.restrike;
        problem.drive = hammer;
    }
    problem.sections.clear();
    const std::vector<const Section*> sections = allSections(drill);
    assert(pieces.empty() || pieces.size() == sections.size());
    for (std::size_t j = 0; j < sections.size(); ++j)
        if (pieces.empty() || pieces[j] == 1)
            problem.sections.push_back(uniformSection(*sections[j], drill, impedance, time));
        else
            for (const Section& piece :
                 uniformPieces(*sections[j], pieces[j], j > hammerCount && sections[j - 1]->loss > 0))
                problem.sections.push_back(uniformSection(piece, drill, impedance, time));
    problem.pieces = pieces;
    problem.law.beta = scenario.bitRock.stiffness * slope;
    problem.law.gamma = scenario.bitRock.gamma;
    setLines(problem.law, scenario);
    problem.gap = scenario.bitRock.gap / scalesOf(scenario).penetration;
    if (drill.endTime) problem.endTime = *drill.endTime / time;
    if (scenario.drill.blowFrequency) problem.nextBlow = 1 / (*scenario.drill.blowFrequency * time);
    return problem;
}

}  // namespace

bool losesWaves(const Problem& problem) {
    for (std::size_t j = problem.hammerSections(); j < problem.sections.size(); ++j)
        if (problem.sections[j].decay > 0 ||
            (problem.sections[j].loss > 0 && j + 1 < problem.sections.size()))
            return true;
    return false;
}

std::string_view rodRefusal(const Problem& problem) {
    const UniformSection plain{.transitTime = problem.sections.front().transitTime};
    if (problem.isForced() && problem.sections.size() == 1 && problem.sections.front() == plain) return {};
    return translatable(
        "a hammer that strikes, several sections, masses and losses are not for this method, which "
        "follows a force on a uniform rod");
}

Problem problemOf(const Scenario& scenario, const std::vector<int>& pieces) {
    if (!isFollowedByEvents(scenario)) return stringProblem(scenario, pieces);
    Problem problem;
    problem.drive = pulseForceOf(scenario);
    setRod(problem, scenario);
    return problem;
}

void setRod(Problem& rod, const Scenario& scenario) {
    setGroups(rod, groupsOf(scenario));
    setLines(rod.law, scenario);
}

Problem problemOf(PulseForce force, const Groups& groups) {
    Problem problem;
    problem.drive = std::move(force);
    setGroups(problem, groups);
    return problem;
}

void setGroups(Problem& rod, const Groups& groups) {
    rod.sections.assign(1, {.transitTime = groups.tau});
    rod.law.beta = groups.beta;
    rod.law.gamma = groups.gamma;
    rod.gap = groups.delta;
}

}  // namespace drillwave
