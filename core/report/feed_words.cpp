// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/feed_words.h"

#include <algorithm>
#include <cmath>

#include "core/report/report_text.h"
#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr int fewestDigits = 3, usualDigits = 4;

/// As many as tell the installed force from a required one.
int digitsApart(double present, double bound) {
    constexpr int most = 9;  // well above the noise of rounding
    const double apart = std::abs(present / bound - 1);
    if (!(apart > 0) || !std::isfinite(apart)) return apart == 0 ? most : fewestDigits;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(apart))) + 1, fewestDigits, most);
}

/// A sentence of one estimate, in the numbers of one reader.
class EstimateMessage {
  public:
    EstimateMessage(const FeedEstimate& estimate, const ReadingStyle& style)
        : m_estimate(estimate), m_style(style) {}

    Message message() const {
        const std::optional<FeedState> state = m_estimate.state();
        if (!state) return wanted();
        const double ofThisBlow = m_estimate.need(ThrustCase::scenario).thrust;
        const ThrustNeed& largest = m_estimate.largest();
        switch (*state) {
            case FeedState::notApplicable:
                return translatable(
                    "The single-blow estimate does not apply: the waves of a blow are still in the string at "
                    "the next blow.");
            case FeedState::pushedBack:
                return {translatable("The feed force of %1 is less than the mean force of the blows, %2: the "
                                     "machine is pushed back."),
                        {installed(m_estimate.balance), required(m_estimate.balance)}};
            case FeedState::belowRequired:
                return {translatable("A feed force of %1 is below the %2 that this blow requires: "
                                     "penetration will probably be lost."),
                        {installed(ofThisBlow), required(ofThisBlow)}};
            case FeedState::requiredAtThisGap:
                return thisGapOnly(ofThisBlow, largest.thrust);
            case FeedState::requiredMet:
                return {
                    m_estimate.isOfAllGaps()
                        ? translatable(
                              "A feed force of %1 is enough for a single blow at any gap (%2 required).")
                        : translatable("A feed force of %1 is enough for this blow and for rigid rock (%2 "
                                       "required); other gaps between bit and rock were not examined."),
                    {installed(largest.thrust), required(largest.thrust)}};
            case FeedState::returnMet:
                return {
                    m_estimate.isOfAllGaps()
                        ? translatable(
                              "A feed force of %1 is enough for a single blow at any gap. It even returns an "
                              "undamped rod to the rock before the next blow (this requires %2).")
                        : translatable("A feed force of %1 is enough for this blow and for rigid rock. It "
                                       "even returns an undamped rod to the rock before the next blow (this "
                                       "requires %2). Other gaps between bit and rock were not examined."),
                    {installed(largest.thrustUndamped), required(largest.thrustUndamped)}};
        }
        return {};
    }

    Message remedy() const {
        const double needed = m_estimate.need(ThrustCase::scenario).thrust;
        const double limit = m_estimate.frequencyFor(needed);
        const int digits = digitsApart(m_estimate.frequency, limit);
        const std::string present = frequency(m_estimate.frequency, std::max(usualDigits, digits));
        if (!(limit > 0))
            return {
                translatable("For this blow, the feed force must be at least %1 at a blow frequency of %2."),
                {least(needed), present}};
        return {translatable("For this blow, the feed force must be at least %1 at %2, or the blow frequency "
                             "at most %3 with the present feed force."),
                {least(needed), present, frequency(limit, digits, Rounding::down)}};
    }

    Message moreFeed() const {
        const std::optional<FeedState> state = m_estimate.state();
        if (!state || state == FeedState::notApplicable) return {};
        const ThrustNeed& largest = m_estimate.largest();
        const double ofThisBlow = m_estimate.need(ThrustCase::scenario).thrust;
        switch (*state) {
            case FeedState::pushedBack:
            case FeedState::belowRequired:
                return m_estimate.isOfAllGaps()
                           ? Message(translatable("Raise the feed force by %1 to have enough for this blow, "
                                                  "by %2 for every gap between bit and rock."),
                                     {more(ofThisBlow), more(largest.thrust)})
                           : Message(translatable("Raise the feed force by %1 to have enough for this blow, "
                                                  "by %2 for rigid rock."),
                                     {more(ofThisBlow), more(largest.thrust)});
            case FeedState::requiredAtThisGap:
                return {
                    m_estimate.isOfAllGaps()
                        ? translatable(
                              "Raise the feed force by %1 to have enough for every gap between bit and rock.")
                        : translatable("Raise the feed force by %1 to have enough for rigid rock."),
                    {more(largest.thrust)}};
            case FeedState::requiredMet:
                return {translatable("A feed force of at least %1 would even return an undamped rod to the "
                                     "rock before each next blow."),
                        {least(largest.thrustUndamped)}};
            case FeedState::returnMet:
                return translatable("No larger feed force is required.");
            case FeedState::notApplicable:
                break;
        }
        return {};
    }

  private:
    /// The force to add to the installed one.
    std::string more(double needed) const {
        return force(needed - m_estimate.force->effective(), fewestDigits, Rounding::up);
    }
    std::string force(double newton, int digits, Rounding rounding = Rounding::nearest) const {
        return m_style.quantity(newton, Quantity::force, digits, rounding);
    }
    std::string frequency(double hertz, int digits, Rounding rounding = Rounding::nearest) const {
        return m_style.quantity(hertz, Quantity::frequency, digits, rounding);
    }

    int digitsFor(double needed) const { return digitsApart(m_estimate.force->effective(), needed); }

    /// The thrust, and what presses with the weight along the hole.
    Message installed(double needed) const {
        const FeedForce& feed = *m_estimate.force;
        const int digits = std::max(usualDigits, digitsFor(needed));
        const std::string thrust = force(feed.thrust, digits);
        if (!feed.weight) return thrust;
        return {translatable("%1 (%2 with the weight along the hole)"),
                {thrust, force(feed.effective(), digits)}};
    }

    std::string required(double needed) const {
        return force(needed, std::max(usualDigits, digitsFor(needed)));
    }

    /// The thrust to install in addition to the weight.
    std::string least(double needed) const {
        const double thrust = m_estimate.thrustFor(needed);
        const int digits = m_estimate.force ? digitsApart(m_estimate.force->thrust, thrust) : fewestDigits;
        return force(thrust, digits, Rounding::up);
    }

    Message thisGapOnly(double ofThisBlow, double largest) const {
        const bool isByGap = m_estimate.largestCase() != ThrustCase::rigidRock;
        return {
            isByGap ? translatable("A feed force of %1 is enough for this blow (%2 required), but not for "
                                   "every gap between bit and rock (up to %3 required).")
            : m_estimate.isOfAllGaps()
                ? translatable("A feed force of %1 is enough for this blow (%2 required), but not for rigid "
                               "rock (%3 required).")
                : translatable("A feed force of %1 is enough for this blow (%2 required), but not for rigid "
                               "rock (%3 required). Other gaps between bit and rock were not examined."),
            {installed(largest), required(ofThisBlow), required(largest)}};
    }

    Message wanted() const {
        const double needed = m_estimate.need(ThrustCase::scenario).thrust;
        const double largest = m_estimate.largest().thrust;
        const std::string present = frequency(m_estimate.frequency, usualDigits);
        if (m_estimate.thrustFor(largest) == 0)
            return {
                translatable("No feed force is given. At a blow frequency of %1, the weight of machine and "
                             "rod along the hole is already enough for this blow and for rigid rock."),
                {present}};
        if (largest <= needed)
            return {translatable(
                        "No feed force is given. At a blow frequency of %2, this blow requires at least %1."),
                    {least(needed), present}};
        return {m_estimate.isOfAllGaps()
                    ? translatable("No feed force is given. At a blow frequency of %2, this blow requires at "
                                   "least %1, and blows at other gaps or on rigid rock up to %3.")
                    : translatable("No feed force is given. At a blow frequency of %2, this blow requires at "
                                   "least %1, and rigid rock at least %3."),
                {least(needed), present, least(largest)}};
    }

    const FeedEstimate& m_estimate;
    const ReadingStyle& m_style;
};

}  // namespace

std::string_view feedWord(FeedState state) {
    static constexpr EnumNames<FeedState> words{{{FeedState::pushedBack, "machine pushed back"},
                                                 {FeedState::belowRequired, "not enough"},
                                                 {FeedState::requiredAtThisGap, "enough for this blow only"},
                                                 {FeedState::requiredMet, "enough in all cases"},
                                                 {FeedState::returnMet, "returns the rod in time"},
                                                 {FeedState::notApplicable, "no estimate"}}};
    return words[state];
}

Message requiredFeedMessage(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                            const ReadingStyle& style) {
    if (estimate) return EstimateMessage(*estimate, style).message();
    if (!hasUnits(scenario))
        return translatable(
            "The feed cannot be judged: the scenario has only dimensionless groups. Enter the scenario in "
            "physical units.");
    return scenario.drill.thrust
               ? translatable("The feed cannot be judged: give a blow frequency.")
               : translatable("The feed cannot be judged: give a blow frequency and a feed force.");
}

std::vector<Message> estimateSentences(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                                       const ReadingStyle& style) {
    std::vector<Message> sentences{requiredFeedMessage(scenario, estimate, style)};
    if (estimate)
        sentences.push_back(
            {translatable(
                 "The required feed force is estimated from single blows; %1 solves consecutive blows."),
             {drillingWords(style)}});
    return sentences;
}

std::string estimateText(const Scenario& scenario, const std::optional<FeedEstimate>& estimate,
                         const ReadingStyle& style) {
    return inOneParagraph(estimateSentences(scenario, estimate, style), style);
}

Message feedRemedy(const FeedEstimate& estimate, const ReadingStyle& style) {
    return EstimateMessage(estimate, style).remedy();
}

Message moreFeedMessage(const FeedEstimate& estimate, const ReadingStyle& style) {
    return EstimateMessage(estimate, style).moreFeed();
}

Message drillingWords(const ReadingStyle& style) {
    return style.isPrinted() ? Message(translatable("the page \"Drilling\""))
                             : Message(translatable("`drill`"));
}

std::string feedForceText(const FeedForce& feed, const ReadingStyle& style) {
    const auto force = [&](double newton) { return style.quantity(newton, Quantity::force, 4); };
    if (!feed.weight) return style.said({translatable("installed feed force %1"), {force(feed.thrust)}});
    return style.said(
        {*feed.weight < 0
             ? translatable("effective feed force %1 (installed %2, less %3 of weight along the hole)")
             : translatable("effective feed force %1 (installed %2, and %3 of weight along the hole)"),
         {force(feed.effective()), force(feed.thrust), force(std::abs(*feed.weight))}});
}

const char* labelOf(ThrustCase which) {
    switch (which) {
        case ThrustCase::scenario:
            return translatable("this blow");
        case ThrustCase::gapQuantile:
            return translatable("95 % of all gaps");
        case ThrustCase::rigidRock:
            return translatable("rigid rock");
        case ThrustCase::elasticWorst:
            return translatable("fully elastic rock (gamma = 1), worst gap");
    }
    return "";
}

}  // namespace drillwave
