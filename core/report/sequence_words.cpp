// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/sequence_words.h"

#include <algorithm>
#include <cmath>

#include "core/report/curve_text.h"
#include "core/report/feed_words.h"
#include "core/report/parameter_words.h"
#include "core/report/report_text.h"

namespace drillwave {

namespace {

constexpr int valueDigitsOfScan = 4;
constexpr std::string_view feedKey = "drill.thrust";

/// Significant digits of a value that its error leaves, `ofError` of them to the error itself.
int digitsLeft(double value, double error, int ofError) {
    constexpr int fewest = 1, most = 5;
    if (!(error > 0) || value == 0) return most;
    const double places = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(error));
    return std::clamp(static_cast<int>(places) + ofError, fewest, most);
}

/// An error that no printed digit shows.
constexpr double unseenError = 5e-5;

std::string penetrationRateText(const SequenceMean& rate, const ReadingStyle& style) {
    constexpr int fewest = 2, most = 4;
    const int digits = digitsLeft(rate.value, rate.error.value_or(0), 1);
    return style.rate(rate.value, std::clamp(digits, fewest, most));
}

std::string percentText(double share, const ReadingStyle& style) {
    return style.number(100 * share, 3) + " %";
}

const char* reasonWords(UnresolvedReason reason) {
    switch (reason) {
        case UnresolvedReason::noWaveLoss:
            return translatable("no wave loss is defined");
        case UnresolvedReason::irregular:
            return translatable("the motion is irregular");
        case UnresolvedReason::fewBlows:
            return translatable("only few blows were followed");
        case UnresolvedReason::lengthsRounded:
            return translatable("the lengths are not whole numbers of time steps");
    }
    return "";
}

Message remedyWords(UnresolvedReason reason, const ReadingStyle& style) {
    const auto field = [&](std::string_view key) { return fieldMessage(*findParameter(key), style); };
    switch (reason) {
        case UnresolvedReason::noWaveLoss:
            return {
                style.isPrinted()
                    ? translatable(
                          "Enter a wave loss under “%1”: waves usually lose 1 to 30 % in each round trip.")
                    : translatable("Give a wave loss (%1): waves usually lose 1 to 30 % in each round trip."),
                {field("drill.wave_loss")}};
        case UnresolvedReason::irregular:
        case UnresolvedReason::fewBlows:
            return {
                style.isPrinted()
                    ? translatable(
                          "Enter a larger number under “%1” to reduce the error of the mean penetration.")
                    : translatable(
                          "Increase the number of blows (%1) to reduce the error of the mean penetration."),
                {field("drill.blows")}};
        case UnresolvedReason::lengthsRounded:
            return translatable(
                "To reduce the error, use shorter time steps, or make the section lengths multiples of a "
                "common length.");
    }
    return {};
}

Message penetrationSentence(const Sequence& sequence, const ReadingStyle& style) {
    const std::string penetration =
        withError(sequence.penetration.value, sequence.penetration.error, Quantity::length, style);
    const std::string rate = penetrationRateText(sequence.penetrationRate, style);
    if (!sequence.singleBlowShare)
        return {translatable("The bit penetrates %1 per blow, at a penetration rate of %2."),
                {penetration, rate}};
    return {translatable("The bit penetrates %1 per blow. The penetration rate of %2 is %3 of the rate that "
                         "single blows from rest would give."),
            {penetration, rate, percentText(sequence.singleBlowShare->value, style)}};
}

/// The machine is pushed back, by the mean force of these blows.
Message pushedBackSentence(const DrillingResult& result, const ReadingStyle& style) {
    const double mean = result.meanImpulse * result.units.impulse() * result.frequencyUsed;
    const double installed = feedForceOf(result.scenario)->effective();
    if (!(installed < mean))
        return translatable("The blows push the machine back without limit: increase the feed force.");
    return {
        translatable(
            "The feed force of %1 is less than the mean force of the blows, %2: the machine is pushed back."),
        {style.quantity(installed, Quantity::force, 4), style.quantity(mean, Quantity::force, 4)}};
}

/// "12 kN", behind "drill.gamma = " where the parameter is no feed force.
Message settingOf(const DrillingScan& scan, double value, const ReadingStyle& style) {
    const std::string text = valueText(scan.axis, value, valueDigitsOfScan, style);
    if (scan.axis.key() == feedKey) return {translatable("a feed force of %1"), {text}};
    return {"%1 = %2", {std::string(scan.axis.key()), text}};
}

/// By how much the best is above a present one, where the errors tell.
Message gainWords(const ScanComparison& comparison, const std::optional<Sequence>& present,
                  const ReadingStyle& style) {
    if (!present || !comparison.isLower(*present)) return {};
    const std::optional<double> share = comparison.bestShare(*present);
    return share ? Message(translatable(" (%1 compared with the present value)"),
                           {style.signedPercent(1 / *share - 1)})
                 : Message();
}

/// Returns a sentence with all values whose rates do not differ from the best one by more than the errors. It
/// is empty if the best value is the only one.
Message equalSentence(const DrillingScan& scan, const ScanComparison& comparison, const ReadingStyle& style) {
    const auto& entries = comparison.entries;
    const auto isEqual = [&](std::size_t place) { return !comparison.isLower(entries[place].sequence); };
    const auto value = [&](std::size_t place) {
        return valueText(scan.axis, entries[place].at, valueDigitsOfScan, style);
    };
    Message ranges;
    std::size_t rangeCount = 0, first = 0, last = 0, equalCount = 0;
    for (std::size_t place = 0; place < entries.size(); ++place) {
        if (!isEqual(place)) continue;
        first = place;
        while (place + 1 < entries.size() && isEqual(place + 1)) ++place;
        last = place;
        equalCount += last - first + 1;
        const Message range = first == last ? Message("%1", {value(first)})
                                            : Message(translatable("%1 to %2"), {value(first), value(last)});
        ranges = rangeCount++ == 0 ? range : Message("%1, %2", {ranges, range});
    }
    if (equalCount < 2) return {};
    if (rangeCount > 1)
        return {translatable(
                    "These values give the same penetration rate within the errors of the computation: %1."),
                {ranges}};
    return {
        translatable(
            "All values from %1 to %2 give the same penetration rate within the errors of the computation."),
        {value(first), value(last)}};
}

}  // namespace

std::string withError(double si, const std::optional<double>& error, Quantity quantity,
                      const ReadingStyle& style) {
    if (!error || *error <= unseenError * std::abs(si)) return style.quantity(si, quantity, 4);
    const ReadUnit unit = style.unitFor(si, quantity);
    const double shown = unit.unit->fromSi(si), shownError = unit.unit->fromSi(*error);
    const std::string mean = style.number(shown, digitsLeft(shown, shownError, 2));
    return mean + (style.isPrinted() ? " ± " : " +- ") + style.number(shownError, 2) + " " + unit.name;
}

Message feedModelWords(const Scenario& scenario, const ReadingStyle& style) {
    if (feedModelOf(scenario) == FeedModel::constantForce) return translatable("a constant force");
    const Drill& drill = scenario.drill;
    const std::string damping = style.quantity(drill.damperDamping.value_or(0), Quantity::damping, 4);
    const std::string stiffness = style.quantity(drill.damperStiffness.value_or(0), Quantity::stiffness, 4);
    if (!(drill.damperStiffness.value_or(0) > 0)) return {translatable("a dashpot of %1"), {damping}};
    if (!(drill.damperDamping.value_or(0) > 0)) return {translatable("a spring of %1"), {stiffness}};
    return {translatable("a dashpot of %1 and a spring of %2"), {damping, stiffness}};
}

std::vector<Message> sequenceSentences(const DrillingResult& result, const ReadingStyle& style) {
    switch (result.outcome) {
        case DrillingOutcome::notSolved:
            return {{translatable("The blows could not be solved: %1."), {result.reason}}};
        case DrillingOutcome::stopped:
            return {translatable("The computation was stopped before all blows were solved.")};
        case DrillingOutcome::pushedBack:
            return {pushedBackSentence(result, style)};
        case DrillingOutcome::done:
            break;
    }
    const std::optional<Sequence> sequence = sequenceOf(result);
    if (!sequence) return {};
    std::vector<Message> sentences{penetrationSentence(*sequence, style)};
    if (sequence->unresolved) {
        sentences.push_back(
            {translatable("The mean penetration per blow is inaccurate: its error is above %1, because %2."),
             {percentText(resolvedShare, style), reasonWords(*sequence->unresolved)}});
        sentences.push_back(remedyWords(*sequence->unresolved, style));
    }
    sentences.push_back(
        {translatable("In %1 of the blows, the bit is in contact with the rock when the blow arrives."),
         {percentText(sequence->contactShare, style)}});
    sentences.push_back(
        {feedModelOf(result.scenario) == FeedModel::damper
             ? translatable(
                   "The connection between machine and rod is modelled as %1, which is an assumption.")
             : translatable("The connection between machine and rod is modelled as %1."),
         {feedModelWords(result.scenario, style)}});
    return sentences;
}

std::string sequenceText(const DrillingResult& result, const ReadingStyle& style) {
    return inOneParagraph(sequenceSentences(result, style), style);
}

std::vector<Message> scanSentences(const DrillingScan& scan, const std::optional<Sequence>& present,
                                   const ReadingStyle& style) {
    const std::optional<ScanComparison> comparison = compareScan(scan);
    if (!comparison || !scan.axis.parameter) return {};
    std::vector<Message> sentences;
    if (comparison->unresolved) {
        const Sequence& unresolved = comparison->unresolved->sequence;
        sentences.push_back({translatable("The scan cannot decide which value is best: the penetrations have "
                                          "errors of +- %1, because %2."),
                             {style.quantity(unresolved.penetration.error.value_or(0), Quantity::length, 2),
                              reasonWords(*unresolved.unresolved)}});
        sentences.push_back(remedyWords(*unresolved.unresolved, style));
    } else if (comparison->entries.size() > 1 && !comparison->isAnyLower()) {
        sentences.push_back({translatable("All values of the scan give the same penetration rate, %1, within "
                                          "the errors of the computation."),
                             {penetrationRateText(comparison->best().sequence.penetrationRate, style)}});
    } else {
        const std::string rate = penetrationRateText(comparison->best().sequence.penetrationRate, style);
        sentences.push_back(
            {translatable("The highest penetration rate of the scan, %1, is reached with %2."),
             {Message("%1%2", {rate, gainWords(*comparison, present, style)}),
              settingOf(scan, comparison->best().at, style)}});
        if (Message equal = equalSentence(scan, *comparison, style); !equal.isEmpty())
            sentences.push_back(std::move(equal));
    }
    sentences.emplace_back(feedLimitsOfModel);
    return sentences;
}

}  // namespace drillwave
