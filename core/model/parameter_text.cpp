// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/parameter_text.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/model/law_parameter.h"
#include "core/model/section_parameter.h"
#include "core/model/validation.h"
#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

namespace drillwave {

namespace {

Message setShape(Scenario& scenario, std::size_t word) {
    const auto shape = static_cast<PulseShape>(word);
    Message refusal = shapeRefusal(scenario, shape);
    if (refusal.isEmpty()) scenario.pulse.shape = shape;
    return refusal;
}

Message setLaw(Scenario& scenario, std::size_t word) {
    scenario.bitRock = withLaw(std::move(scenario.bitRock), static_cast<RockLaw>(word));
    return {};
}

Message setIndexing(Scenario& scenario, std::size_t word) {
    if (!hasUnits(scenario)) return translatable("a dimensionless scenario has no drill");
    scenario.drill.indexing = static_cast<RockIndexing>(word);
    return {};
}

constexpr std::array wordTable{
    WordParameter{pulseShapeKey, pulseShapeNames,
                  [](const Scenario& scenario) { return name(scenario.pulse.shape); }, setShape},
    WordParameter{rockLawKey, rockLawNames,
                  [](const Scenario& scenario) { return name(scenario.bitRock.law); }, setLaw},
    WordParameter{rockIndexingKey, rockIndexingNames,
                  [](const Scenario& scenario) { return name(scenario.drill.indexing); }, setIndexing},
};

constexpr const char* notOfUniformRod =
    translatable("only for drill strings (`drillwave: 2`); this is a uniform rod");

Message refusal(std::string_view key, std::string_view text, const Message& reason) {
    return refusedValue(key, trimmed(text), reason);
}

constexpr const char* notOfString =
    translatable("only for uniform rods (`drillwave: 1`); this is a drill string");
constexpr const char* notOfHammer =
    translatable("only for a force instead of the hammer (`pulse`); this string is struck by a hammer");
constexpr const char* notOfForce =
    translatable("only for a hammer of sections (`hammer`); this string is driven by a force (`pulse`)");

Message assignWord(Scenario& scenario, const WordParameter& parameter, std::string_view text) {
    const auto words = parameter.words();
    const auto found = std::ranges::find(words, trimmed(text));
    if (found != words.end()) {
        const Message reason = parameter.assign(scenario, static_cast<std::size_t>(found - words.begin()));
        return reason.isEmpty() ? reason : refusal(parameter.key, text, reason);
    }
    if (const Message reason = shapeRefusal(scenario, PulseShape());
        parameter.key == pulseShapeKey && !reason.isEmpty())
        return refusal(parameter.key, text, reason);
    return refusal(parameter.key, text, {translatable("must be one of %1"), {parameter.list()}});
}

/// Returns why a scenario whose blow is a force has no hammer.
Message whyNoHammer(const Scenario& scenario) {
    return isString(scenario) ? notOfForce : notOfUniformRod;
}

Message assignRestrike(Scenario& scenario, std::string_view text) {
    const std::optional<bool> restrike = findTruth(trimmed(text));
    if (isForced(scenario)) return refusal(restrikeKey, text, whyNoHammer(scenario));
    if (!restrike) return refusal(restrikeKey, text, translatable("must be true or false"));
    scenario.drillString.hammer.restrike = *restrike;
    return {};
}

Message unknownKey(std::string_view key) {
    for (const std::string_view text : {"title", "pulse.file", "pulse.points", "hammer.sections", "string"})
        if (key == text)
            return {translatable("`%1` is not a number; write it into the scenario file"),
                    {std::string(key)}};
    return notAParameter(key);
}

/// Names the group that does in a dimensionless scenario what this parameter does in a dimensional one.
Message whyNotInDimensionless(const Parameter& parameter) {
    const auto group = std::ranges::find_if(parameters(), [&](const Parameter& other) {
        return other.isGroup() && other.rules.rival == parameter.key;
    });
    if (group == parameters().end()) return translatable("the scenario is given by its dimensionless groups");
    return {translatable("the scenario is given by its dimensionless groups; set `%1` instead"),
            {std::string(group->key)}};
}

Message whyNotInString(const Parameter& parameter) {
    if (parameter.scope == Scope::uniformRod)
        return translatable("follows from the lengths of hammer and string; set those, as `string.1.length`");
    if (parameter.section() != "rod") return notOfString;
    return {translatable("%1; set its sections, as `string.1.length`"), {notOfString}};
}

/// Returns why a parameter of another law of the rock does not apply.
Message whyNotOfLaw(const Parameter& parameter, const Scenario& scenario) {
    const RockLaw law = *parameter.rules.law;
    if (scenario.bitRock.law != law)
        return {translatable("only for %1; set `%2=%3` too"),
                {Message::ofTable(phrase(law)), std::string(rockLawKey), std::string(name(law))}};
    return hasUnits(scenario) ? translatable("needs a unit, because this scenario has physical units")
                              : translatable("has no unit in a dimensionless scenario");
}

}  // namespace

std::string WordParameter::list() const {
    std::string list;
    for (const std::string_view word : words()) list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

std::span<const WordParameter> wordParameters() {
    return wordTable;
}

const WordParameter* findWordParameter(std::string_view key) {
    const auto found = std::ranges::find(wordTable, key, &WordParameter::key);
    return found == wordTable.end() ? nullptr : &*found;
}

std::optional<bool> findTruth(std::string_view word) {
    if (word == "true" || word == "True" || word == "TRUE") return true;
    if (word == "false" || word == "False" || word == "FALSE") return false;
    return std::nullopt;
}

std::string pulseShapeList() {
    return findWordParameter(pulseShapeKey)->list();
}

Message shapeRefusal(const Scenario& scenario, PulseShape shape) {
    if (!isForced(scenario)) return notOfHammer;
    if (isString(scenario) && shape == PulseShape::rigidBody) return notOfString;
    return {};
}

Message whyNotApplicable(const Parameter& parameter, const Scenario& scenario) {
    if (parameter.applies(scenario)) return {};
    if (parameter.scope == Scope::section) return whyNoSection(parameter, scenario);
    if (parameter.scope == Scope::string) return notOfUniformRod;
    if (parameter.scope == Scope::hammer) return whyNoHammer(scenario);
    if (parameter.rules.law) return whyNotOfLaw(parameter, scenario);
    const bool ofPulse = parameter.section() == "pulse";
    if (!isForced(scenario) && ofPulse) return notOfHammer;
    if (isString(scenario) && !ofPulse) return whyNotInString(parameter);
    const std::string shape(name(scenario.pulse.shape));
    if (parameter.scope == Scope::trapezoid)
        return {translatable("only for a trapezoid; the shape is %1"), {shape}};
    if (parameter.scope == Scope::pistonByRatio && scenario.pulse.shape == PulseShape::piston)
        return translatable("follows from the diameters and materials of hammer and rod");
    if (parameter.scope == Scope::pistonByRatio)
        return {translatable("only for a piston; the shape is %1"), {shape}};
    if (!hasUnits(scenario)) return whyNotInDimensionless(parameter);
    if (parameter.scope == Scope::withoutArea)
        return translatable("the rod is given by its area; set `rod.area` or `rod.diameter`");
    if (parameter.scope == Scope::givenPulse)
        return {translatable("follows from the data of the %1"), {shape}};
    return {translatable("only for a piston; the shape is %1"), {shape}};
}

namespace {

/// Returns why groups cannot be set: their scales need at least one section, and no more than are followed.
Message scalesProblem(const Scenario& scenario) {
    const std::uint64_t count = sectionCount(scenario.drillString);
    if (count > maximumSections) return tooManySections(count);
    if (count > 0 || !isString(scenario)) return {};
    return translatable("must have at least one section");
}

}  // namespace

Message assignNumber(Scenario& scenario, const Parameter& parameter, double si) {
    if (const Message reason = whyNotApplicable(parameter, scenario); !reason.isEmpty())
        return {translatable("does not apply here: %1"), {reason}};
    if (const Message problem = rangeProblem(parameter, si); !problem.isEmpty()) return problem;
    if (!parameter.rules.rival.empty())
        if (const Message problem = scalesProblem(scenario); !problem.isEmpty())
            return about("string", problem);
    parameter.assign(scenario, si);
    return {};
}

Message notAParameter(std::string_view key) {
    const std::string near = nearestKey(key);
    if (near.empty()) return {translatable("`%1` is not a parameter"), {shortened(key)}};
    return {translatable("`%1` is not a parameter; did you mean `%2`?"), {shortened(key), near}};
}

std::string nearestKey(std::string_view key) {
    if (std::string near = nearestSectionKey(key); !near.empty()) return near;
    std::vector<std::string_view> keys{restrikeKey, "string.repeat", "bit_rock.corner.1.force",
                                       "bit_rock.corner.1.slope"};
    for (const WordParameter& parameter : wordParameters()) keys.push_back(parameter.key);
    for (const Parameter& parameter : parameters()) keys.push_back(parameter.key);
    return std::string(nearestName(key, keys));
}

Message assignText(Scenario& scenario, std::string_view key, std::string_view text, const Unit* unit) {
    if (const WordParameter* word = findWordParameter(key)) return assignWord(scenario, *word, text);
    if (key == restrikeKey) return assignRestrike(scenario, text);
    const KeptParameter parameter = findParameter(key);
    return parameter ? assignText(scenario, *parameter, text, unit) : unknownKey(key);
}

Message assignText(Scenario& scenario, const Parameter& parameter, std::string_view text, const Unit* unit) {
    if (const KeptParameter other = hasUnits(scenario) ? KeptParameter() : inScales(parameter);
        other && &*other != &parameter)
        return assignText(scenario, *other, text, unit);
    const std::string_view key = parameter.key;
    const Message inapplicable = whyNotApplicable(parameter, scenario);
    if (!inapplicable.isEmpty()) return refusal(key, text, inapplicable);
    const BareNumber bare = unit ? BareNumber::inDefaultUnit : BareNumber::refused;
    const TypedQuantity typed =
        parseQuantity(text, parameter.quantity, bare, unit ? unit : &parameter.displayUnit());
    if (!typed.valid()) return refusal(key, text, typed.problem);
    const Message problem = rangeProblem(parameter, typed.si);
    if (!problem.isEmpty()) return refusal(key, text, problem);
    parameter.assign(scenario, typed.si);
    const Message lost = readBackProblem(parameter, scenario, typed.si);
    return lost.isEmpty() ? lost : refusal(key, text, lost);
}

}  // namespace drillwave
