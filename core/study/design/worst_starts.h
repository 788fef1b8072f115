// SPDX-License-Identifier: GPL-3.0-or-later
// Starting points of searches for worst cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/study/design/design_problem.h"
#include "core/study/design/sobol_points.h"

namespace drillwave {

/// Point in the box of the uncertain inputs, with coordinates 0 … 1 from the lower to the upper end of each
/// range.
using Place = std::vector<double>;

/// Number of points tried on every face of the box.
inline constexpr std::uint64_t faceSamples = 512;

/// Numbered sequence of starting points of a search for worst cases: samples, then points on the faces, then
/// corners. Values where the problem expects worst cases count as further faces and corners.
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
    std::vector<std::vector<double>> m_ends;  // ends of each coordinate, followed by likely places
    std::vector<std::pair<std::size_t, double>> m_faces;
    std::uint64_t m_corners = 0;
};

/// List of the worst points found, the worst first. No two of them are close together, because otherwise all
/// searches could start in one dip and miss a lower one. Among equal values the first is kept.
class WorstPlaces {
  public:
    struct Found {
        double badness;
        double value;
        Place place;
    };
    /// Limits the list to `most` points.
    explicit WorstPlaces(std::size_t most) : m_most(most) {}
    /// Adds a point if it is among the worst. Calls `placeOf()` only if the point is added; ignores NaN.
    void add(double badness, double value, const std::function<Place()>& placeOf);
    const std::vector<Found>& found() const { return m_found; }

  private:
    std::size_t m_most;
    std::vector<Found> m_found;
};

}  // namespace drillwave
