// SPDX-License-Identifier: GPL-3.0-or-later
// Points that fill a box evenly: a Sobol sequence in replicates, each shifted by digits of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace drillwave {

/// Replicates of every set of points: their scatter gives the error of a statistic.
inline constexpr std::size_t replicateCount = 8;

/// u = (MX ⊕ s + ½)/2^64 for each coordinate of a point n of replicate r: X is the Sobol sequence of Joe and
/// Kuo with its point 0; the digital shift s and the mixing M of its digits are by SplitMix64 from seed, r
/// and the coordinate. A point only needs its number, not those before it.
class SobolPoints {
  public:
    /// Requires at most mostDimensions; a replicate has up to 2^20 points.
    SobolPoints(std::size_t dimensions, std::uint64_t seed);

    static constexpr std::size_t mostDimensions = 32;

    std::size_t dimensions() const { return m_dimensions; }
    /// Puts the point n of replicate r into `u`, every coordinate in (0, 1).
    void point(std::size_t replicate, std::uint64_t n, std::span<double> u) const;

  private:
    std::size_t m_dimensions;
    std::vector<std::uint64_t> m_directions;  // by replicate, bit and coordinate
    std::vector<std::uint64_t> m_shifts;      // replicate by replicate
};

}  // namespace drillwave
