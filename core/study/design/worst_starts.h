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

/// Point in the box spanned by the ranges of the uncertain inputs. Each coordinate runs from 0 (lower end of
/// the range) to 1 (upper end).
using Place = std::vector<double>;

/// Number of starting points on each face of the box, in a search for worst cases. The box consists of the
/// ranges of the uncertain inputs.
inline constexpr std::uint64_t faceSamples = 512;

/// Numbered sequence of starting points of a search for worst cases: samples, then points on the faces of the
/// box, then its corners. Values where the problem expects worst cases count as further faces and corners.
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

/// List of the worst points found so far, the worst first. No two of them are close together, so that
/// searches started from them do not all find the same optimum. Among equal values the first is kept.
class WorstPlaces {
  public:
    struct Found {
        double badness;
        double value;
        Place place;
    };
    /// Makes an empty list for at most `most` points.
    explicit WorstPlaces(std::size_t most) : m_most(most) {}
    /// Adds a point with the output `value` if it is among the worst; a larger `badness` is worse. Calls
    /// `placeOf()` for its coordinates only if they are needed. Ignores NaN.
    void add(double badness, double value, const std::function<Place()>& placeOf);
    const std::vector<Found>& found() const { return m_found; }

  private:
    std::size_t m_most;
    std::vector<Found> m_found;
};

}  // namespace drillwave
