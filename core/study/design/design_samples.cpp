// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/design/design_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A row of outputs for each point of a block, and the reason where there are none.
struct SampleBlock {
    std::uint64_t design = 0;
    std::uint64_t begin = 0, end = 0;  // points, counted through all replicates
    std::vector<double> nominal;       // of the first block of a design
    std::vector<double> outputs;
    std::uint64_t unsolved = 0;
    Message reason;
};

/// Solves blocks. One for each thread.
class SampleMaker {
  public:
    SampleMaker(const DesignProblem& problem, const SobolPoints& points, std::uint64_t samples)
        : m_problem(problem),
          m_points(points),
          m_each(samples / replicateCount),
          m_solver(problem.solver()),
          m_values(points.dimensions()) {}

    void operator()(SampleBlock& block, const std::stop_token& stop) {
        const std::size_t width = m_problem.outputCount();
        const std::vector<Distribution> distributions = m_problem.distributions(block.design);
        block.outputs.assign((block.end - block.begin) * width, none);
        block.unsolved = 0;
        block.reason = {};
        block.nominal.assign(block.begin == 0 ? width : 0, none);
        if (block.begin == 0 && !m_solver->solveNominal(block.design, block.nominal, stop).isEmpty())
            std::ranges::fill(block.nominal, none);
        for (std::uint64_t n = block.begin; n < block.end; ++n) {
            if (stop.stop_requested()) return;
            const std::span<double> row = std::span(block.outputs).subspan((n - block.begin) * width, width);
            m_points.point(n / m_each, n % m_each, m_values);
            for (std::size_t i = 0; i < m_values.size(); ++i)
                m_values[i] = distributions[i].quantile(m_values[i]);
            Message reason = m_solver->solve(block.design, m_values, row, stop);
            if (reason.isEmpty()) continue;
            std::ranges::fill(row, none);
            if (block.unsolved++ == 0) block.reason = std::move(reason);
        }
    }

  private:
    const DesignProblem& m_problem;
    const SobolPoints& m_points;
    std::uint64_t m_each;
    std::unique_ptr<DesignSolver> m_solver;
    std::vector<double> m_values;
};

/// Samples of one design, output by output, while its blocks come in.
class GatheredDesign {
  public:
    GatheredDesign(const SampleOrder& order, std::size_t width)
        : m_order(order), m_columns(width, std::vector<double>(order.samples, none)) {}

    void add(const SampleBlock& block) {
        const std::size_t width = m_columns.size();
        for (std::uint64_t n = block.begin; n < block.end; ++n)
            for (std::size_t c = 0; c < width; ++c)
                m_columns[c][n] = block.outputs[(n - block.begin) * width + c];
        if (block.begin == 0) m_design.nominal = block.nominal;
        if (m_design.reason.isEmpty()) m_design.reason = block.reason;
        m_design.unsolved += block.unsolved;
    }

    DesignSamples take() {
        for (std::size_t c = 0; c < m_columns.size(); ++c) {
            std::vector<SampledValue>& values = m_design.statistics.emplace_back();
            if (m_order.statistics[c].empty()) continue;
            if (m_design.hasStatistics(m_order.samples)) {
                const SortedSamples sorted(m_columns[c]);
                for (const Statistic& statistic : m_order.statistics[c])
                    values.push_back(nominalOr(sorted, statistic, c));
            } else {
                values.assign(m_order.statistics[c].size(), SampledValue{});
            }
        }
        if (m_order.uncertain) m_design.uncertainShare = uncertainShare(*m_order.uncertain);
        return std::exchange(m_design, {});
    }

  private:
    SampledValue nominalOr(const SortedSamples& sorted, const Statistic& statistic, std::size_t c) const {
        if (statistic.kind != Statistic::Kind::nominal) return sorted.of(statistic);
        SampledValue value{.value = m_design.nominal[c]};
        value.replicates.fill(value.value);
        return value;
    }

    double uncertainShare(const UncertainPoints& rule) const {
        // Below that of its value no statistic decides anything: equal samples have none at all.
        constexpr double leastError = 1e-9;
        std::vector<double> errors(m_columns.size(), std::numeric_limits<double>::infinity());
        for (std::size_t c = 0; c < m_columns.size(); ++c)
            for (std::size_t s = 0; s < m_order.statistics[c].size() && rule.concerns(c); ++s) {
                const SampledValue& value = m_design.statistics[c][s];
                if (!m_order.statistics[c][s].hasError() || std::isnan(value.value)) continue;
                errors[c] = std::min(errors[c], std::max(value.error(), leastError * std::abs(value.value)));
            }
        std::uint64_t uncertain = 0;
        for (std::uint64_t n = 0; n < m_order.samples; ++n)
            for (std::size_t c = 0; c < m_columns.size(); ++c) {
                const double own = m_columns[rule.errorOutput][n];
                const double scale = rule.isRelative[c] ? std::abs(m_columns[c][n]) : 1;
                if (!(own * scale > errors[c])) continue;
                ++uncertain;
                break;
            }
        return static_cast<double>(uncertain) / static_cast<double>(m_order.samples);
    }

    const SampleOrder& m_order;
    std::vector<std::vector<double>> m_columns;
    DesignSamples m_design;
};

}  // namespace

std::vector<DesignSamples> sampleDesigns(const DesignProblem& problem, const SampleOrder& order,
                                         const DesignWork& work) {
    assert(order.samples % replicateCount == 0 && order.statistics.size() == problem.outputCount());
    const SobolPoints points(problem.distributions(0).size(), order.seed);
    std::uint64_t design = 0, begin = 0;
    const auto fill = [&](SampleBlock& block) {
        if (design == problem.designCount()) return false;
        block.design = design;
        block.begin = begin;
        block.end = std::min(begin + pointsOfBlock, order.samples);
        begin = block.end == order.samples ? 0 : block.end;
        if (begin == 0) ++design;
        return true;
    };
    std::vector<DesignSamples> designs;
    GatheredDesign gathered(order, problem.outputCount());
    const auto deliver = [&](const SampleBlock& block) {
        gathered.add(block);
        if (block.end == order.samples) designs.push_back(gathered.take());
        work.tell(block.end - block.begin);
        return true;
    };
    processInOrder<SampleBlock>(
        work.jobs, work.stop, fill, [&] { return SampleMaker(problem, points, order.samples); }, deliver);
    return designs;
}

}  // namespace drillwave
