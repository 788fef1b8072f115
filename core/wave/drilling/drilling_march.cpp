// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/drilling/drilling_march.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/numeric/normal_quantile.h"
#include "core/wave/network/census.h"

namespace drillwave {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// How often it is asked whether to stop, in cells.
constexpr long cellsBetweenStops = 2048;

/// A time that is so near to the beginning of a cell is there [cells].
constexpr double sameClock = 1e-7;

/// An interval is at most so many deviations off its mean.
constexpr double mostDeviations = 3;

/// Fa over the parts of cells that follow the front, as long as it acts.
std::vector<WaveCell> cellsOf(const PulseForce& force, const CellCuts& cuts) {
    std::vector<WaveCell> cells;
    CellCuts::Walk at(cuts, 0);
    const double last = force.end - 1e-12 * std::max(1.0, force.end);
    for (; at.clock() < last; at.next()) {
        const double time = at.clock(), width = at.width();
        CellProjection projection;
        auto segment = std::ranges::upper_bound(force.segments, time, {}, &PulseSegment::start);
        if (segment != force.segments.begin()) --segment;
        for (; segment != force.segments.end() && segment->start < time + width; ++segment) {
            const double from = std::max(time, segment->start) - segment->start;
            const double to = std::min(time + width - segment->start, segment->length);
            const double offset = segment->start - time;
            if (to > from)
                projection.add((offset + from) / width, (offset + to) / width,
                               [&](double u) { return segment->forceAt(u * width - offset); });
        }
        cells.push_back(projection.cell());
    }
    return cells;
}

}  // namespace

DrillingMarch::DrillingMarch(const DrillingProblem& problem, const DrillingGrid& grid)
    : m_problem(problem),
      m_grid(grid),
      m_hammer(problem.blow.hammerSections()),
      m_interval(grid.interval()),
      m_random(problem.seed) {
    const Problem& blow = problem.blow;
    const std::size_t count = blow.sections.size();
    assert(problem.waveLosses.size() == count);
    const std::vector<double>& widths = grid.cuts.widths();
    m_lines.resize(count);
    m_arriving.resize(count);
    if (grid.shortSection()) {
        m_failureReason = translatable(
            "a section is shorter than a time step: take more (--cells), or leave the section out and add "
            "its mass to the section before it");
        return;
    }
    double passing = 1;  // amplitude that the joint in front of a section passes
    for (std::size_t j = 0; j < count; ++j) {
        m_lines[j].begin(grid.roundTrips[j], grid.cell, problem.waveLosses[j], widths);
        const double transit = grid.roundTrips[j] * grid.cell / 2;
        const double mass = blow.sections[j].impedance * transit;
        if (j >= m_hammer) m_stringTransit += transit;
        (j < m_hammer ? m_hammerMass : m_stringMass) += mass + blow.sections[j].massAfter;
        if (j >= m_hammer) {
            passing *= std::exp(-blow.sections[j].decay);
            m_isWeakened = m_isWeakened || passing < 1;
            m_downLosses.emplace_back(passing, 1 / problem.interval);
            m_upLosses.emplace_back(passing, 1 / problem.interval);
            passing = std::sqrt(1 - blow.sections[j].loss);
        } else {
            m_downLosses.emplace_back();
            m_upLosses.emplace_back();
        }
        if (j + 1 == count) continue;
        UniformSection near = blow.sections[j];
        near.loss = 0;  // applied by m_downLosses and m_upLosses
        m_joints.emplace_back(near, blow.sections[j + 1], 0);
        m_joints.back().setWidths(widths);
    }
    m_bit =
        BitNode(blow.sections.back().impedance, blow.sections.back().massAfter, blow.law, blow.distance());
    m_bit.setWidths(widths);
    m_bit.notePeaksOfCycles();
    RearNode::Parts parts{
        .impedance = blow.sections[m_hammer].impedance, .face = {}, .machine = problem.machine};
    if (m_hammer > 0) {
        parts.hammerImpedance = blow.sections[m_hammer - 1].impedance;
        parts.face = blow.hammer().face;
        parts.releasesAtOnce = grid.releasesAtOnce;
        m_hammerMomentum = m_hammerMass * blow.hammer().velocity;
    } else {
        m_force = cellsOf(blow.force(), grid.cuts);
    }
    m_rear = RearNode(parts, widths);
    m_lastImpulse = m_hammerMomentum;
    if (problem.start == DrillingStart::bouncing) {
        const double velocity = blow.velocity() / 2;
        for (std::size_t j = m_hammer; j < count; ++j) {
            const double wave = velocity * blow.sections[j].impedance / 2;
            m_lines[j].fill(-wave);
            m_downLosses[j].setMean(wave);
            m_upLosses[j].setMean(-wave);
            if (j + 1 < count) m_joints[j].setVelocity(velocity);
        }
        m_bit.setVelocity(velocity);
        m_momentumAtBlow = velocity * m_stringMass;
    }
    m_returning.resize(count);
    m_downs.resize(count);
    m_backs.resize(count);
    m_next.gap = blow.distance();
    m_nextPlace = -blow.distance();
    m_nextInterval = cellsOfNextInterval();
    m_startMomentum = momentum();
    m_storedBefore = storedEnergy();
    m_failureReason = m_rear.failureReason();
}

double DrillingMarch::work() const {
    constexpr double workOfPiece = 50;  // from one event at the bit to the next
    const double cells = static_cast<double>(m_cells) * static_cast<double>(m_grid.cuts.count()) *
                         static_cast<double>(m_lines.size() + 1);
    return cells + workOfPiece * static_cast<double>(m_bit.pieces());
}

/// Returns the momentum of rod or string, machine and masses, each on its own clock.
double DrillingMarch::momentum() const {
    double sum = m_rear.bodyMass() * m_rear.state().bodyVelocity;
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j) {
        sum += m_downLosses[j].held() - m_upLosses[j].held() - m_lines[j].held();
        if (j + 1 < m_lines.size()) sum += m_joints[j].mass() * m_joints[j].velocity();
    }
    return sum + m_bit.mass() * m_bit.state().velocity;
}

double DrillingMarch::storedEnergy() const {
    const double velocity = m_rear.state().bodyVelocity;
    double sum = m_rear.bodyMass() * velocity * velocity / 2;
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j) {
        sum += (m_lines[j].square() + m_downLosses[j].square() + m_upLosses[j].square()) /
               m_problem.blow.sections[j].impedance;
        if (j + 1 < m_lines.size())
            sum += m_joints[j].mass() * m_joints[j].velocity() * m_joints[j].velocity() / 2;
    }
    return sum + m_bit.mass() * m_bit.state().velocity * m_bit.state().velocity / 2;
}

double DrillingMarch::hammerEnergy() const {
    double sum = 0;
    for (std::size_t j = 0; j < m_hammer; ++j) {
        sum += m_lines[j].square() / m_problem.blow.sections[j].impedance;
        if (j + 1 < m_hammer) sum += m_joints[j].mass() * m_joints[j].velocity() * m_joints[j].velocity() / 2;
    }
    return sum;
}

long DrillingMarch::cellsOfNextInterval() {
    if (m_problem.intervalScatter == 0) return m_grid.cellsOfInterval;
    double deviation = 0;
    do {
        const double share = (static_cast<double>(m_random()) + 0.5) / 4294967296.0;
        deviation = normalQuantile(share);
    } while (std::abs(deviation) > mostDeviations);
    return std::max(1L, std::lround(static_cast<double>(m_grid.cellsOfInterval) *
                                    (1 + m_problem.intervalScatter * deviation)));
}

/// The front is there: new rock, a new piston, the mean force of the cycle.
void DrillingMarch::beginBlow() {
    m_blow = m_next;
    m_next = {};
    m_blow.time = static_cast<double>(m_cells) * m_grid.cell;
    m_blow.velocity = m_momentumAtBlow / m_stringMass;
    m_blow.shankOffset = m_problem.machine ? -m_rear.state().stretch : nothing;
    m_rear.beginBlow(m_problem.feedForce - m_lastImpulse / m_interval);
    if (m_hammer > 0) {
        const double velocity = m_problem.blow.hammer().velocity;
        for (std::size_t j = 0; j < m_hammer; ++j) {
            m_lines[j].fill(-velocity * m_problem.blow.sections[j].impedance / 2);
            if (j + 1 < m_hammer) m_joints[j].setVelocity(velocity);
        }
        m_ledger.hammer += hammerEnergy();
    }
    // on the clock of the bit
    const double next =
        std::max(0.0, static_cast<double>(m_nextInterval) - m_stringTransit / m_grid.cell + sameClock);
    m_gapCell = static_cast<long>(next);
    const double offset = next - std::floor(next), place = offset <= 2 * sameClock ? 0 : offset - sameClock;
    const std::vector<double>& places = m_grid.cuts.places();
    m_gapPart = static_cast<std::size_t>(std::ranges::upper_bound(places, place) - places.begin()) - 1;
    const double end = m_gapPart + 1 < places.size() ? places[m_gapPart + 1] : 1;
    m_gapShare = (place - places[m_gapPart]) / (end - places[m_gapPart]);
    m_rearMoved = 0;
}

/// Notes the gap between bit and rock at the next blow, and what the bit has felt so far.
void DrillingMarch::noteGap(const WaveCell& arriving) {
    const BitNode::Part there = m_bit.partOfStep(arriving, static_cast<int>(m_gapPart), m_gapShare, 0);
    m_next.gap = there.state.isApart() ? std::max(0.0, there.state.distance) : 0;
    m_nextPlace =
        there.state.isApart() ? -there.state.distance : there.state.law.elasticWay(there.state.force);
    m_impulseToGap = there.state.record.impulse;
}

bool DrillingMarch::takeBlow(const std::stop_token& stop) {
    if (!m_failureReason.empty()) return false;
    beginBlow();
    const double worked = m_bit.state().law.worked(m_bit.state().force);
    const std::size_t parts = m_grid.cuts.count();
    const bool canFly = m_lines.size() == 1 && !m_problem.machine && !m_kept;
    const auto* const forceEnd = m_force.data() + m_force.size();
    const WaveCell* force = m_force.data();
    for (m_cell = 0; m_cell < m_nextInterval && m_failureReason.empty(); ++m_cell) {
        if (m_cell % cellsBetweenStops == 0 && stop.stop_requested()) return false;
        for (std::size_t part = 0; part < parts; ++part) {
            const WaveCell* const acting = force < forceEnd ? force++ : nullptr;
            if (!canFly || acting || m_cell == m_gapCell || !flyStep(part)) step(part, acting);
        }
    }
    if (m_failureReason.empty() && !m_bit.failureReason().empty()) m_failureReason = m_bit.failureReason();
    if (m_failureReason.empty() && !m_rear.failureReason().empty()) m_failureReason = m_rear.failureReason();
    if (!m_failureReason.empty()) return false;
    m_ledger.rock += m_bit.state().law.worked(m_bit.state().force) - worked;
    endBlow();
    return true;
}

/// A rod under a constant force and no other, away from the rock: S − b goes down, and comes back at once as
/// b − S. That is most of the time between blows. False, and nothing done, where it may not be so.
bool DrillingMarch::flyStep(std::size_t part) {
    if (!m_bit.state().isApart()) return false;
    const WaveCell arriving = m_lines[0].arrive();
    const double force = m_rear.meanForce();
    WaveCell down = -1.0 * arriving;
    down.c[0] += force;
    if (!m_bit.flyStep(down, part)) return false;
    m_lines[0].turn(-force, arriving, part);
    m_rearMoved += m_grid.cuts.widths()[part] * m_rear.mobility() * (force - 2 * arriving.mean());
    if (m_samples) addSamples(part, m_rear.mobility() * (down - arriving), force, down);
    return true;
}

/// All nodes over one part of a cell, from the rear end to the bit.
void DrillingMarch::step(std::size_t part, const WaveCell* force) {
    const std::size_t count = m_lines.size(), parts = m_grid.cuts.count(), hammer = m_hammer;
    // where waves are kept, a hammer that has no more to give moves on
    const bool hammers = m_rear.hasHammer() || (m_kept && hammer > 0);
    LossyLine* const lines = m_lines.data();
    WaveCell* const arriving = m_arriving.data();
    // behind what joint and section take on the way up
    WaveCell* const returning = m_isWeakened ? m_returning.data() : arriving;
    const double width = m_grid.cuts.widths()[part];
    const auto enter = [&](std::size_t j, const WaveCell& back) {
        lines[j].enter(back, arriving[j], part);
        if (m_kept) m_backs[j] = back;
    };
    const auto leave = [&](std::size_t j, const WaveCell& wave) {
        if (m_kept) m_downs[j] = wave;
    };
    for (std::size_t j = hammers ? 0 : hammer; j < count; ++j) arriving[j] = lines[j].arrive();
    if (m_isWeakened) {
        for (std::size_t j = hammers ? 0 : hammer; j < hammer; ++j) returning[j] = arriving[j];
        for (std::size_t j = hammer; j < count; ++j) returning[j] = m_upLosses[j].pass(arriving[j], width);
    }
    WaveCell down, back;
    const auto join = [&](std::size_t j) {
        m_joints[j - 1].step(&down, &returning[j], &back, &down, 1, part, parts);
        enter(j - 1, back);
        if (m_isWeakened && j >= hammer) down = m_downLosses[j].pass(down, width);
        leave(j, down);
    };
    if (hammers) {
        down = -1.0 * arriving[0];
        leave(0, down);
        for (std::size_t j = 1; j < hammer; ++j) join(j);
    }
    const RearNode::Forces rear = m_rear.step(down, returning[hammer], force, part);
    if (hammers) enter(hammer - 1, rear.face - down);
    down = rear.sum() - returning[hammer];
    m_rearMoved += width * m_rear.mobility() * (down.mean() - returning[hammer].mean());
    if (m_isWeakened) down = m_downLosses[hammer].pass(down, width);
    leave(hammer, down);
    for (std::size_t j = hammer + 1; j < count; ++j) join(j);
    if (m_cell == m_gapCell && part == m_gapPart) noteGap(down);
    CellJump none;
    m_bit.step(down, back, static_cast<int>(part), m_kept ? keptClock(part) : 0, CutAt::nothing, none);
    enter(count - 1, back);
    if (m_kept) addWaves(part, rear);
    if (m_samples)
        addSamples(part, m_rear.mobility() * (rear.sum() - 2.0 * returning[hammer]), rear.damper.end(), down);
}

/// Returns where a part of this cell begins on the clock of the kept waves.
double DrillingMarch::keptClock(std::size_t part) const {
    return (static_cast<double>(m_cells + m_cell - m_keptCell) + m_grid.cuts.places()[part]) * m_grid.cell;
}

/// Adds the waves of a part; of a hammer only after the blow, since a new piston arrives for every blow.
void DrillingMarch::addWaves(std::size_t part, const RearNode::Forces& rear) {
    if (!m_kept->waves) return;
    if (m_kept->waves->isFull()) return m_kept->waves.reset();
    m_kept->waves->addStep(keptClock(part), m_grid.cuts.widths()[part], m_bit.cellForce(), rear.face);
    m_kept->waves->addDamper(rear.damper);
    for (std::size_t j = 0; j < m_lines.size(); ++j) {
        if (j < m_hammer && m_cells < m_keptCell) {
            const double first = m_kept->waves->pieces()[j].first;
            m_kept->waves->add(j, WaveCell::constant(first), WaveCell::constant(-first));
        } else {
            m_kept->waves->add(j, m_downs[j], m_backs[j]);
        }
    }
}

MarchedWaves DrillingMarch::takeBlowWithWaves(const std::stop_token& stop) {
    Problem inCells = m_problem.blow;
    std::vector<double> transitTimes;
    for (std::size_t j = 0; j < m_lines.size(); ++j) {
        UniformSection& section = inCells.sections[j];
        section.transitTime = m_grid.roundTrips[j] * m_grid.cell / 2;
        section.decay = section.loss = 0;  // the waves that are kept have lost what they lose
        transitTimes.push_back(section.transitTime);
    }
    StringClocks clocks;
    clocks.begin(m_hammer, transitTimes);

    MarchedWaves kept;
    kept.waves = std::make_shared<StringWaves>(inCells, clocks.delays);
    kept.transitTime = m_stringTransit;
    m_kept = &kept;
    m_bit.setEvents(&kept.events);
    const bool hasBefore = m_count > 0;
    m_keptCell = hasBefore ? m_cells + m_nextInterval : m_cells;
    bool isTaken = !hasBefore || takeBlow(stop);
    if (isTaken) {
        const DrillingLedger before = m_ledger;
        kept.place = m_nextPlace;
        kept.rememberedForce = m_bit.state().law.largestForce();
        kept.residual = m_problem.isFresh ? 0 : m_bit.state().law.residualPenetration();
        if (kept.waves) kept.waves->setMomentum(m_momentumAtBlow);
        isTaken = takeBlow(stop);
        kept.hammerWork = m_ledger.hammer - before.hammer;
        kept.rockWork = m_ledger.rock - before.rock;
    }
    m_bit.setEvents(nullptr);
    m_kept = nullptr;
    if (!isTaken) kept.waves.reset();
    for (ImpactEvent& event : kept.events) event.time += m_stringTransit;
    if (kept.waves) {
        const double end = static_cast<double>(m_cells - m_keptCell) * m_grid.cell;
        kept.waves->finish(end + clocks.earliest());
    }
    return kept;
}

void DrillingMarch::addSamples(std::size_t part, const WaveCell& rearVelocity, double damperForce,
                               const WaveCell& arriving) {
    const std::vector<double>& places = m_grid.cuts.places();
    const double end = part + 1 < places.size() ? places[part + 1] : 1;
    const double time = (static_cast<double>(m_cells + m_cell) + end) * m_grid.cell;
    // the polynomial of a cell in which the damper lifts passes a little below nothing
    if (m_problem.machine) damperForce = std::max(0.0, damperForce);
    m_samples->rear.push_back(
        {time, rearVelocity.end(), damperForce, m_rearPlace + m_rearMoved + m_rear.state().stretch});
    const BitNodeState& bit = m_bit.state();
    const double velocity = m_bit.mass() > 0
                                ? bit.velocity
                                : (2 * arriving.end() - bit.force) / m_problem.blow.sections.back().impedance;
    m_samples->bit.push_back({time + m_stringTransit, bit.force, m_holeDepth + bit.penetration(), velocity});
}

void DrillingMarch::endBlow() {
    const double duration = static_cast<double>(m_nextInterval) * m_grid.cell;
    m_rear.endCycle(duration, m_rearMoved);
    m_rearPlace += m_rearMoved;
    const RearSums& sums = m_rear.sums();
    const BitNodeState& bit = m_bit.state();
    m_cells += m_nextInterval;
    m_blow.rockImpulse = bit.record.impulse;
    m_blow.peakForce = bit.record.peakForce;
    m_blow.contacts = bit.record.contacts;
    m_blow.contactTime = bit.record.contactDuration;
    m_blow.damperPeak = sums.damperPeak;
    m_blow.faceImpulse = sums.faceImpulse;
    m_blow.hammerRebound =
        m_hammer > 0 ? sums.faceImpulse / m_hammerMass - m_problem.blow.hammer().velocity : nothing;
    m_lateShare = sums.lateImpulse / m_hammerMomentum;
    m_momentumAtBlow += sums.faceImpulse + sums.damperImpulse - m_impulseCarriedOver - m_impulseToGap;
    m_impulseCarriedOver = bit.record.impulse - m_impulseToGap;
    m_rockImpulse += bit.record.impulse;
    // what the machine was given, and what has gone into rod or string
    m_fed += m_rear.meanForce() * duration + sums.faceImpulse;
    m_ledger.feed += sums.feedWork;
    m_ledger.damper += sums.damperWork;
    m_ledger.hammer += m_hammer > 0 ? -hammerEnergy() - m_rear.faceEnergy() : sums.forceWork;
    for (std::size_t j = 0; j < m_hammer; ++j)
        m_hammerLost += m_lines[j].lost() / m_problem.blow.sections[j].impedance;
    m_ledger.waves = m_hammerLost;
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j)
        m_ledger.waves += (m_lines[j].lost() + m_downLosses[j].lost() + m_upLosses[j].lost()) /
                          m_problem.blow.sections[j].impedance;
    m_ledger.stored = storedEnergy() - m_storedBefore;
    m_lastImpulse = sums.faceImpulse;
    const BitNode::Turned turned = m_bit.beginCycle(m_problem.isFresh);
    m_blow.penetration = turned.penetration;
    m_holeDepth += turned.penetration;
    m_blow.holeDepth = m_holeDepth;
    m_ledger.faces += turned.lostEnergy;
    m_ledger.rock -= turned.lostEnergy;
    m_nextInterval = cellsOfNextInterval();
    ++m_count;
}

double DrillingMarch::momentumResidual() const {
    return m_rockImpulse - m_fed + momentum() - m_startMomentum;
}

void DrillingMarch::displace(double distance) {
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j) m_lines[j].displace(distance);
    m_bit.putAt(m_bit.placeFromBottom() - distance, m_bit.state().law.largestForce());
}

double DrillingMarch::distanceTo(const DrillingMarch& other) const {
    const auto square = [](double a, double b) { return (a - b) * (a - b); };
    double sum = square(m_bit.placeFromBottom(), other.m_bit.placeFromBottom()) +
                 square(m_bit.state().force, other.m_bit.state().force) +
                 square(m_bit.state().velocity, other.m_bit.state().velocity) * m_bit.mass();
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j) {
        const auto own = m_lines[j].stored(), others = other.m_lines[j].stored();
        double waves = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const WaveCell difference = own[i] - others[i];
            waves += m_grid.cuts.widths()[i % m_grid.cuts.count()] * difference.meanSquare();
        }
        sum += waves;
        if (m_lines[j].isLossy()) sum += square(m_lines[j].mean(), other.m_lines[j].mean());
        if (j + 1 < m_lines.size())
            sum += square(m_joints[j].velocity(), other.m_joints[j].velocity()) * m_joints[j].mass();
    }
    if (!m_problem.machine) return std::sqrt(sum);
    sum += square(m_rear.state().bodyVelocity, other.m_rear.state().bodyVelocity);
    if (m_problem.machine->stiffness > 0) sum += square(m_rear.state().stretch, other.m_rear.state().stretch);
    return std::sqrt(sum);
}

void DrillingMarch::approach(const DrillingMarch& other, double distance) {
    const double away = distanceTo(other);
    const double share = away > 0 ? distance / away : 0;
    const auto moved = [share](double own, double others) { return others + share * (own - others); };
    for (std::size_t j = m_hammer; j < m_lines.size(); ++j) {
        m_lines[j].approach(other.m_lines[j], share, m_grid.cuts.widths());
        m_downLosses[j].setMean(moved(m_downLosses[j].mean(), other.m_downLosses[j].mean()));
        m_upLosses[j].setMean(moved(m_upLosses[j].mean(), other.m_upLosses[j].mean()));
        if (j + 1 < m_lines.size())
            m_joints[j].setVelocity(moved(m_joints[j].velocity(), other.m_joints[j].velocity()));
    }
    const BitNodeState &bit = m_bit.state(), &otherBit = other.m_bit.state();
    const double velocity = moved(bit.velocity, otherBit.velocity);
    m_bit.putAt(moved(m_bit.placeFromBottom(), other.m_bit.placeFromBottom()),
                moved(bit.law.largestForce(), otherBit.law.largestForce()));
    m_bit.setVelocity(velocity);
    RearState rear = m_rear.state();
    rear.bodyVelocity = moved(rear.bodyVelocity, other.m_rear.state().bodyVelocity);
    // places alone do not matter
    const bool hasSpring = m_problem.machine && m_problem.machine->stiffness > 0;
    rear.stretch =
        hasSpring ? moved(rear.stretch, other.m_rear.state().stretch) : other.m_rear.state().stretch;
    m_rear.setState(rear);
    m_lastImpulse = moved(m_lastImpulse, other.m_lastImpulse);
}

}  // namespace drillwave
