// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/contact/contact_law.h"
#include "core/study/drilling/drilling_alerts.h"
#include "core/study/drilling/drilling_mesh.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// A share of J that is rounding.
constexpr double sameImpulse = 1e-9;

/// A shank that is so far off runs away [d0], where it moved by so much more than before.
constexpr double farAway = 50, growingOffset = 2;

/// A motion that repeats may still settle by so much of a mean.
constexpr double settlingShare = 2e-5;

/// Means of motions that differ by less are those of one motion.
constexpr double motionTolerance = 1e-3;

/// Everything of a study but its numbers of the marches.
class MarchStudy {
  public:
    MarchStudy(const Scenario& scenario, const DrillingSettings& settings, const DrillingRequest& wants,
               const std::stop_token& stop, const DrillingProgress& progress)
        : m_wants(wants), m_stop(stop), m_progress(progress) {
        m_result.scenario = scenario;
        m_result.settings = settings;
        m_result.units = drillingUnitsOf(scenario);
        m_result.scales = scalesOf(scenario);
    }

    DrillingResult run() {
        prepare();
        const DrillingGrid& grid = m_mesh.grid;
        takeGrid(grid);
        DrillingRecord main = recordOf(m_mesh.problem, grid,
                                       {m_result.settings.blows, m_wants.mostWork, m_wants.lyapunov,
                                        m_wants.histories, m_wants.jobs, m_wants.onBlow, m_wants.stopEarly},
                                       m_stop, m_progress);
        m_result.outcome = main.outcome;
        m_result.reason = main.reason;
        m_result.ledger = main.ledger;
        takeResiduals(main, grid);
        m_result.blows = std::move(main.blows);
        m_result.instants = std::move(main.instants);
        const bool isWhole = static_cast<long>(m_result.blows.size()) == m_result.settings.blows;
        if (m_result.outcome == DrillingOutcome::done && isWhole) {
            takeStatistics(main.growths);
            if (m_result.statistics && isPushedBack()) {
                m_result.outcome = DrillingOutcome::pushedBack;
                m_result.statistics.reset();
                m_result.lyapunov.reset();
            }
        }
        takeGroups();
        m_result.alerts = drillingAlerts(m_result, {.lateShare = main.lateShare,
                                                    .rounding = grid.rounding(m_mesh.problem),
                                                    .hasMachine = m_mesh.problem.machine.has_value()});
        return std::move(m_result);
    }

  private:
    void prepare() {
        if (m_wants.blowAlone) m_result.alone = solveBlowAlone(m_result.scenario, m_stop);
        m_mesh = drillingMeshOf(m_result.scenario, m_result.settings.cells);
        m_mesh.problem.start = m_result.settings.start;
        m_result.hasLoss = losesWaves(m_mesh.problem);
        m_result.hasWholeTrips = m_mesh.grid.hasWholeTrips();
    }

    void takeGrid(const DrillingGrid& grid) {
        m_result.frequencyUsed = 1 / (grid.interval() * m_result.units.time);
        m_result.cellsPerDuration = 1 / grid.cell;
    }

    void takeResiduals(const DrillingRecord& main, const DrillingGrid& grid) {
        const double fed =
            static_cast<double>(main.blows.size()) * grid.interval() * m_mesh.problem.feedForce;
        if (fed > 0) m_result.momentumResidual = main.momentumResidual / fed;
        if (main.ledger.hammer > 0) m_result.energyResidual = main.ledger.residual() / main.ledger.hammer;
    }

    void takeStatistics(const std::vector<double>& growths) {
        const auto settle = static_cast<std::size_t>(m_result.settings.settle);
        m_result.statistics = statisticsOf(m_result.blows, settle, m_mesh.problem.blow.velocity());
        m_result.meanImpulse = m_result.spread(quantityPlace(&DrillingBlow::faceImpulse)).mean;
        if (m_wants.lyapunov) {
            const BlowSpread spread = spreadOf(std::span(growths).subspan(settle));
            m_result.lyapunov = Lyapunov{spread.mean, spread.meanError};
        }
        if (m_wants.cellError) compareCells(comparedMarch(), settle);
    }

    /// Returns whether the feed of more than one blow by an elastic hammer is below f J, beyond the
    /// error of J, or a machine that runs away from the shank.
    bool isPushedBack() const {
        if (m_mesh.problem.blow.isForced() || m_result.settings.blows < 2) return false;
        const std::size_t face = quantityPlace(&DrillingBlow::faceImpulse);
        const double impulse = m_result.spread(face).mean;
        const double error = m_result.meanError(face).value_or(0) + sameImpulse * impulse;
        if (m_mesh.problem.feedForce * m_mesh.problem.interval < impulse - error) return true;
        return m_mesh.problem.machine && runsAway();
    }

    /// Whether the offset of the shank grows with the square of time: by more in the second half of the blows
    /// that count than in the first one, and far.
    bool runsAway() const {
        const auto settle = static_cast<std::size_t>(m_result.settings.settle);
        const std::vector<DrillingBlow>& blows = m_result.blows;
        const double first = blows[settle].shankOffset,
                     middle = blows[(settle + blows.size() - 1) / 2].shankOffset,
                     last = blows.back().shankOffset;
        const double before = std::abs(middle - first), behind = std::abs(last - middle);
        return behind > farAway / lawUnitOfPenetration && behind > growingOffset * before;
    }

    /// Marches with other cells. Where the motion repeats, the march also starts differently: the motion may
    /// be one of several, or one that a disturbance leaves for good, which no change of cells would show.
    DrillingRecord comparedMarch() const {
        const DrillingStart own = m_result.settings.start;
        if (m_result.statistics->period > 0) {
            DrillingRecord other = marchWithOtherCells(own == DrillingStart::rest ? DrillingStart::bouncing
                                                                                  : DrillingStart::rest);
            if (other.outcome == DrillingOutcome::done) return other;
        }
        return marchWithOtherCells(own);
    }

    DrillingRecord marchWithOtherCells(DrillingStart start) const {
        DrillingMesh other = comparedDrillingMeshOf(m_result.scenario, m_result.settings.cells);
        other.problem.start = start;
        return recordOf(other.problem, other.grid, {m_result.settings.blows, m_wants.mostWork}, m_stop,
                        m_progress);
    }

    void compareCells(const DrillingRecord& other, std::size_t settle) {
        if (other.outcome != DrillingOutcome::done) return fail(other);
        const DrillingStatistics statistics =
            statisticsOf(other.blows, settle, m_mesh.problem.blow.velocity());
        // One that does not come to the same motion may be on its way to another: its scatter counts.
        const int period = m_result.statistics->period;
        const double rounding = std::abs(m_mesh.grid.rounding(m_mesh.problem));
        const bool isLeft = period > 0 && statistics.period != period;
        for (std::size_t q = 0; q < blowQuantities.size(); ++q)
            m_result.cellErrors[q] =
                coveringCells * std::abs(statistics.spreads[q].mean - m_result.spread(q).mean) +
                coveringRounding * rounding * std::abs(m_result.spread(q).mean) +
                (isLeft ? statistics.spreads[q].deviation : 0);
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const BlowSpread &own = m_result.spread(penetration), &others = statistics.spreads[penetration];
        const double errors = own.meanError.value_or(0) + others.meanError.value_or(0);
        m_result.cellsDecideMotion = statistics.period != m_result.statistics->period &&
                                     std::abs(own.mean - others.mean) > errors + motionTolerance * own.mean;
    }

    void fail(const DrillingRecord& other) {
        m_result.outcome = other.outcome;
        m_result.reason = other.reason;
        m_result.statistics.reset();
    }

    void takeGroups() {
        DrillingGroups& groups = m_result.groups;
        if (!m_result.blows.empty() && !m_result.statistics)
            m_result.meanImpulse = meanImpulse(m_result.blows, growingBlows);
        else if (m_result.blows.empty())
            m_result.meanImpulse = 1;
        const double interval = 1 / (m_result.frequencyUsed * m_result.units.time);
        groups.phi = m_mesh.problem.feedForce * interval / m_result.meanImpulse;
        groups.roundTrips = interval / (2 * m_mesh.problem.blow.transitTime());
        groups.blow = groupsOf(m_result.scenario);
        if (!m_mesh.problem.machine) return;
        const std::size_t first = m_mesh.problem.blow.hammerSections();
        groups.mu = m_mesh.problem.machine->mass / m_mesh.problem.blow.mass();
        groups.zeta = m_mesh.problem.machine->damping / m_mesh.problem.blow.sections[first].impedance;
        groups.kappa = m_mesh.problem.machine->stiffness / m_mesh.problem.blow.sections[first].impedance;
    }

    DrillingRequest m_wants;
    const std::stop_token& m_stop;
    const DrillingProgress& m_progress;
    DrillingMesh m_mesh;
    DrillingResult m_result;
};

}  // namespace

std::optional<double> DrillingResult::meanError(std::size_t quantity) const {
    const std::optional<double> batches = spread(quantity).meanError;
    if (!batches) return std::nullopt;
    return *batches + cellErrors[quantity] + settlingShare * std::abs(spread(quantity).mean);
}

long foreseenBlows(const DrillingSettings& settings, const DrillingRequest& wants) {
    return settings.blows * (1 + wants.lyapunov + wants.cellError);
}

double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range) {
    const DrillingGrid grid = drillingMeshOf(scenario, settings.cells).grid;
    return static_cast<double>(range.last - range.first + 1) * static_cast<double>(grid.cellsOfInterval) *
           static_cast<double>(grid.cuts.count());
}

double drillingWork(const Scenario& scenario, const DrillingSettings& settings,
                    const DrillingRequest& wants) {
    const auto workOf = [](const DrillingMesh& mesh, long blows) {
        return mesh.grid.work(mesh.problem) * static_cast<double>(blows);
    };
    double work = workOf(drillingMeshOf(scenario, settings.cells), settings.blows) * (wants.lyapunov ? 2 : 1);
    if (wants.cellError) work += workOf(comparedDrillingMeshOf(scenario, settings.cells), settings.blows);
    return work;
}

DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingRequest& wants, const std::stop_token& stop,
                             const DrillingProgress& progress) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    if (Message refusal = inOneLine(drillingRefusals(scenario, settings)); !refusal.isEmpty()) {
        DrillingResult refused;
        refused.scenario = scenario;
        refused.settings = settings;
        refused.outcome = DrillingOutcome::notSolved;
        refused.reason = std::move(refusal);
        return refused;
    }
    DrillingResult result = MarchStudy(scenario, settings, wants, stop, progress).run();
    result.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return result;
}

}  // namespace drillwave
