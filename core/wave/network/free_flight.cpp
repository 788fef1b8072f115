// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/free_flight.h"

#include <algorithm>
#include <cmath>

namespace drillwave {

bool FreeFlight::suits(const Problem& problem) {
    return std::none_of(problem.sections.begin(), problem.sections.end(), [](const UniformSection& section) {
        return section.massAfter > 0 || section.loss > 0 || section.decay > 0;
    });
}

FreeFlight::Margins FreeFlight::margins(const Problem& problem, double cell, const FlightStart& start) {
    const auto margin = [&](double energy, std::size_t j) {
        return std::sqrt(cell * std::max(0.0, energy) / problem.sections[j].impedance);
    };
    const std::size_t face = problem.hammerSections();
    const double hammer = face > 0 ? margin(start.hammerEnergy, face - 1) : 0;
    return {hammer + margin(start.stringEnergy, face),
            margin(start.stringEnergy, problem.sections.size() - 1)};
}

bool FreeFlight::isClear(const Problem& problem, double cell, const FlightStart& start) {
    const Margins needed = margins(problem, cell, start);
    return start.bitDistance > needed.bit && (start.released || start.faceGap > needed.face);
}

void FreeFlight::begin(const Problem& problem, const CellGrid& grid, const FlightStart& start) {
    m_face = problem.hammerSections();
    m_count = problem.sections.size();
    m_cell = grid.cell;
    m_released = start.released;
    m_faceGap = start.faceGap;
    m_bitDistance = start.bitDistance;
    m_margins = margins(problem, grid.cell, start);
    m_gone = 0;
    m_impedances.clear();
    m_reflections.clear();
    m_delays.clear();
    if (m_lines.size() < m_count) m_lines.resize(m_count);
    for (std::size_t j = 0; j < m_count; ++j) {
        m_impedances.push_back(problem.sections[j].impedance);
        const double before = m_impedances[j == 0 ? 0 : j - 1], z = m_impedances[j];
        m_reflections.push_back((z - before) / (z + before));
        m_delays.push_back(static_cast<std::size_t>(grid.roundTrips[j]));
        m_lines[j].restart(m_delays[j], block);
    }
    m_downs.resize(m_count * block);
    planTurns(m_delays, block, m_turns);
}

bool FreeFlight::staysClear(double cells, const std::stop_token& stop) {
    for (double done = 0; done < cells; done += static_cast<double>(block)) {
        if (stop.stop_requested()) return false;
        for (const NodeTurn& turn : m_turns)
            if (!step(turn)) return false;
        for (std::size_t j = 0; j < m_count; ++j) m_lines[j].advance(block);
        m_gone += static_cast<double>(block);
    }
    return true;
}

bool FreeFlight::step(const NodeTurn& turn) {
    if (turn.node == m_count) return stepBit(turn);
    if (turn.node == 0) {  // free: a force instead of a hammer is over
        const double* back = m_lines[0].oldest();
        double* f = down(0);
        for (std::size_t i = turn.from; i < turn.behind(); ++i) f[i] = -back[i];
        return true;
    }
    if (turn.node == m_face) return stepFace(turn);
    const double r = m_reflections[turn.node];
    const double* f1 = down(turn.node - 1) + turn.from;
    const double* b2 = m_lines[turn.node].oldest() + turn.from;
    double* b1 = m_lines[turn.node - 1].newest() + turn.from;
    double* f2 = down(turn.node) + turn.from;
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
    const double* f1 = down(j - 1);
    const double* b2 = m_lines[j].oldest();
    double* b1 = m_lines[j - 1].newest();
    double* f2 = down(j);
    double gap = m_faceGap, least = gap;
    for (std::size_t i = turn.from; i < turn.behind(); ++i) {
        const double f = f1[i], b = b2[i];
        b1[i] = -f;
        f2[i] = -b;
        gap -= of1 * f + of2 * b;
        least = std::min(least, gap);
    }
    m_faceGap = gap;
    return m_released || least > m_margins.face;
}

bool FreeFlight::stepBit(const NodeTurn& turn) {
    const std::size_t j = m_count - 1;
    const double ofWave = 2 * m_cell / m_impedances[j];
    const double* arriving = down(j);
    double* leaving = m_lines[j].newest();
    double distance = m_bitDistance, least = distance;
    for (std::size_t i = turn.from; i < turn.behind(); ++i) {
        const double g = arriving[i];
        leaving[i] = -g;
        distance -= ofWave * g;
        least = std::min(least, distance);
    }
    m_bitDistance = distance;
    return least > m_margins.bit;
}

}  // namespace drillwave
