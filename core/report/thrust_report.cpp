// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/thrust_report.h"

#include <algorithm>
#include <ranges>

#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/report/alert_words.h"
#include "core/report/curve_text.h"
#include "core/report/feed_json.h"
#include "core/report/feed_words.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

/// Impulse transferred by the hammer in one blow [N s].
double impulseOf(const ThrustReport& report) {
    return pulseImpulse(report.scenario) * report.study.transferred;
}

std::string forceText(double newton, const ReadingStyle& style) {
    return style.quantity(newton, Quantity::force, 4);
}

std::string hertz(double frequency, const ReadingStyle& style) {
    return style.quantity(frequency, Quantity::frequency, 4);
}

/// Not all of them before it is all of them.
std::string shareText(double share, const ReadingStyle& style) {
    return style.number(roundedTo(share * 100, 4, Rounding::down), 4) + " %";
}

/// The effective force over the largest of the needs, and which that is; empty where no thrust is installed.
Message marginSentence(const FeedEstimate& feed, const ReadingStyle& style) {
    if (!feed.largest().margin) return {};
    return {feed.isOfAllGaps() ? translatable("Margin over the largest of the four required forces (%1): %2.")
                               : translatable("Margin over the larger of the two required forces (%1): %2."),
            {labelOf(feed.largestCase()), style.signedPercent(*feed.largest().margin)}};
}

/// Required feeds that a point has; all four where none is solved.
std::vector<ThrustCase> knownCases(const ThrustAlong& along) {
    std::vector<ThrustCase> cases(thrustCases.begin(), thrustCases.end());
    for (const ThrustPoint& point : along.curve.points) {
        if (!point.reason.isEmpty()) continue;
        std::erase_if(cases, [&](ThrustCase which) { return !point.need(which).known; });
        break;
    }
    return cases;
}

/// Blow frequency and installed feed force.
std::string blowsText(const ThrustReport& report, const ReadingStyle& style) {
    std::string text = style.said({translatable("%1 of %2, n_b = %3"),
                                   {hertz(*report.scenario.drill.blowFrequency, style),
                                    style.quantity(impulseOf(report), Quantity::impulse, 4),
                                    style.number(*roundTripsBetweenBlows(report.scenario), 4)}});
    if (const std::optional<FeedForce> feed = feedForceOf(report.scenario))
        text += (feed->weight ? "\n  " : ", ") + feedForceText(*feed, style);
    return text;
}

std::string alongTable(const ThrustAlong& along, const ReadingStyle& style) {
    TextGrid grid;
    std::vector<std::string> titles{along.axis.column().header};
    const std::vector<ThrustCase> cases = knownCases(along);
    for (const ThrustCase which : cases) titles.push_back(style.said(labelOf(which)));
    titles.push_back(style.said(translatable("feed")));
    grid.add(titles);
    for (const ThrustPoint& point : along.curve.points) {
        std::vector<std::string> cells{style.number(along.axis.unit->fromSi(point.value), valueDigits)};
        for (const ThrustCase which : cases)
            cells.push_back(point.reason.isEmpty() ? forceText(point.need(which).thrust, style) : "-");
        const std::optional<FeedState> state = point.reason.isEmpty() ? point.feed.state() : std::nullopt;
        cells.push_back(state ? style.said(Message::ofTable(feedWord(*state))) : "");
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
            object["needs"] = needsJson(point.feed.needs);
            object["effective_force"] = point.feed.effective();
            object["feed"] = feedJson(point.feed);
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
    const bool isInstalled = report.scenario.drill.thrust.has_value();
    TextGrid grid;
    std::vector<const char*> titles{translatable("case"), "e", translatable("required"),
                                    translatable("return in time")};
    if (isInstalled) titles.insert(titles.end(), {translatable("margin"), translatable("enough up to")});
    grid.addTitles(titles, style);
    for (const ThrustCase which : thrustCases) {
        const ThrustNeed& need = report.study.need(which);
        if (!need.known) continue;
        std::vector<std::string> cells{style.said(labelOf(which)), style.number(need.cor.value),
                                       forceText(need.thrust, style), forceText(need.thrustUndamped, style)};
        if (isInstalled)
            cells.insert(cells.end(),
                         {style.signedPercent(*need.margin), hertz(*need.frequencyLimit, style)});
        grid.add(cells);
    }
    return grid;
}

std::vector<Message> thrustSentences(const Scenario& scenario, const FeedEstimate& feed,
                                     const std::optional<double>& shareCovered, const ReadingStyle& style) {
    std::vector<Message> sentences = estimateSentences(scenario, feed, style);
    if (Message more = moreFeedMessage(feed, style); !more.isEmpty())
        sentences.insert(sentences.begin() + 1, std::move(more));
    const std::optional<FeedState> state = feed.state();
    // A feed that is enough for every gap is enough for each one in this rock.
    if (shareCovered && (state == FeedState::belowRequired || state == FeedState::requiredAtThisGap))
        sentences.push_back({translatable("The force for every gap is that for fully elastic rock. In this "
                                          "rock, the feed force is enough for %1 of all gaps."),
                             {shareText(*shareCovered, style)}});
    if (Message margin = marginSentence(feed, style); !margin.isEmpty())
        sentences.push_back(std::move(margin));
    if (!feed.gapsHavePeriod)
        sentences.emplace_back(
            translatable("The impulse of a blow is that from hammer to string. For drill strings, only the "
                         "gap entered and rigid rock are examined."));
    return sentences;
}

std::string thrustText(const ThrustReport& report, const ReadingStyle& style) {
    const std::vector<Message> sentences =
        thrustSentences(report.scenario, report.study.feed, report.study.shareFull, style);
    std::string text = titleLine(report.scenario) + paragraph(style.said(sentences.front())) +
                       groupsLine(report.scenario, style) + "  " + blowsText(report, style) + "\n\n" +
                       needsGrid(report, style).text();
    if (report.along) text += "\n" + alongTable(*report.along, style);
    text += "\n";
    for (const Message& sentence : sentences | std::views::drop(1)) text += paragraph(style.said(sentence));
    for (const Alert& alert : alertsFor(report.scenario))
        if (alert.code == AlertCode::residualWaves) text += paragraph(alertText(alert, style));
    return text;
}

std::string thrustJson(const ThrustReport& report, const std::string& scenarioText) {
    const ThrustStudy& study = report.study;
    const std::optional<FeedForce> feed = feedForceOf(report.scenario);
    JsonObject object = headJson({.scenario = report.scenario,
                                  .scenarioText = scenarioText,
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
    object["thrust_balance"] = study.feed.balance;
    object["needs"] = needsJson(study.feed.needs);
    object["share_of_gaps_held"] = study.shareFull;
    object["thrust_margin"] = study.margin();
    object["feed"] = feedJson(study.feed);
    object["statement"] = estimateText(report.scenario, study.feed);
    if (report.along) object["along"] = alongJson(*report.along);
    return Json(object).text();
}

std::vector<double> valuesOf(const SweepAxis& axis) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < axis.count; ++i) values.push_back(axis.value(i));
    return values;
}

std::string thrustCsv(const ThrustAlong& along) {
    const RowColumn column = along.axis.column();
    std::vector<std::string> headers{column.header};
    for (const char* end : {"", "_undamped"})
        for (const ThrustCase which : thrustCases) headers.push_back(std::string(name(which)) + end + " [N]");
    append(headers, {"effective_force [N]", "thrust_margin", "gap_at_blow [m]", "round_trips", "feed"});
    return csvText({headers, along.curve.points.size(), [&](std::size_t row) {
                        const ThrustPoint& point = along.curve.points[row];
                        Cells cells{column.cell(point.value)};
                        if (!point.reason.isEmpty()) return cells;
                        const auto addNeeds = [&](double ThrustNeed::*force) {
                            for (const ThrustNeed& need : point.feed.needs)
                                cells.push_back(need.known ? Cell(need.*force) : Cell());
                        };
                        addNeeds(&ThrustNeed::thrust);
                        addNeeds(&ThrustNeed::thrustUndamped);
                        const std::optional<GapAtBlow>& gap = point.need(ThrustCase::scenario).gapAtBlow;
                        const bool hasGap = gap && gap->motion.kind != UndampedMotion::Kind::pushedBack;
                        const std::optional<FeedState> state = point.feed.state();
                        append(cells,
                               {point.feed.effective(), point.feed.margin(), hasGap ? Cell(gap->gap) : Cell(),
                                point.feed.roundTrips, state ? Cell(name(*state)) : Cell()});
                        return cells;
                    }});
}

}  // namespace drillwave
