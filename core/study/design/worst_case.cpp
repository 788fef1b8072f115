// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/study/design/adapted_search.h"
#include "core/study/design/design_samples.h"
#include "core/study/design/sobol_points.h"
#include "core/study/design/worst_starts.h"

namespace drillwave {

namespace {

/// Tried where no coordinate leads on, and from how many they are taken.
constexpr std::uint64_t directionsOfStep = 64, mostDirections = std::uint64_t{1} << 20;
/// Most blows of a search, for each sample: along a curved ridge it would creep on.
constexpr std::uint64_t solvesOfSample = 4;
/// Adapting steps from where a search has ended, for each coordinate, from far and from near.
constexpr int stepsOfPolish = 200;
constexpr double firstStep = 0.05, lastStep = 1e-7;
/// Searches that end as near as this found the same.
constexpr double agreement = 1e-6;
constexpr double unfound = std::numeric_limits<double>::quiet_NaN();

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
        if (!m_solver->solve(m_design, m_values, m_outputs, stop).isEmpty())
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

/// One search: where it begins, and where it has ended.
struct Search {
    std::size_t order = 0;
    Place place;
    double value = 0;
    std::uint64_t solves = 0;
    std::size_t number = 0;  ///< from which random steps follow
};

/// Searches from one place: steps to the worst neighbour while there is one, then halves the step; in the end
/// climbs with steps that adapt, once from far and once from near.
class Searcher {
  public:
    Searcher(const DesignProblem& problem, std::uint64_t design, const std::vector<WorstOrder>& orders,
             std::uint64_t samples)
        : m_mostSolves(solvesOfSample * samples),
          m_solver(problem, design),
          m_orders(orders),
          m_directions(problem.distributions(design).size(), 1),
          m_direction(m_directions.dimensions()) {}

    void operator()(Search& search, const std::stop_token& stop) {
        for (double step = firstStep; step >= lastStep && search.solves <= m_mostSolves;) {
            if (stop.stop_requested()) return;
            step = goOn(search, step, stop) ? std::min(2 * step, firstStep) : step / 2;
        }
        polish(search, stop);
    }

  private:
    void polish(Search& search, const std::stop_token& stop) {
        const WorstOrder& order = m_orders[search.order];
        Place whole = search.place, moved;
        std::vector<std::size_t> movable;
        for (std::size_t i = 0; i < whole.size(); ++i)
            if (m_solver.canMove(i)) movable.push_back(i), moved.push_back(whole[i]);
        if (movable.empty()) return;
        const auto put = [&](const Place& from, Place& into) {
            for (std::size_t i = 0; i < movable.size(); ++i) into[movable[i]] = from[i];
        };
        const auto badnessAt = [&](const Place& place) {
            put(place, whole);
            return badness(order, m_solver.solve(whole, stop)[order.output]);
        };
        double most = badness(order, search.value);
        for (const double spread : {0.05, 0.003}) {
            const AdaptedSearch adapted{.spread = spread,
                                        .steps = stepsOfPolish * static_cast<int>(movable.size()),
                                        .seed = search.number + 1};
            search.solves += static_cast<std::uint64_t>(climb(moved, most, badnessAt, adapted, stop));
        }
        put(moved, search.place);
        search.value = badness(order, most);
    }

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
        // Along a kink no single coordinate may lead on, but two together may, or other directions at every
        // step, dense in the end.
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
    const WorstStarts places(problem, design, samples, seed);
    std::vector<WorstPlaces> worst(orders.size(), WorstPlaces(worstSearches));
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
                worst[o].add(badness(orders[o], value), value, [&] { return places.place(n); });
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
            searches.push_back({o, begin.place, begin.value});
    std::vector<Search> ended;
    std::size_t begun = 0;
    const WorkEnd end = processInOrder<Search>(
        work.jobs, work.stop,
        [&](Search& search) {
            if (begun == searches.size()) return false;
            search = searches[begun];
            search.number = begun++;
            return true;
        },
        [&] { return Searcher(problem, design, orders, samples); },
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
