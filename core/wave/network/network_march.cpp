// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/network_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/wave/network/census_impact.h"
#include "core/wave/network/free_flight.h"

namespace drillwave {

namespace {

/// Steps taken by one node before the next one follows: what a first-level cache holds.
constexpr std::size_t mostBlock = 64;

/// Without another limit a blow is followed for so many round trips of the string.
constexpr double mostRoundTrips = 40;

/// What a piece of a cell with events takes, and a cell with its largest forces, in cells.
constexpr long workOfPiece = 150, workOfForces = 8;

/// Of the work that is permitted, what may go into cutting cells that are on their way: in very long strings
/// each cut is as much as some millions of steps. Jumps that are not cut any more show in the balance.
constexpr double shareOfCuts = 0.1;

/// So many means of cells that fly free take what one cell does.
constexpr double flownOfCell = 8;

/// What it takes to see whether a block of cells may hold the largest force of a section that loses.
constexpr long workOfLook = 8;

/// And what every node takes for every block of cells.
constexpr long workOfBlock = 4;

/// The string as its cells have it.
NetworkProblem onGrid(const NetworkProblem& problem, const CellGrid& grid) {
    NetworkProblem rounded = problem;
    for (std::size_t j = 0; j < rounded.sections.size(); ++j)
        rounded.sections[j].transitTime = static_cast<double>(grid.roundTrips[j]) * grid.cell / 2;
    // behind the last section of hammer or string there is no joint
    rounded.sections[rounded.hammerSections - 1].loss = 0;
    rounded.sections.back().loss = 0;
    return rounded;
}

std::vector<double> transitTimes(const CellGrid& grid) {
    std::vector<double> times;
    for (const long count : grid.roundTrips) times.push_back(static_cast<double>(count) * grid.cell / 2);
    return times;
}

bool losesEnergy(const NetworkProblem& problem) {
    return std::any_of(problem.sections.begin(), problem.sections.end(),
                       [](const NetworkSection& section) { return section.loss > 0 || section.decay > 0; });
}

/// All rates at which something follows in this string [1/t0].
std::vector<double> ratesOf(const NetworkProblem& problem) {
    const std::vector<NetworkSection>& sections = problem.sections;
    std::vector<double> rates =
        BitNode(sections.back().impedance, sections.back().massAfter, problem.law, problem.gap).rates();
    const std::size_t h = problem.hammerSections;
    const FaceNode face(sections[h - 1].impedance, sections[h].impedance, problem.face);
    if (face.rate() > 0) rates.push_back(face.rate());
    for (std::size_t j = 0; j + 1 < sections.size(); ++j)
        if (sections[j].massAfter > 0) rates.push_back(Joint(sections[j], sections[j + 1], 0).rate());
    return rates;
}

double limitOf(const NetworkProblem& problem, const StringClocks& clocks) {
    if (problem.endTime) return *problem.endTime;
    return problem.nextBlow.value_or(mostRoundTrips * 2 * clocks.bit());
}

const NetworkSection& sectionAt(const NetworkProblem& problem, std::size_t j) {
    return problem.sections[j];
}

/// Where the next part begins.
double endOf(CellCuts::Walk at) {
    at.next();
    return at.clock();
}

}  // namespace

ForeseenWork foreseeWork(const NetworkProblem& problem, const CellGrid& grid, const NetworkWants& wants) {
    const NetworkProblem rounded = onGrid(problem, grid);
    const auto parts = static_cast<double>(CellCuts(grid.cell, ratesOf(rounded), wants.grading).count());
    double held = 0, shortest = mostBlock;
    for (const long count : grid.roundTrips) {
        held += static_cast<double>(count) * parts;
        shortest = std::min(shortest, static_cast<double>(count) * parts);
    }
    const double steps = limitOf(rounded, StringClocks(rounded, transitTimes(grid))) / grid.cell * parts;
    const double ofNode = (wants.forces ? workOfForces : 1) + static_cast<double>(workOfBlock) / shortest;
    return {steps * static_cast<double>(problem.sections.size() + 1) * ofNode, held};
}

NetworkMarch::NetworkMarch(const NetworkProblem& problem, const CellGrid& grid, const NetworkWants& wants)
    : m_problem(onGrid(problem, grid)),
      m_grid(grid),
      m_wants(wants),
      m_lossy(losesEnergy(m_problem)),
      m_clocks(problem, transitTimes(grid)),
      m_cuts(grid.cell, {}, wants.grading),
      m_face(sectionAt(problem, problem.hammerSections - 1).impedance,
             sectionAt(problem, problem.hammerSections).impedance, problem.face),
      m_bit(problem.sections.back().impedance, problem.sections.back().massAfter, problem.law, problem.gap) {
    const std::size_t count = problem.sections.size();
    for (std::size_t j = 0; j < count; ++j) {
        const NetworkSection& section = problem.sections[j];
        const bool hammer = j < problem.hammerSections;
        m_passing.push_back(std::exp(-section.decay));
        if (j + 1 < count) m_joints.emplace_back(section, problem.sections[j + 1], hammer ? 1 : 0);
    }
    m_cuts = CellCuts(grid.cell, ratesOf(m_problem), wants.grading);
    // what is counted at the end shall not depend on how a wave runs within a part
    if (problem.endTime && wants.cutAt == CutAt::corners)
        for (const double delay : m_clocks.delays) {
            const double cells = (*problem.endTime - delay) / grid.cell;
            m_cuts.endPartAt(cells - std::floor(cells));
        }
    for (std::size_t j = 0; j < count; ++j) {
        const bool hammer = j < problem.hammerSections;
        const double back = hammer ? -problem.sections[j].impedance / 2 : 0;
        m_lines.emplace_back(static_cast<std::size_t>(grid.roundTrips[j]) * m_cuts.count(), mostBlock,
                             WaveCell::constant(back));
        if (wants.forces)
            m_watches.emplace_back(
                WatchedSection{m_clocks.transitTimes[j], problem.sections[j].decay, m_clocks.delays[j]});
    }
    for (SectionWatch& watch : m_watches)
        watch.restart(m_lines[&watch - m_watches.data()].content(), 0, m_cuts);
    m_downs.assign(count, std::vector<WaveCell>(mostBlock));
    m_weakened.resize(mostBlock);
    m_alone = m_joints;
    m_reflected.assign(m_joints.size(), 0);
    if (wants.events) m_bit.setEvents(&m_events);
    if (wants.histories) {
        m_waves = std::make_shared<StringWaves>(m_problem, m_clocks.delays);
        m_bitForces.resize(mostBlock);
    }
    setWidths();
    planTurns();
}

void NetworkMarch::setWidths() {
    m_face.setWidths(m_cuts.widths());
    m_bit.setWidths(m_cuts.widths());
    for (Joint& joint : m_joints) joint.setWidths(m_cuts.widths());
    for (Joint& joint : m_alone) joint.setWidths(m_cuts.widths());
}

NetworkMarch::Nodes NetworkMarch::nodes() const {
    Nodes nodes{m_face.state(), m_bit.state(), {}, m_events.size()};
    for (const Joint& joint : m_joints)
        if (joint.mass() > 0) nodes.massVelocities.push_back(joint.velocity());
    return nodes;
}

void NetworkMarch::setNodes(const Nodes& nodes) {
    m_face.setState(nodes.face);
    m_bit.setState(nodes.bit);
    std::size_t next = 0;
    for (Joint& joint : m_joints)
        if (joint.mass() > 0) joint.setVelocity(nodes.massVelocities[next++]);
    m_events.resize(nodes.events);
}

void NetworkMarch::planTurns() {
    std::vector<std::size_t> delays;
    for (const DelayLine<WaveCell>& line : m_lines) delays.push_back(line.delay());
    m_turns = nodeTurns(delays, mostBlock);
}

double NetworkMarch::jumpPlace(std::size_t part, double place) const {
    return m_cuts.places()[part] + place * m_cuts.widths()[part] / m_grid.cell;
}

/// One block of turn. Where a jump was found it is to be taken again.
NetworkMarch::NodeJump NetworkMarch::stepBlock() {
    for (const NodeTurn& turn : m_turns) {
        if (m_stop.stop_requested()) return {};
        const NodeJump jump = turn.node == 0                          ? stepRear(turn)
                              : turn.node == m_lines.size()           ? stepBit(turn)
                              : turn.node == m_problem.hammerSections ? stepFace(turn)
                                                                      : stepJoint(turn.node, turn);
        if (jump.found) return jump;
    }
    return {};
}

NetworkMarch::NodeJump NetworkMarch::stepRear(const NodeTurn& turn) {
    const WaveCell* back = m_lines[0].arriving();
    for (std::size_t i = turn.from; i < turn.behind(); ++i) m_downs[0][i] = -m_passing[0] * back[i];
    return {};
}

NetworkMarch::NodeJump NetworkMarch::stepJoint(std::size_t j, const NodeTurn& turn) {
    const std::size_t parts = m_cuts.count();
    const std::size_t part = (static_cast<std::size_t>(m_step) + turn.from) % parts;
    const WaveCell* f1 = m_downs[j - 1].data() + turn.from;
    const WaveCell* b2 = m_lines[j].arriving() + turn.from;
    WaveCell* f2 = m_downs[j].data() + turn.from;
    if (m_passing[j - 1] != 1) {
        for (std::size_t i = 0; i < turn.count; ++i) f2[i] = m_passing[j - 1] * f1[i];
        f1 = f2;
    }
    if (m_passing[j] != 1) {
        for (std::size_t i = 0; i < turn.count; ++i) m_weakened[i] = m_passing[j] * b2[i];
        b2 = m_weakened.data();
    }
    if (m_joints[j - 1].mass() > 0 && m_census) countMass(j - 1, f1, b2, turn);
    m_joints[j - 1].step(f1, b2, m_lines[j - 1].leaving() + turn.from, f2, turn.count, part, parts);
    return {};
}

NetworkMarch::NodeJump NetworkMarch::stepFace(const NodeTurn& turn) {
    const std::size_t j = m_problem.hammerSections;
    CellCuts::Walk at(m_cuts, m_step + static_cast<long>(turn.from));
    CellJump jump;
    for (std::size_t i = turn.from; i < turn.behind(); ++i, at.next()) {
        WaveCell f = m_downs[j - 1][i];
        WaveCell b = m_passing[j] == 1 ? m_lines[j].arriving()[i] : m_passing[j] * m_lines[j].arriving()[i];
        const int part = static_cast<int>(at.part());
        const double time = at.clock();
        if (m_census && m_census->time() >= time && m_census->time() < endOf(at)) countFace(f, b, at);
        m_face.step(f, b, part, time, i < m_faceTaken ? CutAt::nothing : m_cutAt, jump);
        if (jump.found) return {true, j, i, jumpPlace(at.part(), jump.place)};
        m_downs[j][i] = f;
        m_lines[j - 1].leaving()[i] = b;
    }
    return {};
}

NetworkMarch::NodeJump NetworkMarch::stepBit(const NodeTurn& turn) {
    const std::size_t j = m_problem.sections.size() - 1;
    CellCuts::Walk at(m_cuts, m_step + static_cast<long>(turn.from));
    CellJump jump;
    const double censusClock = m_census ? m_census->clockOf(j + 1) : -1;
    const long pieces = m_bit.pieces();
    for (std::size_t i = turn.from; i < turn.behind(); ++i, at.next()) {
        const WaveCell g = m_passing[j] == 1 ? m_downs[j][i] : m_passing[j] * m_downs[j][i];
        const int part = static_cast<int>(at.part());
        const double clock = at.clock(), time = clock + m_clocks.bit();
        if (censusClock >= clock && censusClock < endOf(at)) countBit(g, at);
        constexpr long fewPieces = 1000;  // many of them may take as long as blocks do
        if (m_bit.pieces() - pieces > fewPieces && m_stop.stop_requested()) return {};
        m_lines[j].leaving()[i] = m_bit.step(g, part, time, i < m_bitTaken ? CutAt::nothing : m_cutAt, jump);
        if (jump.found) return {true, j + 1, i, jumpPlace(at.part(), jump.place)};
        if (m_waves) m_bitForces[i] = m_bit.cellForce();
    }
    return {};
}

/// For the census, whose time lies in this cell.
void NetworkMarch::countFace(const WaveCell& f1, const WaveCell& b2, const CellCuts::Walk& at) {
    const std::size_t j = m_problem.hammerSections;
    const double share = std::min(1.0, (m_census->time() - at.clock()) / at.width());
    const FaceNode::Part first = m_face.partOfStep(f1, b2, static_cast<int>(at.part()), share, at.clock());
    m_census->setFace(first.state);
    m_census->down(j).setEntered(first.f2, at.clock());
    m_census->up(j - 1).setEntered(first.b1, at.clock());
}

/// For the census, whose time lies in this cell.
void NetworkMarch::countBit(const WaveCell& g, const CellCuts::Walk& at) {
    const std::size_t j = m_problem.sections.size() - 1;
    const double share = std::min(1.0, (m_census->clockOf(j + 1) - at.clock()) / at.width());
    const BitNode::Part first =
        m_bit.partOfStep(g, static_cast<int>(at.part()), share, at.clock() + m_clocks.bit());
    m_census->setBit(first.state);
    m_census->up(j).setEntered(first.leaving, at.clock());
}

/// For the census, where its time lies in these turns.
void NetworkMarch::countMass(std::size_t joint, const WaveCell* f1, const WaveCell* b2,
                             const NodeTurn& turn) {
    const double wanted = m_census->clockOf(joint + 1);
    const long from = m_step + static_cast<long>(turn.from);
    if (wanted < m_cuts.clock(from) || wanted >= m_cuts.clock(from + static_cast<long>(turn.count))) return;
    Joint copy = m_joints[joint];
    WaveCell f2, b1;
    for (std::size_t i = 0; i < turn.count; ++i) {
        const long step = from + static_cast<long>(i);
        const double start = m_cuts.clock(step), width = m_cuts.width(step);
        if (wanted >= m_cuts.clock(step + 1)) {
            copy.step(f1 + i, b2 + i, &b1, &f2, 1, static_cast<std::size_t>(step) % m_cuts.count(),
                      m_cuts.count());
            continue;
        }
        const double share = std::min(1.0, (wanted - start) / width);
        if (share > 0) copy.stepAlone(f1[i].part(0, share), b2[i].part(0, share), share * width, b1, f2);
        m_census->setMassVelocity(joint, copy.velocity());
        m_census->down(joint + 1).setEntered(f2, start);
        m_census->up(joint).setEntered(b1, start);
        return;
    }
}

/// One block of steps, cut where waves jump.
void NetworkMarch::takeBlock() {
    const Nodes before = nodes();
    m_faceTaken = m_bitTaken = 0;
    while (true) {
        const bool mayCut = m_mayCut && !m_cuts.isFull() && m_recut <= m_mostRecut;
        m_cutAt = mayCut ? m_wants.cutAt : CutAt::nothing;
        const NodeJump jump = stepBlock();
        if (!jump.found) return;
        setNodes(before);
        if (cut(jump.place)) {
            m_faceTaken = m_bitTaken = 0;  // steps have other numbers now
        } else {
            (jump.node == m_lines.size() ? m_bitTaken : m_faceTaken) = jump.step + 1;
        }
    }
}

/// Cuts all cells at a place. False where that is not to be done.
bool NetworkMarch::cut(double place) {
    CellCuts finer = m_cuts;
    if (!finer.cutAt(place)) return false;
    m_mayCut = isAffordable(finer);
    if (!m_mayCut) return false;
    const CellCuts coarse = std::exchange(m_cuts, std::move(finer));
    for (const DelayLine<WaveCell>& line : m_lines) m_recut += static_cast<long>(line.delay());
    const long parts = static_cast<long>(coarse.count());
    const std::size_t part = static_cast<std::size_t>(m_step % parts);
    const auto at = std::lower_bound(m_cuts.places().begin(), m_cuts.places().end(), coarse.places()[part]);
    m_step = m_step / parts * static_cast<long>(m_cuts.count()) + (at - m_cuts.places().begin());
    for (DelayLine<WaveCell>& line : m_lines)
        line.replace(m_cuts.recut(line.arriving(), line.delay(), coarse, part));
    for (std::size_t j = 0; j < m_watches.size(); ++j)
        m_watches[j].restart(m_lines[j].content(), m_step, m_cuts);
    setWidths();
    planTurns();
    return true;
}

/// Whether the way that is left at most is no more work with these parts of cells than is permitted.
bool NetworkMarch::isAffordable(const CellCuts& cuts) const {
    const double cells = (limitTime() - clock()) / m_grid.cell * static_cast<double>(cuts.count());
    const double nodes = static_cast<double>(m_lines.size() + 1);
    return cells * nodes <= static_cast<double>(m_mostWork - work());
}

void NetworkMarch::observe(std::size_t count) {
    if (!m_census && !m_wants.forces) return;
    const double start = clock(), end = m_cuts.clock(m_step + static_cast<long>(count));
    const double lastTime = m_problem.endTime.value_or(std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; j < m_lines.size() && !m_stop.stop_requested(); ++j) {
        if (m_census) {
            for (const bool down : {true, false}) {
                LineCensus& line = down ? m_census->down(j) : m_census->up(j);
                if (!line.concerns(start, end, m_lossy)) continue;
                const WaveCell* cells = down ? m_downs[j].data() : m_lines[j].leaving();
                CellCuts::Walk at(m_cuts, m_step);
                for (std::size_t i = 0; i < count; ++i, at.next()) line.add(cells[i], at.clock(), at.width());
            }
        }
        if (m_wants.forces)
            for (std::size_t i = 0; i < count; ++i)
                m_watches[j].add(m_downs[j][i], m_lines[j].leaving()[i],
                                 {m_lines[j].arriving() + i, m_lines[j].delay()},
                                 m_step + static_cast<long>(i), m_cuts, lastTime);
        if (m_wants.forces && j >= m_problem.hammerSections && j + 1 < m_lines.size())
            for (std::size_t i = 0; i < count; ++i) {
                const WaveCell f1 = m_passing[j] * m_downs[j][i], none;
                const long step = m_step + static_cast<long>(i);
                WaveCell b1, f2;
                m_alone[j].step(&f1, &none, &b1, &f2, 1, static_cast<std::size_t>(step) % m_cuts.count(),
                                m_cuts.count());
                m_reflected[j] += m_cuts.width(step) * b1.meanSquare();
            }
    }
}

/// Where they are too many, none is kept.
void NetworkMarch::keepWaves(std::size_t count) {
    if (m_waves->isFull()) return m_waves.reset();
    CellCuts::Walk at(m_cuts, m_step);
    for (std::size_t i = 0; i < count; ++i, at.next())
        m_waves->addStep(at.clock(), at.width(), m_bitForces[i]);
    for (std::size_t j = 0; j < m_lines.size(); ++j)
        for (std::size_t i = 0; i < count; ++i) m_waves->add(j, m_downs[j][i], m_lines[j].leaving()[i]);
}

double NetworkMarch::limitTime() const {
    return limitOf(m_problem, m_clocks);
}

/// Decides when all that moves is counted next: all of it must lie ahead.
void NetworkMarch::scheduleCensus() {
    if (m_problem.endTime || m_lossy) {  // no proof for what loses: what passes counts from the beginning on
        m_census.emplace(m_problem, m_clocks, limitTime());
        return;
    }
    double ahead = 0;
    for (std::size_t j = 0; j < m_lines.size(); ++j)
        ahead = std::max(ahead, m_clocks.delays[j + 1] + m_clocks.transitTimes[j]);
    const double time = clock() + ahead;
    const bool isFree = m_bit.state().isApart() && m_bit.state().record.contacts > 0 && m_face.state().apart;
    if (isFree ? !m_free && clock() >= m_landing : time >= limitTime())
        m_census.emplace(m_problem, m_clocks, time);
}

NetworkImpact NetworkMarch::notSolved(std::string reason) const {
    NetworkImpact impact;
    impact.reason = std::move(reason);
    impact.cells = m_cells;
    return impact;
}

long NetworkMarch::flownCells() const {
    return static_cast<long>(m_flown / flownOfCell);
}

long NetworkMarch::work() const {
    return flownCells() + m_recut + m_cells + workOfPiece * (m_bit.pieces() + m_face.pieces());
}

/// What is looked at beside that for the largest forces.
long NetworkMarch::workForForces() const {
    if (!m_wants.forces) return 0;
    long looked = 0;
    for (const SectionWatch& watch : m_watches) looked += watch.looked();
    return m_cells * (workOfForces - 1) + workOfLook * looked;
}

void NetworkMarch::leaveOutForces() {
    m_wants.forces = false;
    m_watches.clear();
    m_leftOutForces = true;
}

NetworkImpact NetworkMarch::run(long mostCells, const std::stop_token& stop) {
    const std::size_t nodeCount = m_problem.sections.size() + 1;
    constexpr std::size_t count = mostBlock;
    m_stop = stop;
    m_mostWork = mostCells;
    m_mostRecut = static_cast<long>(shareOfCuts * static_cast<double>(mostCells));
    while (true) {
        if (m_wants.forcesIfTheyFit && work() + workForForces() > mostCells) leaveOutForces();
        if (work() + workForForces() > mostCells) return notSolved("it takes more wave cells than permitted");
        if (!m_census) scheduleCensus();
        takeBlock();
        if (!m_bit.trouble().empty()) return notSolved(std::string(m_bit.trouble()));
        if (!m_face.trouble().empty()) return notSolved(std::string(m_face.trouble()));
        m_cells += static_cast<long>(count * nodeCount);
        observe(count);
        if (m_waves) keepWaves(count);
        if (m_stop.stop_requested()) return notSolved("stopped");  // a block may be left unfinished
        for (DelayLine<WaveCell>& line : m_lines) line.advance(count);
        m_step += static_cast<long>(count);
        if (std::optional<NetworkImpact> impact = endOfBlow()) return *std::move(impact);
    }
}

std::optional<NetworkImpact> NetworkMarch::endOfBlow() {
    const auto restOf = [&](const CensusResult& census) {
        return restTime(m_problem, census).value_or(std::numeric_limits<double>::infinity());
    };
    if (m_census && clock() > m_census->lastClock()) {
        const CensusResult census = m_census->finish();
        m_census.reset();
        if (m_problem.endTime) return result(census, NetworkEnd::endTime);
        if (census.time >= limitTime()) {
            const bool proven = !m_lossy && restOf(census) <= census.time;
            return result(census, proven ? NetworkEnd::proven : NetworkEnd::nextBlow);
        }
        if (census.bit.isApart() && census.face.apart) m_free = census;
    }
    if (!m_free) return {};
    if (!isUntouchedSince(*m_free)) {
        m_free.reset();
        return {};
    }
    // what is counted stays as it is until something touches again
    const double rest = restOf(*m_free), last = std::min(rest, limitTime());
    if (clock() < last - m_clocks.earliest() && !fliesUntil(last)) return {};
    m_free->time = std::max(last, m_free->time);
    return result(*m_free, rest <= limitTime() ? NetworkEnd::proven : NetworkEnd::nextBlow);
}

bool NetworkMarch::isUntouchedSince(const CensusResult& census) const {
    const BitNodeState& bit = m_bit.state();
    const FaceNodeState& face = m_face.state();
    return bit.isApart() && bit.record.contacts == census.bit.record.contacts && face.apart &&
           face.record.impulse == census.face.record.impulse;
}

/// Whether nothing touches until then, told by the means of the waves where those are all that is wanted.
bool NetworkMarch::fliesUntil(double time) {
    if (m_wants.forces || m_wants.histories || clock() < m_landing || !FreeFlight::suits(m_problem))
        return false;
    FlightStart start{.waves = {},
                      .faceGap = m_face.state().gap,
                      .bitDistance = m_bit.state().distance,
                      .hammerEnergy = m_free->hammerEnergy,
                      .stringEnergy = m_free->stringEnergy,
                      .released = m_face.state().released};
    if (!FreeFlight::isClear(m_problem, m_grid.cell, start)) return false;
    for (const DelayLine<WaveCell>& line : m_lines)
        start.waves.push_back(m_cuts.meansOfCells(line.content(), m_step));
    FreeFlight flight(m_problem, m_grid.cell, start);
    const bool stays = flight.staysClear((time - clock()) / m_grid.cell, m_stop);
    m_flown += flight.gone() * static_cast<double>(m_lines.size() + 1);
    m_landing = clock() + flight.gone() * m_grid.cell;
    return stays;
}

NetworkImpact NetworkMarch::result(const CensusResult& census, NetworkEnd end) {
    NetworkImpact impact = impactOf(m_problem, census);
    impact.end = end;
    std::copy_if(m_events.begin(), m_events.end(), std::back_inserter(impact.events),
                 [&](const ImpactEvent& event) { return event.time <= census.time; });
    for (const SectionWatch& watch : m_watches) impact.sections.push_back(watch.forces());
    if (m_wants.forces)
        for (std::size_t j = m_problem.hammerSections; j < m_joints.size(); ++j)
            impact.jointReflection.push_back(m_reflected[j] / m_problem.sections[j].impedance /
                                             impact.hammerEnergy);
    if (m_waves) m_waves->finish(census.time);
    impact.leftOutForces = m_leftOutForces;
    impact.waves = m_waves;
    impact.cells = m_cells + flownCells();
    impact.cell = m_grid.cell;
    impact.rounding = m_grid.rounding;
    return impact;
}

}  // namespace drillwave
