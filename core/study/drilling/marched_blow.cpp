// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/marched_blow.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "core/contact/contact_law.h"
#include "core/model/blow_traits.h"
#include "core/model/form_conversion.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_mesh.h"
#include "core/study/drilling/drilling_record.h"
#include "core/text/message.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/wave/work_limit.h"

namespace drillwave {
namespace {

/// Returns the rest of a curve from a time at which one of its pieces begins.
PiecewisePolynomial since(const PiecewisePolynomial& curve, double start, double rounding) {
    PiecewisePolynomial rest;
    rest.clear(start);
    for (const PiecewisePolynomial::Piece& piece : curve.pieces())
        if (piece.start >= start - rounding)
            rest.append(piece.length, piece.scale, curve.coefficients(piece));
    return rest;
}

/// From the blow on; a bit that presses then touches from there.
std::vector<ImpactEvent> eventsOf(const MarchedWaves& kept) {
    std::vector<ImpactEvent> events;
    if (kept.place > 0) events.push_back({ContactEvent::contact, 0});
    std::ranges::copy_if(kept.events, std::back_inserter(events),
                         [](const ImpactEvent& event) { return event.time >= 0; });
    return events;
}

/// When the force is largest, as its pieces have it at their ends and in their middle.
double timeOfPeak(const PiecewisePolynomial& force) {
    double largest = 0, time = force.start();
    for (const PiecewisePolynomial::Piece& piece : force.pieces())
        for (const double share : {0.0, 0.5, 1.0}) {
            const double here = force.value(piece, share * piece.length);
            if (here > largest) largest = here, time = piece.start + share * piece.length;
        }
    return time;
}

Impact impactOf(const MarchedWaves& kept, const DrillingBlow& blow, double hammerImpulse) {
    Impact impact;
    impact.outcome = Outcome::nextBlow;
    impact.waves = kept.waves;
    impact.endTime = impact.forcesEnd = kept.waves->end();
    impact.events = eventsOf(kept);
    impact.impulse = blow.rockImpulse;
    impact.peakForce = blow.peakForce;
    impact.contacts =
        static_cast<int>(std::ranges::count(impact.events, ContactEvent::contact, &ImpactEvent::kind));
    impact.hammerImpulse = hammerImpulse;
    impact.hammerWork = kept.hammerWork;
    impact.rockWork = kept.rockWork;
    impact.contactDuration = blow.contactTime;
    // the rock is that of this blow from when its wave arrives there
    impact.incident = since(kept.waves->bitWave(), kept.transitTime, kept.waves->rounding());
    impact.force = since(kept.waves->bitForce(), kept.transitTime, kept.waves->rounding());
    impact.peakTime = timeOfPeak(impact.force);
    impact.firstContactTime = impact.separationTime = Impact::never;
    for (const ImpactEvent& event : impact.events) {
        if (event.kind == ContactEvent::contact && !(impact.firstContactTime <= event.time))
            impact.firstContactTime = event.time;
        // of the contact that the wave of the blow makes: what follows is bouncing or rest
        if (event.kind == ContactEvent::separation && event.time > impact.peakTime &&
            !(impact.separationTime <= event.time))
            impact.separationTime = event.time;
    }
    return impact;
}

ImpactSummary summaryOf(const Impact& impact, const Problem& problem, const MarchedWaves& kept,
                        const DrillingBlow& blow) {
    ContactLaw<> rock(problem.law);
    rock.rememberAcross(std::max(kept.rememberedForce, impact.peakForce));
    ImpactSummary summary;
    summary.peakForce = impact.peakForce;
    summary.maxPenetration = rock.largestPenetration() * lawUnitOfPenetration;
    summary.residualPenetration = (kept.residual + blow.penetration) * lawUnitOfPenetration;
    summary.firstContactTime = impact.firstContactTime;
    summary.separationTime = impact.separationTime;
    summary.contactDuration = impact.contactDuration;
    summary.contacts = impact.contacts;
    summary.workRatio = 2 * problem.mass() * impact.hammerWork;
    summary.energy.rockWork = impact.efficiency();
    summary.endTime = impact.endTime;
    return summary;
}

}  // namespace

Blow marchedBlow(const Scenario& scenario, const DrillingSettings& settings, long number,
                 const std::stop_token& stop, double mostWork) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    Blow blow;
    std::vector<Message> refusals = drillingRefusals(scenario, settings);
    if (number < 1 || number > settings.blows)
        refusals.emplace_back(translatable("there is no blow %1 of %2"),
                              std::vector<Message>{std::to_string(number), std::to_string(settings.blows)});
    blow.impact.reason = inOneLine(std::move(refusals));
    if (!blow.impact.reason.isEmpty()) return blow;
    blow.scenario = hasSections(scenario) ? scenario : oneSectionOf(scenario);
    blow.groups = groupsOf(blow.scenario);
    blow.scales = scalesOf(blow.scenario);
    blow.marched = MarchedStart{.number = number};
    DrillingMesh mesh = drillingMeshOf(scenario, settings.cells);
    mesh.problem.start = settings.start;
    blow.problem = mesh.problem.blow;

    Message problem = memoryProblem(mesh.problem, mesh.grid);
    if (problem.isEmpty() && mesh.grid.work(mesh.problem) * static_cast<double>(number) > mostWork)
        problem = WorkLimitReason::sequence;
    if (!problem.isEmpty()) {
        blow.impact = Impact::unsolved(std::move(problem));
        return blow;
    }
    DrillingMarch march(mesh.problem, mesh.grid);
    while (problem.isEmpty() && march.blows() + 2 < number && march.takeBlow(stop))
        problem = workProblem(march, number, mostWork);
    if (!problem.isEmpty()) {
        blow.impact = Impact::unsolved(std::move(problem));
        return blow;
    }
    const MarchedWaves kept = march.blows() + 2 >= number ? march.takeBlowWithWaves(stop) : MarchedWaves{};
    if (!march.failureReason().empty() || stop.stop_requested()) {
        blow.impact = Impact::unsolved(
            Message::ofTable(march.failureReason().empty() ? "stopped" : march.failureReason()));
    } else if (!kept.waves) {
        blow.impact = Impact::unsolved(translatable("it has too many waves to keep"), Hindrance::histories);
    } else {
        blow.marched->rememberedForce = kept.rememberedForce;
        blow.problem.gap = -kept.place * lawUnitOfPenetration;
        blow.impact = impactOf(kept, march.blow(), march.hammerMomentum());
        blow.summary = summaryOf(blow.impact, blow.problem, kept, march.blow());
    }
    blow.runTime = std::chrono::duration<double>(Clock::now() - begin).count();
    return blow;
}

}  // namespace drillwave
