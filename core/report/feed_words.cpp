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
std::string_view placeOf(const WidestNeed& widest) {
    if (widest.ofAllGaps) return "at every gap";
    return widest.which == ThrustCase::rigidRock ? "on rigid rock" : "for this blow and on rigid rock";
}

/// The same where it is not met: which gap in which rock.
std::string_view exactPlaceOf(const WidestNeed& widest) {
    switch (widest.which) {
        case ThrustCase::scenario:
            return "in this blow";
        case ThrustCase::gapQuantile:
            return "at 95 % of all gaps";
        case ThrustCase::rigidRock:
            return "on rigid rock";
        case ThrustCase::elasticWorst:
            break;
    }
    return "at the worst gap on elastic rock";
}

/// The sentence of one decision, in the numbers of one reader.
class DecisionText {
  public:
    DecisionText(const FeedDecision& decision, const ReadingStyle& style)
        : m_decision(decision), m_style(style) {}

    std::string text() const {
        using Kind = FeedDecision::Kind;
        const std::optional<WidestNeed>& widest = m_decision.widest;
        switch (m_decision.kind) {
            case Kind::noUnits:
                return "The feed is not judged: the scenario is given by its dimensionless groups, not in "
                       "physical units.";
            case Kind::noFrequency:
                return m_decision.force
                           ? "The feed is not judged: no blow frequency is given."
                           : "The feed is not judged: neither blow frequency nor thrust is given.";
            case Kind::noThrust:
                return "No thrust is given: " + wanted() + ".";
            case Kind::enough:
                return installed(widest->thrust) + " is enough " +
                       (widest->ofAllGaps ? "at every gap" : "for this blow and on rigid rock") +
                       upTo(widest->thrust) + ".";
            case Kind::enoughThisBlow:
                return installed(widest ? widest->thrust : m_decision.need) + " is enough for this blow" +
                       upTo(m_decision.need) +
                       (widest ? ", but not " + std::string(exactPlaceOf(*widest)) + ": that takes " +
                                     remedy(widest->thrust)
                               : "; other gaps were not looked at") +
                       ".";
            case Kind::notEnough:
                return installed(m_decision.need) + " is not enough: " + remedy(m_decision.need) + wider() +
                       ".";
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
    std::string installed(double needed) const {
        const FeedForce& feed = *m_decision.force;
        const int digits = std::max(usualDigits, digitsApart(feed.effective(), needed));
        const std::string text = force(feed.thrust, digits);
        if (!feed.weight) return text;
        return text + " (" + force(feed.effective(), digits) + " with the weight along the hole)";
    }

    std::string upTo(double needed) const {
        const double limit = m_decision.frequencyFor(needed);
        if (!(limit > 0)) return {};
        return " up to " + frequency(limit, digitsApart(m_decision.frequency, limit), Rounding::down);
    }

    std::string least(double needed) const {
        const double thrust = m_decision.thrustFor(needed);
        const int digits = m_decision.force ? digitsApart(m_decision.force->thrust, thrust) : fewestDigits;
        return "at least " + force(thrust, digits, Rounding::up);
    }

    std::string remedy(double needed) const {
        const double limit = m_decision.frequencyFor(needed);
        const int digits = digitsApart(m_decision.frequency, limit);
        std::string text =
            least(needed) + " at " + frequency(m_decision.frequency, std::max(usualDigits, digits));
        if (limit > 0) text += ", or at most " + frequency(limit, digits, Rounding::down);
        return text;
    }

    /// What would be enough for more than this blow.
    std::string wider() const {
        if (!m_decision.hasWiderNeed()) return {};
        return "; " + std::string(placeOf(*m_decision.widest)) + " " + least(m_decision.widest->thrust);
    }

    std::string wanted() const {
        const std::string at = " at " + frequency(m_decision.frequency, usualDigits);
        if (m_decision.thrustFor(m_decision.need) == 0)
            return "the weight along the hole alone is enough for this blow" + at + wider();
        return "this blow needs " + least(m_decision.need) + at + wider();
    }

    const FeedDecision& m_decision;
    const ReadingStyle& m_style;
};

constexpr std::string_view outsideTheModel =
    " Waves that the blow before has left are not in this; `drill` follows them. Whether it is too much "
    "(friction, buckling, stalling of the rotation) is outside the model.";

/// Where the bit is in the motion that nothing damps, behind what is told without numbers.
std::string motionText(Feed feed, const GapAtBlow& found, const ReadingStyle& style) {
    if (found.motion.kind != UndampedMotion::Kind::bouncing) return {};
    const std::string begin =
        feed == Feed::backInTime ? " It is then " : " If nothing damps the rebound, the bit is ";
    if (!found.motion.stable)
        return " If nothing damps the rebound, the bit bounces without ever becoming steady, because e is "
               "not "
               "below 1.";
    return begin + style.quantity(found.gap, Quantity::length, 3) + " off the rock when the hammer strikes.";
}

}  // namespace

std::string_view feedWord(Feed feed) {
    static constexpr EnumNames<Feed> words{{{Feed::unknown, ""},
                                            {Feed::pushedBack, "machine pushed back"},
                                            {Feed::penetrationLost, "penetration lost"},
                                            {Feed::fullRate, "enough, bounces"},
                                            {Feed::backInTime, "enough, may bounce"},
                                            {Feed::resting, "enough, rests"}}};
    return words[feed];
}

std::string feedDecisionText(const FeedDecision& decision, const ReadingStyle& style) {
    return DecisionText(decision, style).text();
}

std::string_view feedAdvice(Feed feed) {
    switch (feed) {
        case Feed::unknown:
            return "Give the installed thrust to have it judged.";
        case Feed::pushedBack:
            return "The blows push the machine back from the rock. Raise the feed, or lower the percussion.";
        case Feed::penetrationLost:
            return "Penetration is lost: the bit bounces off the bottom between blows, many meet a bit that "
                   "is not on the rock, and the string runs loose. Joints rattle, run hot and wear. Raise "
                   "the "
                   "feed, or lower the percussion.";
        case Feed::fullRate:
            return "It drills at full rate, but the bit leaves the rock between blows and the joints are "
                   "hammered, unless the machine damps the rebound well.";
        case Feed::backInTime:
            return "It drills at full rate, and a bit that rests on the rock when the hammer strikes is back "
                   "before the next blow; a bit that bounces goes on bouncing if nothing damps the rebound.";
        case Feed::resting:
            return "It drills at full rate, and the bit rests on the rock before every blow even if nothing "
                   "damps the rebound.";
    }
    return {};
}

std::string feedMeaning(Feed feed, const std::optional<GapAtBlow>& found, const ReadingStyle& style) {
    std::string text(feedAdvice(feed));
    if (found) text += motionText(feed, *found, style);
    if (feed == Feed::backInTime || feed == Feed::resting) text += outsideTheModel;
    return text;
}

std::string feedForceText(const FeedForce& feed, const ReadingStyle& style) {
    const auto force = [&](double newton) { return style.quantity(newton, Quantity::force, 4); };
    if (!feed.weight) return "installed thrust of " + force(feed.thrust);
    return "effective force of " + force(feed.effective()) + " (thrust " + force(feed.thrust) +
           (*feed.weight < 0 ? ", less " : ", and ") + force(std::abs(*feed.weight)) +
           " of weight along the hole)";
}

}  // namespace drillwave
