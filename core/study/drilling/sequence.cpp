// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/drilling/sequence.h"

#include <cmath>

#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr std::size_t penetrationPlace = quantityPlace(&DrillingBlow::penetration);

SequenceMean scaled(SequenceMean mean, double factor) {
    mean.value *= factor;
    if (mean.error) *mean.error *= std::abs(factor);
    return mean;
}

/// The quotient of two numbers whose errors are independent bounds.
SequenceMean over(const SequenceMean& mean, const Estimate& reference) {
    SequenceMean share = scaled(mean, 1 / reference.value);
    if (share.error) *share.error += std::abs(share.value) * reference.error / reference.value;
    return share;
}

std::optional<UnresolvedReason> unresolvedReason(const DrillingResult& result) {
    const double allowed = resolvedShare * std::abs(result.spread(penetrationPlace).mean);
    const std::optional<double> scatter = result.spread(penetrationPlace).meanError;
    if (!scatter) return UnresolvedReason::fewBlows;
    const double ofCells = result.cellErrors[penetrationPlace];
    if (*result.meanError(penetrationPlace) <= allowed) return std::nullopt;
    if (!result.hasLoss) return UnresolvedReason::noWaveLoss;
    if (ofCells > *scatter && !result.hasWholeTrips) return UnresolvedReason::lengthsRounded;
    // A scatter falls with the root of the blows; one that a march of usual length would settle is of few.
    const double counted = static_cast<double>(result.settings.blows - result.settings.settle);
    const double usual = static_cast<double>(DrillingSettings{}.blows - DrillingSettings{}.settle);
    if (ofCells <= allowed && counted < usual && *scatter * std::sqrt(counted / usual) + ofCells <= allowed)
        return UnresolvedReason::fewBlows;
    return UnresolvedReason::irregular;
}

}  // namespace

std::string_view name(UnresolvedReason reason) {
    static constexpr EnumNames<UnresolvedReason> names{
        {{UnresolvedReason::noWaveLoss, "no_wave_loss"},
         {UnresolvedReason::irregular, "irregular"},
         {UnresolvedReason::fewBlows, "few_blows"},
         {UnresolvedReason::lengthsRounded, "lengths_rounded"}}};
    return names[reason];
}

std::string_view name(FeedModel model) {
    static constexpr EnumNames<FeedModel> names{
        {{FeedModel::constantForce, "constant_force"}, {FeedModel::damper, "damper"}}};
    return names[model];
}

FeedModel feedModelOf(const Scenario& scenario) {
    const Drill& drill = scenario.drill;
    const bool hasDamper = drill.damperDamping.value_or(0) > 0 || drill.damperStiffness.value_or(0) > 0;
    return drill.machineMass.value_or(0) > 0 && hasDamper ? FeedModel::damper : FeedModel::constantForce;
}

std::optional<Sequence> sequenceOf(const DrillingResult& result) {
    if (!result.statistics) return std::nullopt;
    Sequence sequence;
    sequence.penetration = scaled({result.spread(penetrationPlace).mean, result.meanError(penetrationPlace)},
                                  result.units.length());
    sequence.penetrationRate = scaled(sequence.penetration, result.frequencyUsed);
    if (result.alone && result.alone->penetration.value > 0)
        sequence.singleBlowShare = over(sequence.penetration, result.alone->penetration);
    sequence.contactShare = result.statistics->contactShare;
    const BlowSpread& gap = result.spread(quantityPlace(&DrillingBlow::gap));
    const double length = result.units.length();
    sequence.gap = {.mean = gap.mean * length,
                    .meanError = gap.meanError,
                    .deviation = gap.deviation * length,
                    .q05 = gap.q05 * length,
                    .q50 = gap.q50 * length,
                    .q95 = gap.q95 * length,
                    .least = gap.least * length,
                    .largest = gap.largest * length};
    if (sequence.gap.meanError) *sequence.gap.meanError *= length;
    sequence.unresolved = unresolvedReason(result);
    return sequence;
}

}  // namespace drillwave
