// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/assignments.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>

#include "core/model/section_parameter.h"

namespace drillwave {
namespace {

constexpr std::string_view sameThing = "set the same thing";

/// Where a key comes among those that are set together.
using Rank = std::tuple<std::ptrdiff_t, int, std::ptrdiff_t>;

/// The repeat decides which places there are; what is set at a place is more particular than what is set by
/// name.
Rank rankOfSection(const Parameter& parameter) {
    const std::ptrdiff_t before = findParameter("end_time") - parameters().data() + 1;
    if (!parameter.address) return {before, 1, 0};
    return {before, parameter.address->place == 0 ? 2 : 3, parameter.address->field - sectionFields().data()};
}

/// Place in the table of parameters, from 1; 0 for what is not in it.
Rank rankOf(std::string_view key) {
    const Parameter* parameter = findParameter(key);
    if (!parameter) return {};
    if (parameter->scope == Scope::section) return rankOfSection(*parameter);
    return {parameter - parameters().data() + 1, 0, 0};
}

bool setTheSameOfSections(std::string_view a, std::string_view b) {
    const Parameter* one = findParameter(a);
    const Parameter* other = findParameter(b);
    return one && other && one->address && other->address && one->address->hasSameSections(*other->address) &&
           areRivals(*one->address->field, *other->address->field);
}

bool mayMeet(std::string_view a, std::string_view b) {
    const Parameter* one = findParameter(a);
    const Parameter* other = findParameter(b);
    return one && other && drillwave::mayMeet(*one, *other);
}

bool namesAsRival(std::string_view a, std::string_view b) {
    const Parameter* parameter = findParameter(a);
    return parameter && !b.empty() && parameter->rules.rival == b;
}

}  // namespace

bool areRivals(std::string_view a, std::string_view b) {
    return a == b || namesAsRival(a, b) || namesAsRival(b, a) || setTheSameOfSections(a, b);
}

std::string rivalProblem(std::string_view a, const Scenario& ofA, std::string_view b, const Scenario& ofB) {
    if (areRivals(a, b)) return std::string(sameThing);
    const Parameter* one = findParameter(a);
    const Parameter* other = findParameter(b);
    return one && other ? meetingProblem(*one, ofA, *other, ofB) : std::string();
}

Assignments::Assignments(const std::vector<std::string_view>& keys) {
    for (const std::string_view key : keys) add(key);
}

void Assignments::add(std::string_view key) {
    const auto later = std::ranges::upper_bound(m_order, rankOf(key), {},
                                                [this](std::size_t i) { return rankOf(*m_keys[i]); });
    m_order.insert(later, m_keys.size());
    for (std::size_t before = 0; before < m_keys.size(); ++before) {
        if (!m_keys[before]) continue;
        if (areRivals(*m_keys[before], key)) m_rivals.emplace_back(before, m_keys.size());
        if (mayMeet(*m_keys[before], key)) m_mayMeet.emplace_back(before, m_keys.size());
    }
    m_keys.emplace_back(key);
}

void Assignments::skip() {
    m_keys.emplace_back();
}

std::optional<RivalPair> Assignments::rivals(const IsSet& isSet) const {
    for (const auto& [a, b] : m_rivals)
        if (!isSet || (isSet(a) && isSet(b))) return RivalPair{a, b, std::string(sameThing)};
    return std::nullopt;
}

std::optional<RivalPair> Assignments::meeting(const Scenario& scenario, const IsSet& isSet) const {
    for (const auto& [a, b] : m_mayMeet) {
        if (isSet && !(isSet(a) && isSet(b))) continue;
        std::string problem = rivalProblem(*m_keys[a], scenario, *m_keys[b], scenario);
        if (!problem.empty()) return RivalPair{a, b, std::move(problem)};
    }
    return std::nullopt;
}

bool Assignments::movesPulse(std::size_t number) const {
    assert(number < m_keys.size());
    const std::string_view key = m_keys[number].value_or("");
    return std::ranges::any_of(std::array{"pulse.", "rod.", "hammer.", "material.", "string."},
                               [&](const char* section) { return key.starts_with(section); });
}

bool Assignments::movePulse() const {
    return std::ranges::any_of(m_order, [this](std::size_t number) { return movesPulse(number); });
}

}  // namespace drillwave
