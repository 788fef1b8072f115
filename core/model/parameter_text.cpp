// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/parameter_text.h"

#include <algorithm>
#include <vector>

#include "core/model/law_parameter.h"
#include "core/model/section_parameter.h"
#include "core/model/word_parameter.h"
#include "core/text/decimal_text.h"
#include "core/text/nearest_name.h"

namespace drillwave {
namespace {

constexpr std::string_view notOfUniformRod =
    "only a drill string has it (`drillwave: 2`), this is a uniform rod";

std::string refusal(std::string_view key, std::string_view text, std::string_view reason) {
    return std::string(key) + " = " + shortened(trimmed(text)) + " (" + std::string(reason) + ")";
}

constexpr std::string_view notOfString = "only a uniform rod has it (`drillwave: 1`), this is a drill string";
constexpr std::string_view notOfHammer =
    "only a force in place of the hammer has it (`pulse`), this string is struck by a hammer";
constexpr std::string_view notOfForce =
    "only a hammer of sections has it (`hammer`), this string is driven by a force (`pulse`)";

std::string assignWord(Scenario& scenario, const WordParameter& parameter, std::string_view text) {
    const auto words = parameter.words();
    const auto found = std::ranges::find(words, trimmed(text));
    if (found != words.end()) {
        const std::string reason =
            parameter.assign(scenario, static_cast<std::size_t>(found - words.begin()));
        return reason.empty() ? reason : refusal(parameter.key, text, reason);
    }
    if (const std::string_view reason = shapeRefusal(scenario, PulseShape());
        parameter.key == pulseShapeKey && !reason.empty())
        return refusal(parameter.key, text, reason);
    return refusal(parameter.key, text, "must be one of " + parameter.list());
}

std::string assignRestrike(Scenario& scenario, std::string_view text) {
    const std::optional<bool> restrike = findTruth(trimmed(text));
    if (!isString(scenario)) return refusal(restrikeKey, text, notOfUniformRod);
    if (isForced(scenario)) return refusal(restrikeKey, text, notOfForce);
    if (!restrike) return refusal(restrikeKey, text, "must be true or false");
    scenario.drillString.hammer.restrike = *restrike;
    return {};
}

std::string unknownKey(std::string_view key) {
    for (const std::string_view text : {"title", "pulse.file", "pulse.points", "hammer.sections", "string"})
        if (key == text) return "`" + std::string(key) + "` is no number; write it into the scenario file";
    const std::string near = nearestKey(key);
    return "`" + shortened(key) + "` is not a parameter" +
           (near.empty() ? "" : "; did you mean `" + near + "`?");
}

/// Names the group that does in a dimensionless scenario what this parameter does in a dimensional one.
std::string whyNotInDimensionless(const Parameter& parameter) {
    const auto group = std::ranges::find_if(parameters(), [&](const Parameter& other) {
        return other.isGroup() && other.rules.rival == parameter.key;
    });
    return "the scenario is given by its dimensionless groups" +
           (group == parameters().end() ? "" : "; set `" + std::string(group->key) + "` instead");
}

std::string whyNotInString(const Parameter& parameter) {
    if (parameter.scope == Scope::uniformRod)
        return "follows from the lengths of hammer and string; set those, as `string.1.length`";
    return std::string(notOfString) +
           std::string(parameter.section() == "rod" ? "; set its sections, as `string.1.length`" : "");
}

/// Of a parameter that only one law of the rock has.
std::string whyNotOfLaw(const Parameter& parameter, const Scenario& scenario) {
    const RockLaw law = *parameter.rules.law;
    if (scenario.bitRock.law != law)
        return "only " + std::string(phrase(law)) + " has it; set `" + std::string(rockLawKey) + "=" +
               std::string(name(law)) + "` too";
    return hasUnits(scenario) ? "needs a unit, as this scenario is in physical quantities"
                              : "has no unit in a dimensionless scenario";
}

}  // namespace

std::optional<bool> findTruth(std::string_view word) {
    if (word == "true" || word == "True" || word == "TRUE") return true;
    if (word == "false" || word == "False" || word == "FALSE") return false;
    return std::nullopt;
}

std::string pulseShapeList() {
    return findWordParameter(pulseShapeKey)->list();
}

std::string_view shapeRefusal(const Scenario& scenario, PulseShape shape) {
    if (!isForced(scenario)) return notOfHammer;
    if (isString(scenario) && shape == PulseShape::rigidBody) return notOfString;
    return {};
}

std::string whyNotApplicable(const Parameter& parameter, const Scenario& scenario) {
    if (parameter.applies(scenario)) return {};
    if (parameter.scope == Scope::section) return whyNoSection(parameter, scenario);
    if (parameter.scope == Scope::string) return std::string(notOfUniformRod);
    if (parameter.scope == Scope::hammer)
        return std::string(isString(scenario) ? notOfForce : notOfUniformRod);
    if (parameter.rules.law) return whyNotOfLaw(parameter, scenario);
    const bool ofPulse = parameter.section() == "pulse";
    if (!isForced(scenario) && ofPulse) return std::string(notOfHammer);
    if (isString(scenario) && !ofPulse) return whyNotInString(parameter);
    const std::string shape(name(scenario.pulse.shape));
    if (parameter.scope == Scope::trapezoid) return "only a trapezoid has it, the shape is " + shape;
    if (parameter.scope == Scope::pistonByRatio && scenario.pulse.shape == PulseShape::piston)
        return "follows from the diameters and materials of hammer and rod";
    if (parameter.scope == Scope::pistonByRatio) return "only a piston has it, the shape is " + shape;
    if (!hasUnits(scenario)) return whyNotInDimensionless(parameter);
    if (parameter.scope == Scope::withoutArea)
        return "the rod is given by its area; set `rod.area` or `rod.diameter`";
    if (parameter.scope == Scope::givenPulse) return "follows from the data of the " + shape;
    return "only a piston has it, the shape is " + shape;
}

std::string assignNumber(Scenario& scenario, const Parameter& parameter, double si) {
    if (const std::string reason = whyNotApplicable(parameter, scenario); !reason.empty())
        return "has no meaning here: " + reason;
    if (std::string problem = rangeProblem(parameter, si); !problem.empty()) return problem;
    parameter.assign(scenario, si);
    return {};
}

std::string nearestKey(std::string_view key) {
    if (std::string near = nearestSectionKey(key); !near.empty()) return near;
    std::vector<std::string_view> keys{restrikeKey, "string.repeat", "bit_rock.corner.1.force",
                                       "bit_rock.corner.1.slope"};
    for (const WordParameter& parameter : wordParameters()) keys.push_back(parameter.key);
    for (const Parameter& parameter : parameters()) keys.push_back(parameter.key);
    return std::string(nearestName(key, keys));
}

std::string assignText(Scenario& scenario, std::string_view key, std::string_view text, const Unit* unit) {
    if (const WordParameter* word = findWordParameter(key)) return assignWord(scenario, *word, text);
    if (key == restrikeKey) return assignRestrike(scenario, text);
    const KeptParameter parameter = findParameter(key);
    return parameter ? assignText(scenario, *parameter, text, unit) : unknownKey(key);
}

std::string assignText(Scenario& scenario, const Parameter& parameter, std::string_view text,
                       const Unit* unit) {
    if (const KeptParameter other = hasUnits(scenario) ? KeptParameter() : inScales(parameter);
        other && &*other != &parameter)
        return assignText(scenario, *other, text, unit);
    const std::string_view key = parameter.key;
    const std::string inapplicable = whyNotApplicable(parameter, scenario);
    if (!inapplicable.empty()) return refusal(key, text, inapplicable);
    const BareNumber bare = unit ? BareNumber::inDefaultUnit : BareNumber::refused;
    const TypedQuantity typed =
        parseQuantity(text, parameter.quantity, bare, unit ? unit : &parameter.displayUnit());
    if (!typed.valid()) return refusal(key, text, typed.problem);
    const std::string problem = rangeProblem(parameter, typed.si);
    if (!problem.empty()) return refusal(key, text, problem);
    parameter.assign(scenario, typed.si);
    const std::string lost = readBackProblem(parameter, scenario, typed.si);
    return lost.empty() ? std::string() : refusal(key, text, lost);
}

}  // namespace drillwave
