// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/scan/drilling_scan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/model/validation.h"
#include "core/numeric/ordered_work.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Statistics agree to that share of what they are of without any error.
constexpr double sameMean = 1e-6;

/// Two marches of one problem are one when so many blows of them are the same, to that share of what they are
/// of; one may be up to so many blows behind the other less one.
constexpr std::size_t sameBlows = 16;
constexpr double sameBlow = 1e-9;

/// One value of a scan.
struct ValueWork {
    std::uint64_t index = 0;
    DrillingResult rest, bouncing;
    bool differs = false;
};

Scenario scenarioAt(const Scenario& base, const SweepAxis& axis, std::uint64_t index) {
    Scenario scenario = base;
    (void)axis.assign(scenario, axis.value(index));
    return scenario;
}

/// Whether both come to the same, as far as their errors tell.
bool isSameMotion(const DrillingResult& one, const DrillingResult& other) {
    if (one.outcome != other.outcome) return false;
    if (!one.statistics || !other.statistics) return true;
    for (const std::size_t q : {0UL, 2UL, 3UL}) {
        const double errors = one.spread(q).meanError.value_or(0) + other.spread(q).meanError.value_or(0);
        const double size = std::max(std::abs(one.spread(q).mean), std::abs(other.spread(q).mean));
        if (std::abs(one.spread(q).mean - other.spread(q).mean) > errors + sameMean * (1 + size))
            return false;
    }
    return true;
}

bool isSameBlow(const DrillingBlow& one, const DrillingBlow& other) {
    return std::ranges::all_of(
        std::array{&DrillingBlow::gap, &DrillingBlow::velocity, &DrillingBlow::rockImpulse,
                   &DrillingBlow::penetration, &DrillingBlow::peakForce},
        [&](auto value) {
            return std::abs(one.*value - other.*value) <= sameBlow * (1 + std::abs(other.*value));
        });
}

/// Whether a march has come to where another one has been or will be: what follows is the same.
bool hasMet(const std::vector<DrillingBlow>& blows, const std::vector<DrillingBlow>& other) {
    if (blows.size() < 2 * sameBlows) return false;
    const std::span last(blows.end() - sameBlows, blows.end());
    for (std::size_t shift = 0; shift < 2 * sameBlows; ++shift) {
        const std::size_t first = blows.size() - 2 * sameBlows + shift;
        if (first + sameBlows > other.size()) return false;
        if (std::equal(last.begin(), last.end(), other.begin() + static_cast<std::ptrdiff_t>(first),
                       isSameBlow))
            return true;
    }
    return false;
}

}  // namespace

std::vector<Message> scanRefusals(const Scenario& base, const SweepAxis& axis,
                                  const DrillingSettings& settings) {
    for (const std::uint64_t index : axis.extremes()) {
        Scenario scenario = base;
        if (Message problem = axis.assign(scenario, axis.value(index)); !problem.isEmpty()) return {problem};
        if (const std::vector<InputProblem> invalid = validate(scenario); !invalid.empty())
            return {invalid.front().text};
        if (std::vector<Message> problems = drillingRefusals(scenario, settings); !problems.empty())
            return problems;
    }
    return {};
}

double scanWork(const Scenario& scenario, const DrillingSettings& settings) {
    const auto work = [&](bool isWhole) {
        return drillingWork(scenario, settings, {.cellError = isWhole, .lyapunov = isWhole});
    };
    return work(true) + work(false);  // from rest, and from bouncing
}

DrillingScan scanDrilling(const Scenario& base, const SweepAxis& axis, const DrillingSettings& settings,
                          const DrillingScanWork& work) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    DrillingScan scan{.base = base, .axis = axis, .settings = settings, .points = {}};
    scan.refusal = inOneLine(scanRefusals(base, axis, settings));
    if (!scan.refusal.isEmpty()) return scan;
    std::uint64_t next = 0;
    const auto fill = [&](ValueWork& chunk) {
        if (next == axis.count) return false;
        chunk.index = next++;
        return true;
    };
    const auto makeWorker = [&] {
        return [&](ValueWork& chunk, const std::stop_token& stop) {
            const Scenario scenario = scenarioAt(base, axis, chunk.index);
            DrillingRequest wants{.lyapunov = work.lyapunov, .mostWork = work.mostWork};
            DrillingSettings from = settings;
            chunk.rest = studyDrilling(scenario, from, wants, stop);
            wants.cellError = wants.lyapunov = wants.blowAlone = false;
            from.start = DrillingStart::bouncing;
            bool isMet = false;
            wants.stopEarly = [&](const std::vector<DrillingBlow>& blows) {
                return isMet = hasMet(blows, chunk.rest.blows);
            };
            chunk.bouncing = studyDrilling(scenario, from, wants, stop);
            chunk.differs = !isMet && !isSameMotion(chunk.rest, chunk.bouncing);
            wants.stopEarly = {};
            wants.lyapunov = work.lyapunov;
            wants.cellError = true;
            if (chunk.differs)  // its error is stated, and its λ
                chunk.bouncing = studyDrilling(scenario, from, wants, stop);
            chunk.bouncing.alone = chunk.rest.alone;
        };
    };
    const auto deliver = [&](ValueWork& chunk) {
        const double value = axis.value(chunk.index);
        if (chunk.index == 0 && chunk.rest.alone) scan.cor = chunk.rest.alone->cor;
        scan.bouncingBlows += static_cast<long>(chunk.bouncing.blows.size());
        if (chunk.differs)
            for (DrillingResult* result : {&chunk.rest, &chunk.bouncing})
                if (!result->cellsDecideMotion)
                    result->alerts.push_back({AlertLevel::warning, AlertCode::coexistingMotions, {}, {}});
        scan.points.push_back({value, DrillingStart::rest, std::move(chunk.rest)});
        if (chunk.differs) scan.points.push_back({value, DrillingStart::bouncing, std::move(chunk.bouncing)});
        if (work.progress) work.progress(1);
        if (work.onValue) work.onValue(scan);
        return true;
    };
    processInOrder<ValueWork>(work.jobs, work.stop, fill, makeWorker, deliver);
    scan.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return scan;
}

}  // namespace drillwave
