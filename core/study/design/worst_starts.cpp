// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/worst_starts.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

constexpr std::uint64_t mostCorners = 16384;
/// Along any coordinate of the box.
constexpr double apart = 0.1;

double distance(const Place& one, const Place& other) {
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, std::abs(one[i] - other[i]));
    return largest;
}

}  // namespace

WorstStarts::WorstStarts(const DesignProblem& problem, std::uint64_t design, std::uint64_t samples,
                         std::uint64_t seed)
    : m_distributions(problem.distributions(design)),
      m_samples(samples),
      m_points(m_distributions.size(), seed) {
    const std::size_t d = m_distributions.size();
    bool hasBox = true;
    for (std::size_t i = 0; i < d; ++i) {
        std::vector<double>& ends = m_ends.emplace_back();
        hasBox &= m_distributions[i].hasBox();
        if (!m_distributions[i].hasBox()) continue;
        ends = {0, 1};
        for (const double value : problem.likelyPlaces(design, i))
            ends.push_back(m_distributions[i].boxPlace(value));
        for (const double end : ends) m_faces.emplace_back(i, end);
    }
    m_corners = hasBox ? 1 : 0;
    for (const std::vector<double>& ends : m_ends) m_corners *= std::max<std::size_t>(ends.size(), 1);
    // The ends alone where likely places make too many.
    if (m_corners > mostCorners) {
        for (std::vector<double>& ends : m_ends) ends.resize(2);
        m_corners = std::uint64_t{1} << d;
    }
}

Place WorstStarts::place(std::uint64_t number) const {
    Place place(m_distributions.size());
    if (number < m_samples) {
        const std::uint64_t each = m_samples / replicateCount;
        m_points.point(number / each, number % each, place);
        return place;
    }
    number -= m_samples;
    if (number < m_faces.size() * faceSamples) {
        const auto& [coordinate, end] = m_faces[number / faceSamples];
        m_points.point(0, number % faceSamples, place);
        place[coordinate] = end;
        return place;
    }
    number -= m_faces.size() * faceSamples;
    for (std::size_t i = 0; i < place.size(); number /= m_ends[i++].size())
        place[i] = m_ends[i][number % m_ends[i].size()];
    return place;
}

void WorstPlaces::add(double badness, double value, const std::function<Place()>& placeOf) {
    if (std::isnan(badness)) return;
    if (m_found.size() == m_most && badness <= m_found.back().badness) return;
    Found found{badness, value, placeOf()};
    const auto isNear = [&](const Found& other) { return distance(other.place, found.place) < apart; };
    const auto at =
        std::ranges::find_if(m_found, [&](const Found& other) { return badness > other.badness; });
    if (std::any_of(m_found.begin(), at, isNear)) return;
    const auto index = at - m_found.begin();
    m_found.erase(std::remove_if(at, m_found.end(), isNear), m_found.end());
    m_found.insert(m_found.begin() + index, std::move(found));
    if (m_found.size() > m_most) m_found.pop_back();
}

}  // namespace drillwave
