// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/feed_json.h"

#include "core/text/enum_names.h"

namespace drillwave {

namespace {

/// The key of a case: "this_blow", "gaps_95", "rigid_rock", "worst_gap".
std::string_view keyOf(ThrustCase which) {
    static constexpr EnumNames<ThrustCase> keys{{{ThrustCase::scenario, "this_blow"},
                                                 {ThrustCase::gapQuantile, "gaps_95"},
                                                 {ThrustCase::rigidRock, "rigid_rock"},
                                                 {ThrustCase::elasticWorst, "worst_gap"}}};
    return keys[which];
}

/// A force of each case, null where the case was not examined.
JsonObject casesJson(const FeedEstimate& feed, double ThrustNeed::*force) {
    JsonObject object;
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = feed.need(which);
        object[keyOf(which)] = need.known ? Json(need.*force) : Json();
    }
    return object;
}

JsonObject meanJson(const SequenceMean& mean, double unit = 1) {
    return {{"mean", mean.value / unit}, {"error", mean.error ? Json(*mean.error / unit) : Json()}};
}

JsonObject modelJson(const Scenario& scenario) {
    const Drill& drill = scenario.drill;
    const bool hasDamper = feedModelOf(scenario) == FeedModel::damper;
    JsonObject object{{"kind", name(feedModelOf(scenario))},
                      {"machine_mass", drill.machineMass},
                      {"damper_damping", hasDamper ? drill.damperDamping : std::nullopt},
                      {"damper_stiffness", hasDamper ? drill.damperStiffness : std::nullopt},
                      {"wave_loss", drill.waveLoss.value_or(0)}};
    // No maker publishes its damper, and nobody has measured the loss of a wave in this rod.
    JsonArray assumed;
    if (hasDamper && drill.damperDamping) assumed.emplace_back("damper_damping");
    if (hasDamper && drill.damperStiffness) assumed.emplace_back("damper_stiffness");
    if (drill.waveLoss) assumed.emplace_back("wave_loss");
    object["assumed"] = assumed;
    return object;
}

}  // namespace

Json feedJson(const std::optional<FeedEstimate>& feed) {
    if (!feed) return {};
    JsonArray examined, missing;
    for (const ThrustCase which : thrustCases)
        (feed->need(which).known ? examined : missing).emplace_back(keyOf(which));
    const std::optional<FeedState> state = feed->state();
    JsonObject object{{"installed", feed->force ? Json(feed->force->thrust) : Json()},
                      {"effective", feed->effective()},
                      {"balance", feed->balance},
                      {"required", casesJson(*feed, &ThrustNeed::thrust)},
                      {"return_in_time", casesJson(*feed, &ThrustNeed::thrustUndamped)},
                      {"examined", examined},
                      {"not_examined", missing}};
    object["not_examined_reason"] = feed->isOfAllGaps() ? Json()
                                    : feed->gapsHavePeriod
                                        ? Json("the gaps were not computed here; `thrust` computes them")
                                        : Json("the gaps of a string have no period");
    object["round_trips"] = feed->roundTrips;
    object["state"] = state ? Json(name(*state)) : Json();
    return object;
}

Json sequenceJson(const DrillingResult& result, OutputUnits units, const ScanComparison* scan) {
    const std::optional<Sequence> sequence = sequenceOf(result);
    if (!sequence) return {};
    const double unit = units == OutputUnits::si ? 1 : result.scales.penetration;
    JsonObject object{{"penetration", meanJson(sequence->penetration, unit)},
                      {"penetration_rate", meanJson(sequence->penetrationRate)},
                      {"contact_share", sequence->contactShare},
                      {"gap", JsonObject{{"mean", sequence->gap.mean / unit},
                                         {"q05", sequence->gap.q05 / unit},
                                         {"q50", sequence->gap.q50 / unit},
                                         {"q95", sequence->gap.q95 / unit}}},
                      {"resolved", sequence->isResolved()}};
    object["single_blow_share"] =
        sequence->singleBlowShare ? Json(meanJson(*sequence->singleBlowShare)) : Json();
    object["best_share"] = scan ? Json(scan->bestShare(*sequence)) : Json();
    object["best_at"] = scan && scan->isResolved() ? Json(scan->best().at) : Json();
    object["unresolved_reason"] = sequence->unresolved ? Json(name(*sequence->unresolved)) : Json();
    object["model"] = modelJson(result.scenario);
    return object;
}

}  // namespace drillwave
