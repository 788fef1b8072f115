// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/sensitivity.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/study/design/design_samples.h"
#include "core/study/design/statistic.h"

namespace drillwave {

namespace {

/// Rows of a block: at each point f(A), f(B) and f(AB_i) of every output.
struct IndexBlock {
    std::size_t replicate = 0;
    std::uint64_t begin = 0, end = 0;
    std::vector<double> values;
    std::vector<bool> solved;  // of each point
    Message reason;
};

/// Solves blocks. One for each thread.
class IndexMaker {
  public:
    IndexMaker(const DesignProblem& problem, std::uint64_t design, const std::vector<std::size_t>& outputs,
               const SobolPoints& points)
        : m_design(design),
          m_outputs(outputs),
          m_points(points),
          m_distributions(problem.distributions(design)),
          m_solver(problem.solver()),
          m_row(problem.outputCount()) {}

    void operator()(IndexBlock& block, const std::stop_token& stop) {
        const std::size_t d = m_distributions.size();
        const std::size_t width = (d + 2) * m_outputs.size();
        block.values.assign((block.end - block.begin) * width, 0);
        block.solved.assign(block.end - block.begin, true);
        block.reason = {};
        std::vector<double> u(2 * d), x(d);
        for (std::uint64_t n = block.begin; n < block.end; ++n) {
            m_points.point(block.replicate, n, u);
            double* values = block.values.data() + (n - block.begin) * width;
            for (std::size_t which = 0; which < d + 2; ++which) {
                if (stop.stop_requested()) return;
                for (std::size_t i = 0; i < d; ++i) {
                    const bool ofB = which == 1 || which == i + 2;
                    x[i] = m_distributions[i].quantile(u[ofB ? d + i : i]);
                }
                Message reason = m_solver->solve(m_design, x, m_row, stop);
                for (const std::size_t output : m_outputs) *values++ = m_row[output];
                if (reason.isEmpty()) continue;
                block.solved[n - block.begin] = false;
                if (block.reason.isEmpty()) block.reason = std::move(reason);
            }
        }
    }

  private:
    std::uint64_t m_design;
    const std::vector<std::size_t>& m_outputs;
    const SobolPoints& m_points;
    std::vector<Distribution> m_distributions;
    std::unique_ptr<DesignSolver> m_solver;
    std::vector<double> m_row;
};

/// Sums over the points of one replicate, of one output. Values are taken about the first of all points, so
/// that squares lose nothing.
struct IndexSums {
    double count = 0;
    double values = 0, squares = 0;                // of A and B
    std::vector<double> weighted, changes, jumps;  // of each coordinate: f(B)Δ, Δ, Δ²

    void add(const double* row, std::size_t stride, double origin) {
        const std::size_t d = weighted.size();
        const double a = row[0] - origin, b = row[stride] - origin;
        ++count;
        values += a + b;
        squares += a * a + b * b;
        for (std::size_t i = 0; i < d; ++i) {
            const double change = row[(i + 2) * stride] - origin - a;
            weighted[i] += b * change;
            changes[i] += change;
            jumps[i] += change * change;
        }
    }
    double mean() const { return values / (2 * count); }
    double variance() const { return squares / (2 * count) - mean() * mean(); }
    double first(std::size_t i) const { return (weighted[i] - mean() * changes[i]) / count / variance(); }
    double total(std::size_t i) const { return jumps[i] / (2 * count) / variance(); }
};

Estimate estimateOf(const std::array<double, replicateCount>& replicates) {
    double mean = 0;
    for (const double value : replicates) mean += value / static_cast<double>(replicateCount);
    return {mean, errorOf(replicates)};
}

/// Sums of all replicates of one output.
class OutputSums {
  public:
    explicit OutputSums(std::size_t coordinates) {
        for (IndexSums& sums : m_sums)
            sums = {.weighted = std::vector<double>(coordinates),
                    .changes = std::vector<double>(coordinates),
                    .jumps = std::vector<double>(coordinates)};
    }
    void add(std::size_t replicate, const double* row, std::size_t stride) {
        if (!m_begun) m_origin = row[0];
        m_begun = true;
        m_sums[replicate].add(row, stride, m_origin);
    }
    OutputSensitivity result() const {
        // of the mean squared: below it is rounding
        constexpr double constantBelow = 1e-20;
        OutputSensitivity found;
        const std::size_t d = m_sums.front().weighted.size();
        for (const IndexSums& sums : m_sums) {
            const double mean = sums.mean() + m_origin;
            found.isConstant |= !(sums.variance() > constantBelow * mean * mean);
        }
        for (std::size_t i = 0; i < d && !found.isConstant; ++i) {
            std::array<double, replicateCount> first{}, total{};
            for (std::size_t r = 0; r < replicateCount; ++r) {
                first[r] = m_sums[r].first(i);
                total[r] = m_sums[r].total(i);
            }
            found.indices.push_back({estimateOf(first), estimateOf(total)});
        }
        return found;
    }

  private:
    std::array<IndexSums, replicateCount> m_sums;
    double m_origin = 0;
    bool m_begun = false;
};

}  // namespace

std::uint64_t sensitivitySolves(std::size_t uncertain, std::uint64_t samples) {
    return uncertain == 1 ? 0 : (uncertain + 2) * samples;
}

Sensitivity sensitivityOf(const DesignProblem& problem, std::uint64_t design,
                          const std::vector<std::size_t>& outputs, std::uint64_t samples, std::uint64_t seed,
                          const DesignWork& work) {
    const std::size_t d = problem.distributions(design).size();
    Sensitivity found;
    if (d == 1) {
        found.outputs.assign(outputs.size(), {.indices = {{{1, 0}, {1, 0}}}});
        return found;
    }
    const SobolPoints points(2 * d, seed);
    const std::uint64_t each = samples / replicateCount;
    const std::uint64_t length = std::max<std::uint64_t>(1, pointsOfBlock / (d + 2));
    std::size_t replicate = 0;
    std::uint64_t begin = 0;
    const auto fill = [&](IndexBlock& block) {
        if (replicate == replicateCount) return false;
        block.replicate = replicate;
        block.begin = begin;
        block.end = std::min(begin + length, each);
        begin = block.end == each ? 0 : block.end;
        if (begin == 0) ++replicate;
        return true;
    };
    std::vector<OutputSums> sums(outputs.size(), OutputSums(d));
    const auto deliver = [&](const IndexBlock& block) {
        const std::size_t stride = outputs.size(), width = (d + 2) * stride;
        for (std::uint64_t n = 0; n < block.end - block.begin; ++n) {
            found.unsolved += !block.solved[n];
            for (std::size_t o = 0; o < outputs.size() && block.solved[n]; ++o)
                sums[o].add(block.replicate, block.values.data() + n * width + o, stride);
        }
        if (found.reason.isEmpty()) found.reason = block.reason;
        work.tell((block.end - block.begin) * (d + 2));
        return true;
    };
    const WorkEnd end = processInOrder<IndexBlock>(
        work.jobs, work.stop, fill, [&] { return IndexMaker(problem, design, outputs, points); }, deliver);
    if (end == WorkEnd::finished)
        for (const OutputSums& output : sums) found.outputs.push_back(output.result());
    return found;
}

}  // namespace drillwave
