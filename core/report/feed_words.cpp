// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/feed_words.h"

#include <algorithm>
#include <cmath>

#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr int fewestDigits = 3, usualDigits = 4;

/// As many as tell what is from what would be enough.
int digitsApart(double present, double bound) {
    constexpr int most = 9;  // well above the noise of rounding
    const double apart = std::abs(present / bound - 1);
    if (!(apart > 0) || !std::isfinite(apart)) return apart == 0 ? most : fewestDigits;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(apart))) + 1, fewestDigits, most);
}

/// Where the largest need is from, behind "enough" or "at least".
const char* placeOf(const WidestNeed& widest) {
    if (widest.ofAllGaps) return translatable("drillwave::Message", "at every gap");
    return widest.which == ThrustCase::rigidRock
               ? translatable("drillwave::Message", "on rigid rock")
               : translatable("drillwave::Message", "for this blow and on rigid rock");
}

/// The same where it is not met: which gap in which rock.
const char* exactPlaceOf(const WidestNeed& widest) {
    switch (widest.which) {
        case ThrustCase::scenario:
            return translatable("drillwave::Message", "in this blow");
        case ThrustCase::gapQuantile:
            return translatable("drillwave::Message", "at 95 % of all gaps");
        case ThrustCase::rigidRock:
            return translatable("drillwave::Message", "on rigid rock");
        case ThrustCase::elasticWorst:
            break;
    }
    return translatable("drillwave::Message", "at the worst gap on elastic rock");
}

/// The sentence of one decision, in the numbers of one reader.
class DecisionMessage {
  public:
    DecisionMessage(const FeedDecision& decision, const ReadingStyle& style)
        : m_decision(decision), m_style(style) {}

    Message message() const {
        using Kind = FeedDecision::Kind;
        const std::optional<WidestNeed>& widest = m_decision.widest;
        switch (m_decision.kind) {
            case Kind::noUnits:
                return translatable("drillwave::Message",
                                    "The feed is not judged: the scenario is given by its dimensionless "
                                    "groups, not in physical units.");
            case Kind::noFrequency:
                return m_decision.force
                           ? translatable("drillwave::Message",
                                          "The feed is not judged: no blow frequency is given.")
                           : translatable(
                                 "drillwave::Message",
                                 "The feed is not judged: neither blow frequency nor thrust is given.");
            case Kind::noThrust:
                return wanted();
            case Kind::enough:
                return {widest->ofAllGaps ? translatable("drillwave::Message", "%1 is enough at every gap%2.")
                                          : translatable("drillwave::Message",
                                                         "%1 is enough for this blow and on rigid rock%2."),
                        {installed(widest->thrust), upTo(widest->thrust)}};
            case Kind::enoughThisBlow:
                if (!widest)
                    return {translatable("drillwave::Message",
                                         "%1 is enough for this blow%2; other gaps were not looked at."),
                            {installed(m_decision.need), upTo(m_decision.need)}};
                return {translatable("drillwave::Message",
                                     "%1 is enough for this blow%2, but not %3: that takes %4."),
                        {installed(widest->thrust), upTo(m_decision.need), exactPlaceOf(*widest),
                         remedy(widest->thrust)}};
            case Kind::notEnough:
                return {translatable("drillwave::Message", "%1 is not enough: %2%3."),
                        {installed(m_decision.need), remedy(m_decision.need), wider()}};
        }
        return {};
    }

  private:
    std::string force(double newton, int digits, Rounding rounding = Rounding::nearest) const {
        return m_style.quantity(newton, Quantity::force, digits, rounding);
    }
    std::string frequency(double hertz, int digits, Rounding rounding = Rounding::nearest) const {
        return m_style.quantity(hertz, Quantity::frequency, digits, rounding);
    }

    /// The thrust, and what presses with the weight along the hole.
    Message installed(double needed) const {
        const FeedForce& feed = *m_decision.force;
        const int digits = std::max(usualDigits, digitsApart(feed.effective(), needed));
        const std::string thrust = force(feed.thrust, digits);
        if (!feed.weight) return thrust;
        return {translatable("drillwave::Message", "%1 (%2 with the weight along the hole)"),
                {thrust, force(feed.effective(), digits)}};
    }

    Message upTo(double needed) const {
        const double limit = m_decision.frequencyFor(needed);
        if (!(limit > 0)) return {};
        return {translatable("drillwave::Message", " up to %1"),
                {frequency(limit, digitsApart(m_decision.frequency, limit), Rounding::down)}};
    }

    Message least(double needed) const {
        const double thrust = m_decision.thrustFor(needed);
        const int digits = m_decision.force ? digitsApart(m_decision.force->thrust, thrust) : fewestDigits;
        return {translatable("drillwave::Message", "at least %1"), {force(thrust, digits, Rounding::up)}};
    }

    Message remedy(double needed) const {
        const double limit = m_decision.frequencyFor(needed);
        const int digits = digitsApart(m_decision.frequency, limit);
        const std::string present = frequency(m_decision.frequency, std::max(usualDigits, digits));
        if (!(limit > 0)) return {translatable("drillwave::Message", "%1 at %2"), {least(needed), present}};
        return {translatable("drillwave::Message", "%1 at %2, or at most %3"),
                {least(needed), present, frequency(limit, digits, Rounding::down)}};
    }

    /// What would be enough for more than this blow.
    Message wider() const {
        if (!m_decision.hasWiderNeed()) return {};
        return {"; %1 %2", {placeOf(*m_decision.widest), least(m_decision.widest->thrust)}};
    }

    Message wanted() const {
        const std::string present = frequency(m_decision.frequency, usualDigits);
        if (m_decision.thrustFor(m_decision.need) == 0)
            return {
                translatable(
                    "drillwave::Message",
                    "No thrust is given: the weight along the hole alone is enough for this blow at %1%2."),
                {present, wider()}};
        return {translatable("drillwave::Message", "No thrust is given: this blow needs %1 at %2%3."),
                {least(m_decision.need), present, wider()}};
    }

    const FeedDecision& m_decision;
    const ReadingStyle& m_style;
};

/// Where the bit is in the motion that nothing damps, behind what is told without numbers.
Message motionMessage(Feed feed, const GapAtBlow& found, const ReadingStyle& style) {
    if (found.motion.kind != UndampedMotion::Kind::bouncing) return {};
    if (!found.motion.stable)
        return translatable("drillwave::Message",
                            " If nothing damps the rebound, the bit bounces without ever becoming steady, "
                            "because e is not below 1.");
    return {feed == Feed::backInTime
                ? translatable("drillwave::Message", " It is then %1 off the rock when the hammer strikes.")
                : translatable(
                      "drillwave::Message",
                      " If nothing damps the rebound, the bit is %1 off the rock when the hammer strikes."),
            {style.quantity(found.gap, Quantity::length, 3)}};
}

}  // namespace

std::string_view feedWord(Feed feed) {
    static constexpr EnumNames<Feed> words{{{Feed::unknown, ""},
                                            {Feed::pushedBack, "machine pushed back"},
                                            {Feed::penetrationLost, "penetration lost"},
                                            {Feed::fullRate, "enough, bit bounces"},
                                            {Feed::backInTime, "enough, bit may bounce"},
                                            {Feed::resting, "enough, bit stays on rock"}}};
    return words[feed];
}

Message feedDecisionMessage(const FeedDecision& decision, const ReadingStyle& style) {
    return DecisionMessage(decision, style).message();
}

std::string feedDecisionText(const FeedDecision& decision, const ReadingStyle& style) {
    return style.said(feedDecisionMessage(decision, style));
}

const char* feedAdvice(Feed feed) {
    switch (feed) {
        case Feed::unknown:
            return translatable("drillwave::Message", "Give the installed thrust to have it judged.");
        case Feed::pushedBack:
            return translatable(
                "drillwave::Message",
                "The blows push the machine back from the rock. Raise the feed, or lower the percussion.");
        case Feed::penetrationLost:
            return translatable("drillwave::Message",
                                "Penetration is lost: the bit bounces off the bottom between blows, many "
                                "meet a bit that is not on the rock, and the string runs loose. Joints "
                                "rattle, run hot and wear. Raise the feed, or lower the percussion.");
        case Feed::fullRate:
            return translatable("drillwave::Message",
                                "It drills at full rate, but the bit leaves the rock between blows and the "
                                "joints are hammered, unless the machine damps the rebound well.");
        case Feed::backInTime:
            return translatable(
                "drillwave::Message",
                "It drills at full rate, and a bit that rests on the rock when the hammer strikes is back "
                "before the next blow; a bit that bounces goes on bouncing if nothing damps the rebound.");
        case Feed::resting:
            return translatable("drillwave::Message",
                                "It drills at full rate, and the bit rests on the rock before every blow "
                                "even if nothing damps the rebound.");
    }
    return "";
}

Message feedMeaning(Feed feed, const std::optional<GapAtBlow>& found, const ReadingStyle& style) {
    const Message motion = found ? motionMessage(feed, *found, style) : Message();
    Message outside;
    if (feed == Feed::backInTime || feed == Feed::resting)
        outside = {translatable("drillwave::Message",
                                " Waves that the blow before has left are not in this; %1 follows them. "
                                "Whether it is too much (friction, buckling, stalling of the rotation) is "
                                "outside the model."),
                   {drillingWords(style)}};
    return {"%1%2%3", {feedAdvice(feed), motion, outside}};
}

Message drillingWords(const ReadingStyle& style) {
    return style.isPrinted() ? Message(translatable("drillwave::Message", "the page \"Drilling\""))
                             : Message(translatable("drillwave::Message", "`drill`"));
}

std::string feedForceText(const FeedForce& feed, const ReadingStyle& style) {
    const auto force = [&](double newton) { return style.quantity(newton, Quantity::force, 4); };
    if (!feed.weight)
        return style.said(
            {translatable("drillwave::Message", "installed thrust of %1"), {force(feed.thrust)}});
    return style.said(
        {*feed.weight < 0
             ? translatable("drillwave::Message",
                            "effective force of %1 (thrust %2, less %3 of weight along the hole)")
             : translatable("drillwave::Message",
                            "effective force of %1 (thrust %2, and %3 of weight along the hole)"),
         {force(feed.effective()), force(feed.thrust), force(std::abs(*feed.weight))}});
}

}  // namespace drillwave
