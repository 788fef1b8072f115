// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/assignments.h"

#include <algorithm>
#include <cassert>

#include "core/model/parameter.h"

namespace drillwave {
namespace {

/// Place in the table of parameters, from 1; 0 for what is not in it.
std::ptrdiff_t rankOf(std::string_view key) {
    const Parameter* parameter = findParameter(key);
    return parameter ? parameter - parameters().data() + 1 : 0;
}

bool namesAsRival(std::string_view a, std::string_view b) {
    const Parameter* parameter = findParameter(a);
    return parameter && !b.empty() && parameter->rules.rival == b;
}

}  // namespace

bool areRivals(std::string_view a, std::string_view b) {
    return a == b || namesAsRival(a, b) || namesAsRival(b, a);
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
    return key.starts_with("pulse.") || key.starts_with("rod.");
}

bool Assignments::movePulse() const {
    return std::ranges::any_of(m_order, [this](std::size_t number) { return movesPulse(number); });
}

}  // namespace drillwave
