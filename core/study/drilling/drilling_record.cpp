// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/drilling_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <semaphore>
#include <system_error>
#include <thread>

#include "core/contact/contact_law.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/wave/work_limit.h"

namespace drillwave {

namespace {

constexpr EnumNames<DrillingOutcome> outcomeNames{{{DrillingOutcome::done, "done"},
                                                   {DrillingOutcome::pushedBack, "pushed_back"},
                                                   {DrillingOutcome::notSolved, "not_solved"},
                                                   {DrillingOutcome::stopped, "stopped"}}};

/// A thrust may be below the mean reaction by that share of it and be marched.
constexpr double equalThrust = 1e-9;

/// A bit that is so far away does not come back [d0].
constexpr double mostGap = 1000;

/// How far the second march of λ is displaced.
constexpr double displacement = 1e-6;

/// Work after which a march is judged by what all of its blows would take.
constexpr double judgedWork = 5e7;

/// Wave cells that a march keeps at once, of all sections and of the force: well above those of any rig, in
/// some 0.1 GB.
constexpr double mostKeptCells = 2e6;

/// Takes the blows of a march on a thread of its own, one per request.
class MarchBeside {
  public:
    /// Requires march and stop token to outlive it.
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

/// Whether nothing bounded comes of it.
bool fliesAway(const DrillingProblem& problem, double interval, const std::vector<DrillingBlow>& blows,
               long growing) {
    if (blows.back().gap * lawUnitOfPenetration > mostGap) return true;
    if (problem.blow.isForced() || growing < growingBlows) return false;
    return problem.feedForce * interval <= meanImpulse(blows, growingBlows);
}

/// Returns the recorded instants from one time to another.
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

}  // namespace

std::string_view name(DrillingOutcome outcome) {
    return outcomeNames[outcome];
}

double meanImpulse(const std::vector<DrillingBlow>& blows, std::size_t last) {
    const std::size_t from = blows.size() - std::min(last, blows.size());
    double sum = 0;
    for (std::size_t i = from; i < blows.size(); ++i) sum += blows[i].faceImpulse;
    return sum / static_cast<double>(blows.size() - from);
}

Message memoryProblem(const DrillingProblem& problem, const DrillingGrid& grid) {
    const double force = problem.blow.isForced() ? problem.blow.force().end / grid.cell : 0;
    double kept = std::ceil(force) * static_cast<double>(grid.cuts.count());
    for (const double trip : grid.roundTrips)
        kept += std::ceil(trip) * static_cast<double>(grid.cuts.count());
    if (kept <= mostKeptCells) return {};
    return {
        translatable("its waves are kept in %1 cells, more than the %2 permitted; a longer blow, a shorter "
                     "string or fewer --cells need less"),
        {rounded(kept, 2), rounded(mostKeptCells, 2)}};
}

Message workProblem(const DrillingMarch& march, long blows, double mostWork) {
    const double all = march.work() / static_cast<double>(march.blows()) * static_cast<double>(blows);
    if (march.work() < std::min(judgedWork, mostWork) || all <= mostWork) return {};
    return {WorkLimitReason::contacts, {rounded(all, 2), rounded(mostWork, 2)}};
}

DrillingRecord recordOf(const DrillingProblem& problem, const DrillingGrid& grid, const RecordLength& length,
                        const std::stop_token& stop, const DrillingProgress& progress) {
    DrillingRecord result;
    // compared at the given frequency, not at the one rounded to cells
    if (problem.blow.isForced() && problem.feedForce * problem.interval < 1 - equalThrust) {
        result.outcome = DrillingOutcome::pushedBack;
        return result;
    }
    if (result.reason = memoryProblem(problem, grid); !result.reason.isEmpty()) {
        result.outcome = DrillingOutcome::notSolved;
        return result;
    }
    DrillingMarch main(problem, grid);
    if (!main.failureReason().empty()) {
        result.outcome = DrillingOutcome::notSolved;
        result.reason = Message::ofTable(main.failureReason());
        return result;
    }
    std::optional<DrillingMarch> beside;
    if (length.lyapunov) {
        beside.emplace(main);
        beside->displace(displacement);
        beside->approach(main, displacement);
    }
    std::optional<MarchBeside> thread;
    if (beside && length.jobs > 1) {
        try {
            thread.emplace(*beside, stop);
        } catch (const std::system_error&) {
            // No thread can be started: this one takes both marches.
        }
    }
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
            const std::string_view failure =
                main.failureReason().empty() && beside ? beside->failureReason() : main.failureReason();
            result.outcome = failure.empty() ? DrillingOutcome::stopped : DrillingOutcome::notSolved;
            result.reason = Message::ofTable(failure);
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
        if (fliesAway(problem, grid.interval(), result.blows, growing))
            result.outcome = DrillingOutcome::pushedBack;
        if (result.reason = workProblem(main, length.blows, length.mostWork); !result.reason.isEmpty())
            result.outcome = DrillingOutcome::notSolved;
        if (length.onBlow) length.onBlow(main.blow());
        if (progress) progress(beside ? 2 : 1);
        if (length.histories && main.blows() == length.histories->last && !samples.rear.empty())
            historyEnd = samples.rear.back().time;
        if (length.stopEarly && length.stopEarly(result.blows)) break;
    }
    if (length.histories && static_cast<std::size_t>(length.histories->first) <= result.blows.size())
        result.instants =
            instantsOf(samples, result.blows[static_cast<std::size_t>(length.histories->first) - 1].time,
                       historyEnd > 0 ? historyEnd : std::numeric_limits<double>::max());
    result.ledger = main.ledger();
    result.momentumResidual = main.momentumResidual();
    return result;
}

}  // namespace drillwave
