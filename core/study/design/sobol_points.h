// SPDX-License-Identifier: GPL-3.0-or-later
// Points that fill a box evenly: a Sobol sequence in several replicates, each with its own digital shift.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace drillwave {

/// Number of replicates (independently randomised copies) of a set of sample points. The scatter between them
/// gives the error of a statistic.
inline constexpr std::size_t replicateCount = 8;

/// Sobol points in several replicates (independently randomised copies). A coordinate of point n in replicate
/// r is u = (MX ⊕ s + ½)/2^64. X is the Sobol sequence of Joe and Kuo, including its point 0. The digital
/// shift s and the digit mixing M come from SplitMix64 with the seed, r and the coordinate. Points can be
/// computed in any order.
class SobolPoints {
  public:
    /// Requires 1 … mostDimensions dimensions. Each replicate (randomised copy) has at most 2^20 points.
    SobolPoints(std::size_t dimensions, std::uint64_t seed);

    static constexpr std::size_t mostDimensions = 32;

    std::size_t dimensions() const { return m_dimensions; }
    /// Writes the coordinates of point n of a replicate (both from 0) to `u`. Every coordinate lies in (0,
    /// 1).
    void point(std::size_t replicate, std::uint64_t n, std::span<double> u) const;

  private:
    std::size_t m_dimensions;
    std::vector<std::uint64_t> m_directions;  // direction numbers, by replicate, bit and coordinate
    std::vector<std::uint64_t> m_shifts;      // digital shifts, replicate by replicate
};

}  // namespace drillwave
