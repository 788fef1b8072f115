// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/network_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

/// Steps taken by one node before the next one follows: what a first-level cache holds.
constexpr std::size_t mostBlock = 64;

/// Without another limit a blow is followed for so many round trips of the string.
constexpr double mostRoundTrips = 40;

/// What a piece of a cell with events takes, and a cell with its largest forces, in cells.
constexpr long workOfPiece = 60, workOfForces = 8;

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

std::size_t NetworkMarch::nextBlock() const {
    std::size_t block = mostBlock;
    for (const DelayLine& line : m_lines) block = std::min(block, line.delay());
    return block;
}

/// Whether a contact may begin within a cell.
bool NetworkMarch::mayJump() const {
    if (m_wants.cutAt != CutAt::jumps) return m_wants.cutAt == CutAt::corners;
    return (m_face.state().apart && !m_face.state().released) || m_bit.state().isApart();
}

double NetworkMarch::jumpPlace(std::size_t part, double place) const {
    return m_cuts.places()[part] + place * m_cuts.widths()[part] / m_grid.cell;
}

CellJump NetworkMarch::stepBlock(std::size_t count, CutAt cutAt) {
    const std::size_t last = m_problem.sections.size() - 1;
    const std::size_t parts = m_cuts.count(), part = static_cast<std::size_t>(m_step) % parts;
    for (std::size_t i = 0; i < count; ++i) m_downs[0][i] = -m_passing[0] * m_lines[0].arriving()[i];
    for (std::size_t j = 1; j <= last; ++j) {
        if (m_passing[j - 1] != 1)
            for (std::size_t i = 0; i < count; ++i) m_downs[j][i] = m_passing[j - 1] * m_downs[j - 1][i];
        if (j == m_problem.hammerSections) {
            const CellJump jump = stepFace(count, cutAt);
            if (jump.found) return jump;
            continue;
        }
        const WaveCell* f1 = m_passing[j - 1] == 1 ? m_downs[j - 1].data() : m_downs[j].data();
        const WaveCell* b2 = m_lines[j].arriving();
        if (m_passing[j] != 1) {
            for (std::size_t i = 0; i < count; ++i) m_weakened[i] = m_passing[j] * b2[i];
            b2 = m_weakened.data();
        }
        if (m_joints[j - 1].mass() > 0 && m_census) takeMassVelocity(j - 1, f1, b2, count);
        m_joints[j - 1].step(f1, b2, m_lines[j - 1].leaving(), m_downs[j].data(), count, part, parts);
    }
    return stepBit(count, cutAt);
}

CellJump NetworkMarch::stepFace(std::size_t count, CutAt cutAt) {
    const std::size_t j = m_problem.hammerSections;
    CellCuts::Walk at(m_cuts, m_step);
    CellJump jump;
    for (std::size_t i = 0; i < count; ++i, at.next()) {
        WaveCell f = m_downs[j - 1][i];
        WaveCell b = m_passing[j] == 1 ? m_lines[j].arriving()[i] : m_passing[j] * m_lines[j].arriving()[i];
        const int part = static_cast<int>(at.part());
        const double time = at.clock();
        if (m_census && m_census->time() >= time && m_census->time() < endOf(at)) {
            const double share = std::min(1.0, (m_census->time() - time) / at.width());
            m_census->setFace(m_face.stateWithin(f, b, part, share, time));
        }
        m_face.step(f, b, part, time, cutAt, jump);
        if (jump.found) return {true, jumpPlace(at.part(), jump.place)};
        m_downs[j][i] = f;
        m_lines[j - 1].leaving()[i] = b;
    }
    return {};
}

CellJump NetworkMarch::stepBit(std::size_t count, CutAt cutAt) {
    const std::size_t j = m_problem.sections.size() - 1;
    CellCuts::Walk at(m_cuts, m_step);
    CellJump jump;
    const double censusClock = m_census ? m_census->clockOf(j + 1) : -1;
    for (std::size_t i = 0; i < count; ++i, at.next()) {
        const WaveCell g = m_passing[j] == 1 ? m_downs[j][i] : m_passing[j] * m_downs[j][i];
        const int part = static_cast<int>(at.part());
        const double clock = at.clock(), time = clock + m_clocks.bit();
        if (m_census && censusClock >= clock && censusClock < endOf(at)) {
            const double share = std::min(1.0, (censusClock - clock) / at.width());
            m_census->setBit(m_bit.stateWithin(g, part, share, time));
        }
        m_lines[j].leaving()[i] = m_bit.step(g, part, time, cutAt, jump);
        if (jump.found) return {true, jumpPlace(at.part(), jump.place)};
        if (m_waves) m_bitForces[i] = m_bit.cellForce();
    }
    return {};
}

/// The velocity of the mass of a joint at the time of the census, where that lies in this block.
void NetworkMarch::takeMassVelocity(std::size_t joint, const WaveCell* f1, const WaveCell* b2,
                                    std::size_t count) {
    const double wanted = m_census->clockOf(joint + 1);
    if (wanted < clock() || wanted >= m_cuts.clock(m_step + static_cast<long>(count))) return;
    Joint copy = m_joints[joint];
    for (std::size_t i = 0; i < count; ++i) {
        const long step = m_step + static_cast<long>(i);
        const double start = m_cuts.clock(step), width = m_cuts.width(step);
        if (wanted < m_cuts.clock(step + 1)) {
            m_census->setMassVelocity(
                joint, copy.velocityWithin(f1[i], b2[i], width, std::min(1.0, (wanted - start) / width)));
            return;
        }
        WaveCell f2, b1;
        copy.step(f1 + i, b2 + i, &b1, &f2, 1, static_cast<std::size_t>(step) % m_cuts.count(),
                  m_cuts.count());
    }
}

/// Cuts all cells at a place. False where that is not to be done.
bool NetworkMarch::cut(double place) {
    const CellCuts coarse = m_cuts;
    if (!m_cuts.cutAt(place)) return false;
    const long parts = static_cast<long>(coarse.count());
    const std::size_t part = static_cast<std::size_t>(m_step % parts);
    const auto at = std::lower_bound(m_cuts.places().begin(), m_cuts.places().end(), coarse.places()[part]);
    m_step = m_step / parts * static_cast<long>(m_cuts.count()) + (at - m_cuts.places().begin());
    for (DelayLine& line : m_lines) line.replace(m_cuts.recut(line.arriving(), line.delay(), coarse, part));
    for (std::size_t j = 0; j < m_watches.size(); ++j)
        m_watches[j].restart(m_lines[j].content(), m_step, m_cuts);
    setWidths();
    return true;
}

void NetworkMarch::observe(std::size_t count) {
    if (!m_census && !m_wants.forces) return;
    const double start = clock(), end = m_cuts.clock(m_step + static_cast<long>(count));
    const double lastTime = m_problem.endTime.value_or(std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; j < m_lines.size(); ++j) {
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
    if (m_bit.state().isApart() && m_bit.state().record.contacts > 0 && m_face.state().apart) {
        m_census.emplace(m_problem, m_clocks, time);
    } else if (time >= limitTime()) {
        m_census.emplace(m_problem, m_clocks, time);
    }
}

NetworkImpact NetworkMarch::notSolved(std::string reason) const {
    NetworkImpact impact;
    impact.reason = std::move(reason);
    impact.cells = m_cells;
    return impact;
}

long NetworkMarch::work() const {
    long looked = 0;
    for (const SectionWatch& watch : m_watches) looked += watch.looked();
    return m_cells * (m_wants.forces ? workOfForces : 1) + workOfPiece * (m_bit.pieces() + m_face.pieces()) +
           workOfLook * looked;
}

NetworkImpact NetworkMarch::run(long mostCells, const std::stop_token& stop) {
    const std::size_t nodeCount = m_problem.sections.size() + 1;
    bool cuts = true;
    while (true) {
        if (stop.stop_requested()) return notSolved("stopped");
        if (work() > mostCells) return notSolved("it takes more wave cells than permitted");
        if (!m_census) scheduleCensus();
        const std::size_t count = nextBlock();
        if (mayJump() && cuts) {
            const Nodes before = nodes();
            const CellJump jump = stepBlock(count, m_wants.cutAt);
            if (jump.found) {
                setNodes(before);
                cuts = cut(jump.place);  // else this block is taken as it is
                continue;
            }
        } else {
            stepBlock(count, CutAt::nothing);
        }
        cuts = true;
        if (!m_bit.trouble().empty()) return notSolved(std::string(m_bit.trouble()));
        if (!m_face.trouble().empty()) return notSolved(std::string(m_face.trouble()));
        m_cells += static_cast<long>(count * nodeCount);
        observe(count);
        if (m_waves) keepWaves(count);
        for (DelayLine& line : m_lines) line.advance(count);
        m_step += static_cast<long>(count);
        if (!m_census || clock() <= m_census->lastClock()) continue;
        const CensusResult census = m_census->finish();
        if (m_problem.endTime) return result(census, NetworkEnd::endTime);
        if (!m_lossy && nothingFollows(m_problem, census)) return result(census, NetworkEnd::proven);
        if (census.time >= limitTime()) return result(census, NetworkEnd::nextBlow);
        m_census.reset();
    }
}

NetworkImpact NetworkMarch::result(const CensusResult& census, NetworkEnd end) {
    NetworkImpact impact;
    impact.end = end;
    impact.endTime = census.time;
    for (std::size_t j = 0; j < m_problem.hammerSections; ++j)
        impact.hammerMass += m_problem.sections[j].mass() + m_problem.sections[j].massAfter;
    impact.hammerMomentum = impact.hammerMass;
    impact.hammerEnergy = impact.hammerMass / 2;
    const double e0 = impact.hammerEnergy;

    BilinearLaw<double> law = census.bit.law;
    law.remember(census.bit.force);
    const double force = census.bit.isApart() ? 0 : census.bit.force;
    impact.energy = {law.worked(force) / e0, census.hammerEnergy / e0, census.stringEnergy / e0,
                     census.jointLoss / e0,  census.rodLoss / e0,      census.faceEnergy / e0};
    const NetworkLedger& energy = impact.energy;
    impact.energyResidual =
        1 - energy.rock - energy.hammer - energy.string - energy.joints - energy.rods - energy.face;
    const BitRecord& rock = census.bit.record;
    impact.rockImpulse = rock.impulse;
    impact.pistonMomentum = census.hammerMomentum;
    impact.stringMomentum = census.stringMomentum;
    impact.externalMomentum = census.externalMomentum;
    impact.momentumResidual = (impact.hammerMomentum - rock.impulse - census.hammerMomentum -
                               census.stringMomentum - census.externalMomentum) /
                              impact.hammerMomentum;
    impact.peakForce = rock.peakForce;
    impact.peakTime = rock.peakTime;
    impact.largestPenetration = law.largestPenetration();
    impact.residualPenetration = law.residualPenetration();
    impact.firstContact = rock.firstContact;
    impact.lastSeparation = rock.lastSeparation;
    impact.contactDuration = rock.contactDuration;
    impact.contacts = rock.contacts;
    const FaceRecord& face = census.face.record;
    impact.faceImpulse = face.impulse;
    impact.faceSeparation = face.firstSeparation;

    std::copy_if(m_events.begin(), m_events.end(), std::back_inserter(impact.events),
                 [&](const ImpactEvent& event) { return event.time <= census.time; });
    for (const SectionWatch& watch : m_watches) impact.sections.push_back(watch.forces());
    if (m_wants.forces)
        for (std::size_t j = m_problem.hammerSections; j < m_joints.size(); ++j)
            impact.jointReflection.push_back(m_reflected[j] / m_problem.sections[j].impedance / e0);
    if (m_waves) m_waves->finish(census.time);
    impact.waves = m_waves;
    impact.cells = m_cells;
    impact.cell = m_grid.cell;
    impact.rounding = m_grid.rounding;
    return impact;
}

}  // namespace drillwave
