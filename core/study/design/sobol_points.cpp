// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/sobol_points.h"

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>
#include <cassert>

namespace drillwave {

namespace {

constexpr std::size_t mostBits = 21;  // of the number of a point

std::uint64_t splitMix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

std::uint64_t seedOf(std::uint64_t seed, std::size_t replicate, std::size_t coordinate) {
    std::uint64_t state = seed;
    state = splitMix(state) ^ replicate;
    state = splitMix(state) ^ coordinate;
    return state;
}

/// Digits each mixed with random ones of those before them (Matoušek 1998): intervals keep their points, but
/// where in its interval a point is differs from point to point. A shift alone has all of a replicate at one
/// place of their intervals, and the error of a mean falls no faster than 1/n.
class DigitMixer {
  public:
    explicit DigitMixer(std::uint64_t state) : m_shift(splitMix(state)) {
        for (std::size_t digit = 0; digit < m_takes.size(); ++digit) {
            const std::uint64_t own = std::uint64_t{1} << (63 - digit);
            const std::uint64_t before = ~((own << 1) - 1) & (digit == 0 ? 0 : ~std::uint64_t{0});
            m_takes[digit] = own | (splitMix(state) & before);
        }
    }
    std::uint64_t shift() const { return m_shift; }
    std::uint64_t operator()(std::uint64_t digits) const {
        std::uint64_t mixed = 0;
        for (const std::uint64_t takes : m_takes)
            mixed = mixed << 1 | static_cast<std::uint64_t>(std::popcount(digits & takes) & 1);
        return mixed;
    }

  private:
    std::uint64_t m_shift;
    std::array<std::uint64_t, 64> m_takes{};
};

/// (X + ½)/2^64 rounded down: 1 itself must not come.
double inUnit(std::uint64_t digits) {
    return (static_cast<double>(digits >> 11) + 0.5) * 0x1p-53;
}

}  // namespace

SobolPoints::SobolPoints(std::size_t dimensions, std::uint64_t seed) : m_dimensions(dimensions) {
    assert(dimensions > 0 && dimensions <= mostDimensions);
    // Boost's sequence begins at point 1; point 2^j is V_j ⊕ V_(j−1) of the direction numbers, in Gray's
    // order.
    boost::random::sobol engine(dimensions);
    std::vector<std::uint64_t> directions(dimensions * mostBits);
    for (std::size_t bit = 0; bit < mostBits; ++bit) {
        engine.seed((std::uint64_t{1} << bit) - 1);
        for (std::size_t i = 0; i < dimensions; ++i) {
            const auto point = static_cast<std::uint64_t>(engine());
            directions[bit * dimensions + i] =
                point ^ (bit == 0 ? 0 : directions[(bit - 1) * dimensions + i]);
        }
    }
    for (std::size_t r = 0; r < replicateCount; ++r) {
        std::vector<DigitMixer> mixers;
        for (std::size_t i = 0; i < dimensions; ++i) mixers.emplace_back(seedOf(seed, r, i));
        for (std::size_t n = 0; n < directions.size(); ++n)
            m_directions.push_back(mixers[n % dimensions](directions[n]));
        for (const DigitMixer& mixer : mixers) m_shifts.push_back(mixer.shift());
    }
}

void SobolPoints::point(std::size_t replicate, std::uint64_t n, std::span<double> u) const {
    assert(replicate < replicateCount && n >> mostBits == 0 && u.size() == m_dimensions);
    const std::uint64_t gray = n ^ (n >> 1);
    const std::uint64_t* directions = m_directions.data() + replicate * mostBits * m_dimensions;
    for (std::size_t i = 0; i < m_dimensions; ++i) {
        std::uint64_t digits = m_shifts[replicate * m_dimensions + i];
        for (std::size_t bit = 0; gray >> bit != 0; ++bit)
            if (gray >> bit & 1) digits ^= directions[bit * m_dimensions + i];
        u[i] = inUnit(digits);
    }
}

}  // namespace drillwave
