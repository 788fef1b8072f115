// SPDX-License-Identifier: GPL-3.0-or-later
// The largest forces in one section of a hammer or a string.
#pragma once

#include <array>
#include <cstddef>

namespace drillwave {

// The four largest loads of a rod or a section, and a container with one value for each of them.

/// Four kinds of largest load: the compression and tension while the blow lasts, and the compression and
/// tension of the residual waves after it.
enum class Load : std::size_t { compression, tension, compressionAfter, tensionAfter };
inline constexpr std::array loads{Load::compression, Load::tension, Load::compressionAfter,
                                  Load::tensionAfter};

/// Returns whether the load is a tension, during or after the blow.
constexpr bool isTension(Load load) {
    return load == Load::tension || load == Load::tensionAfter;
}
/// Returns whether the load is caused by the residual waves after the blow.
constexpr bool isAfter(Load load) {
    return load == Load::compressionAfter || load == Load::tensionAfter;
}

/// Container of four values of type T, one for each load (compression or tension, during or after the blow).
/// They are accessible by name or by operator[] with a Load.
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

/// Applies the function `map` to each of the four values in `from`, and returns the four results. There is
/// one value for each load: compression and tension, during and after the blow.
template <class T>
auto eachOf(const OfLoads<T>& from, const auto& map) -> OfLoads<decltype(map(from.compression))> {
    return {map(from.compression), map(from.tension), map(from.compressionAfter), map(from.tensionAfter)};
}

/// Largest compressive or tensile force in a section of hammer or string, with its position and time. In a
/// conical section it is the force at the largest stress.
struct SectionPeak {
    /// Magnitude of the largest compressive or tensile force, in units of F0; ≥ 0.
    double force = 0;
    /// Position ξ of the largest force along the section: 0 at its rear end, 1 at its front end.
    double place = 0;
    /// Time of the largest force since the start of the blow, in units of t0.
    double time = 0;
};

/// Largest compression and tension of one section of hammer or string, during and after the blow. The blow
/// lasts until one transit of the string after the last separation of bit and rock. The loads after the blow
/// are searched over at least one round trip of the string, unless an end time or the next blow is earlier.
using SectionForces = OfLoads<SectionPeak>;

}  // namespace drillwave
