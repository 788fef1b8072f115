// SPDX-License-Identifier: GPL-3.0-or-later
// Where searches for worst cases begin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/sobol_points.h"

namespace drillwave {

/// Place in the box of the uncertain numbers, 0 … 1 along each coordinate.
using Place = std::vector<double>;

/// Points on every face of the box.
inline constexpr std::uint64_t faceSamples = 512;

/// Places to begin with, one after another by number: samples, then faces, then corners, each also where the
/// problem thinks worst cases likely.
class WorstStarts {
  public:
    WorstStarts(const DesignProblem& problem, std::uint64_t design, std::uint64_t samples,
                std::uint64_t seed);

    std::uint64_t count() const { return m_samples + m_faces.size() * faceSamples + m_corners; }
    bool isSample(std::uint64_t number) const { return number < m_samples; }
    Place place(std::uint64_t number) const;

  private:
    std::vector<Distribution> m_distributions;
    std::uint64_t m_samples;
    SobolPoints m_points;
    std::vector<std::vector<double>> m_ends;  // of each coordinate, and likely places
    std::vector<std::pair<std::size_t, double>> m_faces;
    std::uint64_t m_corners = 0;
};

/// The worst places so far, the worst first, no two of them near each other: otherwise all searches may begin
/// in one dip and miss a lower one. Among equals, the first one.
class WorstPlaces {
  public:
    struct Found {
        double badness;
        double value;
        Place place;
    };
    /// Keeps at most `most` places.
    explicit WorstPlaces(std::size_t most) : m_most(most) {}
    /// Calls `placeOf()` only if needed; ignores NaN.
    void add(double badness, double value, const std::function<Place()>& placeOf);
    const std::vector<Found>& found() const { return m_found; }

  private:
    std::size_t m_most;
    std::vector<Found> m_found;
};

}  // namespace drillwave
