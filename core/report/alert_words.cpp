// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/alert_words.h"

#include <cmath>
#include <utility>

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/report/feed_words.h"
#include "core/report/parameter_words.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

std::string fourDigits(const Alert& alert, std::string_view name, const ReadingStyle& style) {
    return style.number(alert.argument(name).value, 4);
}

std::string whole(const Alert& alert, std::string_view name) {
    return std::to_string(static_cast<long>(alert.argument(name).value));
}

std::string bound(const Alert& alert, std::string_view name, const ReadingStyle& style) {
    return style.bound(alert.argument(name).value);
}

std::string inUnit(const Alert& alert, std::string_view name, const ReadingStyle& style) {
    const AlertArgument& argument = alert.argument(name);
    return style.quantity(argument.value, argument.quantity, 4);
}

Message implausible(const Alert& alert, const ReadingStyle& style) {
    const KeptParameter named = findParameter(alert.parameter);
    const bool isByRatio = alert.argument("value").quantity != named->quantity;
    const KeptParameter parameter = isByRatio ? inScales(*named) : named;
    const auto end = [&](double value) { return style.quantity(value, parameter->quantity, 4); };
    return {translatable("The input %1 = %2 is outside its typical range, %3 to %4."),
            {parameter->address        ? labelMessage(*parameter, alert.subject)
             : alert.subject.isEmpty() ? titleMessage(*parameter, parameter->symbol)
                                       : alert.subject,
             inUnit(alert, "value", style), end(parameter->plausible.low), end(parameter->plausible.high)}};
}

Message longPulse(const Alert& alert, const ReadingStyle& style) {
    const double percent =
        static_cast<double>(static_cast<int>(alert.argument("late_impulse").value * 1000)) / 10;
    return {translatable("When the first reflection returns to the hammer, %1 % of the impulse of the blow "
                         "is still to come. A real hammer would feel the reflection, but here the hammer "
                         "force is prescribed. To include this effect, use a drill string with a hammer."),
            {style.number(percent, 4)}};
}

Message defaultHammer(const Alert& alert, const ReadingStyle& style) {
    if (alert.arguments.empty())
        return translatable(
            "No hammer data are given. The hammer is assumed to have the impedance of the rod and to give a "
            "rectangular blow. Enter the data of the piston.");
    Message values;
    for (const AlertArgument& argument : alert.arguments) {
        const KeptParameter parameter = findParameter(argument.name);
        const std::string value =
            style.keepsUnitsOfFile()
                ? formatQuantity(argument.value, argument.quantity, parameter->displayUnit())
                : style.quantity(argument.value, argument.quantity, 4);
        values = joined(std::move(values), "%1, %2", {"%1 %2", {labelMessage(*parameter), value}});
    }
    return {translatable("The hammer is the default one (%1, the material of the rod). Give the data of the "
                         "rock drill's piston."),
            {values}};
}

Message pistonImpedance(const Alert& alert) {
    return alert.argument("ratio").value < 1
               ? translatable(
                     "The impedance of the hammer is below that of the rod. The hammer therefore bounces "
                     "back after one force step, and the rod receives more than the momentum of the hammer.")
               : translatable(
                     "The impedance of the hammer is above that of the rod: the force falls in ever smaller "
                     "steps. Reflections that return to the hammer are neglected here.");
}

/// The numbers of the estimate that the words take.
FeedEstimate estimateOf(const Alert& alert) {
    FeedEstimate feed;
    feed.force = FeedForce{alert.argument("installed").value, {}};
    if (alert.has("weight")) feed.weight = *(feed.force->weight = alert.argument("weight").value);
    feed.frequency = alert.argument("frequency").value;
    feed.balance = alert.argument("balance").value;
    feed.roundTrips = 1;  // the estimate applies, or there would be no alert
    for (ThrustNeed& need : feed.needs) need.thrust = alert.argument("required").value;
    return feed;
}

Message thrustBelowNeeded(const Alert& alert, const ReadingStyle& style) {
    const FeedEstimate feed = estimateOf(alert);
    return {"%1 %2 %3", {requiredFeedMessage({}, feed, style), feedRemedy(feed, style), feedLimitsOfModel}};
}

/// How the waves of a blow meet the next one.
Message dampingOfWaves(const Alert& alert, const ReadingStyle& style) {
    if (alert.has("losses_of_string")) return translatable("damped only by the losses of the string");
    if (!alert.has("wave_loss")) return translatable("undamped");
    const double loss = alert.argument("wave_loss").value;
    const double left = std::pow(1 - loss, alert.argument("round_trips").value);
    return {translatable("%1 % of the wave is left, with a loss of %2 % per round trip"),
            {style.number(100 * left, 2), style.number(100 * loss, 3)}};
}

Message residualWaves(const Alert& alert, const ReadingStyle& style) {
    const std::string roundTrips = fourDigits(alert, "round_trips", style);
    if (!alert.has("whole"))
        return {
            translatable("The waves of a blow make only %1 round trips in the string before the next blow, "
                         "and they still act on that blow (%3). This may change the penetration by up to 10 "
                         "%, depending on blow frequency and string length; to compute it, use %2."),
            {roundTrips, drillingWords(style), dampingOfWaves(alert, style)}};
    return {
        translatable(
            "The waves of a blow make only %1 round trips in the string before the next blow, and they still "
            "act on that blow (%4). Because %1 is close to the whole number %2, they arrive at the same time "
            "as the next blow. This may change the penetration by up to 10 %; to compute it, use %3."),
        {roundTrips, whole(alert, "whole"), drillingWords(style), dampingOfWaves(alert, style)}};
}

Message lengthsRounded(const Alert& alert, const ReadingStyle& style) {
    const bool isShared = alert.has("shared_cell");
    const Message cell =
        isShared
            ? Message(translatable("only share a time step of %1, which takes more work than is permitted"),
                      {inUnit(alert, "shared_cell", style)})
            : Message(translatable("share no time step"));
    // what elastic rock keeps is 0 by law; its force and the rebound are what rounding moves
    const Message off =
        alert.has("cor_error")
            ? Message(translatable("force on the rock and rebound have errors: e by up to %1"),
                      {bound(alert, "cor_error", style)})
            : Message(translatable("the efficiency may have an error of %1"),
                      {bound(alert, "efficiency_error", style)});
    return {translatable("The transit times of the sections %1: they were rounded by up to %2, and %3. %4"),
            {cell, inUnit(alert, "time", style), off,
             isShared ? translatable("Round the section lengths to multiples of a common length, such as 50 "
                                     "mm. A longer time step then fits all sections exactly.")
                      : translatable("Enter all lengths in whole millimetres, with the same steel in all "
                                     "sections: the time step is then exact.")}};
}

/// Why the closed form is not for the blow: the group to blame says it.
Message closedFormObstacle(const Alert& alert, const ReadingStyle& style) {
    if (alert.parameter == "tau")
        return {translatable("the blow is longer than a round trip in the rod (tau = %1 < 0.5)"),
                {fourDigits(alert, "tau", style)}};
    if (alert.parameter == "delta")
        return {
            translatable("the bit meets the rock in the middle of a wave (delta = %1 is not a whole number)"),
            {fourDigits(alert, "delta", style)}};
    if (alert.parameter == "bit_rock.law")
        return translatable("the loading curve of the rock is not a straight line");
    return translatable("the bit is still on the rock when the next reflection arrives");
}

Message closedFormInvalid(const Alert& alert, const ReadingStyle& style) {
    return {translatable("The closed-form solution for elastic rock does not apply, because %1. Its "
                         "coefficient of restitution, e = %2, has an error of %3."),
            {closedFormObstacle(alert, style), fourDigits(alert, "closed_form_cor", style),
             fourDigits(alert, "difference", style)}};
}

Message inputDecides(const Alert& alert, const ReadingStyle& style) {
    return {translatable("The bit chatters on the rock (%1 contacts). Tiny changes of the input then change "
                         "the coefficient of restitution e, which can be known only to within %2. A longer "
                         "rod, a shorter blow or a softer rock reduces the chatter."),
            {whole(alert, "contacts"), bound(alert, "cor_error", style)}};
}

/// The sentences of a stress above a strength: in a section of a string, and in a rod during and after the
/// blow.
struct OverloadWords {
    const char* ofSection;
    const char* duringBlow;
    const char* afterBlow;
};
constexpr OverloadWords yieldWords{
    translatable(
        "%1 would yield: the stress in this section reaches %2, at %3 from its rear end and %4 after "
        "the start of the blow. Its yield strength is %5."),
    translatable(
        "The rod would yield: during the blow the stress reaches %1, at %2 from the hammer and %3 after "
        "the start of the blow. Its yield strength is %4."),
    translatable(
        "After the blow, residual waves would make the rod yield; the waves are not damped here. The stress "
        "reaches %1, at %2 from the hammer and %3 after the start of the blow. The yield strength is %4.")};
constexpr OverloadWords fatigueWords{
    translatable("Every blow loads %1 above its fatigue strength of %5. The stress reaches %2, at %3 from "
                 "the rear end of this section and %4 after the start of the blow."),
    translatable("Every blow loads the rod above its fatigue strength of %4. During the blow, the stress "
                 "reaches %1, at %2 from the hammer and %3 after the start of the blow."),
    translatable(
        "Every blow loads the rod above its fatigue strength of %4, by residual waves that are not damped "
        "here. The stress reaches %1, at %2 from the hammer and %3 after the start of the blow.")};

Message overload(const Alert& alert, const OverloadWords& words, const ReadingStyle& style) {
    const bool isCompression = alert.has("compression");
    std::vector<Message> values{
        {isCompression ? translatable("%1 in compression") : translatable("%1 in tension"),
         {inUnit(alert, isCompression ? "compression" : "tension", style)}},
        inUnit(alert, "place", style),
        inUnit(alert, "time", style),
        inUnit(alert, "strength", style)};
    const bool isOfSection = alert.has("section");
    if (isOfSection) values.insert(values.begin(), alert.subject);
    const bool isAfter = alert.level == AlertLevel::information;
    return {isOfSection ? words.ofSection : isAfter ? words.afterBlow : words.duringBlow, std::move(values)};
}

}  // namespace

Message alertMessage(const Alert& alert, const ReadingStyle& style) {
    switch (alert.code) {
        case AlertCode::implausibleValue:
            return implausible(alert, style);
        case AlertCode::longPulse:
            return longPulse(alert, style);
        case AlertCode::defaultHammer:
            return defaultHammer(alert, style);
        case AlertCode::pistonImpedance:
            return pistonImpedance(alert);
        case AlertCode::gapWithoutEffect:
            return translatable(
                "The rod moves as a rigid body until it meets the rock. The gap between bit and rock "
                "therefore only shifts the time of contact and has no other effect.");
        case AlertCode::thrustBelowNeeded:
            return thrustBelowNeeded(alert, style);
        case AlertCode::superRebound:
            return {translatable("The rod rebounds with more momentum than it had before impact (e = %1). An "
                                 "estimate for rigid rock (e = 1) gives too small a feed force."),
                    {fourDigits(alert, "cor", style)}};
        case AlertCode::severalContacts:
            return {translatable("The bit hits the rock %1 times in this blow: reflected waves push it "
                                 "against the rock again."),
                    {whole(alert, "contacts")}};
        case AlertCode::closedFormInvalid:
            return closedFormInvalid(alert, style);
        case AlertCode::inputDecides:
            return inputDecides(alert, style);
        case AlertCode::reducedAccuracy:
            return {translatable(
                        "The numerical error of the coefficient of restitution e may be as large as %1."),
                    {bound(alert, "cor_error", style)}};
        case AlertCode::stressAboveYield:
            return overload(alert, yieldWords, style);
        case AlertCode::stressAboveFatigue:
            return overload(alert, fatigueWords, style);
        case AlertCode::residualWaves:
            return residualWaves(alert, style);
        case AlertCode::lengthsRounded:
            return lengthsRounded(alert, style);
        case AlertCode::wavesThinned:
            return {translatable("This blow has too many waves to store them all. Plots of waves and forces "
                                 "therefore show a coarser model of the string. Its coefficient of "
                                 "restitution and efficiency differ by at most %1."),
                    {bound(alert, "difference", style)}};
        case AlertCode::blowNotOver:
            return {
                alert.has("forced")
                    ? translatable("This blow is not over after %1, when the next blow starts: the bit may "
                                   "hit the rock again. The values are for that moment and not final.")
                    : translatable(
                          "This blow is not over after %1, when the next blow starts: bit and rock, or "
                          "hammer and string, may meet again. The values are for that moment and not final."),
                {inUnit(alert, "time", style)}};
        case AlertCode::stressesLeftOut:
            return translatable(
                "The largest stresses of the sections were not computed, because this would exceed the limit "
                "of computing work. No strength was checked. Try a shorter end time (end_time).");
        case AlertCode::cornersWithoutEffect:
            return {translatable(
                        "The force on the rock reaches only %1, below the first corner of the loading curve "
                        "at %2. The rock therefore acts as if its loading curve were one straight line."),
                    {inUnit(alert, "peak_force", style), inUnit(alert, "corner_force", style)}};
        case AlertCode::pushedBack:
            return {
                translatable(
                    "The feed force of %1 is below the mean force of the blows, %2, or too close to it. The "
                    "gap between bit and rock therefore grows from blow to blow. Increase the feed force."),
                {inUnit(alert, "force", style), inUnit(alert, "needed", style)}};
        case AlertCode::noWaveLoss:
            return translatable(
                "Nothing damps the waves, so their fronts never decay. Give a wave loss; 1 to 30 % per round "
                "trip is usual.");
        case AlertCode::restrikeInTheWay:
            return {translatable(
                        "After the piston has separated, the rebounding string hits it again, and the piston "
                        "passes up to %1 % of its momentum to the string. If the machine has drawn the "
                        "piston back by then, switch off “may strike again” (restrike: false in the file)."),
                    {style.number(100 * alert.argument("share").value, 3)}};
        case AlertCode::shankOff:
            return {
                translatable("At impact, the shank is up to %1 from its mean position in the machine. A real "
                             "machine would then have another stroke and blow energy than assumed. If the "
                             "damper has no spring, add one: a dashpot alone lets the shank drift."),
                {inUnit(alert, "offset", style)}};
        case AlertCode::frequencyRounded:
            return {
                translatable("The blow frequency is rounded to %1, so that each blow falls on a time step."),
                {inUnit(alert, "used", style)}};
        case AlertCode::notSettled:
            return translatable(
                "The motion may not be steady yet: means of the first and second half of the blows differ by "
                "more than three times their error. Increase the number of blows, or of transient blows.");
        case AlertCode::coexistingMotions:
            return translatable(
                "Two steady motions are possible. The start or the time step decides which one is computed; "
                "a real drill may settle into either.");
        case AlertCode::irregularMotion:
            return translatable(
                "The motion does not repeat from blow to blow: use the means, not the values of single "
                "blows.");
        case AlertCode::energyUnbalanced:
            return {translatable("The energy balance of all blows has an error of %1 %. The time step is too "
                                 "long for the short contacts between bit and rock. A shorter time step "
                                 "reduces the error in proportion."),
                    {style.number(100 * alert.argument("share").value, 2)}};
        case AlertCode::damperAssumed:
            return translatable(
                "The data of the damper are assumed, because makers do not publish them. Try dashpots from "
                "0.05 to 0.5 times the impedance of the rod.");
    }
    return {};
}

std::string alertText(const Alert& alert, const ReadingStyle& style) {
    return style.said(alertMessage(alert, style));
}

}  // namespace drillwave
