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
    return {translatable("The %1 = %2 is outside the usual range, %3 to %4."),
            {parameter->address ? labelMessage(*parameter, alert.subject)
                                : titleMessage(*parameter, parameter->symbol),
             inUnit(alert, "value", style), end(parameter->plausible.low), end(parameter->plausible.high)}};
}

Message longPulse(const Alert& alert, const ReadingStyle& style) {
    const double percent =
        static_cast<double>(static_cast<int>(alert.argument("late_impulse").value * 1000)) / 10;
    return {translatable(
                "The first reflection returns before the last %1 % of the blow. A real hammer would feel it, "
                "but here the force is prescribed. To include it, use a drill string with a hammer."),
            {style.number(percent, 4)}};
}

Message defaultHammer(const Alert& alert, const ReadingStyle& style) {
    if (alert.arguments.empty())
        return translatable(
            "The hammer has the impedance of the rod, which is the default: its blow is one step. Give the "
            "data of the piston.");
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
                     "The impedance of the hammer is below that of the rod: the hammer bounces back after "
                     "one step, and the rod receives more than its momentum.")
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
    return {translatable("with %1 % left at a wave loss of %2 %"),
            {style.number(100 * left, 2), style.number(100 * loss, 3)}};
}

Message residualWaves(const Alert& alert, const ReadingStyle& style) {
    const std::string roundTrips = fourDigits(alert, "round_trips", style);
    if (!alert.has("whole"))
        return {
            translatable("The waves of a blow make only %1 round trips before the next blow, and meet it %3. "
                         "Penetration may change by up to 10 % with blow frequency and string length; %2 "
                         "computes it."),
            {roundTrips, drillingWords(style), dampingOfWaves(alert, style)}};
    return {
        translatable("The waves of a blow make only %1 round trips before the next blow, and meet it %4 and "
                     "nearly in step (close to %2). Penetration may change by up to 10 %; %3 computes it."),
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
    return {
        translatable("The transit times of the sections %1: they were rounded by up to %2, and %3. %4"),
        {cell, inUnit(alert, "time", style), off,
         isShared
             ? translatable("Choose lengths with a larger common divisor (e.g. 50 mm): fewer time steps.")
             : translatable(
                   "Enter all lengths in whole millimetres, with one steel: the time step is then exact.")}};
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
    return {
        translatable(
            "The closed form for elastic rock does not apply, because %1: its e = %2 has an error of %3."),
        {closedFormObstacle(alert, style), fourDigits(alert, "closed_form_cor", style),
         fourDigits(alert, "difference", style)}};
}

Message inputDecides(const Alert& alert, const ReadingStyle& style) {
    return {translatable("The bit chatters on the rock (%1 contacts), so e depends on the last digits of the "
                         "input and can be known only to within %2. A longer rod, a shorter blow "
                         "or a softer rock reduces the chatter."),
            {whole(alert, "contacts"), bound(alert, "cor_error", style)}};
}

/// Which stress, where, when, and what it is held against.
Message overload(const Alert& alert, const Message& consequence, const ReadingStyle& style) {
    const bool isAfter = alert.level == AlertLevel::information;
    const bool isCompression = alert.has("compression");
    const Message stress{
        isCompression ? translatable("compression reaches %1") : translatable("tension reaches %1"),
        {inUnit(alert, isCompression ? "compression" : "tension", style)}};
    const std::string place = inUnit(alert, "place", style), time = inUnit(alert, "time", style),
                      strength = inUnit(alert, "strength", style);
    if (alert.has("section"))
        return {translatable("%1 %2: %3, %4 from its rear end at %5; its strength is %6."),
                {alert.subject, consequence, stress, place, time, strength}};
    if (isAfter)
        return {translatable("The rod %1: %2, %3 from the hammer at %4, after the blow, in the residual "
                             "waves (undamped here); its strength is %5."),
                {consequence, stress, place, time, strength}};
    return {translatable("The rod %1: %2, %3 from the hammer at %4, during the blow; its strength is %5."),
            {consequence, stress, place, time, strength}};
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
                "The gap has no effect on a rigid body motion: it only shifts the time of contact.");
        case AlertCode::thrustBelowNeeded:
            return thrustBelowNeeded(alert, style);
        case AlertCode::superRebound:
            return {translatable("The rod rebounds with more momentum than it had before impact (e = %1). An "
                                 "estimate for rigid rock (e = 1) gives too small a feed force."),
                    {fourDigits(alert, "cor", style)}};
        case AlertCode::severalContacts:
            return {
                translatable(
                    "The bit hits the rock %1 times in this blow: reflected waves push it back to the rock."),
                {whole(alert, "contacts")}};
        case AlertCode::closedFormInvalid:
            return closedFormInvalid(alert, style);
        case AlertCode::inputDecides:
            return inputDecides(alert, style);
        case AlertCode::reducedAccuracy:
            return {translatable("The numerical error of e may be as large as %1."),
                    {bound(alert, "cor_error", style)}};
        case AlertCode::stressAboveYield:
            return overload(alert, translatable("would yield"), style);
        case AlertCode::stressAboveFatigue:
            return overload(alert, translatable("suffers fatigue at every blow"), style);
        case AlertCode::residualWaves:
            return residualWaves(alert, style);
        case AlertCode::lengthsRounded:
            return lengthsRounded(alert, style);
        case AlertCode::wavesThinned:
            return {translatable("This blow has too many waves to keep. Plots of waves and forces show a "
                                 "coarser string, whose COR and efficiency differ by at most %1."),
                    {bound(alert, "difference", style)}};
        case AlertCode::blowNotOver:
            return {alert.has("forced")
                        ? translatable("After %1 the bit may still hit the rock again: these are the values "
                                       "at the next blow, not the final ones.")
                        : translatable("After %1 bit and rock, or hammer and string, may still meet again: "
                                       "these are the values at the next blow, not the final ones."),
                    {inUnit(alert, "time", style)}};
        case AlertCode::stressesLeftOut:
            return translatable(
                "The largest stresses of the sections take more work than is permitted. They were not "
                "computed, and no strength was checked. Try a shorter end_time.");
        case AlertCode::cornersWithoutEffect:
            return {translatable("The force stays below the first corner of the loading curve (%1 of %2): "
                                 "the law acts like a bilinear one."),
                    {inUnit(alert, "peak_force", style), inUnit(alert, "corner_force", style)}};
        case AlertCode::pushedBack:
            return {translatable("The feed force of %1 is below the mean force of the blows, %2, or too "
                                 "close to it: gaps grow without bound. Increase the feed force."),
                    {inUnit(alert, "force", style), inUnit(alert, "needed", style)}};
        case AlertCode::noWaveLoss:
            return translatable(
                "Nothing damps the waves: jumps never fade. Give a wave loss; 1 to 30 % per round trip is "
                "usual.");
        case AlertCode::restrikeInTheWay:
            return {translatable("After separation the piston still transfers up to %1 % of its momentum: it "
                                 "is in the way of the rebounding string. If the machine has drawn it back "
                                 "by then, switch off “may strike again” (restrike: false in the file)."),
                    {style.number(100 * alert.argument("share").value, 3)}};
        case AlertCode::shankOff:
            return {translatable(
                        "At a blow the shank is up to %1 away from its mean position in the machine: stroke "
                        "and blow would differ. With only a dashpot it creeps; give the damper a spring."),
                    {inUnit(alert, "offset", style)}};
        case AlertCode::frequencyRounded:
            return {
                translatable("The blow frequency is computed as %1, so that each blow falls on a time step."),
                {inUnit(alert, "used", style)}};
        case AlertCode::notSettled:
            return translatable(
                "The means of the first and second half of the blows differ by more than three times their "
                "error. Increase the number of blows, or of transient blows.");
        case AlertCode::coexistingMotions:
            return translatable(
                "Two steady motions are possible. The start or the time step decides which one is computed; "
                "a real drill may settle into either.");
        case AlertCode::irregularMotion:
            return translatable("The motion does not repeat: use the means, not the values of single blows.");
        case AlertCode::energyUnbalanced:
            return {translatable("The energy balance of all blows has an error of %1 %: the time step is "
                                 "long for these contacts. A shorter one reduces the error in proportion."),
                    {style.number(100 * alert.argument("share").value, 2)}};
        case AlertCode::damperAssumed:
            return translatable(
                "The damper is assumed, because makers do not publish theirs. Try dashpots from 0.05 to 0.5 "
                "times the impedance of the rod.");
    }
    return {};
}

std::string alertText(const Alert& alert, const ReadingStyle& style) {
    return style.said(alertMessage(alert, style));
}

}  // namespace drillwave
