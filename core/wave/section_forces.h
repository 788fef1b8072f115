// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in one section of a hammer or a string.
#pragma once

#include <array>
#include <cstddef>

namespace drillwave {

// The four largest loads of a rod or a section, and what there is of each.

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

/// Returns `map` of each load.
template <class T>
auto eachOf(const OfLoads<T>& from, const auto& map) -> OfLoads<decltype(map(from.compression))> {
    return {map(from.compression), map(from.tension), map(from.compressionAfter), map(from.tensionAfter)};
}

/// Largest force of one sign in a section, and its place; in a cone that of the largest stress.
struct SectionPeak {
    double force = 0;  ///< [F0], of either sign ≥ 0
    double place = 0;  ///< ξ in the section, 0 at its rear end … 1
    double time = 0;   ///< [t0]
};

/// Compression and tension of one section of hammer or string, as RodForces for a rod: while the blow lasts,
/// to one transit of the string after the last separation of bit and rock; and later, for at least a round
/// trip of the string, unless an end time or the next blow is earlier.
using SectionForces = OfLoads<SectionPeak>;

}  // namespace drillwave
