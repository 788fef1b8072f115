// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/free_flight.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

namespace {

/// Cells taken by one node before the next one follows.
constexpr std::size_t block = 128;

}  // namespace

bool FreeFlight::suits(const NetworkProblem& problem) {
    return std::none_of(problem.sections.begin(), problem.sections.end(), [](const NetworkSection& section) {
        return section.massAfter > 0 || section.loss > 0 || section.decay > 0;
    });
}

FreeFlight::Margins FreeFlight::margins(const NetworkProblem& problem, double cell,
                                        const FlightStart& start) {
    const auto margin = [&](double energy, std::size_t j) {
        return std::sqrt(cell * std::max(0.0, energy) / problem.sections[j].impedance);
    };
    const std::size_t face = problem.hammerSections;
    return {margin(start.hammerEnergy, face - 1) + margin(start.stringEnergy, face),
            margin(start.stringEnergy, problem.sections.size() - 1)};
}

bool FreeFlight::isClear(const NetworkProblem& problem, double cell, const FlightStart& start) {
    const Margins needed = margins(problem, cell, start);
    return start.bitDistance > needed.bit && (start.released || start.faceGap > needed.face);
}

FreeFlight::FreeFlight(const NetworkProblem& problem, double cell, const FlightStart& start)
    : m_face(problem.hammerSections),
      m_cell(cell),
      m_released(start.released),
      m_faceGap(start.faceGap),
      m_bitDistance(start.bitDistance),
      m_margins(margins(problem, cell, start)) {
    std::vector<std::size_t> delays;
    for (std::size_t j = 0; j < problem.sections.size(); ++j) {
        m_impedances.push_back(problem.sections[j].impedance);
        const double before = m_impedances[j == 0 ? 0 : j - 1], z = m_impedances[j];
        m_reflections.push_back((z - before) / (z + before));
        delays.push_back(start.waves[j].size());
        m_lines.emplace_back(delays.back(), block, 0.0);
        m_lines.back().replace(start.waves[j]);
    }
    m_downs.assign(m_lines.size(), std::vector<double>(block));
    m_turns = nodeTurns(delays, block);
}

bool FreeFlight::staysClear(double cells, const std::stop_token& stop) {
    for (double done = 0; done < cells; done += static_cast<double>(block)) {
        if (stop.stop_requested()) return false;
        for (const NodeTurn& turn : m_turns)
            if (!step(turn)) return false;
        for (DelayLine<double>& line : m_lines) line.advance(block);
        m_gone += static_cast<double>(block);
    }
    return true;
}

bool FreeFlight::step(const NodeTurn& turn) {
    if (turn.node == m_face) return stepFace(turn);
    if (turn.node == m_lines.size()) return stepBit(turn);
    if (turn.node == 0) {
        for (std::size_t i = turn.from; i < turn.behind(); ++i) m_downs[0][i] = -m_lines[0].arriving()[i];
        return true;
    }
    const double r = m_reflections[turn.node];
    const double* f1 = m_downs[turn.node - 1].data() + turn.from;
    const double* b2 = m_lines[turn.node].arriving() + turn.from;
    double* b1 = m_lines[turn.node - 1].leaving() + turn.from;
    double* f2 = m_downs[turn.node].data() + turn.from;
    for (std::size_t i = 0; i < turn.count; ++i) {
        const double f = f1[i], b = b2[i], turned = r * (f - b);
        b1[i] = b + turned;
        f2[i] = f + turned;
    }
    return true;
}

bool FreeFlight::stepFace(const NodeTurn& turn) {
    const std::size_t j = m_face;
    const double of1 = 2 * m_cell / m_impedances[j - 1], of2 = 2 * m_cell / m_impedances[j];
    double least = m_faceGap;
    for (std::size_t i = turn.from; i < turn.behind(); ++i) {
        const double f = m_downs[j - 1][i], b = m_lines[j].arriving()[i];
        m_lines[j - 1].leaving()[i] = -f;
        m_downs[j][i] = -b;
        m_faceGap -= of1 * f + of2 * b;
        least = std::min(least, m_faceGap);
    }
    return m_released || least > m_margins.face;
}

bool FreeFlight::stepBit(const NodeTurn& turn) {
    const std::size_t j = m_lines.size() - 1;
    const double ofWave = 2 * m_cell / m_impedances[j];
    double least = m_bitDistance;
    for (std::size_t i = turn.from; i < turn.behind(); ++i) {
        const double g = m_downs[j][i];
        m_lines[j].leaving()[i] = -g;
        m_bitDistance -= ofWave * g;
        least = std::min(least, m_bitDistance);
    }
    return least > m_margins.bit;
}

}  // namespace drillwave
