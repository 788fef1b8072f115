// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/march_plan.h"

#include <algorithm>
#include <cmath>

#include "core/wave/network/bit_node.h"
#include "core/wave/network/face_node.h"
#include "core/wave/network/joint.h"

namespace drillwave {

namespace {

/// The turns of nodes number `first` … `last` over some steps.
void addTurns(std::vector<NodeTurn>& turns, std::span<const std::size_t> delays, std::size_t first,
              std::size_t last, std::size_t from, std::size_t count) {
    for (std::size_t begin = first, end = first; begin <= last; begin = end = end + 1) {
        std::size_t shortest = count;  // of sections between nodes that have to wait for each other
        for (; end < last && delays[end] < count; ++end) shortest = std::min(shortest, delays[end]);
        if (begin == end) {
            turns.push_back({begin, from, count});
            continue;
        }
        // a few turns each; where sections are shorter still, those divide them further
        const std::size_t most = std::max(shortest, (count + 3) / 4);
        for (std::size_t done = 0; done < count; done += most)
            addTurns(turns, delays, begin, end, from + done, std::min(most, count - done));
    }
}

/// Without another limit a blow is followed for so many round trips of the string.
constexpr double mostRoundTrips = 40;

/// Smallest jump that counts, as a share of the largest force.
constexpr double leastFront = 1e-9;

/// Work of every node for every block of cells, in cells.
constexpr long workOfBlock = 4;

}  // namespace

void planTurns(std::span<const std::size_t> delays, std::size_t block, std::vector<NodeTurn>& turns) {
    turns.clear();
    addTurns(turns, delays, 0, delays.size(), 0, block);
}

void MarchPlan::begin(const Problem& problem, const CellGrid& grid, const NetworkWants& wants) {
    m_problem = problem;
    m_grid = grid;
    m_wants = wants;
    m_transitTimes.clear();
    for (std::size_t j = 0; j < sections(); ++j) {
        m_transitTimes.push_back(static_cast<double>(grid.roundTrips[j]) * grid.cell / 2);
        m_problem.sections[j].transitTime = m_transitTimes[j];
    }
    if (!m_problem.isForced()) m_problem.sections[m_problem.hammerSections() - 1].loss = 0;
    m_problem.sections.back().loss = 0;
    m_lossy = losesWaves(m_problem);
    m_clocks.begin(m_problem.hammerSections(), m_transitTimes);
    takeRates();
    m_cuts.begin(grid.cell, m_rates, wants.grading);
    if (problem.isForced()) cutAtFronts(problem.force());
    foresee();
    // what is counted at the end shall not depend on how a wave runs within a part
    if (problem.endTime && wants.cutAt == CutAt::corners)
        for (const double delay : m_clocks.delays) {
            const double cells = (*problem.endTime - delay) / grid.cell;
            m_cuts.endPartAt(cells - std::floor(cells));
        }
}

void MarchPlan::takeRates() {
    const std::vector<UniformSection>& all = m_problem.sections;
    m_rates.clear();
    BitNode(all.back().impedance, all.back().massAfter, m_problem.law, m_problem.distance())
        .addRates(m_rates);
    const std::size_t h = m_problem.hammerSections();
    if (h > 0) {
        const FaceNode face(all[h - 1].impedance, all[h].impedance, m_problem.hammer().face);
        if (face.rate() > 0) m_rates.push_back(face.rate());
    }
    for (std::size_t j = 0; j + 1 < all.size(); ++j)
        if (all[j].massAfter > 0) m_rates.push_back(Joint(all[j], all[j + 1], 0).rate());
}

/// Between the parts of the force, at jumps first: as many places are left for what contacts make.
void MarchPlan::cutAtFronts(const PulseForce& force) {
    if (m_wants.cutAt == CutAt::nothing) return;
    int left = m_wants.grading.mostCuts / 2;
    for (const bool jumps : {true, false}) {
        double before = 0;
        for (const PulseSegment& segment : force.segments) {
            const double jump = std::abs(segment.forceAt(0) - before);
            before = segment.forceAt(segment.length);
            if (left == 0 || (jump > leastFront * force.peak) != jumps) continue;
            if (!jumps && m_wants.cutAt != CutAt::corners) continue;
            const double cells = segment.start / m_grid.cell;
            if (m_cuts.cutAt(cells - std::floor(cells))) --left;
        }
        if (left > 0 && (before > leastFront * force.peak) == jumps) {
            const double cells = force.end / m_grid.cell;
            if (m_cuts.cutAt(cells - std::floor(cells))) --left;
        }
    }
}

void MarchPlan::foresee() {
    const auto parts = static_cast<double>(m_cuts.count());
    double held = 0, shortest = stepsOfBlock;
    for (const long count : m_grid.roundTrips) {
        held += static_cast<double>(count) * parts;
        shortest = std::min(shortest, static_cast<double>(count) * parts);
    }
    const double steps = limitTime() / m_grid.cell * parts;
    const double ofNode =
        static_cast<double>(m_wants.forces ? workOfForces : 1) + static_cast<double>(workOfBlock) / shortest;
    m_foreseen = {steps * static_cast<double>(sections() + 1) * ofNode, held};
}

double MarchPlan::limitTime() const {
    if (m_problem.endTime) return *m_problem.endTime;
    const double forced = m_problem.isForced() ? m_problem.force().end : 0;
    return m_problem.nextBlow.value_or(forced + mostRoundTrips * 2 * m_clocks.bit());
}

}  // namespace drillwave
