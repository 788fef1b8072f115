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
    return {translatable("The first reflection is back while %1 % of the blow is still to come; a real "
                         "hammer would feel it, here its force is prescribed."),
            {style.number(percent, 4)}};
}

Message defaultHammer(const Alert& alert, const ReadingStyle& style) {
    if (alert.arguments.empty())
        return translatable(
            "The hammer's impedance is that of the rod, the value assumed where none is "
            "given: its blow is one step.");
    Message values;
    for (const AlertArgument& argument : alert.arguments) {
        const KeptParameter parameter = findParameter(argument.name);
        const std::string value =
            style.keepsUnitsOfFile()
                ? formatQuantity(argument.value, argument.quantity, parameter->displayUnit())
                : style.quantity(argument.value, argument.quantity, 4);
        values = joined(std::move(values), "%1, %2", {"%1 %2", {labelMessage(*parameter), value}});
    }
    return {translatable("The hammer is the one assumed where none is given (%1, the material of the rod): "
                         "give the data of the rock drill's piston."),
            {values}};
}

Message pistonImpedance(const Alert& alert) {
    return alert.argument("ratio").value < 1
               ? translatable(
                     "The hammer's impedance is below the rod's: it bounces back after one step, so "
                     "that the rod takes over more than its momentum.")
               : translatable(
                     "The hammer's impedance is above the rod's: it pushes in a staircase of ever "
                     "smaller steps, assumed to run on as if the rod were long.");
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
        return {translatable("The waves of a blow make only %1 round trips until the next blow, and "
                             "meet it %3: penetration may swing by 10 % up or down with frequency "
                             "times length; %2 follows it."),
                {roundTrips, drillingWords(style), dampingOfWaves(alert, style)}};
    return {translatable("The waves of a blow make only %1 round trips until the next blow, and meet "
                         "it %4 and nearly in step (close to %2): penetration may swing by 10 % up "
                         "or down; %3 follows it."),
            {roundTrips, whole(alert, "whole"), drillingWords(style), dampingOfWaves(alert, style)}};
}

Message lengthsRounded(const Alert& alert, const ReadingStyle& style) {
    const bool isShared = alert.has("shared_cell");
    const Message cell =
        isShared
            ? Message(translatable(
                          "share but a cell of time of %1, which would take more work than is permitted"),
                      {inUnit(alert, "shared_cell", style)})
            : Message(translatable("share no cell of time"));
    // what elastic rock keeps is 0 by law; its force and the rebound are what rounding moves
    const Message off =
        alert.has("cor_error")
            ? Message(translatable("the force on the rock and the rebound are off: e by up to %1"),
                      {bound(alert, "cor_error", style)})
            : Message(translatable("the efficiency may be off by %1"),
                      {bound(alert, "efficiency_error", style)});
    return {translatable("The transit times of the sections %1: they were rounded by up to %2, and %3. %4"),
            {cell, inUnit(alert, "time", style), off,
             isShared ? translatable("Lengths with a larger common divisor share a longer one.")
                      : translatable("Lengths in whole millimetres of one steel share one and are exact.")}};
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
        return translatable("the loading curve of the rock is no straight line");
    return translatable("the bit is still on the rock when the next reflection arrives");
}

Message closedFormInvalid(const Alert& alert, const ReadingStyle& style) {
    return {
        translatable("The closed form for elastic rock does not hold, because %1: its e = %2 is off by %3."),
        {closedFormObstacle(alert, style), fourDigits(alert, "closed_form_cor", style),
         fourDigits(alert, "difference", style)}};
}

Message inputDecides(const Alert& alert, const ReadingStyle& style) {
    return {translatable("The bit chatters on the rock (%1 contacts), so that e depends on the last digits "
                         "of the input: it is known to %2 only, and no calculation knows it better. A longer "
                         "rod, a shorter blow or a softer rock chatters less."),
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
        return {translatable("%1 %2: %3, %4 from its rear end at %5, against a strength of %6."),
                {alert.subject, consequence, stress, place, time, strength}};
    if (isAfter)
        return {translatable("The rod %1: %2, %3 from the hammer at %4, after the blow, in the waves left "
                             "(which nothing damps here), against a strength of %5."),
                {consequence, stress, place, time, strength}};
    return {translatable("The rod %1: %2, %3 from the hammer at %4, during the blow, against a strength "
                         "of %5."),
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
            return {translatable("The rod leaves with more momentum than it came with (e = %1): rigid rock, "
                                 "e = 1, would underestimate the thrust."),
                    {fourDigits(alert, "cor", style)}};
        case AlertCode::severalContacts:
            return {translatable(
                        "The bit hits the rock %1 times in this blow: the waves on their way bring it back."),
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
            return overload(alert, translatable("is fatigued by every blow"), style);
        case AlertCode::residualWaves:
            return residualWaves(alert, style);
        case AlertCode::lengthsRounded:
            return lengthsRounded(alert, style);
        case AlertCode::wavesThinned:
            return {translatable("The waves of this blow are too many to be kept: plots of waves and forces "
                                 "are of a coarser string, whose COR and efficiency differ by at most %1."),
                    {bound(alert, "difference", style)}};
        case AlertCode::blowNotOver:
            return {alert.has("forced")
                        ? translatable("After %1 the bit may still meet the rock again: these are the "
                                       "numbers at the next blow, not final ones.")
                        : translatable("After %1 bit or hammer may still meet again: these are the numbers "
                                       "at the next blow, not final ones."),
                    {inUnit(alert, "time", style)}};
        case AlertCode::stressesLeftOut:
            return translatable(
                "The largest stresses of the sections take more work than is permitted: they were left out "
                "and no strength was checked. A shorter end_time may leave room for them.");
        case AlertCode::cornersWithoutEffect:
            return {translatable("The force stays below the first corner of the loading curve (%1 of %2): "
                                 "the law acts as the bilinear one."),
                    {inUnit(alert, "peak_force", style), inUnit(alert, "corner_force", style)}};
        case AlertCode::pushedBack:
            return {translatable("The feed, %1, is less than the mean reaction of the blows, %2, or so near "
                                 "to it that gaps grow without bound."),
                    {inUnit(alert, "force", style), inUnit(alert, "needed", style)}};
        case AlertCode::noWaveLoss:
            return translatable(
                "Nothing damps the waves: jumps never fade. A wave loss of 1 to 30 % in "
                "a round trip is usual.");
        case AlertCode::restrikeInTheWay:
            return {translatable("After it has separated, the piston still passes up to %1 % of its "
                                 "momentum: it is in the way of the rebounding string, where a machine would "
                                 "have drawn it back; “may strike again” switched off "
                                 "(restrike: false in the file) says so."),
                    {style.number(100 * alert.argument("share").value, 3)}};
        case AlertCode::shankOff:
            return {translatable("At a blow the shank is up to %1 off its mean place in the machine: the "
                                 "stroke, and so the blow, would be another one. A dashpot lets it creep; "
                                 "the spring of the damper brings it back."),
                    {inUnit(alert, "offset", style)}};
        case AlertCode::frequencyRounded:
            return {
                translatable("The blow frequency is marched as %1, so that blows come at the end of a cell."),
                {inUnit(alert, "used", style)}};
        case AlertCode::notSettled:
            return translatable(
                "The means of the first and the second half of the blows differ by more than "
                "three of their errors: more blows, or more that settle, are needed.");
        case AlertCode::coexistingMotions:
            return translatable(
                "Two motions coexist. The start or the time step decides which one is "
                "computed; which one a machine takes is not known.");
        case AlertCode::irregularMotion:
            return translatable("The motion does not repeat: means are results, single blows are none.");
        case AlertCode::energyUnbalanced:
            return {translatable("The energy of all blows closes to %1 % only: the cells are long for these "
                                 "contacts; shorter ones take it down with their length."),
                    {style.number(100 * alert.argument("share").value, 2)}};
        case AlertCode::damperAssumed:
            return translatable(
                "No maker publishes its damper: try dashpots from 0.05 to 0.5 of the impedance of the rod.");
    }
    return {};
}

std::string alertText(const Alert& alert, const ReadingStyle& style) {
    return style.said(alertMessage(alert, style));
}

}  // namespace drillwave
