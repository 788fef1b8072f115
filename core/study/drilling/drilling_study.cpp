// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <mutex>
#include <numeric>
#include <semaphore>
#include <thread>
#include <utility>

#include "core/blow/blow.h"
#include "core/blow/feed_force.h"
#include "core/contact/contact_law.h"
#include "core/text/enum_names.h"
#include "core/wave/drilling/drilling_grid.h"
#include "core/wave/drilling/drilling_march.h"

namespace drillwave {

namespace {

constexpr EnumNames<DrillingOutcome> outcomeNames{{{DrillingOutcome::done, "done"},
                                                   {DrillingOutcome::pushedBack, "pushed_back"},
                                                   {DrillingOutcome::notSolved, "not_solved"},
                                                   {DrillingOutcome::stopped, "stopped"}}};

constexpr EnumNames<DrillingVerdict> verdictNames{{{DrillingVerdict::pushedBack, "pushed_back"},
                                                   {DrillingVerdict::rests, "rests"},
                                                   {DrillingVerdict::fullRate, "full_rate"},
                                                   {DrillingVerdict::rateLost, "rate_lost"}}};

/// A thrust may be below the mean reaction by that share of it and be marched.
constexpr double equalThrust = 1e-9;

/// A bit that is so far away does not come back [d0].
constexpr double mostGap = 1000;

/// Nor does one whose gap has grown for so many blows of a machine that is pushed back on the mean of them.
constexpr long growingBlows = 50;

/// What half as many cells change counts so often: it covered a march with a quarter of the cells in 58 of 60
/// random rods, once in 54.
constexpr double coveringCells = 3;

/// How far the second march of λ is displaced.
constexpr double displacement = 1e-6;

/// A share of the momentum of a hammer that passes after it has separated is in the way.
constexpr double mostLateShare = 0.02;

/// The place of the shank at a blow departs from its mean by that much: the stroke would be another one [m].
constexpr double mostShankOffset = 5e-3;

/// A frequency that is rounded by more is told.
constexpr double toldRounding = 1e-5;

/// λ above that is chaotic.
constexpr double chaotic = 0.05;

/// A share of the penetration at a very large thrust that passes for all of it, and a share of blows that
/// begin in contact which passes for rest.
constexpr double fullShare = 0.95, restingShare = 0.95;

/// One march of a study.
struct March {
    std::vector<DrillingBlow> blows;
    DrillingOutcome outcome = DrillingOutcome::done;
    std::string reason;
    DrillingLedger ledger;
    double momentumResidual = 0;
    double lateShare = 0;  ///< largest
    std::vector<DrillingInstant> instants;
    std::vector<double> growths;  ///< ln of how a small distance has grown, of each blow
};

struct MarchLength {
    long blows;
    bool lyapunov = false;
    std::optional<BlowRange> histories = {};
    int jobs = 1;  ///< the march of λ has a thread of its own where they are more
    std::function<void(const DrillingBlow&)> onBlow = {};
};

/// Takes the blows of a march on a thread of its own, one whenever it is told.
class MarchBeside {
  public:
    /// Both must outlive it.
    MarchBeside(DrillingMarch& march, const std::stop_token& stop)
        : m_thread([this, &march, &stop] {
              for (m_begun.acquire(); !m_ends; m_begun.acquire()) {
                  m_isTaken = march.takeBlow(stop);
                  m_done.release();
              }
          }) {}
    ~MarchBeside() {
        m_ends = true;
        m_begun.release();
    }
    MarchBeside(const MarchBeside&) = delete;
    MarchBeside& operator=(const MarchBeside&) = delete;

    void beginBlow() { m_begun.release(); }
    /// Waits for it.
    bool hasTakenBlow() {
        m_done.acquire();
        return m_isTaken;
    }

  private:
    std::binary_semaphore m_begun{0}, m_done{0};
    bool m_ends = false, m_isTaken = false;
    std::jthread m_thread;
};

double meanImpulse(const std::vector<DrillingBlow>& blows, std::size_t last) {
    const std::size_t from = blows.size() - std::min(last, blows.size());
    double sum = 0;
    for (std::size_t i = from; i < blows.size(); ++i) sum += blows[i].faceImpulse;
    return sum / static_cast<double>(blows.size() - from);
}

/// Whether nothing bounded comes of it.
bool isPushedBack(const DrillingProblem& problem, double interval, const std::vector<DrillingBlow>& blows,
                  long growing) {
    if (blows.back().gap * lawUnitOfPenetration > mostGap) return true;
    if (problem.blow.isForced() || growing < growingBlows) return false;
    return problem.feedForce * interval <= meanImpulse(blows, growingBlows);
}

/// What was watched, from one time to another.
std::vector<DrillingInstant> instantsOf(const DrillingSamples& samples, double from, double to) {
    std::vector<DrillingInstant> instants;
    std::size_t next = 0;
    for (const RearSample& rear : samples.rear) {
        if (rear.time < from || rear.time > to) continue;
        while (next < samples.bit.size() && samples.bit[next].time < rear.time) ++next;
        if (next == 0 || next == samples.bit.size()) continue;
        const BitSample &before = samples.bit[next - 1], &behind = samples.bit[next];
        const double share = (rear.time - before.time) / (behind.time - before.time);
        const auto between = [&](double BitSample::*value) {
            return before.*value + share * (behind.*value - before.*value);
        };
        instants.push_back({.time = rear.time,
                            .force = between(&BitSample::force),
                            .penetration = between(&BitSample::penetration),
                            .frontVelocity = between(&BitSample::velocity),
                            .rearVelocity = rear.velocity,
                            .damperForce = rear.damperForce,
                            .bodyPlace = rear.bodyPlace});
    }
    return instants;
}

March march(const DrillingProblem& problem, const DrillingGrid& grid, const MarchLength& length,
            const std::stop_token& stop, const DrillingProgress& progress) {
    March result;
    if (problem.blow.isForced() && problem.feedForce * grid.interval() < 1 - equalThrust) {
        result.outcome = DrillingOutcome::pushedBack;
        return result;
    }
    DrillingMarch main(problem, grid);
    std::optional<DrillingMarch> beside;
    if (length.lyapunov) {
        beside.emplace(main);
        beside->displace(displacement);
        beside->approach(main, displacement);
    }
    std::optional<MarchBeside> thread;
    if (beside && length.jobs > 1) thread.emplace(*beside, stop);
    const auto takeBlow = [&] {
        if (!thread) return main.takeBlow(stop) && (!beside || beside->takeBlow(stop));
        thread->beginBlow();
        const bool isTaken = main.takeBlow(stop);
        return thread->hasTakenBlow() && isTaken;
    };
    result.blows.reserve(static_cast<std::size_t>(length.blows));
    long growing = 0;
    DrillingSamples samples;
    double historyEnd = 0;
    while (result.outcome == DrillingOutcome::done && main.blows() < length.blows) {
        if (length.histories) {  // the bit is behind: of the first blow it tells of the one before
            const long next = main.blows() + 1;
            main.watch(next >= length.histories->first - 1 && next <= length.histories->last ? &samples
                                                                                             : nullptr);
        }
        if (!takeBlow()) {
            const std::string_view trouble =
                main.trouble().empty() && beside ? beside->trouble() : main.trouble();
            result.outcome = trouble.empty() ? DrillingOutcome::stopped : DrillingOutcome::notSolved;
            result.reason = trouble;
            break;
        }
        if (beside) {
            const double distance = beside->distanceTo(main);
            result.growths.push_back(std::log(std::max(distance, 1e-300) / displacement));
            beside->approach(main, displacement);
        }
        growing = !result.blows.empty() && main.blow().gap > result.blows.back().gap ? growing + 1 : 0;
        result.blows.push_back(main.blow());
        result.lateShare = std::max(result.lateShare, main.lateShare());
        if (isPushedBack(problem, grid.interval(), result.blows, growing))
            result.outcome = DrillingOutcome::pushedBack;
        if (length.onBlow) length.onBlow(main.blow());
        if (progress) progress(beside ? 2 : 1);
        if (length.histories && main.blows() == length.histories->last && !samples.rear.empty())
            historyEnd = samples.rear.back().time;
    }
    if (length.histories && static_cast<std::size_t>(length.histories->first) <= result.blows.size())
        result.instants =
            instantsOf(samples, result.blows[static_cast<std::size_t>(length.histories->first) - 1].time,
                       historyEnd > 0 ? historyEnd : std::numeric_limits<double>::max());
    result.ledger = main.ledger();
    result.momentumResidual = main.momentumResidual();
    return result;
}

/// Everything of a study but its numbers of the marches.
class Study {
  public:
    Study(const Scenario& scenario, const DrillingSettings& settings, const DrillingWants& wants,
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
        March main = march(
            m_problem, grid,
            {m_result.settings.blows, m_wants.lyapunov, m_wants.histories, m_wants.jobs, m_wants.onBlow},
            m_stop, m_progress);
        m_result.outcome = main.outcome;
        m_result.reason = main.reason;
        m_result.ledger = main.ledger;
        takeResiduals(main, grid);
        m_result.blows = std::move(main.blows);
        m_result.instants = std::move(main.instants);
        if (m_result.outcome == DrillingOutcome::done) takeStatistics(main.growths);
        takeGroups();
        takeVerdict();
        takeAlerts(main.lateShare, grid);
        return std::move(m_result);
    }

  private:
    /// e of the blow at zero gap, and its pieces.
    void solveBlowAlone() {
        Scenario touching = m_result.scenario;
        touching.bitRock.gap = 0;
        const Blow blow = solveBlow(touching, {}, Detail::ledger, m_stop);
        Problem problem = blow.problem;
        problem.gap = m_result.scenario.bitRock.gap / m_result.scales.penetration;
        m_result.cor = blow.isSolved() && blow.summary.transferred > 0
                           ? blow.summary.impulse / blow.summary.transferred - 1
                           : std::numeric_limits<double>::quiet_NaN();
        m_problem = drillingProblemOf(m_result.scenario, std::move(problem));
        m_problem.start = m_result.settings.start;
        m_result.hasLoss = std::ranges::any_of(m_problem.waveLosses, [](double loss) { return loss > 0; });
    }

    void takeGrid(const DrillingGrid& grid) {
        m_result.frequencyUsed = 1 / (grid.interval() * m_result.units.time);
        m_result.cellsPerDuration = 1 / grid.cells.cell;
    }

    void takeResiduals(const March& main, const DrillingGrid& grid) {
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
        std::optional<March> half, full;
        const auto marchHalf = [&] {
            if (m_wants.cellError) half = marchWithHalfTheCells();
        };
        const auto marchFull = [&] {
            if (m_wants.fullRate && std::isfinite(m_result.cor)) full = marchAtFullRate();
        };
        if (m_wants.jobs > 1) {
            std::future<void> other = std::async(std::launch::async, marchFull);
            marchHalf();
            other.get();
        } else {
            marchHalf();
            marchFull();
        }
        if (half) compareCells(*half, settle);
        if (full && m_result.statistics) compareFullRate(*full);
    }

    March marchWithHalfTheCells() const {
        const DrillingGrid coarse = coarseDrillingGridOf(m_problem, m_result.settings.cells);
        return march(m_problem, coarse, {m_result.settings.blows}, m_stop, m_progress);
    }

    March marchAtFullRate() const {
        DrillingProblem pressed = m_problem;
        const DrillingGrid grid = drillingGridOf(pressed, std::min(m_result.settings.cells, scanCells));
        pressed.feedForce = 2 * (1 + 2 * m_result.cor) * m_result.meanImpulse / grid.interval();
        return march(pressed, grid, {scanBlows}, m_stop, m_progress);
    }

    void compareCells(const March& half, std::size_t settle) {
        if (half.outcome != DrillingOutcome::done) return fail(half);
        const DrillingStatistics statistics = statisticsOf(half.blows, settle, m_problem.blow.velocity());
        for (std::size_t q = 0; q < blowQuantities.size(); ++q)
            m_result.cellErrors[q] =
                coveringCells * std::abs(statistics.spreads[q].mean - m_result.spread(q).mean);
    }

    void compareFullRate(const March& full) {
        if (full.outcome == DrillingOutcome::stopped) return fail(full);
        if (full.outcome != DrillingOutcome::done) return;
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const DrillingStatistics statistics =
            statisticsOf(full.blows, static_cast<std::size_t>(scanSettle), m_problem.blow.velocity());
        const double most = statistics.spreads[penetration].mean;
        if (most > 0) m_result.fullRateShare = m_result.spread(penetration).mean / most;
    }

    void fail(const March& other) {
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

    void takeVerdict() {
        if (m_result.outcome == DrillingOutcome::pushedBack)
            m_result.verdict = DrillingVerdict::pushedBack;
        else if (m_result.statistics && m_result.statistics->contactShare >= restingShare)
            m_result.verdict = DrillingVerdict::rests;
        else if (m_result.fullRateShare.value_or(0) >= fullShare)
            m_result.verdict = DrillingVerdict::fullRate;
        else
            m_result.verdict = DrillingVerdict::rateLost;
    }

    void takeAlerts(double lateShare, const DrillingGrid& grid) {
        std::vector<Alert>& alerts = m_result.alerts;
        const Drill& drill = m_result.scenario.drill;
        const auto add = [&](AlertLevel level, AlertCode code, std::vector<AlertArgument> arguments = {}) {
            alerts.push_back({level, code, {}, std::move(arguments)});
        };
        if (m_result.outcome == DrillingOutcome::pushedBack) {
            const double needed = m_result.meanImpulse * m_result.units.impulse() * m_result.frequencyUsed;
            add(AlertLevel::warning, AlertCode::pushedBack,
                {{"force", feedForceOf(m_result.scenario)->effective(), Quantity::force},
                 {"needed", needed, Quantity::force}});
        }
        if (!m_result.hasLoss) add(AlertLevel::information, AlertCode::noWaveLoss);
        if (std::abs(grid.rounding(m_problem)) > toldRounding)
            add(AlertLevel::information, AlertCode::frequencyRounded,
                {{"frequency", *drill.blowFrequency, Quantity::frequency},
                 {"used", m_result.frequencyUsed, Quantity::frequency}});
        if (lateShare > mostLateShare)
            add(AlertLevel::warning, AlertCode::restrikeInTheWay, {{"share", lateShare}});
        if (m_problem.machine) {
            add(AlertLevel::information, AlertCode::damperAssumed);
            addShankOffset();
        }
        if (!m_result.statistics) return;
        if (!m_result.statistics->isSettled) add(AlertLevel::warning, AlertCode::notSettled);
        if (m_result.statistics->period == 0 || (m_result.lyapunov && m_result.lyapunov->value > chaotic))
            add(AlertLevel::information, AlertCode::irregularMotion);
    }

    void addShankOffset() {
        double mean = 0, most = 0;
        const auto settle = static_cast<std::size_t>(m_result.settings.settle);
        if (m_result.blows.size() <= settle) return;
        for (std::size_t i = settle; i < m_result.blows.size(); ++i) mean += m_result.blows[i].shankOffset;
        mean /= static_cast<double>(m_result.blows.size() - settle);
        for (std::size_t i = settle; i < m_result.blows.size(); ++i)
            most = std::max(most, std::abs(m_result.blows[i].shankOffset - mean));
        most *= m_result.units.length();
        if (most > mostShankOffset)
            m_result.alerts.push_back(
                {AlertLevel::warning, AlertCode::shankOff, {}, {{"offset", most, Quantity::length}}});
    }

    DrillingWants m_wants;
    const std::stop_token& m_stop;
    std::mutex m_told;
    DrillingProgress m_progress;
    DrillingProblem m_problem;
    DrillingResult m_result;
};

}  // namespace

std::string_view name(DrillingOutcome outcome) {
    return outcomeNames[outcome];
}

std::string_view name(DrillingVerdict verdict) {
    return verdictNames[verdict];
}

std::optional<double> DrillingResult::meanError(std::size_t quantity) const {
    const std::optional<double> batches = spread(quantity).meanError;
    if (!batches) return std::nullopt;
    return *batches + cellErrors[quantity];
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
    if (wants.cellError) work += coarseDrillingGridOf(problem, settings.cells).work(problem) * blows;
    if (wants.fullRate)
        work += drillingGridOf(problem, scanCells).work(problem) * static_cast<double>(scanBlows);
    return work;
}

DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingWants& wants, const std::stop_token& stop,
                             const DrillingProgress& progress) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    DrillingResult result = Study(scenario, settings, wants, stop, progress).run();
    result.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return result;
}

}  // namespace drillwave
