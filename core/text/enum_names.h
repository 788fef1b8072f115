// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the values of an enumeration. That each has one is checked when it is compiled.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace drillwave {

/// Whether an enumerator has that value: the compiler writes others as a number behind a cast, "(Method)3".
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

/// Returns the number of values of an enumeration, which count up from 0.
template <class Enum>
inline constexpr std::size_t valueCount = countValues<Enum>();

/// Returns all values in their order.
template <class Enum>
inline constexpr std::array<Enum, valueCount<Enum>> allValues = [] {
    std::array<Enum, valueCount<Enum>> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
    return values;
}();

/// A name of each value, as it stands in files or on the command line:
/// `constexpr EnumNames<Method> names{{{Method::exact, "exact"}, {Method::lattice, "lattice"}}};`
template <class Enum>
class EnumNames {
  public:
    struct Row {
        Enum value;
        std::string_view name;
    };

    /// In the order of the values, none left out.
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

    /// The first value of that name.
    constexpr std::optional<Enum> find(std::string_view name) const {
        const auto found = std::ranges::find(m_names, name);
        if (found == m_names.end()) return std::nullopt;
        return allValues<Enum>[static_cast<std::size_t>(found - m_names.begin())];
    }

    /// Returns all names in the order of the values.
    constexpr std::span<const std::string_view> all() const { return m_names; }

  private:
    std::array<std::string_view, valueCount<Enum>> m_names{};
};

}  // namespace drillwave
