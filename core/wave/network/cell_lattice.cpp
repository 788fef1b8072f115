// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/cell_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

/// Work of a piece of a cell with events, in cells.
constexpr long workOfPiece = 150;

/// Clock before all others.
constexpr double never = -std::numeric_limits<double>::infinity();

/// Where the next part begins.
double endOf(CellCuts::Walk at) {
    at.next();
    return at.clock();
}

}  // namespace

void CellLattice::begin(const MarchPlan& plan, long mostRecut) {
    m_plan = &plan;
    const Problem& problem = plan.problem();
    m_count = plan.sections();
    m_mostRecut = mostRecut;
    m_step = m_recut = 0;
    m_mayCut = true;
    m_events.clear();
    m_cuts = plan.cuts();
    // copies keep the memory for what has a map for every width
    if (problem.isForced()) {
        m_force.emplace(problem.force(), problem.sections.front().impedance);
        m_face = FaceNode();
    } else {
        m_force.reset();
        const FaceNode face(problem.sections[faceSection() - 1].impedance,
                            problem.sections[faceSection()].impedance, problem.hammer().face);
        m_face = face;
    }
    const BitNode bit(problem.sections.back().impedance, problem.sections.back().massAfter, problem.law,
                      problem.distance());
    m_bit = bit;
    m_bit.setEvents(plan.wants().events ? &m_events : nullptr);
    m_passing.clear();
    const double velocity = problem.isForced() ? 0 : problem.hammer().velocity;
    if (m_lines.size() < m_count) m_lines.resize(m_count);
    if (m_joints.size() < m_count - 1) m_joints.resize(m_count - 1);
    for (std::size_t j = 0; j < m_count; ++j) {
        const UniformSection& section = problem.sections[j];
        const bool hammer = j < faceSection();
        m_passing.push_back(std::exp(-section.decay));
        m_lines[j].restart(static_cast<std::size_t>(plan.grid().roundTrips[j]) * m_cuts.count(),
                           stepsOfBlock);
        std::ranges::fill(m_lines[j].content(),
                          WaveCell::constant(hammer ? -velocity * section.impedance / 2 : 0));
        if (j + 1 == m_count) continue;
        const Joint joint(section, problem.sections[j + 1], hammer ? velocity : 0);
        m_joints[j] = joint;
    }
    m_downs.resize(m_count * stepsOfBlock);
    m_weakened.resize(stepsOfBlock);
    m_bitForces.resize(stepsOfBlock);
    setWidths();
    orderTurns();
}

void CellLattice::setWidths() {
    m_face.setWidths(m_cuts.widths());
    m_bit.setWidths(m_cuts.widths());
    for (std::size_t j = 0; j + 1 < m_count; ++j) m_joints[j].setWidths(m_cuts.widths());
}

void CellLattice::orderTurns() {
    m_delays.clear();
    for (std::size_t j = 0; j < m_count; ++j) m_delays.push_back(m_lines[j].delay());
    planTurns(m_delays, stepsOfBlock, m_turns);
}

void CellLattice::keepNodes() {
    m_before.face = face();
    m_before.bit = m_bit.state();
    m_before.events = m_events.size();
    m_before.massVelocities.clear();
    for (std::size_t j = 0; j + 1 < m_count; ++j) m_before.massVelocities.push_back(m_joints[j].velocity());
}

void CellLattice::restoreNodes() {
    if (m_force)
        m_force->setState(m_before.face);
    else
        m_face.setState(m_before.face);
    m_bit.setState(m_before.bit);
    m_events.resize(m_before.events);
    for (std::size_t j = 0; j + 1 < m_count; ++j) m_joints[j].setVelocity(m_before.massVelocities[j]);
}

double CellLattice::jumpPlace(std::size_t part, double place) const {
    return m_cuts.places()[part] + place * m_cuts.widths()[part] / m_plan->grid().cell;
}

/// Where a jump was found the block is to be taken again.
CellLattice::NodeJump CellLattice::stepBlock(StringCensus& census, const std::stop_token& stop) {
    for (const NodeTurn& turn : m_turns) {
        if (stop.stop_requested()) return {};
        const NodeJump jump = turn.node == 0               ? stepRear(turn, census)
                              : turn.node == m_count       ? stepBit(turn, census, stop)
                              : turn.node == faceSection() ? stepFace(turn, census)
                                                           : stepJoint(turn, census);
        if (jump.found) return jump;
    }
    return {};
}

/// A free end, or one that a force pushes.
CellLattice::NodeJump CellLattice::stepRear(const NodeTurn& turn, StringCensus& census) {
    const WaveCell* back = m_lines[0].oldest();
    if (!m_force) {
        for (std::size_t i = turn.from; i < turn.behind(); ++i) toDown(0)[i] = -m_passing[0] * back[i];
        return {};
    }
    CellCuts::Walk at(m_cuts, m_step + static_cast<long>(turn.from));
    const double censusClock = census.isUnderWay() ? census.time() : never;
    for (std::size_t i = turn.from; i < turn.behind(); ++i, at.next()) {
        const double time = at.clock(), width = at.width();
        const WaveCell arriving = m_passing[0] * back[i];
        if (censusClock >= time && censusClock < endOf(at)) {
            const double share = std::min(1.0, (censusClock - time) / width);
            ForceNode first = *m_force;
            census.down(0).setEntered(first.step(arriving.part(0, share), time, share * width), time);
            census.setFace(first.state());
        }
        toDown(0)[i] = m_force->step(arriving, time, width);
    }
    return {};
}

/// The waves back over these steps of the block, as they arrive at its rear end.
const WaveCell* CellLattice::arriving(std::size_t section, const NodeTurn& turn) {
    const WaveCell* b = m_lines[section].oldest();
    if (m_passing[section] == 1) return b;
    for (std::size_t i = turn.from; i < turn.behind(); ++i) m_weakened[i] = m_passing[section] * b[i];
    return m_weakened.data();
}

CellLattice::NodeJump CellLattice::stepJoint(const NodeTurn& turn, StringCensus& census) {
    const std::size_t j = turn.node;
    const std::size_t parts = m_cuts.count();
    const std::size_t part = (static_cast<std::size_t>(m_step) + turn.from) % parts;
    const WaveCell* f1 = down(j - 1) + turn.from;
    const WaveCell* b2 = arriving(j, turn) + turn.from;
    WaveCell* f2 = toDown(j) + turn.from;
    if (m_passing[j - 1] != 1) {
        for (std::size_t i = 0; i < turn.count; ++i) f2[i] = m_passing[j - 1] * f1[i];
        f1 = f2;
    }
    if (m_joints[j - 1].mass() > 0 && census.isUnderWay()) countMass(j - 1, f1, b2, turn, census);
    m_joints[j - 1].step(f1, b2, m_lines[j - 1].newest() + turn.from, f2, turn.count, part, parts);
    return {};
}

CellLattice::NodeJump CellLattice::stepFace(const NodeTurn& turn, StringCensus& census) {
    const std::size_t j = faceSection();
    CellCuts::Walk at(m_cuts, m_step + static_cast<long>(turn.from));
    const WaveCell *f1 = down(j - 1), *b2 = arriving(j, turn);
    WaveCell *b1 = m_lines[j - 1].newest(), *f2 = toDown(j);
    const double censusClock = census.isUnderWay() ? census.time() : never;
    CellJump jump;
    for (std::size_t i = turn.from; i < turn.behind(); ++i, at.next()) {
        const double time = at.clock();
        if (censusClock >= time && censusClock < endOf(at)) countFace(f1[i], b2[i], at, census);
        m_face.step({f1[i], b2[i], b1[i], f2[i]}, static_cast<int>(at.part()), time,
                    i < m_faceTaken ? CutAt::nothing : m_cutAt, jump);
        if (jump.found) return {true, j, i, jumpPlace(at.part(), jump.place)};
    }
    return {};
}

CellLattice::NodeJump CellLattice::stepBit(const NodeTurn& turn, StringCensus& census,
                                           const std::stop_token& stop) {
    const std::size_t j = m_count - 1;
    CellCuts::Walk at(m_cuts, m_step + static_cast<long>(turn.from));
    const bool keepsForces = m_plan->wants().histories, weakens = m_passing[j] != 1;
    const double censusClock = census.isUnderWay() ? census.clockOf(j + 1) : never;
    const long pieces = m_bit.pieces();
    const WaveCell* entered = down(j);
    WaveCell *leaving = m_lines[j].newest(), weakened;
    CellJump jump;
    for (std::size_t i = turn.from; i < turn.behind(); ++i, at.next()) {
        if (weakens) weakened = m_passing[j] * entered[i];
        const WaveCell& g = weakens ? weakened : entered[i];
        const double clock = at.clock(), time = clock + m_plan->clocks().bit();
        if (censusClock >= clock && censusClock < endOf(at)) countBit(g, at, census);
        constexpr long fewPieces = 1000;  // many of them may take as long as blocks do
        if (m_bit.pieces() - pieces > fewPieces && stop.stop_requested()) return {};
        m_bit.step(g, leaving[i], static_cast<int>(at.part()), time,
                   i < m_bitTaken ? CutAt::nothing : m_cutAt, jump);
        if (jump.found) return {true, j + 1, i, jumpPlace(at.part(), jump.place)};
        if (keepsForces) m_bitForces[i] = m_bit.cellForce();
    }
    return {};
}

/// For the census, whose time lies in this cell.
void CellLattice::countFace(const WaveCell& f1, const WaveCell& b2, const CellCuts::Walk& at,
                            StringCensus& census) const {
    const std::size_t j = faceSection();
    const double share = std::min(1.0, (census.time() - at.clock()) / at.width());
    const FaceNode::Part first = m_face.partOfStep(f1, b2, static_cast<int>(at.part()), share, at.clock());
    census.setFace(first.state);
    census.down(j).setEntered(first.f2, at.clock());
    census.up(j - 1).setEntered(first.b1, at.clock());
}

/// For the census, whose time lies in this cell.
void CellLattice::countBit(const WaveCell& g, const CellCuts::Walk& at, StringCensus& census) const {
    const std::size_t j = m_count - 1;
    const double share = std::min(1.0, (census.clockOf(j + 1) - at.clock()) / at.width());
    const BitNode::Part first =
        m_bit.partOfStep(g, static_cast<int>(at.part()), share, at.clock() + m_plan->clocks().bit());
    census.setBit(first.state);
    census.up(j).setEntered(first.leaving, at.clock());
}

/// For the census, where its time lies in these turns.
void CellLattice::countMass(std::size_t joint, const WaveCell* f1, const WaveCell* b2, const NodeTurn& turn,
                            StringCensus& census) {
    const double wanted = census.clockOf(joint + 1);
    const long from = m_step + static_cast<long>(turn.from);
    if (wanted < m_cuts.clock(from) || wanted >= m_cuts.clock(from + static_cast<long>(turn.count))) return;
    Joint& mass = m_joints[joint];
    const double before = mass.velocity();
    WaveCell f2, b1;
    for (std::size_t i = 0; i < turn.count; ++i) {
        const long step = from + static_cast<long>(i);
        const double start = m_cuts.clock(step), width = m_cuts.width(step);
        if (wanted >= m_cuts.clock(step + 1)) {
            mass.step(f1 + i, b2 + i, &b1, &f2, 1, static_cast<std::size_t>(step) % m_cuts.count(),
                      m_cuts.count());
            continue;
        }
        const double share = std::min(1.0, (wanted - start) / width);
        if (share > 0) mass.stepAlone(f1[i].part(0, share), b2[i].part(0, share), share * width, b1, f2);
        census.setMassVelocity(joint, mass.velocity());
        census.down(joint + 1).setEntered(f2, start);
        census.up(joint).setEntered(b1, start);
        break;
    }
    mass.setVelocity(before);
}

void CellLattice::takeBlock(StringCensus& census, double spareWork, const std::stop_token& stop) {
    keepNodes();
    m_faceTaken = m_bitTaken = 0;
    while (true) {
        const bool mayCut = m_mayCut && !m_cuts.isFull() && m_recut <= m_mostRecut;
        m_cutAt = mayCut ? m_plan->wants().cutAt : CutAt::nothing;
        const NodeJump jump = stepBlock(census, stop);
        if (!jump.found) return;
        restoreNodes();
        if (cut(jump.place, spareWork)) {
            m_faceTaken = m_bitTaken = 0;  // steps have other numbers now
        } else {
            (jump.node == m_count ? m_bitTaken : m_faceTaken) = jump.step + 1;
        }
    }
}

/// Cuts all cells at a place. False where that is not to be done.
bool CellLattice::cut(double place, double spareWork) {
    m_coarse = m_cuts;
    const double left = m_plan->limitTime() - clock();
    if (!m_cuts.cutAt(place)) return false;
    m_mayCut = isAffordable(left, spareWork);
    if (!m_mayCut) {
        m_cuts = m_coarse;
        return false;
    }
    for (std::size_t j = 0; j < m_count; ++j) m_recut += static_cast<long>(m_lines[j].delay());
    const long parts = static_cast<long>(m_coarse.count());
    const std::size_t part = static_cast<std::size_t>(m_step % parts);
    const double start = m_coarse.places()[part];
    const auto at = std::lower_bound(m_cuts.places().begin(), m_cuts.places().end(), start);
    m_step = m_step / parts * static_cast<long>(m_cuts.count()) + (at - m_cuts.places().begin());
    for (std::size_t j = 0; j < m_count; ++j) {
        const std::span<const WaveCell> whole = m_lines[j].content();
        m_whole.assign(whole.begin(), whole.end());
        m_lines[j].restart(whole.size() / m_coarse.count() * m_cuts.count(), stepsOfBlock);
        m_cuts.recut(m_whole, m_coarse, part, m_lines[j].content());
    }
    setWidths();
    orderTurns();
    return true;
}

/// Whether to follow it for so long is no more work with these parts of cells.
bool CellLattice::isAffordable(double time, double spareWork) const {
    const double cells = time / m_plan->grid().cell * static_cast<double>(m_cuts.count());
    return cells * static_cast<double>(m_count + 1) <= spareWork - static_cast<double>(work());
}

long CellLattice::workOfEvents() const {
    return workOfPiece * (m_bit.pieces() + m_face.pieces());
}

double CellLattice::held() const {
    double sum = 0;
    for (std::size_t j = 0; j < m_count; ++j) sum += static_cast<double>(m_lines[j].delay());
    return sum;
}

void CellLattice::advance() {
    for (std::size_t j = 0; j < m_count; ++j) m_lines[j].advance(stepsOfBlock);
    m_step += static_cast<long>(stepsOfBlock);
}

}  // namespace drillwave
