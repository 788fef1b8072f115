// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/study/design/design_samples.h"
#include "core/study/design/sobol_points.h"

namespace drillwave {

namespace {

constexpr std::uint64_t faceSamples = 512;
/// Tried where no coordinate leads on, and from how many they are taken.
constexpr std::uint64_t directionsOfStep = 64, mostDirections = std::uint64_t{1} << 20;
/// Most blows of a search, for each sample: along a curved ridge it would creep on.
constexpr std::uint64_t solvesOfSample = 4;
constexpr double firstStep = 0.05, lastStep = 1e-7;
/// Searches that end as near as this found the same.
constexpr double agreement = 1e-6;
constexpr double unfound = std::numeric_limits<double>::quiet_NaN();

using Place = std::vector<double>;  // in the box, 0 … 1 along each coordinate

double badness(const WorstOrder& order, double value) {
    return order.towards == Sense::largest ? value : -value;
}

/// Solves at places in the box. One for each thread.
class BoxSolver {
  public:
    BoxSolver(const DesignProblem& problem, std::uint64_t design)
        : m_design(design),
          m_distributions(problem.distributions(design)),
          m_solver(problem.solver()),
          m_values(m_distributions.size()),
          m_outputs(problem.outputCount()) {}

    std::vector<double> valuesAt(const Place& place) const {
        std::vector<double> values(place.size());
        for (std::size_t i = 0; i < place.size(); ++i) values[i] = m_distributions[i].inBox(place[i]);
        return values;
    }
    /// All outputs, not a number where it could not be solved.
    std::span<const double> solve(const Place& place, const std::stop_token& stop) {
        for (std::size_t i = 0; i < place.size(); ++i) m_values[i] = m_distributions[i].inBox(place[i]);
        if (!m_solver->solve(m_design, m_values, m_outputs, stop).empty())
            std::ranges::fill(m_outputs, unfound);
        return m_outputs;
    }
    bool canMove(std::size_t i) const { return m_distributions[i].hasBox(); }

  private:
    std::uint64_t m_design;
    std::vector<Distribution> m_distributions;
    std::unique_ptr<DesignSolver> m_solver;
    std::vector<double> m_values, m_outputs;
};

/// Places to begin with, one after another by number: samples, then faces, then corners.
class FirstPlaces {
  public:
    FirstPlaces(const DesignProblem& problem, std::uint64_t design, std::uint64_t samples, std::uint64_t seed)
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

    std::uint64_t count() const { return m_samples + m_faces.size() * faceSamples + m_corners; }
    bool isSample(std::uint64_t number) const { return number < m_samples; }

    Place place(std::uint64_t number) const {
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

  private:
    static constexpr std::uint64_t mostCorners = 16384;

    std::vector<Distribution> m_distributions;
    std::uint64_t m_samples;
    SobolPoints m_points;
    std::vector<std::vector<double>> m_ends;
    std::vector<std::pair<std::size_t, double>> m_faces;
    std::uint64_t m_corners = 0;
};

/// The worst places so far, the worst first; of equals the one that came first.
class WorstPlaces {
  public:
    struct Found {
        double badness;
        double value;
        std::uint64_t number;
    };
    void add(const Found& found) {
        if (std::isnan(found.badness)) return;
        const auto at =
            std::ranges::find_if(m_found, [&](const Found& other) { return found.badness > other.badness; });
        m_found.insert(at, found);
        if (m_found.size() > worstSearches) m_found.pop_back();
    }
    const std::vector<Found>& found() const { return m_found; }

  private:
    std::vector<Found> m_found;
};

/// One search: where it begins, and where it has ended.
struct Search {
    std::size_t order = 0;
    Place place;
    double value = 0;
    std::uint64_t solves = 0;
};

/// Steps to the worst neighbour while there is one, then halves the step.
class Compass {
  public:
    Compass(const DesignProblem& problem, std::uint64_t design, const std::vector<WorstOrder>& orders,
            std::uint64_t samples)
        : m_mostSolves(solvesOfSample * samples),
          m_solver(problem, design),
          m_orders(orders),
          m_directions(problem.distributions(design).size(), 1),
          m_direction(m_directions.dimensions()) {}

    void operator()(Search& search, const std::stop_token& stop) {
        for (double step = firstStep; step >= lastStep;) {
            if (stop.stop_requested()) return;
            if (search.solves > m_mostSolves) return;
            step = goOn(search, step, stop) ? std::min(2 * step, firstStep) : step / 2;
        }
    }

  private:
    bool goOn(Search& search, double step, const std::stop_token& stop) {
        Place best = search.place;
        double value = search.value;
        const auto attempt = [&](Place place) {
            if (place == search.place) return;
            ++search.solves;
            const WorstOrder& order = m_orders[search.order];
            const double there = m_solver.solve(place, stop)[order.output];
            if (!(badness(order, there) > badness(order, value))) return;
            value = there;
            best = std::move(place);
        };
        const auto moved = [&](Place place, std::size_t i, double by) {
            place[i] = std::clamp(place[i] + by, 0.0, 1.0);
            return place;
        };
        const std::size_t d = search.place.size();
        for (std::size_t i = 0; i < d; ++i)
            for (const double by : {-step, step})
                if (m_solver.canMove(i)) attempt(moved(search.place, i, by));
        // Along a kink no coordinate may lead on alone, but two, or other directions at every step, in the
        // end dense.
        for (std::size_t i = 0; i < d && best == search.place; ++i)
            for (std::size_t j = i + 1; j < d; ++j)
                for (const double a : {-step, step})
                    for (const double b : {-step, step})
                        if (m_solver.canMove(i) && m_solver.canMove(j))
                            attempt(moved(moved(search.place, i, a), j, b));
        if (best == search.place)
            for (std::uint64_t i = 0; i < directionsOfStep; ++i) {
                Place place = search.place;
                m_directions.point(0, 1 + (search.solves + i) % mostDirections, m_direction);
                for (std::size_t c = 0; c < d; ++c)
                    if (m_solver.canMove(c)) place = moved(place, c, step * (2 * m_direction[c] - 1));
                attempt(place);
            }
        if (best == search.place) return false;
        search.place = std::move(best);
        search.value = value;
        return true;
    }

    std::uint64_t m_mostSolves;
    BoxSolver m_solver;
    const std::vector<WorstOrder>& m_orders;
    SobolPoints m_directions;
    std::vector<double> m_direction;
};

struct PlaceBlock {
    std::uint64_t begin = 0, end = 0;
    std::vector<double> values;  // of each order at each place
};

}  // namespace

std::uint64_t worstSolves(std::size_t uncertain, std::uint64_t samples) {
    return samples + 2 * uncertain * faceSamples + (std::uint64_t{1} << uncertain);
}

std::vector<std::optional<WorstCase>> worstCases(const DesignProblem& problem, std::uint64_t design,
                                                 const std::vector<WorstOrder>& orders, std::uint64_t samples,
                                                 std::uint64_t seed, const DesignWork& work) {
    const FirstPlaces places(problem, design, samples, seed);
    std::vector<WorstPlaces> worst(orders.size());
    std::vector<double> sampled(orders.size(), unfound);
    std::uint64_t next = 0;
    const auto fill = [&](PlaceBlock& block) {
        block.begin = next;
        next = block.end = std::min(next + pointsOfBlock, places.count());
        return block.begin < block.end;
    };
    const auto makeWorker = [&] {
        return
            [&, solver = BoxSolver(problem, design)](PlaceBlock& block, const std::stop_token& stop) mutable {
                block.values.clear();
                for (std::uint64_t n = block.begin; n < block.end && !stop.stop_requested(); ++n) {
                    const std::span<const double> outputs = solver.solve(places.place(n), stop);
                    for (const WorstOrder& order : orders) block.values.push_back(outputs[order.output]);
                }
            };
    };
    const auto deliver = [&](const PlaceBlock& block) {
        for (std::uint64_t n = block.begin; n < block.end; ++n)
            for (std::size_t o = 0; o < orders.size(); ++o) {
                const double value = block.values[(n - block.begin) * orders.size() + o];
                worst[o].add({badness(orders[o], value), value, n});
                if (places.isSample(n) && !(badness(orders[o], value) <= badness(orders[o], sampled[o])) &&
                    !std::isnan(value))
                    sampled[o] = value;
            }
        work.tell(block.end - block.begin);
        return true;
    };
    std::vector<std::optional<WorstCase>> found(orders.size());
    if (processInOrder<PlaceBlock>(work.jobs, work.stop, fill, makeWorker, deliver) == WorkEnd::stopped)
        return found;

    std::vector<Search> searches;
    for (std::size_t o = 0; o < orders.size(); ++o)
        for (const WorstPlaces::Found& begin : worst[o].found())
            searches.push_back({o, places.place(begin.number), begin.value});
    std::vector<Search> ended;
    std::size_t begun = 0;
    const WorkEnd end = processInOrder<Search>(
        work.jobs, work.stop,
        [&](Search& search) {
            if (begun == searches.size()) return false;
            search = searches[begun++];
            return true;
        },
        [&] { return Compass(problem, design, orders, samples); },
        [&](const Search& search) {
            ended.push_back(search);
            work.tell(search.solves);
            return true;
        });
    if (end == WorkEnd::stopped) return found;
    const BoxSolver box(problem, design);
    for (const Search& search : ended) {
        std::optional<WorstCase>& best = found[search.order];
        const WorstOrder& order = orders[search.order];
        if (best && badness(order, search.value) <= badness(order, best->value)) continue;
        best = {.value = search.value, .at = box.valuesAt(search.place), .sampled = sampled[search.order]};
    }
    for (const Search& search : ended) {
        WorstCase& best = *found[search.order];
        ++best.searches;
        best.agreeing += std::abs(search.value - best.value) <= agreement * std::abs(best.value);
    }
    return found;
}

}  // namespace drillwave
