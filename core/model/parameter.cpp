// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/parameter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/section_parameter.h"

namespace drillwave {

KeptParameter::KeptParameter(const Parameter& parameter)
    : KeptParameter(parameter.address ? findSectionParameter(parameter.key)
                                      : KeptParameter(std::shared_ptr<const Parameter>(
                                            std::shared_ptr<void>(), &parameter))) {}

KeptParameter::KeptParameter(std::shared_ptr<const Parameter> parameter)
    : m_parameter(std::move(parameter)) {}

const Parameter& KeptParameter::operator*() const {
    assert(m_parameter);
    return *m_parameter;
}

bool operator==(const KeptParameter& one, const KeptParameter& other) {
    if (!one || !other) return !one && !other;
    return one.m_parameter == other.m_parameter || one->key == other->key;
}

bool Range::contains(double value) const {
    return std::isfinite(value) && (lowOpen ? value > low : value >= low) &&
           (highOpen ? value < high : value <= high);
}

std::string Range::ends() const {
    return (lowOpen ? "(" : "[") + formatNumber(low) + ", " + formatNumber(high) + (highOpen ? ")" : "]");
}

std::string Range::ends(const Unit& unit) const {
    return Range{unit.fromSi(low), unit.fromSi(high), lowOpen, "", highOpen}.ends();
}

bool Parameter::applies(const Scenario& scenario) const {
    if (rules.law && scenario.bitRock.law != *rules.law) return false;
    const PulseShape shape = scenario.pulse.shape;
    switch (scope) {
        case Scope::all:
            return true;
        case Scope::withUnits:
        case Scope::manyBlows:
            return hasUnits(scenario);
        case Scope::withoutUnits:
            return !hasUnits(scenario);
        case Scope::string:
        case Scope::uniformRod:
            return isString(scenario) == (scope == Scope::string);
        case Scope::hammer:
            return !isForced(scenario);
        case Scope::section:
            return hasSectionFor(*this, scenario);
        case Scope::dimensional:
            return scenario.form == ScenarioForm::dimensional;
        case Scope::withoutArea:
            return scenario.form == ScenarioForm::dimensional && !scenario.rod.area;
        case Scope::givenPulse:
            return hasUnits(scenario) && isForced(scenario) && shape != PulseShape::piston &&
                   shape != PulseShape::table;
        case Scope::trapezoid:
            return isForced(scenario) && shape == PulseShape::trapezoid;
        case Scope::pistonInSi:
            return hasUnits(scenario) && isForced(scenario) && shape == PulseShape::piston;
        case Scope::pistonByRatio:
            return !hasUnits(scenario) && shape == PulseShape::piston;
    }
    return false;
}

bool Parameter::isGroup() const {
    return key.find('.') == std::string_view::npos && scope != Scope::string;
}

std::string_view Parameter::section() const {
    if (isGroup()) return "groups";
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

std::string_view Parameter::fileSection() const {
    return isGroup() ? "dimensionless" : section();
}

std::string_view Parameter::localKey() const {
    const std::size_t dot = address ? key.rfind('.') : key.find('.');
    return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

const Unit& Parameter::displayUnit() const {
    const Unit* found = findUnit(quantity, unit);
    assert(found);
    return *found;
}

KeptParameter findParameter(std::string_view key) {
    const auto found = std::ranges::find(parameters(), key, &Parameter::key);
    if (found != parameters().end()) return *found;
    KeptParameter ofLaw = findLawParameter(key);
    return ofLaw ? ofLaw : findSectionParameter(key);
}

Message Range::problem(double value, const Unit& unit) const {
    if (!std::isfinite(value)) return translatable("must be a finite number");
    if (contains(value)) return {};
    // Who gives nothing, or less, need not be told how little or how much would do.
    if (low >= 0 && value <= 0 && !unit.name.empty())
        return low > 0 || lowOpen ? translatable("must be greater than 0")
                                  : translatable("must be at least 0");
    const std::string name = std::isfinite(high) && !unit.name.empty() ? " " + std::string(unit.name) : "";
    const Message problem{std::isfinite(high) ? translatable("must be in %1%2")
                          : lowOpen           ? translatable("must be greater than %1")
                                              : translatable("must be at least %1"),
                          {std::isfinite(high) ? ends(unit) : formatNumber(unit.fromSi(low)), name}};
    return value > high && *whyNotMore ? Message("%1: %2", {problem, whyNotMore}) : problem;
}

const Unit& unitOfRange(Quantity quantity, const Unit& customary) {
    return quantity == Quantity::share ? customary : unitsOf(quantity).front();
}

Message rangeProblem(const Parameter& parameter, double value) {
    if (parameter.rules.wholeNumber && std::isfinite(value) && value != std::floor(value))
        return translatable("must be a whole number");
    return parameter.hard.problem(value, unitOfRange(parameter.quantity, parameter.displayUnit()));
}

Message readBackProblem(const Parameter& parameter, const Scenario& scenario, double wanted) {
    assert(parameter.applies(scenario));
    constexpr double rounding = 1e-12;
    if (parameter.address) return {};  // a section keeps what it is given; where several differ none is read
    const double kept = parameter.value(scenario).value_or(std::nan(""));
    if (std::abs(kept - wanted) <= rounding * std::abs(wanted)) return {};
    return {translatable(
                "cannot be stored: its values are at the limit of double precision, it reads back as %1"),
            {formatNumber(kept)}};
}

bool isGiven(const Parameter& parameter, const Scenario& scenario) {
    if (!parameter.applies(scenario)) return false;
    if (parameter.isGroup()) return !hasUnits(scenario);
    if (parameter.key == "pulse.impulse") return !scenario.pulse.impulseFromForce;
    if (parameter.key == "pulse.force") return scenario.pulse.impulseFromForce;
    return true;
}

}  // namespace drillwave
