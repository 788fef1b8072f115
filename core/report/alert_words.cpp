// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/alert_words.h"

#include "core/model/law_parameter.h"
#include "core/model/parameter.h"
#include "core/report/feed_words.h"
#include "core/text/handy_text.h"

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

/// "stiffness k", as in the form: in words, not as in a file.
std::string nameOf(const Parameter& parameter) {
    std::string name(parameter.label);
    if (!parameter.symbol.empty()) name += " " + std::string(parameter.symbol);
    return name;
}

std::string implausible(const Alert& alert, const ReadingStyle& style) {
    const KeptParameter named = findParameter(alert.parameter);
    const bool isByRatio = alert.argument("value").quantity != named->quantity;
    const KeptParameter parameter = isByRatio ? inScales(*named) : named;
    const auto end = [&](double value) { return style.quantity(value, parameter->quantity, 4); };
    return "The " + nameOf(*parameter) + " = " + inUnit(alert, "value", style) +
           " is outside the usual range, " + end(parameter->plausible.low) + " to " +
           end(parameter->plausible.high) + ".";
}

std::string longPulse(const Alert& alert, const ReadingStyle& style) {
    const double percent =
        static_cast<double>(static_cast<int>(alert.argument("late_impulse").value * 1000)) / 10;
    return "The first reflection is back while " + style.number(percent, 4) +
           " % of the blow is still to come; a real hammer would feel it, here its force is prescribed.";
}

std::string defaultHammer(const Alert& alert, const ReadingStyle& style) {
    if (alert.arguments.empty())
        return "The hammer's impedance is that of the rod, the value assumed where none is given: "
               "its blow is one step.";
    std::string values;
    for (const AlertArgument& argument : alert.arguments) {
        const KeptParameter parameter = findParameter(argument.name);
        values += (values.empty() ? "" : ", ") + std::string(parameter->localKey()) + " " +
                  (style.keepsUnitsOfFile()
                       ? formatQuantity(argument.value, argument.quantity, parameter->displayUnit())
                       : style.quantity(argument.value, argument.quantity, 4));
    }
    return "The hammer is the one assumed where none is given (" + values +
           ", the material of the rod): give the data of the rock drill's piston.";
}

std::string pistonImpedance(const Alert& alert) {
    return alert.argument("ratio").value < 1
               ? "The hammer's impedance is below the rod's: it bounces back after one step, so that the rod "
                 "takes over more than its momentum."
               : "The hammer's impedance is above the rod's: it pushes in a staircase of ever smaller steps, "
                 "assumed to run on as if the rod were long.";
}

std::string thrustBelowNeeded(const Alert& alert, const ReadingStyle& style) {
    FeedDecision decision{.kind = FeedDecision::Kind::notEnough,
                          .force = FeedForce{alert.argument("installed").value, {}},
                          .frequency = alert.argument("frequency").value,
                          .need = alert.argument("full_rate").value};
    if (alert.has("weight")) decision.weight = *(decision.force->weight = alert.argument("weight").value);
    const bool isPushedBack = decision.force->effective() < alert.argument("balance").value;
    return feedDecisionText(decision, style) + " " +
           std::string(feedAdvice(isPushedBack ? Feed::pushedBack : Feed::penetrationLost));
}

std::string residualWaves(const Alert& alert, const ReadingStyle& style) {
    const std::string start =
        "The waves of a blow make only n_b = " + fourDigits(alert, "round_trips", style) +
        " round trips until the next blow, and meet it undamped";
    if (!alert.has("whole"))
        return start +
               ": penetration may swing by 10 % up or down with frequency times length; `drill` follows it.";
    return start + " and nearly in step (n_b close to " + whole(alert, "whole") +
           "): penetration may swing by 10 % up or down; `drill` follows it.";
}

std::string lengthsRounded(const Alert& alert, const ReadingStyle& style) {
    const bool isShared = alert.has("shared_cell");
    const std::string cell = isShared ? "share but a cell of time of " + inUnit(alert, "shared_cell", style) +
                                            ", which would take more work than is permitted"
                                      : "share no cell of time";
    // what elastic rock keeps is 0 by law; its force and the rebound are what rounding moves
    const std::string off =
        alert.has("cor_error")
            ? "the force on the rock and the rebound are off: e by up to " + bound(alert, "cor_error", style)
            : "the efficiency may be off by " + bound(alert, "efficiency_error", style);
    return "The transit times of the sections " + cell + ": they were rounded by up to " +
           inUnit(alert, "time", style) + ", and " + off +
           (isShared ? ". Lengths with a larger common divisor share a longer one."
                     : ". Lengths in whole millimetres of one steel share one and are exact.");
}

/// Why the closed form is not for the blow: the group to blame says it.
std::string closedFormObstacle(const Alert& alert, const ReadingStyle& style) {
    if (alert.parameter == "tau")
        return "the blow is longer than a round trip in the rod (tau = " + fourDigits(alert, "tau", style) +
               " < 0.5)";
    if (alert.parameter == "delta")
        return "the bit meets the rock in the middle of a wave (delta = " +
               fourDigits(alert, "delta", style) + " is not a whole number)";
    if (alert.parameter == "bit_rock.law") return "the loading curve of the rock is no straight line";
    return "the bit is still on the rock when the next reflection arrives";
}

std::string closedFormInvalid(const Alert& alert, const ReadingStyle& style) {
    return "The closed form for elastic rock does not hold, because " + closedFormObstacle(alert, style) +
           ": its e = " + fourDigits(alert, "closed_form_cor", style) + " is off by " +
           fourDigits(alert, "difference", style) + ".";
}

std::string inputDecides(const Alert& alert, const ReadingStyle& style) {
    return "The bit chatters on the rock (" + whole(alert, "contacts") +
           " contacts), so that e depends on the last digits of the input: it is known to " +
           bound(alert, "cor_error", style) +
           " only, and no calculation knows it better. A longer rod, a shorter blow or a softer rock "
           "chatters less.";
}

/// Which stress, where, when, and what it is held against.
std::string overload(const Alert& alert, const std::string& rod, const std::string& consequence,
                     const ReadingStyle& style) {
    const bool isAfter = alert.level == AlertLevel::information;
    const std::string kind = alert.has("compression") ? "compression" : "tension";
    if (alert.has("section"))
        return "Section " + whole(alert, "section") + " of hammer and string " + consequence + ": " + kind +
               " reaches " + inUnit(alert, kind, style) + ", " + inUnit(alert, "place", style) +
               " from its rear end at " + inUnit(alert, "time", style) + ", against a strength of " +
               inUnit(alert, "strength", style) + ".";
    return rod + " " + consequence + ": " + kind + " reaches " + inUnit(alert, kind, style) + ", " +
           inUnit(alert, "place", style) + " from the hammer at " + inUnit(alert, "time", style) +
           (isAfter ? ", after the blow, in the waves left (which nothing damps here)"
                    : ", during the blow") +
           ", against a strength of " + inUnit(alert, "strength", style) + ".";
}

}  // namespace

std::string alertText(const Alert& alert, const ReadingStyle& style) {
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
            return "The gap has no effect on a rigid body motion: it only shifts the time of contact.";
        case AlertCode::thrustBelowNeeded:
            return thrustBelowNeeded(alert, style);
        case AlertCode::superRebound:
            return "The rod leaves with more momentum than it came with (e = " +
                   fourDigits(alert, "cor", style) + "): rigid rock, e = 1, would underestimate the thrust.";
        case AlertCode::severalContacts:
            return "The bit hits the rock " + whole(alert, "contacts") +
                   " times in this blow: the waves on their way bring it back.";
        case AlertCode::closedFormInvalid:
            return closedFormInvalid(alert, style);
        case AlertCode::inputDecides:
            return inputDecides(alert, style);
        case AlertCode::reducedAccuracy:
            return "The numerical error of e may be as large as " + bound(alert, "cor_error", style) + ".";
        case AlertCode::stressAboveYield:
            return overload(alert, "The rod", "would yield", style);
        case AlertCode::stressAboveFatigue:
            return overload(alert, "The rod", "tires with every blow", style);
        case AlertCode::residualWaves:
            return residualWaves(alert, style);
        case AlertCode::lengthsRounded:
            return lengthsRounded(alert, style);
        case AlertCode::blowNotOver:
            return "After " + inUnit(alert, "time", style) +
                   " bit or hammer may still meet again: these are the numbers at the next blow, not final "
                   "ones.";
        case AlertCode::stressesLeftOut:
            return "The largest stresses of the sections take more work than is permitted: they were left "
                   "out and no strength was checked. A shorter end_time may leave room for them.";
        case AlertCode::cornersWithoutEffect:
            return "The force stays below the first corner of the loading curve (" +
                   inUnit(alert, "peak_force", style) + " of " + inUnit(alert, "corner_force", style) +
                   "): the law acts as the bilinear one.";
        case AlertCode::pushedBack:
            return "The feed, " + inUnit(alert, "force", style) +
                   ", is less than the mean reaction of the blows, " + inUnit(alert, "needed", style) +
                   ", or so near to it that gaps grow without bound.";
        case AlertCode::noWaveLoss:
            return "Nothing takes from the waves: jumps never fade. A wave_loss of 1 to 30 % in a round trip "
                   "is usual.";
        case AlertCode::restrikeInTheWay:
            return "After it has separated, the piston still passes up to " +
                   style.number(100 * alert.argument("share").value, 3) +
                   " % of its momentum: it is in the way of the rebounding string, where a machine would "
                   "have drawn "
                   "it back; restrike: false says so.";
        case AlertCode::shankOff:
            return "At a blow the shank is up to " + inUnit(alert, "offset", style) +
                   " off its mean place in the machine: the stroke, and so the blow, would be another one. A "
                   "dashpot lets it creep; a spring (damper_stiffness) brings it back.";
        case AlertCode::frequencyRounded:
            return "The blow frequency is marched as " + inUnit(alert, "used", style) +
                   ", so that blows come at the end of a cell.";
        case AlertCode::notSettled:
            return "The means of the first and the second half of the blows differ by more than three of "
                   "their errors: "
                   "more blows, or more that settle, are needed.";
        case AlertCode::coexistingMotions:
            return "From rest and from bouncing it comes to different motions: which one a machine takes is "
                   "not known.";
        case AlertCode::irregularMotion:
            return "The motion does not repeat: means are results, single blows are none.";
        case AlertCode::energyUnbalanced:
            return "The energy of all blows closes to " +
                   style.number(100 * alert.argument("share").value, 2) +
                   " % only: the cells are long for these contacts; shorter ones take it down with their "
                   "length.";
        case AlertCode::damperAssumed:
            return "No maker publishes its damper: try dashpots from 0.05 to 0.5 of the impedance of the "
                   "rod.";
    }
    return {};
}

}  // namespace drillwave
