// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/assignments.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/section_parameter.h"

namespace drillwave {

namespace {

constexpr const char* sameThing = translatable("set the same thing");

/// Where a key comes among those that are set together.
using Rank = std::tuple<std::ptrdiff_t, int, std::ptrdiff_t>;

/// The repeat decides which places there are; what is set at a place is more particular than what is set by
/// name.
Rank rankOfSection(const Parameter& parameter) {
    const std::ptrdiff_t before = &*findParameter("end_time") - parameters().data() + 1;
    if (!parameter.address) return {before, 1, 0};
    return {before, parameter.address->place == 0 ? 2 : 3, parameter.address->field - sectionFields().data()};
}

/// Place in the table of parameters, from 1; 0 for what is not in it.
Rank rankOf(const KeptParameter& parameter) {
    if (!parameter) return {};
    if (parameter->scope == Scope::section) return rankOfSection(*parameter);
    if (const std::size_t corner = cornerOf(*parameter))
        return {&*findParameter("bit_rock.gap") - parameters().data() + 1, 1,
                static_cast<std::ptrdiff_t>(corner)};
    return {&*findParameter(parameter->key) - parameters().data() + 1, 0, 0};  // whatever its form
}

AssignedKey assigned(std::string_view key) {
    return {key, findParameter(key)};
}

bool setTheSameOfSections(const Parameter& one, const Parameter& other) {
    return one.address && other.address && one.address->hasSameSections(*other.address) &&
           areRivals(*one.address->field, *other.address->field);
}

bool namesAsRival(const AssignedKey& one, std::string_view other) {
    return one.parameter && !other.empty() && one.parameter->rules.rival == other;
}

bool areRivals(const AssignedKey& a, const AssignedKey& b) {
    return a.key == b.key || namesAsRival(a, b.key) || namesAsRival(b, a.key) ||
           (a.parameter && b.parameter && setTheSameOfSections(*a.parameter, *b.parameter));
}

bool mayMeet(const AssignedKey& a, const AssignedKey& b) {
    return a.parameter && b.parameter && mayMeet(*a.parameter, *b.parameter);
}

Message rivalProblem(const AssignedKey& a, const Scenario& ofA, const AssignedKey& b, const Scenario& ofB) {
    if (areRivals(a, b)) return sameThing;
    return a.parameter && b.parameter ? meetingProblem(*a.parameter, ofA, *b.parameter, ofB) : Message();
}

}  // namespace

bool areRivals(std::string_view a, std::string_view b) {
    return areRivals(assigned(a), assigned(b));
}

Message rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB) {
    return rivalProblem(assigned(a), ofA, assigned(b), ofB);
}

Assignments::Assignments(const std::vector<std::string_view>& keys) {
    for (const std::string_view key : keys) add(key);
}

void Assignments::add(std::string_view key) {
    AssignedKey added = assigned(key);
    const auto later = std::ranges::upper_bound(
        m_order, rankOf(added.parameter), {}, [this](std::size_t i) { return rankOf(m_keys[i]->parameter); });
    m_order.insert(later, m_keys.size());
    for (std::size_t before = 0; before < m_keys.size(); ++before) {
        if (!m_keys[before]) continue;
        if (areRivals(*m_keys[before], added)) m_rivals.emplace_back(before, m_keys.size());
        if (mayMeet(*m_keys[before], added)) m_mayMeet.emplace_back(before, m_keys.size());
    }
    m_keys.emplace_back(std::move(added));
}

void Assignments::skip() {
    m_keys.emplace_back();
}

std::optional<RivalPair> Assignments::rivals(const IsSet& isSet) const {
    for (const auto& [a, b] : m_rivals)
        if (!isSet || (isSet(a) && isSet(b))) return RivalPair{a, b, sameThing};
    return std::nullopt;
}

std::optional<RivalPair> Assignments::meeting(const Scenario& scenario, const IsSet& isSet) const {
    for (const auto& [a, b] : m_mayMeet) {
        if (isSet && !(isSet(a) && isSet(b))) continue;
        Message problem = rivalProblem(*m_keys[a], scenario, *m_keys[b], scenario);
        if (!problem.isEmpty()) return RivalPair{a, b, std::move(problem)};
    }
    return std::nullopt;
}

bool Assignments::movesPulse(std::size_t number) const {
    assert(number < m_keys.size());
    if (!m_keys[number]) return false;
    const std::string_view key = m_keys[number]->key;
    return std::ranges::any_of(std::array{"pulse.", "rod.", "hammer.", "material.", "string."},
                               [&](const char* section) { return key.starts_with(section); });
}

bool Assignments::movePulse() const {
    return std::ranges::any_of(m_order, [this](std::size_t number) { return movesPulse(number); });
}

namespace {

/// The same number of the other form: the material of a rod, and that of the sections of a string.
KeptParameter counterpartOf(const Parameter& parameter) {
    static constexpr std::array<std::array<std::string_view, 2>, 2> pairs{
        {{"rod.youngs_modulus", "material.youngs_modulus"}, {"rod.density", "material.density"}}};
    for (const auto& [ofRod, ofString] : pairs) {
        if (parameter.key == ofRod) return findParameter(ofString);
        if (parameter.key == ofString) return findParameter(ofRod);
    }
    return nullptr;
}

}  // namespace

std::optional<double> valueIn(const Scenario& scenario, const Parameter& parameter) {
    if (parameter.applies(scenario)) return parameter.value(scenario);
    const KeptParameter other = counterpartOf(parameter);
    return other && other->applies(scenario) ? other->value(scenario) : std::nullopt;
}

std::vector<KeptParameter> differingParameters(std::span<const Scenario* const> scenarios) {
    std::vector<KeptParameter> differing;
    const auto look = [&](const KeptParameter& kept) {
        const Parameter& parameter = *kept;
        const KeptParameter other = counterpartOf(parameter);
        const auto isListedAs = [&](const KeptParameter& each) { return other && each->key == other->key; };
        if (std::ranges::any_of(differing, isListedAs)) return;
        const auto gives = [&](const Scenario* each) { return isGiven(parameter, *each); };
        const auto isOther = [&](const Scenario* each) {
            return valueIn(*each, parameter) != valueIn(*scenarios.front(), parameter);
        };
        if (std::ranges::any_of(scenarios, gives) && std::ranges::any_of(scenarios, isOther))
            differing.push_back(kept);
    };
    for (const Parameter& parameter : parameters()) look(parameter);
    const auto isListed = [&](const KeptParameter& parameter) {
        return std::ranges::any_of(differing,
                                   [&](const KeptParameter& other) { return other->key == parameter->key; });
    };
    for (const auto& numbersOf : {loadingNumbers, sectionParameters})
        for (const Scenario* scenario : scenarios)
            for (const KeptParameter& parameter : numbersOf(*scenario))
                if (!isListed(parameter)) look(parameter);
    return differing;
}

}  // namespace drillwave
