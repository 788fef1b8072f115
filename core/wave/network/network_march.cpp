// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/network_march.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/contact_law.h"
#include "core/text/message.h"
#include "core/wave/impact.h"
#include "core/wave/network/census.h"
#include "core/wave/problem.h"
#include "core/wave/work_limit.h"

namespace drillwave {

namespace {

// Results of a census: balances, rock and face.

/// Returns the time; never if it is negative.
double timeOrNever(double time) {
    return time >= 0 ? time : Impact::never;
}

// Energies, momenta and records at the time of the census; the rest is left as it is.
Impact impactOf(const Problem& problem, const CensusResult& census) {
    const FaceRecord& face = census.face.record;
    Impact impact;
    impact.endTime = census.time;
    if (problem.isForced()) {
        impact.hammerImpulse = face.impulse;
        impact.hammerWork = face.work;
    } else {
        double mass = 0;
        for (std::size_t j = 0; j < problem.hammerSections(); ++j)
            mass += problem.sections[j].mass() + problem.sections[j].massAfter;
        impact.hammerImpulse = mass * problem.velocity();
        impact.hammerWork = impact.hammerImpulse * problem.velocity() / 2;
    }

    ContactLaw<double> law = census.bit.law;
    law.remember(census.bit.force);
    impact.rockWork = law.worked(census.bit.isApart() ? 0 : census.bit.force);
    impact.hammerEnergy = census.hammerEnergy;
    impact.finalEnergy = census.stringEnergy;
    impact.jointLoss = census.jointLoss;
    impact.rodLoss = census.rodLoss;
    impact.faceEnergy = census.faceEnergy;

    const BitRecord& rock = census.bit.record;
    impact.impulse = rock.impulse;
    impact.hammerMomentum = census.hammerMomentum;
    impact.finalMomentum = census.stringMomentum;
    impact.externalMomentum = census.externalMomentum;
    impact.faceImpulse = face.impulse;
    impact.faceSeparation = timeOrNever(face.firstSeparation);
    // momentum that losses take from the string is not rebound; rounding must not give less than −1
    if (face.impulse > 0)
        impact.cor = losesWaves(problem) ? rock.impulse / face.impulse - 1
                                         : std::max(-1.0, -census.stringMomentum / face.impulse);

    impact.peakForce = rock.peakForce;
    impact.peakTime = rock.peakTime;
    impact.firstContactTime = timeOrNever(rock.firstContact);
    impact.separationTime = timeOrNever(rock.lastSeparation);
    if (census.bit.isApart() && rock.contacts > 0)
        impact.endOfBlow = rock.lastSeparation + problem.transitTime();
    impact.contactDuration = rock.contactDuration;
    impact.contacts = rock.contacts;
    return impact;
}

/// Share of the permitted work for cutting cells that are on their way: in very long strings each cut takes
/// as much as some millions of steps. Jumps that are no longer cut show in the balance.
constexpr double shareOfCuts = 0.1;

/// Number of means of cells in free flight that take as much work as one cell.
constexpr double flownOfCell = 8;

}  // namespace

const ForeseenWork& NetworkMarch::plan(const Problem& problem, const CellGrid& grid,
                                       const NetworkWants& wants) {
    m_plan.begin(problem, grid, wants);
    return m_plan.foreseen();
}

void NetworkMarch::begin(long mostCells) {
    m_lattice.begin(m_plan, static_cast<long>(shareOfCuts * static_cast<double>(mostCells)));
    m_recorder.begin(m_plan, m_lattice);
    m_census.abandon();
    m_free.reset();
    m_cells = 0;
    m_flown = m_landing = 0;
}

Impact NetworkMarch::run(long mostCells, const std::stop_token& stop) {
    begin(mostCells);
    while (true) {
        if (m_plan.wants().forcesIfTheyFit && work() > mostCells) m_recorder.leaveOutForces();
        if (work() > mostCells) return notSolved(workLimitReason(), Hindrance::workLimit);
        if (!m_census.isUnderWay()) scheduleCensus();
        m_lattice.takeBlock(m_census, static_cast<double>(mostCells - flownCells() - m_cells), stop);
        if (!m_lattice.failureReason().empty())
            return notSolved(Message::ofTable(m_lattice.failureReason()), Hindrance::other);
        m_cells += static_cast<long>(stepsOfBlock * (m_plan.sections() + 1));
        if (m_census.isUnderWay()) countBlock(stop);
        m_recorder.add(stop);
        if (stop.stop_requested())
            return notSolved("stopped", Hindrance::other);  // a block may be left unfinished
        m_lattice.advance();
        if (std::optional<Impact> impact = endOfBlow(stop)) return *std::move(impact);
    }
}

/// Decides when all that moves is counted next: all of it must lie ahead.
void NetworkMarch::scheduleCensus() {
    const Problem& problem = m_plan.problem();
    const StringClocks& clocks = m_plan.clocks();
    if (problem.endTime ||
        m_plan.isLossy()) {  // no proof for what loses: what passes counts from the beginning on
        m_census.begin(problem, clocks, m_plan.limitTime());
        return;
    }
    double ahead = 0;
    for (std::size_t j = 0; j < m_plan.sections(); ++j)
        ahead = std::max(ahead, clocks.delays[j + 1] + clocks.transitTimes[j]);
    const double now = m_lattice.clock(), time = now + ahead, limit = m_plan.limitTime();
    const double block = m_lattice.cuts().clock(m_lattice.step() + static_cast<long>(stepsOfBlock)) - now;
    // The last one is taken at the limit itself, whatever happens until then, and has to begin in time.
    const auto isLateAt = [&](double clock) { return clock + block + ahead > limit; };
    if (isLateAt(now)) {
        m_census.begin(problem, clocks, limit);
        return;
    }
    const BitNodeState& bit = m_lattice.bit();
    const bool isFree = bit.isApart() && bit.record.contacts > 0 && m_lattice.face().apart;
    if (isFree && !m_free && now >= m_landing)
        m_census.begin(problem, clocks, isLateAt(time - clocks.earliest()) ? limit : time);
}

/// The waves of the block that was taken last.
void NetworkMarch::countBlock(const std::stop_token& stop) {
    const CellCuts& cuts = m_lattice.cuts();
    const long step = m_lattice.step();
    const double start = m_lattice.clock(), end = cuts.clock(step + static_cast<long>(stepsOfBlock));
    for (std::size_t j = 0; j < m_plan.sections() && !stop.stop_requested(); ++j)
        for (const bool down : {true, false}) {
            LineCensus& line = down ? m_census.down(j) : m_census.up(j);
            if (!line.concerns(start, end, m_plan.isLossy())) continue;
            const WaveCell* cells = down ? m_lattice.down(j) : m_lattice.line(j).newest();
            CellCuts::Walk at(cuts, step);
            for (std::size_t i = 0; i < stepsOfBlock; ++i, at.next())
                line.add(cells[i], at.clock(), at.width());
        }
}

std::optional<Impact> NetworkMarch::endOfBlow(const std::stop_token& stop) {
    const double now = m_lattice.clock(), limit = m_plan.limitTime();
    const auto restOf = [&](const CensusResult& census) {
        return restTime(m_plan.problem(), census).value_or(std::numeric_limits<double>::infinity());
    };
    if (m_census.isUnderWay() && now > m_census.lastClock()) {
        const CensusResult census = m_census.finish();
        if (m_plan.problem().endTime) return result(census, Outcome::endTime);
        if (census.time >= limit) {
            const bool proven = !m_plan.isLossy() && restOf(census) <= census.time;
            return result(census, proven ? Outcome::rebounded : Outcome::nextBlow);
        }
        if (census.bit.isApart() && census.face.apart) m_free = census;
    }
    if (!m_free) return {};
    if (!isUntouchedSince(*m_free)) {
        m_free.reset();
        return {};
    }
    // what is counted stays as it is until something touches again
    const double rest = restOf(*m_free), last = std::min(rest, limit);
    if (now < last - m_plan.clocks().earliest() && !fliesUntil(last, stop)) return {};
    // the waves that are left still make forces
    if (rest <= limit && now < m_recorder.wantedTime() - m_plan.clocks().earliest()) return {};
    m_free->time = std::max(last, m_free->time);
    return result(*m_free, rest <= limit ? Outcome::rebounded : Outcome::nextBlow);
}

bool NetworkMarch::isUntouchedSince(const CensusResult& census) const {
    const BitNodeState& bit = m_lattice.bit();
    const FaceNodeState& face = m_lattice.face();
    return bit.isApart() && bit.record.contacts == census.bit.record.contacts && face.apart &&
           face.record.impulse == census.face.record.impulse;
}

/// Returns whether nothing touches until then; follows means of the waves if no more is requested.
bool NetworkMarch::fliesUntil(double time, const std::stop_token& stop) {
    const Problem& problem = m_plan.problem();
    const double now = m_lattice.clock(), cell = m_plan.grid().cell;
    if (m_recorder.hasForces() || m_plan.wants().histories || now < m_landing || !FreeFlight::suits(problem))
        return false;
    const FlightStart start{.faceGap = m_lattice.face().gap,
                            .bitDistance = m_lattice.bit().distance,
                            .hammerEnergy = m_free->hammerEnergy,
                            .stringEnergy = m_free->stringEnergy,
                            .released = m_lattice.face().released};
    if (!FreeFlight::isClear(problem, cell, start)) return false;
    m_flight.begin(problem, m_plan.grid(), start);
    for (std::size_t j = 0; j < m_plan.sections(); ++j)
        m_lattice.cuts().meansOfCells(m_lattice.line(j).content(), m_lattice.step(), m_flight.waves(j));
    const bool stays = m_flight.staysClear((time - now) / cell, stop);
    m_flown += m_flight.gone() * static_cast<double>(m_plan.sections() + 1);
    m_landing = now + m_flight.gone() * cell;
    return stays;
}

Impact NetworkMarch::result(const CensusResult& census, Outcome outcome) {
    Impact impact = impactOf(m_plan.problem(), census);
    impact.outcome = outcome;
    std::ranges::copy_if(m_lattice.events(), std::back_inserter(impact.events),
                         [&](const ImpactEvent& event) { return event.time <= census.time; });
    m_recorder.finish(census.time, impact);
    impact.pieces = m_cells + flownCells();
    impact.cell = m_plan.grid().cell;
    impact.rounding = m_plan.grid().rounding;
    return impact;
}

Impact NetworkMarch::notSolved(Message reason, Hindrance hindrance) {
    m_recorder.abandon();
    Impact impact = Impact::unsolved(std::move(reason), hindrance);
    impact.pieces = m_cells;
    return impact;
}

/// Returns the cause of most of the work, and how to reduce it.
const char* NetworkMarch::workLimitReason() const {
    return m_lattice.workOfEvents() > work() / 2 ? WorkLimitReason::events : WorkLimitReason::steps;
}

long NetworkMarch::flownCells() const {
    return static_cast<long>(m_flown / flownOfCell);
}

long NetworkMarch::work() const {
    return flownCells() + m_cells + m_lattice.work() + m_recorder.workForForces(m_cells);
}

}  // namespace drillwave
