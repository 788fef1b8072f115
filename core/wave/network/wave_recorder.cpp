// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/wave_recorder.h"

#include <algorithm>
#include <limits>

namespace drillwave {

namespace {

/// Work of checking whether a block of cells may hold the largest force of a section with losses, in
/// cells.
constexpr long workOfLook = 8;

}  // namespace

void WaveRecorder::begin(const MarchPlan& plan, const CellLattice& lattice) {
    m_plan = &plan;
    m_lattice = &lattice;
    m_watches.clear();
    m_alone.clear();
    m_reflected.clear();
    m_waves.reset();
    m_hasForces = plan.wants().forces;
    m_leftOutForces = false;
    const Problem& problem = plan.problem();
    if (plan.wants().histories) m_waves = std::make_shared<StringWaves>(problem, plan.clocks().delays);
    if (!m_hasForces) return;
    m_stringTransit = problem.transitTime();
    m_endOfBlow = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < plan.sections(); ++j) {
        const UniformSection& section = problem.sections[j];
        m_watches.emplace_back(WatchedSection{section.transitTime, section.decay, plan.clocks().delays[j]});
        if (plan.wants().reflections && j + 1 < plan.sections())
            m_alone.emplace_back(section, problem.sections[j + 1], 0);
    }
    m_reflected.assign(m_alone.size(), 0);
    restartWatches();
}

void WaveRecorder::restartWatches() {
    m_parts = m_lattice->cuts().count();
    for (std::size_t j = 0; j < m_watches.size(); ++j)
        m_watches[j].restart(m_lattice->line(j).content(), m_lattice->step());
    for (Joint& joint : m_alone) joint.setWidths(m_lattice->cuts().widths());
}

void WaveRecorder::add(const std::stop_token& stop) {
    if (m_hasForces) addForces(stop);
    if (m_waves) addWaves();
}

void WaveRecorder::addForces(const std::stop_token& stop) {
    if (m_parts != m_lattice->cuts().count()) restartWatches();
    const Problem& problem = m_plan->problem();
    const double lastTime = m_plan->limitTime();
    // the bit is known for all that meets in this block, and for longer
    const BitNodeState& bit = m_lattice->bit();
    if (bit.record.lastContact >= 0 && bit.record.lastContact <= lastTime)
        m_endOfBlow = bit.isApart() ? bit.record.lastSeparation + m_stringTransit
                                    : std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < m_watches.size() && !stop.stop_requested(); ++j) {
        m_watches[j].setEndOfBlow(m_endOfBlow, wantedTime());
        const DelayLine<WaveCell>& line = m_lattice->line(j);
        m_watches[j].add({m_lattice->down(j), stepsOfBlock}, {line.oldest(), line.delay() + stepsOfBlock},
                         m_lattice->step(), m_lattice->cuts(), lastTime);
        if (j >= problem.hammerSections() && j < m_alone.size()) addReflection(j);
    }
}

void WaveRecorder::addReflection(std::size_t section) {
    const CellCuts& cuts = m_lattice->cuts();
    CellCuts::Walk at(cuts, m_lattice->step());
    for (std::size_t i = 0; i < stepsOfBlock; ++i, at.next()) {
        const WaveCell f1 = m_lattice->passing(section) * m_lattice->down(section)[i], none;
        WaveCell b1, f2;
        m_alone[section].step(&f1, &none, &b1, &f2, 1, at.part(), cuts.count());
        m_reflected[section] += at.width() * b1.meanSquare();
    }
}

/// Where they are too many, none is kept.
void WaveRecorder::addWaves() {
    if (m_waves->isFull()) return m_waves.reset();
    CellCuts::Walk at(m_lattice->cuts(), m_lattice->step());
    const WaveCell* back = m_lattice->line(0).oldest();
    for (std::size_t i = 0; i < stepsOfBlock; ++i, at.next())
        m_waves->addStep(at.clock(), at.width(), m_lattice->bitForces()[i],
                         m_lattice->down(0)[i] + m_lattice->passing(0) * back[i]);
    for (std::size_t j = 0; j < m_plan->sections(); ++j)
        for (std::size_t i = 0; i < stepsOfBlock; ++i)
            m_waves->add(j, m_lattice->down(j)[i], m_lattice->line(j).newest()[i]);
}

long WaveRecorder::workForForces(long cells) const {
    if (!m_hasForces) return 0;
    long looked = 0;
    for (const SectionWatch& watch : m_watches) looked += watch.looked();
    return cells * (workOfForces - 1) + workOfLook * looked;
}

void WaveRecorder::leaveOutForces() {
    m_hasForces = false;
    m_leftOutForces = true;
    m_watches.clear();
    m_alone.clear();
}

double WaveRecorder::wantedTime() const {
    const bool isOver = m_endOfBlow < std::numeric_limits<double>::infinity();
    return m_hasForces && isOver ? std::min(m_endOfBlow + 2 * m_stringTransit, m_plan->limitTime()) : 0;
}

/// Returns the forces of a section, from the pieces with the largest stress: force over impedance.
SectionForces WaveRecorder::forcesOf(std::size_t first, std::size_t count) const {
    SectionForces forces = m_watches[first].forces();
    if (count == 1) return forces;
    const std::vector<UniformSection>& pieces = m_plan->problem().sections;
    for (const Load load : loads) {
        double most = -1;
        for (std::size_t i = 0; i < count; ++i) {
            SectionPeak here = m_watches[first + i].forces()[load];
            const double stress = here.force / pieces[first + i].impedance;
            if (stress <= most) continue;
            most = stress;
            here.place = (static_cast<double>(i) + here.place) / static_cast<double>(count);
            forces[load] = here;
        }
    }
    return forces;
}

void WaveRecorder::finish(double time, Impact& impact) {
    const Problem& problem = m_plan->problem();
    const double passed = m_lattice->clock() + m_plan->clocks().earliest();
    const double end = problem.endTime ? time : std::max(time, std::min(wantedTime(), passed));
    impact.forcesEnd = wantedTime() > 0 ? std::min(wantedTime(), end) : end;
    for (const SectionWatch& watch : m_watches) impact.cellsLookedInto += watch.cellsLookedInto();
    std::size_t first = 0;
    const auto addSection = [&](std::size_t count) {
        if (!m_watches.empty()) impact.sections.push_back(forcesOf(first, count));
        first += count;
        if (first > problem.hammerSections() && first - 1 < m_alone.size())
            impact.jointReflection.push_back(m_reflected[first - 1] / problem.sections[first - 1].impedance /
                                             impact.hammerWork);
    };
    if (problem.pieces.empty())
        for (std::size_t j = 0; j < problem.sections.size(); ++j) addSection(1);
    else
        for (const int count : problem.pieces) addSection(static_cast<std::size_t>(count));
    impact.leftOutForces = m_leftOutForces;
    if (m_waves) m_waves->finish(end);
    impact.waves = std::move(m_waves);
}

}  // namespace drillwave
