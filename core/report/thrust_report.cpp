// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_report.h"

#include <algorithm>
#include <ranges>

#include "core/model/alerts.h"
#include "core/model/blow_interval.h"
#include "core/model/blow_traits.h"
#include "core/report/alert_words.h"
#include "core/report/curve_text.h"
#include "core/report/feed_words.h"
#include "core/report/json_value.h"
#include "core/report/report_text.h"
#include "core/text/enum_names.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

const char* label(ThrustCase which) {
    switch (which) {
        case ThrustCase::scenario:
            return translatable("drillwave::Message", "this blow");
        case ThrustCase::gapQuantile:
            return translatable("drillwave::Message", "95 % of all gaps");
        case ThrustCase::rigidRock:
            return translatable("drillwave::Message", "rigid rock");
        case ThrustCase::elasticWorst:
            return translatable("drillwave::Message", "elastic rock, worst gap");
    }
    return "";
}

/// What the hammer hands on with a blow [N s].
double impulseOf(const ThrustReport& report) {
    return pulseImpulse(report.scenario) * report.study.transferred;
}

/// "5 kN ... 7 kN", in print "5 … 7 kN".
std::string bracket(const ThrustNeed& need, const ReadingStyle& style) {
    const auto force = [&](double newton) { return style.quantity(newton, Quantity::force, 4); };
    std::string least = force(need.thrust);
    const std::string undamped = force(need.thrustUndamped);
    if (!style.isPrinted()) return least + " ... " + undamped;
    const std::string unit = " " + style.unitFor(need.thrust, Quantity::force).name;
    if (least.ends_with(unit) && undamped.ends_with(unit)) least.resize(least.size() - unit.size());
    return least + " … " + undamped;
}

std::string hertz(double frequency, const ReadingStyle& style) {
    return style.quantity(frequency, Quantity::frequency, 4);
}

/// "6.3 mm", "none" where the bit rests on the rock, "-" where there is no steady one.
std::string gapText(const GapAtBlow& found, const ReadingStyle& style) {
    if (found.motion.kind == UndampedMotion::Kind::resting)
        return style.said(translatable("drillwave::Message", "none"));
    if (!found.motion.stable) return style.isPrinted() ? "–" : "-";
    return style.quantity(found.gap, Quantity::length, 3);
}

/// Not all of them before it is all of them.
std::string shareText(double share, const ReadingStyle& style) {
    return style.number(roundedTo(share * 100, 4, Rounding::down), 4) + " %";
}

/// The effective force over the largest of the needs, and which that is; empty where no thrust is installed.
Message marginSentence(const ThrustNeeds& needs, const ReadingStyle& style) {
    const ThrustNeed& largest = largestOf(needs);
    if (!largest.margin) return {};
    const WidestNeed widest = widestOf(needs);
    return {widest.ofAllGaps
                ? translatable("drillwave::Message", "Margin over the largest of the four needs (%1): %2.")
                : translatable("drillwave::Message", "Margin over the larger of the two needs (%1): %2."),
            {label(widest.which), style.signedPercent(*largest.margin)}};
}

/// Those that a point knows; all four where none is solved.
std::vector<ThrustCase> knownCases(const ThrustAlong& along) {
    std::vector<ThrustCase> cases(thrustCases.begin(), thrustCases.end());
    for (const ThrustPoint& point : along.curve.points) {
        if (!point.reason.isEmpty()) continue;
        std::erase_if(cases, [&](ThrustCase which) { return !point.need(which).known; });
        break;
    }
    return cases;
}

/// What comes how often, and what presses against it.
std::string blowsText(const ThrustReport& report, const ReadingStyle& style) {
    std::string text = style.said({translatable("drillwave::Message", "%1 of %2, n_b = %3"),
                                   {hertz(*report.scenario.drill.blowFrequency, style),
                                    style.quantity(impulseOf(report), Quantity::impulse, 4),
                                    style.number(*roundTripsBetweenBlows(report.scenario), 4)}});
    if (const std::optional<FeedForce> feed = feedForceOf(report.scenario))
        text += (feed->weight ? "\n  " : ", ") + feedForceText(*feed, style);
    return text;
}

std::string bracketTable(const ThrustAlong& along, const ReadingStyle& style) {
    TextGrid grid;
    std::vector<std::string> titles{along.axis.column().header};
    const std::vector<ThrustCase> cases = knownCases(along);
    for (const ThrustCase which : cases) titles.push_back(style.said(label(which)));
    titles.push_back(style.said(translatable("drillwave::Message", "feed")));
    grid.add(titles);
    for (const ThrustPoint& point : along.curve.points) {
        std::vector<std::string> cells{style.number(along.axis.unit->fromSi(point.value), valueDigits)};
        for (const ThrustCase which : cases)
            cells.push_back(point.reason.isEmpty() ? bracket(point.need(which), style) : "-");
        cells.push_back(style.said(Message::ofTable(feedWord(point.verdict.feed))));
        grid.add(cells);
    }
    return grid.text();
}

JsonObject gapAtBlowJson(const GapAtBlow& found) {
    using Kind = UndampedMotion::Kind;
    static constexpr EnumNames<Kind> kinds{
        {{Kind::pushedBack, "pushed_back"}, {Kind::bouncing, "bouncing"}, {Kind::resting, "resting"}}};
    const bool bounces = found.motion.kind == Kind::bouncing;
    const auto whereItBounces = [&](double value) { return bounces ? Json(value) : Json(); };
    return {{"motion", kinds[found.motion.kind]},
            {"stable", found.motion.stable},
            {"gap", whereItBounces(found.gap)},
            {"gap_in_d0", whereItBounces(found.inD0)}};
}

JsonObject needJson(const ThrustNeed& need) {
    return {{"cor", need.cor.value},
            {"cor_error", need.cor.error},
            {"thrust", need.thrust},
            {"thrust_undamped", need.thrustUndamped},
            {"margin", need.margin},
            {"frequency_limit", need.frequencyLimit},
            {"feed", name(need.feed)},
            {"gap_at_blow", need.gapAtBlow ? Json(gapAtBlowJson(*need.gapAtBlow)) : Json()}};
}

JsonObject needsJson(const ThrustNeeds& needs) {
    JsonObject object;
    for (const ThrustCase which : thrustCases)
        if (const ThrustNeed& need = needs[static_cast<std::size_t>(which)]; need.known)
            object[name(which)] = needJson(need);
    return object;
}

JsonObject alongJson(const ThrustAlong& along) {
    JsonArray points;
    for (const ThrustPoint& point : along.curve.points) {
        JsonObject object{{"value", point.value}};
        if (point.reason.isEmpty()) {
            object["needs"] = needsJson(point.needs);
            object["effective_force"] = point.verdict.effective();
            object["feed"] = name(point.verdict.feed);
        } else {
            object["reason"] = point.reason.text();
        }
        points.emplace_back(object);
    }
    return {{"parameter", along.axis.key()},
            {"unit", unitJson(along.axis.parameter->quantity)},
            {"points", points}};
}

}  // namespace

TextGrid needsGrid(const ThrustReport& report, const ReadingStyle& style) {
    const bool judged = report.scenario.drill.thrust.has_value();
    TextGrid grid;
    std::vector<const char*> titles{translatable("drillwave::Message", "thrust needed for"), "e",
                                    translatable("drillwave::Message", "enough ... bit back undamped")};
    if (judged)
        titles.insert(titles.end(), {translatable("drillwave::Message", "margin"),
                                     translatable("drillwave::Message", "enough up to"),
                                     translatable("drillwave::Message", "gap at the blow"),
                                     translatable("drillwave::Message", "feed")});
    grid.addTitles(titles, style);
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = report.study.need(which);
        if (!need.known) continue;
        std::vector<std::string> cells{style.said(label(which)), style.number(need.cor.value),
                                       bracket(need, style)};
        if (judged)
            cells.insert(cells.end(), {style.signedPercent(*need.margin), hertz(*need.frequencyLimit, style),
                                       gapText(*need.gapAtBlow, style),
                                       style.said(Message::ofTable(feedWord(need.feed)))});
        grid.add(cells);
    }
    return grid;
}

FeedDecision decisionOf(const JudgedNeeds& judged) {
    return decideFeed(judged.scenario, judged.verdict, widestOf(judged.needs));
}

std::vector<Message> verdictSentences(const JudgedNeeds& judged, const ReadingStyle& style) {
    const FeedDecision decision = decisionOf(judged);
    std::vector<Message> sentences{feedDecisionMessage(decision, style),
                                   feedMeaning(judged.verdict.feed, judged.needs.front().gapAtBlow, style)};
    // What is enough at every gap is so at each in this rock.
    if (judged.shareFull && decision.kind != FeedDecision::Kind::enough)
        sentences.emplace_back(
            translatable("drillwave::Message", "It is enough at %1 of all gaps in this rock."),
            std::vector<Message>{shareText(*judged.shareFull, style)});
    if (Message margin = marginSentence(judged.needs, style); !margin.isEmpty())
        sentences.push_back(std::move(margin));
    if (!gapHasPeriod(judged.scenario))
        sentences.emplace_back(
            translatable("drillwave::Message",
                         "The impulse of a blow is that of the hammer's face. The gaps of a drill string "
                         "have no period over which a share of them or the worst one could be told."));
    return sentences;
}

std::string thrustText(const ThrustReport& report, const ReadingStyle& style) {
    const std::vector<Message> sentences = verdictSentences(report.judged(), style);
    std::string text = titleLine(report.scenario) + paragraph(style.said(sentences.front())) +
                       groupsLine(report.scenario, style) + "  " + blowsText(report, style) + "\n\n" +
                       needsGrid(report, style).text();
    if (report.along) text += "\n" + bracketTable(*report.along, style);
    text += "\n";
    for (const Message& sentence : sentences | std::views::drop(1)) text += paragraph(style.said(sentence));
    for (const Alert& alert : alertsFor(report.scenario))
        if (alert.code == AlertCode::residualWaves) text += paragraph(alertText(alert, style));
    return text +
           paragraph(style.said(translatable(
               "drillwave::Message",
               "What a damper changes, and what waves from blow to blow, `drillwave drill` follows.")));
}

std::string thrustJson(const ThrustReport& report) {
    const ThrustStudy& study = report.study;
    const std::optional<FeedForce> feed = feedForceOf(report.scenario);
    JsonObject object = headJson({.scenario = report.scenario,
                                  .scenarioText = report.scenarioText,
                                  .method = MethodChoice{},
                                  .units = {{"thrust", unitJson(Quantity::force)},
                                            {"installed_thrust", unitJson(Quantity::force)},
                                            {"weight_along_hole", unitJson(Quantity::force)},
                                            {"effective_force", unitJson(Quantity::force)},
                                            {"impulse", unitJson(Quantity::impulse)},
                                            {"gap_at_blow", unitJson(Quantity::length)},
                                            {"frequency_limit", unitJson(Quantity::frequency)},
                                            {"blow_frequency", unitJson(Quantity::frequency)}},
                                  .runTime = report.runTime});
    object["blow_frequency"] = *report.scenario.drill.blowFrequency;
    object["impulse"] = impulseOf(report);
    object["round_trips"] = *roundTripsBetweenBlows(report.scenario);
    object["installed_thrust"] = report.scenario.drill.thrust;
    object["weight_along_hole"] = weightAlongHole(report.scenario);
    object["effective_force"] = feed ? std::optional(feed->effective()) : std::nullopt;
    object["thrust_balance"] = study.verdict.balance;
    object["needs"] = needsJson(study.needs);
    object["share_of_gaps_held"] = study.shareFull;
    object["thrust_margin"] = study.margin();
    object["feed"] = name(study.verdict.feed);
    object["advice"] = feedAdvice(study.verdict.feed);
    object["verdict"] = feedDecisionText(decisionOf(report.judged()));
    if (report.along) object["along"] = alongJson(*report.along);
    return Json(object).text();
}

}  // namespace drillwave
