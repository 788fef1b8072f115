// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the values of an enumeration. The compiler checks that every value has a name.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace drillwave {

/// Returns whether an enumeration has an enumerator of this value. It looks at the text that the compiler
/// writes for the value: a name, or for any other value a number after a cast, "(Method)3".
template <auto value>
consteval bool isEnumerator() {
    constexpr std::string_view before = "value = ";
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.rfind(before) + before.size());
    const std::size_t cast = text.rfind(')');
    return cast == std::string_view::npos || text[cast + 1] == ':';  // "(anonymous namespace)::" is no cast
}

template <class Enum, std::size_t first = 0>
consteval std::size_t countValues() {
    if constexpr (isEnumerator<static_cast<Enum>(first)>())
        return countValues<Enum, first + 1>();
    else
        return first;
}

/// Number of values of an enumeration. The values must count up from 0 without gaps.
template <class Enum>
inline constexpr std::size_t valueCount = countValues<Enum>();

/// Array of all values of an enumeration, ascending from 0.
template <class Enum>
inline constexpr std::array<Enum, valueCount<Enum>> allValues = [] {
    std::array<Enum, valueCount<Enum>> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
    return values;
}();

/// Table of the names of an enumeration, as files and the command line write them:
/// `constexpr EnumNames<Method> names{{{Method::exact, "exact"}, {Method::lattice, "lattice"}}};`
template <class Enum>
class EnumNames {
  public:
    struct Row {
        Enum value;
        std::string_view name;
    };

    /// Makes the table from one pair of value and name for each value of the enumeration. The pairs must be
    /// in the order of the values and complete; otherwise the code does not compile.
    template <std::size_t count>
    consteval EnumNames(const Row (&rows)[count]) {
        static_assert(count == valueCount<Enum>, "every value of an enumeration has one name");
        for (std::size_t i = 0; i < count; ++i) {
            if (rows[i].value != allValues<Enum>[i]) throw "names stand in the order of the values";
            m_names[i] = rows[i].name;
        }
    }

    constexpr std::string_view operator[](Enum value) const {
        assert(static_cast<std::size_t>(value) < m_names.size());
        return m_names[static_cast<std::size_t>(value)];
    }

    /// Returns the value with this name, the first one if several have it, or nullopt.
    constexpr std::optional<Enum> find(std::string_view name) const {
        const auto found = std::ranges::find(m_names, name);
        if (found == m_names.end()) return std::nullopt;
        return allValues<Enum>[static_cast<std::size_t>(found - m_names.begin())];
    }

    /// Returns the names of all values, in the order of the values.
    constexpr std::span<const std::string_view> all() const { return m_names; }

  private:
    std::array<std::string_view, valueCount<Enum>> m_names{};
};

}  // namespace drillwave
