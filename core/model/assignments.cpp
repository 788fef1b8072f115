// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/assignments.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>

#include "core/model/section_parameter.h"

namespace drillwave {
namespace {

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

bool namesAsRival(std::string_view a, std::string_view b) {
    const Parameter* parameter = findParameter(a);
    return parameter && !b.empty() && parameter->rules.rival == b;
}

}  // namespace

bool areRivals(std::string_view a, std::string_view b) {
    return a == b || namesAsRival(a, b) || namesAsRival(b, a) || setTheSameOfSections(a, b);
}

Assignments::Assignments(const std::vector<std::string_view>& keys) {
    for (const std::string_view key : keys) add(key);
}

void Assignments::add(std::string_view key) {
    const auto later = std::ranges::upper_bound(m_order, rankOf(key), {},
                                                [this](std::size_t i) { return rankOf(*m_keys[i]); });
    m_order.insert(later, m_keys.size());
    m_keys.emplace_back(key);
}

void Assignments::skip() {
    m_keys.emplace_back();
}

bool Assignments::contradict(std::size_t a, std::size_t b) const {
    assert(a < m_keys.size() && b < m_keys.size());
    return m_keys[a] && m_keys[b] && areRivals(*m_keys[a], *m_keys[b]);
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
