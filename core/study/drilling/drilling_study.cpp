// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <utility>

#include "core/study/drilling/blow_alone.h"
#include "core/study/drilling/drilling_alerts.h"
#include "core/text/enum_names.h"
#include "core/wave/drilling/drilling_grid.h"

namespace drillwave {

namespace {

constexpr EnumNames<DrillingVerdict> verdictNames{{{DrillingVerdict::pushedBack, "pushed_back"},
                                                   {DrillingVerdict::rests, "rests"},
                                                   {DrillingVerdict::fullRate, "full_rate"},
                                                   {DrillingVerdict::rateLost, "rate_lost"}}};

/// A share of the penetration at a very large thrust that passes for all of it, and a share of blows that
/// begin in contact which passes for rest.
constexpr double fullShare = 0.95, restingShare = 0.95;

/// Everything of a study but its numbers of the marches.
class MarchStudy {
  public:
    MarchStudy(const Scenario& scenario, const DrillingSettings& settings, const DrillingWants& wants,
               const std::stop_token& stop, const DrillingProgress& progress)
        : m_wants(wants), m_stop(stop) {
        if (progress)
            m_progress = [&](long more) {
                const std::scoped_lock lock(m_told);
                progress(more);
            };
        m_result.scenario = scenario;
        m_result.settings = settings;
        m_result.units = drillingUnitsOf(scenario);
        m_result.scales = scalesOf(scenario);
    }

    DrillingResult run() {
        solveBlowAlone();
        const DrillingGrid grid = drillingGridOf(m_problem, m_result.settings.cells);
        takeGrid(grid);
        DrillingRecord main = recordOf(m_problem, grid,
                                       {m_result.settings.blows, m_wants.lyapunov, m_wants.histories,
                                        m_wants.jobs, m_wants.onBlow, m_wants.isEnough},
                                       m_stop, m_progress);
        m_result.outcome = main.outcome;
        m_result.reason = main.reason;
        m_result.ledger = main.ledger;
        takeResiduals(main, grid);
        m_result.blows = std::move(main.blows);
        m_result.instants = std::move(main.instants);
        const bool isWhole = static_cast<long>(m_result.blows.size()) == m_result.settings.blows;
        if (m_result.outcome == DrillingOutcome::done && isWhole) takeStatistics(main.growths);
        takeGroups();
        m_result.verdict = verdictOf(m_result);
        m_result.alerts = drillingAlerts(m_result, {.lateShare = main.lateShare,
                                                    .rounding = grid.rounding(m_problem),
                                                    .hasMachine = m_problem.machine.has_value()});
        return std::move(m_result);
    }

    std::optional<double> fullPenetration() {
        solveBlowAlone();
        if (std::isfinite(m_result.cor)) takeFullRate(marchAtFullRate());
        return m_result.fullPenetration;
    }

  private:
    void solveBlowAlone() {
        BlowAlone alone = blowAlone(m_result.scenario, m_wants.cor, m_stop);
        m_result.cor = alone.cor;
        m_problem = drillingProblemOf(m_result.scenario, std::move(alone.problem));
        m_problem.start = m_result.settings.start;
        m_result.hasLoss = std::ranges::any_of(m_problem.waveLosses, [](double loss) { return loss > 0; });
    }

    void takeGrid(const DrillingGrid& grid) {
        m_result.frequencyUsed = 1 / (grid.interval() * m_result.units.time);
        m_result.cellsPerDuration = 1 / grid.cells.cell;
    }

    void takeResiduals(const DrillingRecord& main, const DrillingGrid& grid) {
        const double fed = static_cast<double>(main.blows.size()) * grid.interval() * m_problem.feedForce;
        if (fed > 0) m_result.momentumResidual = main.momentumResidual / fed;
        if (main.ledger.hammer > 0) m_result.energyResidual = main.ledger.residual() / main.ledger.hammer;
    }

    void takeStatistics(const std::vector<double>& growths) {
        const auto settle = static_cast<std::size_t>(m_result.settings.settle);
        m_result.statistics = statisticsOf(m_result.blows, settle, m_problem.blow.velocity());
        m_result.meanImpulse = m_result.spread(quantityPlace(&DrillingBlow::faceImpulse)).mean;
        if (m_wants.lyapunov) {
            const BlowSpread spread = spreadOf(std::span(growths).subspan(settle));
            m_result.lyapunov = Lyapunov{spread.mean, spread.meanError};
        }
        std::optional<DrillingRecord> other, full;
        const auto marchOther = [&] {
            if (m_wants.cellError) other = marchWithOtherCells();
        };
        const auto marchFull = [&] {
            if (m_wants.fullRate && !m_wants.fullPenetration && std::isfinite(m_result.cor))
                full = marchAtFullRate();
        };
        if (m_wants.jobs > 1) {
            std::future<void> pressed = std::async(std::launch::async, marchFull);
            marchOther();
            pressed.get();
        } else {
            marchOther();
            marchFull();
        }
        if (other) compareCells(*other, settle);
        if (full && m_result.statistics) takeFullRate(*full);
        if (m_wants.fullPenetration) m_result.fullPenetration = m_wants.fullPenetration;
        if (m_result.statistics && m_result.fullPenetration)
            m_result.fullRateShare =
                m_result.spread(quantityPlace(&DrillingBlow::penetration)).mean / *m_result.fullPenetration;
    }

    DrillingRecord marchWithOtherCells() const {
        const DrillingGrid other = comparedDrillingGridOf(m_problem, m_result.settings.cells);
        return recordOf(m_problem, other, {m_result.settings.blows}, m_stop, m_progress);
    }

    DrillingRecord marchAtFullRate() const {
        DrillingProblem pressed = m_problem;
        const DrillingGrid grid = drillingGridOf(pressed, std::min(m_result.settings.cells, scanCells));
        pressed.feedForce = 2 * (1 + 2 * m_result.cor) * m_result.meanImpulse / grid.interval();
        return recordOf(pressed, grid, {scanBlows}, m_stop, m_progress);
    }

    void compareCells(const DrillingRecord& other, std::size_t settle) {
        if (other.outcome != DrillingOutcome::done) return fail(other);
        const DrillingStatistics statistics = statisticsOf(other.blows, settle, m_problem.blow.velocity());
        for (std::size_t q = 0; q < blowQuantities.size(); ++q)
            m_result.cellErrors[q] =
                coveringCells * std::abs(statistics.spreads[q].mean - m_result.spread(q).mean);
    }

    void takeFullRate(const DrillingRecord& full) {
        if (full.outcome == DrillingOutcome::stopped) return fail(full);
        if (full.outcome != DrillingOutcome::done) return;
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const DrillingStatistics statistics =
            statisticsOf(full.blows, static_cast<std::size_t>(scanSettle), m_problem.blow.velocity());
        const double most = statistics.spreads[penetration].mean;
        if (most > 0) m_result.fullPenetration = most;
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
        groups.phi = m_problem.feedForce * interval / m_result.meanImpulse;
        groups.roundTrips = interval / (2 * m_problem.blow.transitTime());
        groups.blow = groupsOf(m_result.scenario);
        if (!m_problem.machine) return;
        const std::size_t first = m_problem.blow.hammerSections();
        groups.mu = m_problem.machine->mass / m_problem.blow.mass();
        groups.zeta = m_problem.machine->damping / m_problem.blow.sections[first].impedance;
        groups.kappa = m_problem.machine->stiffness / m_problem.blow.sections[first].impedance;
    }

    DrillingWants m_wants;
    const std::stop_token& m_stop;
    std::mutex m_told;
    DrillingProgress m_progress;
    DrillingProblem m_problem;
    DrillingResult m_result;
};

}  // namespace

DrillingVerdict verdictOf(const DrillingResult& result) {
    if (result.outcome == DrillingOutcome::pushedBack) return DrillingVerdict::pushedBack;
    if (result.statistics && result.statistics->contactShare >= restingShare) return DrillingVerdict::rests;
    const bool isFull = result.fullRateShare.value_or(0) >= fullShare;
    return isFull ? DrillingVerdict::fullRate : DrillingVerdict::rateLost;
}

void takeFullRate(DrillingResult& result, const DrillingResult& other) {
    const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
    if (!result.statistics || !other.statistics || !other.fullRateShare) return;
    const double share =
        *other.fullRateShare * result.spread(penetration).mean / other.spread(penetration).mean;
    if (std::isfinite(share)) result.fullRateShare = share;
    result.verdict = verdictOf(result);
}

std::string_view name(DrillingVerdict verdict) {
    return verdictNames[verdict];
}

std::optional<double> DrillingResult::meanError(std::size_t quantity) const {
    const std::optional<double> batches = spread(quantity).meanError;
    if (!batches) return std::nullopt;
    return *batches + cellErrors[quantity];
}

std::optional<double> fullPenetrationOf(const Scenario& scenario, const DrillingSettings& settings,
                                        const std::stop_token& stop) {
    return MarchStudy(scenario, settings, {}, stop, {}).fullPenetration();
}

long foreseenBlows(const DrillingSettings& settings, const DrillingWants& wants) {
    return settings.blows * (1 + wants.lyapunov + wants.cellError) + (wants.fullRate ? scanBlows : 0);
}

double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range) {
    const DrillingProblem problem = drillingProblemOf(scenario, problemOf(scenario));
    const DrillingGrid grid = drillingGridOf(problem, settings.cells);
    return static_cast<double>(range.last - range.first + 1) * static_cast<double>(grid.cellsOfInterval) *
           static_cast<double>(grid.cuts.count());
}

double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingWants& wants) {
    const DrillingProblem problem = drillingProblemOf(scenario, problemOf(scenario));
    const auto blows = static_cast<double>(settings.blows);
    double work = drillingGridOf(problem, settings.cells).work(problem) * blows * (wants.lyapunov ? 2 : 1);
    if (wants.cellError) work += comparedDrillingGridOf(problem, settings.cells).work(problem) * blows;
    if (wants.fullRate)
        work += drillingGridOf(problem, scanCells).work(problem) * static_cast<double>(scanBlows);
    return work;
}

DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingWants& wants, const std::stop_token& stop,
                             const DrillingProgress& progress) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    DrillingResult result = MarchStudy(scenario, settings, wants, stop, progress).run();
    result.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return result;
}

}  // namespace drillwave
