// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/design_check.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/model/assignments.h"
#include "core/study/design/constant_energy.h"
#include "core/study/design/scenario_designs.h"
#include "core/study/rows/axis_scenario.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Lines, each once, no more than are read.
class Lines {
  public:
    void add(bool isUsage, const Message& text) {
        constexpr std::size_t enough = 20;
        if (text.isEmpty() || m_lines.size() == enough || !m_reported.insert(text.text()).second) return;
        m_lines.push_back({isUsage, text});
    }
    void usage(const Message& text) { add(true, text); }
    void invalid(const Message& text) { add(false, text); }
    bool empty() const { return m_lines.empty(); }
    std::vector<DesignProblemLine> take() { return std::move(m_lines); }

  private:
    std::vector<DesignProblemLine> m_lines;
    std::set<std::string> m_reported;
};

void checkCounts(const DesignStudy& study, Lines& lines) {
    const auto most = [&](std::size_t count, std::size_t limit, const char* pattern) {
        if (count > limit) lines.usage({pattern, {std::to_string(limit), std::to_string(count)}});
    };
    const std::size_t drawn = study.draws ? study.draws->parameters.size() : 0;
    if (study.dimensions() == 0)
        lines.usage(translatable("nothing is uncertain; give --uncertain KEY=LOW:HIGH or --draws FILE.csv"));
    most(study.uncertain.size() + drawn, mostUncertain,
         translatable("at most %1 uncertain parameters, these are %2"));
    most(study.choices.size(), mostChoices, translatable("at most %1 choices, these are %2"));
    most(study.aims.size(), mostAims, translatable("at most %1 aims, these are %2"));
    const std::uint64_t designs = study.designCount();
    if (designs == 0 || designs > mostDesigns)
        lines.usage(
            {designs == 0
                 ? translatable(
                       "at most %1 designs, and the choices make too many to count; give fewer values")
                 : translatable("at most %1 designs, the choices make %2; give fewer values"),
             {std::to_string(mostDesigns), std::to_string(designs)}});
    else if (designs * study.samples > mostDesignSolves)
        lines.usage(
            {translatable("at most %1 blows, %2 designs at %3 samples are more; take fewer"),
             {std::to_string(mostDesignSolves), std::to_string(designs), std::to_string(study.samples)}});
}

std::vector<NamedKey> keysOf(const DesignStudy& study, std::vector<NamedKey> keys) {
    for (const SweepAxis& axis : study.choices) {
        keys.push_back({std::string(axis.key()), true});
        if (!axis.presets) continue;
        for (const std::string_view key : axis.presets->keys())
            keys.push_back({std::string(key), true, false, std::string(axis.key())});
    }
    for (const UncertainInput& input : study.uncertain)
        keys.push_back({std::string(input.parameter->key), false, input.kind == DistributionKind::percent});
    if (study.draws)
        for (const KeptParameter& parameter : study.draws->parameters)
            keys.push_back({std::string(parameter->key)});
    return keys;
}

/// As the question has it.
const std::string& nameOf(const NamedKey& named) {
    return named.choice.empty() ? named.key : named.choice;
}

/// Whether the choice is one of hammers, each with an energy of its own.
bool choosesHammers(const SweepAxis& axis) {
    return axis.presets && axis.presets->part() == PresetPart::hammer;
}

Message energyLine(const Scenario& scenario) {
    const Message problem = keepEnergyProblem(scenario);
    return problem.isEmpty() ? problem : about(std::string("--keep-energy"), problem);
}

void checkKeys(const DesignStudy& study, const std::vector<NamedKey>& unread, Lines& lines) {
    const std::vector<NamedKey> keys = keysOf(study, unread);
    for (std::size_t a = 0; a < keys.size(); ++a)
        for (std::size_t b = a + 1; b < keys.size(); ++b) {
            const NamedKey &one = keys[a], &other = keys[b];
            if (one.key == other.key && one.isChosen && other.isPercent) continue;
            if (!one.choice.empty() && one.choice == other.choice) continue;
            const Message problem = rivalProblem(one.key, study.base, other.key, study.base);
            if (problem.isEmpty()) continue;
            const bool areChosenPresets = one.isChosen && other.isChosen && one.choice != other.choice;
            if (one.key != other.key || areChosenPresets)
                lines.invalid({translatable("%1 and %2 %3; leave out one of them"),
                               {nameOf(one), nameOf(other), problem}});
            else if (one.isChosen == other.isChosen)
                lines.invalid({translatable("%1 is given twice; give it once"), {one.key}});
            else
                lines.invalid(
                    {translatable(
                         "%1 is both design variable and uncertain: only +-P% about its value can be both"),
                     {one.key}});
        }
    if (!study.keepsEnergy) return;
    lines.invalid(energyLine(study.base));
    const KeptParameter scaled = energyParameter(study.base);
    const auto refuse = [&](const std::string& choice) {
        lines.invalid({translatable("keeping the energy sets %1, and so does the choice of %2; leave out "
                                    "that choice, or do not keep the energy (--no-keep-energy)"),
                       {std::string(scaled->key), choice}});
    };
    if (!scaled) return;
    for (const SweepAxis& axis : study.choices)
        if (choosesHammers(axis)) refuse(std::string(axis.key()));
    for (const NamedKey& named : keys)
        if (named.isChosen && areRivals(named.key, scaled->key)) refuse(nameOf(named));
}

/// Limits and aims, of the base: what a blow has does not depend on its numbers.
void checkOutputs(const DesignStudy& study, Lines& lines) {
    for (const OutputColumn& column : study.columns()) {
        if (column.output->needsThrustStudy())
            lines.invalid(translatable("thrust_margin needs a study of all gaps; aim at thrust instead"));
        else if (column.output->needsDrilling())
            lines.invalid(
                {translatable("%1 needs many blows for each value; use `drillwave drill` or a sweep"),
                 {std::string(column.output->name)}});
        else
            lines.invalid(columnProblem({&column, 1}, study.base));
    }
}

/// Returns a problem of a design together with the choices of the design.
Message at(const DesignStudy& study, std::uint64_t design, const Message& problem) {
    if (study.choices.empty()) return problem;
    const std::vector<double> values = study.choice(design);
    Message places;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const RowColumn column = study.choices[i].column();
        std::string text;
        column.appendText(text, values[i]);
        if (column.unit && !column.unit->name.empty()) text += " " + std::string(column.unit->name);
        places =
            joined(std::move(places), "%1, %2", {"%1 = %2", {std::string(study.choices[i].key()), text}});
    }
    return {translatable("at %1: %2"), {places, problem}};
}

/// A design must be a scenario, and take each uncertain number alone and all together at both ends: all
/// combinations of ends are left to the samples, which count what has no answer.
void checkDesign(const DesignStudy& study, std::uint64_t design, AxisScenario& chosen, Lines& lines) {
    if (!study.choices.empty()) {
        chosen.set(study.choice(design));
        if (chosen.obstacle()) return lines.invalid(at(study, design, chosen.obstacle()->text));
    }
    if (const Message line = study.keepsEnergy ? energyLine(chosen.scenario()) : Message(); !line.isEmpty())
        return lines.invalid(line);
    const Scenario scenario = designScenario(study, design);
    bool fits = true;
    for (const UncertainInput& input : study.uncertain) {
        const Message problem = input.problemIn(scenario);
        fits &= problem.isEmpty();
        lines.invalid(problem);
    }
    if (!fits) return;
    const std::vector<SweepAxis> axes = uncertainAxes(study, scenario);
    for (const SweepAxis& axis : axes)
        for (const double end : axis.list) {
            const std::vector<SweepAxis> alone{axis};
            AxisScenario scene(scenario, alone);
            scene.set(std::vector{end});
            if (scene.obstacle()) lines.invalid(at(study, design, scene.obstacle()->text));
        }
}

}  // namespace

std::vector<DesignProblemLine> problemsOf(const DesignStudy& study, const std::stop_token& stop,
                                          const std::vector<NamedKey>& unread) {
    Lines lines;
    checkCounts(study, lines);
    checkKeys(study, unread, lines);
    checkOutputs(study, lines);
    if (!lines.empty()) return lines.take();
    AxisScenario chosen(study.base, study.choices);
    for (std::uint64_t design = 0; design < study.designCount() && !stop.stop_requested(); ++design)
        checkDesign(study, design, chosen, lines);
    return lines.take();
}

}  // namespace drillwave
