// SPDX-License-Identifier: GPL-3.0-or-later
// The four largest loads of a rod or a section, and what there is of each.
#pragma once

#include <array>
#include <cstddef>

namespace drillwave {

/// While the blow lasts, or later, of the waves it leaves.
enum class Load : std::size_t { compression, tension, compressionAfter, tensionAfter };
inline constexpr std::array loads{Load::compression, Load::tension, Load::compressionAfter,
                                  Load::tensionAfter};

constexpr bool isTension(Load load) {
    return load == Load::tension || load == Load::tensionAfter;
}
constexpr bool isAfter(Load load) {
    return load == Load::compressionAfter || load == Load::tensionAfter;
}

template <class T>
struct OfLoads {
    T compression = {}, tension = {}, compressionAfter = {}, tensionAfter = {};

    T& operator[](Load load) { return this->*members[static_cast<std::size_t>(load)]; }
    const T& operator[](Load load) const { return this->*members[static_cast<std::size_t>(load)]; }
    bool operator==(const OfLoads&) const = default;

  private:
    static constexpr T OfLoads::*members[] = {&OfLoads::compression, &OfLoads::tension,
                                              &OfLoads::compressionAfter, &OfLoads::tensionAfter};
};

/// What `map` makes of each.
template <class T>
auto eachOf(const OfLoads<T>& from, const auto& map) -> OfLoads<decltype(map(from.compression))> {
    return {map(from.compression), map(from.tension), map(from.compressionAfter), map(from.tensionAfter)};
}

}  // namespace drillwave
