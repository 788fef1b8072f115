// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <utility>

#include "core/contact/contact_law.h"
#include "core/study/drilling/blow_alone.h"
#include "core/study/drilling/drilling_alerts.h"
#include "core/study/drilling/drilling_mesh.h"
#include "core/text/enum_names.h"
#include "core/text/message_list.h"

namespace drillwave {

namespace {

constexpr EnumNames<DrillingVerdict> verdictNames{{{DrillingVerdict::pushedBack, "pushed_back"},
                                                   {DrillingVerdict::rests, "rests"},
                                                   {DrillingVerdict::fullRate, "full_rate"},
                                                   {DrillingVerdict::rateLost, "rate_lost"}}};

/// A share of the penetration at a very large thrust that passes for all of it, and a share of blows that
/// begin in contact which passes for rest.
constexpr double fullShare = 0.95, restingShare = 0.95;

/// A share of J that is rounding.
constexpr double sameImpulse = 1e-9;

/// A shank that is so far off runs away [d0], where it moved by so much more than before.
constexpr double farAway = 50, growingOffset = 2;

/// Means of motions that differ by less are those of one motion.
constexpr double motionTolerance = 1e-3;

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
        prepare();
        const DrillingGrid& grid = m_mesh.grid;
        takeGrid(grid);
        DrillingRecord main = recordOf(m_mesh.problem, grid,
                                       {m_result.settings.blows, m_wants.mostWork, m_wants.lyapunov,
                                        m_wants.histories, m_wants.jobs, m_wants.onBlow, m_wants.isEnough},
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
                m_result.fullRateShare.reset();
            }
        }
        takeGroups();
        m_result.verdict = verdictOf(m_result);
        m_result.alerts = drillingAlerts(m_result, {.lateShare = main.lateShare,
                                                    .rounding = grid.rounding(m_mesh.problem),
                                                    .hasMachine = m_mesh.problem.machine.has_value()});
        return std::move(m_result);
    }

    std::optional<double> fullPenetration() {
        prepare();
        if (std::isfinite(m_result.cor)) takeFullRate(marchAtFullRate());
        return m_result.fullPenetration;
    }

  private:
    void prepare() {
        m_result.cor = m_wants.cor ? corAtZeroGap(m_result.scenario, m_stop) : std::nan("");
        m_mesh = drillingMeshOf(m_result.scenario, m_result.settings.cells);
        m_mesh.problem.start = m_result.settings.start;
        m_result.hasLoss = losesWaves(m_mesh.problem);
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
        std::optional<DrillingRecord> other, full;
        const auto marchOther = [&] {
            if (m_wants.cellError) other = marchWithOtherCells();
        };
        const auto marchFull = [&] {
            if (m_wants.fullRate && !m_wants.fullPenetration && std::isfinite(m_result.cor))
                full = marchAtFullRate();
        };
        if (m_wants.jobs > 1) {
            // Deferred where no thread can be started.
            std::future<void> pressed = std::async(std::launch::async | std::launch::deferred, marchFull);
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

    DrillingRecord marchWithOtherCells() const {
        DrillingMesh other = comparedDrillingMeshOf(m_result.scenario, m_result.settings.cells);
        other.problem.start = m_result.settings.start;
        return recordOf(other.problem, other.grid, {m_result.settings.blows, m_wants.mostWork}, m_stop,
                        m_progress);
    }

    DrillingRecord marchAtFullRate() const {
        DrillingMesh pressed =
            drillingMeshOf(m_result.scenario, std::min(m_result.settings.cells, scanCells));
        pressed.problem.start = m_result.settings.start;
        pressed.problem.feedForce =
            2 * (1 + 2 * m_result.cor) * m_result.meanImpulse / pressed.grid.interval();
        return recordOf(pressed.problem, pressed.grid, {scanBlows, m_wants.mostWork}, m_stop, m_progress);
    }

    void compareCells(const DrillingRecord& other, std::size_t settle) {
        if (other.outcome != DrillingOutcome::done) return fail(other);
        const DrillingStatistics statistics =
            statisticsOf(other.blows, settle, m_mesh.problem.blow.velocity());
        for (std::size_t q = 0; q < blowQuantities.size(); ++q)
            m_result.cellErrors[q] =
                coveringCells * std::abs(statistics.spreads[q].mean - m_result.spread(q).mean);
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const BlowSpread &own = m_result.spread(penetration), &others = statistics.spreads[penetration];
        const double errors = own.meanError.value_or(0) + others.meanError.value_or(0);
        m_result.cellsDecideMotion = statistics.period != m_result.statistics->period &&
                                     std::abs(own.mean - others.mean) > errors + motionTolerance * own.mean;
    }

    void takeFullRate(const DrillingRecord& full) {
        if (full.outcome == DrillingOutcome::stopped) return fail(full);
        if (full.outcome != DrillingOutcome::done) return;
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const DrillingStatistics statistics =
            statisticsOf(full.blows, static_cast<std::size_t>(scanSettle), m_mesh.problem.blow.velocity());
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
        groups.phi = m_mesh.problem.feedForce * interval / m_result.meanImpulse;
        groups.roundTrips = interval / (2 * m_mesh.problem.blow.transitTime());
        groups.blow = groupsOf(m_result.scenario);
        if (!m_mesh.problem.machine) return;
        const std::size_t first = m_mesh.problem.blow.hammerSections();
        groups.mu = m_mesh.problem.machine->mass / m_mesh.problem.blow.mass();
        groups.zeta = m_mesh.problem.machine->damping / m_mesh.problem.blow.sections[first].impedance;
        groups.kappa = m_mesh.problem.machine->stiffness / m_mesh.problem.blow.sections[first].impedance;
    }

    DrillingWants m_wants;
    const std::stop_token& m_stop;
    std::mutex m_told;
    DrillingProgress m_progress;
    DrillingMesh m_mesh;
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
    if (!drillingRefusals(scenario, settings).empty()) return std::nullopt;
    return MarchStudy(scenario, settings, {}, stop, {}).fullPenetration();
}

long foreseenBlows(const DrillingSettings& settings, const DrillingWants& wants) {
    return settings.blows * (1 + wants.lyapunov + wants.cellError) + (wants.fullRate ? scanBlows : 0);
}

double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range) {
    const DrillingGrid grid = drillingMeshOf(scenario, settings.cells).grid;
    return static_cast<double>(range.last - range.first + 1) * static_cast<double>(grid.cellsOfInterval) *
           static_cast<double>(grid.cuts.count());
}

double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingWants& wants) {
    const auto workOf = [](const DrillingMesh& mesh, long blows) {
        return mesh.grid.work(mesh.problem) * static_cast<double>(blows);
    };
    double work = workOf(drillingMeshOf(scenario, settings.cells), settings.blows) * (wants.lyapunov ? 2 : 1);
    if (wants.cellError) work += workOf(comparedDrillingMeshOf(scenario, settings.cells), settings.blows);
    if (wants.fullRate) work += workOf(drillingMeshOf(scenario, scanCells), scanBlows);
    return work;
}

DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingWants& wants, const std::stop_token& stop,
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
