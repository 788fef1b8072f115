#include "core/study/thrust_study.h"

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/wave/exact_solver.h"

namespace drillwave {

namespace {

constexpr std::size_t index(ThrustCase which) {
    return static_cast<std::size_t>(which);
}

ThrustNeed needOf(const Scenario& scenario, const Estimate& cor) {
    ThrustNeed need{
        .cor = cor, .thrust = *thrustNeeded(scenario, cor.value), .margin = {}, .frequencyLimit = {}};
    if (const std::optional<double> installed = scenario.drill.thrust) {
        need.margin = *installed / need.thrust - 1;
        need.frequencyLimit = *scenario.drill.blowFrequency * *installed / need.thrust;
    }
    return need;
}

Feed judge(const ThrustStudy& study) {
    const auto isShort = [&](ThrustCase which) { return *study.need(which).margin < 0; };
    if (!study.need(ThrustCase::scenario).margin) return Feed::unknown;
    if (isShort(ThrustCase::scenario)) return Feed::tooLow;
    if (isShort(ThrustCase::gapQuantile)) return Feed::lowAtOtherGaps;
    if (isShort(ThrustCase::rigidRock) || isShort(ThrustCase::elasticWorst)) return Feed::lowOnElasticRock;
    return *study.largestNeed().margin > overfeed - 1 ? Feed::tooHigh : Feed::enough;
}

/// Both curves over the gap, half of the progress each.
struct Curves {
    GapCurve rock;     ///< as it is
    GapCurve elastic;  ///< γ = 1, from no gap on
};

Curves curvesOf(const PulseForce& pulse, const Groups& groups, const std::stop_token& stop,
                const GapProgress& progress) {
    const auto half = [&](double before) {
        return [&progress, before](double done) {
            if (progress) progress(before + done / 2);
        };
    };
    Groups elastic = groups;
    elastic.gamma = 1;
    return {gapCurve(pulse, groups, Detail::cor, stop, half(0)),
            gapCurve(pulse, elastic, 0, Detail::cor, stop, half(0.5))};
}

}  // namespace

std::string_view name(ThrustCase which) {
    constexpr std::array<std::string_view, thrustCaseCount> names{"scenario", "gap_95_percent", "rigid_rock",
                                                                  "elastic_worst_gap"};
    return names[index(which)];
}

std::string_view name(Feed feed) {
    constexpr std::array<std::string_view, 6> names{
        "unknown", "too_low", "low_at_other_gaps", "low_on_elastic_rock", "enough", "too_high"};
    return names[static_cast<std::size_t>(feed)];
}

const ThrustNeed& ThrustStudy::largestNeed() const {
    return *std::ranges::max_element(needs, {}, &ThrustNeed::thrust);
}

ThrustStudy studyThrust(const Scenario& scenario, std::stop_token stop, const GapProgress& progress) {
    const PulseForce pulse = pulseForceOf(scenario);
    const Groups groups = groupsOf(scenario);
    ThrustStudy study;
    const Impact impact = ExactSolver().solve(pulse, groups, Detail::cor, stop);
    if (impact.outcome != Outcome::rebounded) {
        study.stopped = stop.stop_requested();
        study.reason = impact.reason;
        return study;
    }
    const Curves curves = curvesOf(pulse, groups, stop, progress);
    study.stopped = curves.rock.stopped || curves.elastic.stopped;
    for (const GapCurve* curve : {&curves.rock, &curves.elastic})
        if (!curve->isComplete()) study.reason = curve->reason;
    if (study.stopped || !study.reason.empty()) return study;

    const GapStatistics statistics = gapStatistics(curves.rock);
    const auto set = [&](ThrustCase which, const Estimate& cor) {
        study.needs[index(which)] = needOf(scenario, cor);
    };
    set(ThrustCase::scenario, {impact.cor, impact.corError});
    set(ThrustCase::gapQuantile, statistics.of(GapOutput::cor).uniform.quantiles.back());
    set(ThrustCase::rigidRock, {1, 0});
    set(ThrustCase::elasticWorst, largestCor(curves.elastic));
    study.feed = judge(study);
    if (scenario.drill.thrust) {
        const double held = *scenario.drill.thrust / *thrustNeeded(scenario, 0) - 1;
        study.shareHeld = 1 - shareAbove(curves.rock, held).value;
    }
    return study;
}

std::string_view feedAdvice(Feed feed) {
    switch (feed) {
        case Feed::unknown:
            return "No installed thrust is given: give drill.thrust to see margins.";
        case Feed::tooLow:
            return "Too little feed: the bit bounces off the bottom between blows and the string runs loose. "
                   "Joints rattle, run hot and wear, the next blow meets a bit that is not on the rock, and "
                   "part of it comes back into the drill. Raise the feed, or lower the percussion.";
        case Feed::lowAtOtherGaps:
            return "Enough feed for this blow, but not for all gaps that blows meet: the bit lifts off now "
                   "and "
                   "then, and the string is loose for those blows. Raise the feed a little.";
        case Feed::lowOnElasticRock:
            return "Enough feed for this rock. Where the bottom pushes the bit back, on hard rock or on "
                   "cuttings that are not flushed away, the bit starts to bounce and the string runs loose: "
                   "watch the flushing, and raise the feed when the joints begin to rattle.";
        case Feed::enough:
            return "Enough feed to hold the bit on the rock, also where the bottom pushes it back.";
        case Feed::tooHigh:
            return "Over-feeding: far more than even the worst bottom needs. The bit is pressed in while it "
                   "should turn: rotation drags or stalls, buttons wear, rods bend and the hole wanders. "
                   "Lower the feed.";
    }
    return {};
}

}  // namespace drillwave
