// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/drilling_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/contact/contact_law.h"
#include "core/report/alert_words.h"
#include "core/report/blow_csv.h"
#include "core/report/feed_json.h"
#include "core/report/feed_words.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/report/sequence_words.h"
#include "core/study/drilling/drilling_numbers.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

using enum DrillingMeasure;

/// Deviations below that, in units of Problem, are rounding.
constexpr double noSpread = 1e-9;

/// Without units a number of the groups.
Json valueOf(double ofProblem, DrillingMeasure measure, const DrillingResult& result, OutputUnits units) {
    return scaleOf(measure, result).value(ofProblem, units);
}

JsonObject spreadJson(const DrillingResult& result, std::size_t quantity, OutputUnits units) {
    const BlowSpread& spread = result.spread(quantity);
    const DrillingMeasure measure = blowQuantities[quantity].measure;
    const auto value = [&](double number) { return valueOf(number, measure, result, units); };
    const std::optional<double> error = result.meanError(quantity);
    return {{"mean", value(spread.mean)},
            {"mean_error", error ? value(*error) : Json()},
            {"deviation", value(spread.deviation)},
            {"q05", value(spread.q05)},
            {"q50", value(spread.q50)},
            {"q95", value(spread.q95)},
            {"least", value(spread.least)},
            {"largest", value(spread.largest)}};
}

/// Unit of values without physical units: "d0".
const char* multipleOf(DrillingMeasure measure) {
    switch (measure) {
        case count:
            return "1";
        case time:
            return "t0";
        case length:
            return "d0";
        case velocity:
            return "v0";
        case impulse:
            return "I0";
        case force:
            return "F0";
        case energy:
            return "W0";
    }
    return "";
}

JsonObject unitsJson(const DrillingResult& result, OutputUnits units) {
    const auto unit = [&](DrillingMeasure measure, const char* multiple) {
        if (units == OutputUnits::dimensionless) return Json(multiple);
        return unitJson(scaleOf(measure, result).quantity);
    };
    JsonObject object;
    for (const BlowQuantity& quantity : blowQuantities)
        object[quantity.name] = unit(quantity.measure, multipleOf(quantity.measure));
    object["contact_limit"] = unit(length, multipleOf(length));
    object["ledger"] = unit(energy, multipleOf(energy));
    object["penetration_rate"] = "m/s";
    object["feed"] = "N";
    object["blow_frequency_used"] = "Hz";
    return object;
}

JsonArray alertList(const std::vector<Alert>& alerts) {
    JsonArray array;
    for (const Alert& alert : alerts)
        array.emplace_back(
            JsonObject{{"level", alert.level == AlertLevel::warning ? "warning" : "information"},
                       {"code", name(alert.code)},
                       {"text", alertText(alert)}});
    return array;
}

Json statisticsJson(const DrillingResult& result, OutputUnits units) {
    if (!result.statistics) return Json();
    JsonObject object;
    for (std::size_t q = 0; q < blowQuantities.size(); ++q)
        object[blowQuantities[q].name] = spreadJson(result, q, units);
    return object;
}

}  // namespace

DrillingScale scaleOf(DrillingMeasure measure, const DrillingResult& result) {
    const DrillingUnits& units = result.units;
    const Scales& scales = result.scales;
    switch (measure) {
        case count:
            break;
        case time:
            return {Quantity::time, units.time, scales.time};
        case length:
            return {Quantity::length, units.length(), scales.penetration};
        case velocity:
            return {Quantity::velocity, units.velocity, scales.velocity};
        case impulse:
            return {Quantity::impulse, units.impulse(), scales.impulse};
        case force:
            return {Quantity::force, units.force, scales.force};
        case energy:
            return {Quantity::energy, units.energy(), scales.energy};
    }
    return {};
}

double withoutRounding(double spread) {
    return std::abs(spread) < noSpread ? 0 : spread;
}

Message motionWords(const DrillingResult& result) {
    const DrillingStatistics& statistics = *result.statistics;
    const auto motion = [&]() -> Message {
        if (statistics.regime == DrillingRegime::rest)
            return translatable("rod back at rest before every blow");
        if (statistics.regime != DrillingRegime::period) return translatable("irregular: use means only");
        if (statistics.period == 1) return translatable("repeats every blow");
        return {translatable("repeats every %1 blows"), {std::to_string(statistics.period)}};
    };
    if (!result.lyapunov || statistics.regime == DrillingRegime::irregular) return motion();
    const bool isUnstable = result.lyapunov->value > result.lyapunov->error.value_or(0);
    return isUnstable ? Message{translatable("%1, but a small disturbance grows"), {motion()}} : motion();
}

Message exponentWords(const DrillingResult& result, const ReadingStyle& style) {
    if (!result.lyapunov) return {};
    const std::string exponent = style.number(result.lyapunov->value, 3);
    if (!result.lyapunov->error) return {translatable("Lyapunov exponent %1 per blow"), {exponent}};
    return {translatable("Lyapunov exponent %1 +- %2 per blow"),
            {exponent, style.number(*result.lyapunov->error, 2)}};
}

Message regimeWords(const DrillingResult& result, const ReadingStyle& style) {
    const Message exponent = exponentWords(result, style);
    return exponent.isEmpty() ? motionWords(result) : Message{"%1; %2", {motionWords(result), exponent}};
}

std::vector<Message> drillingSentences(const DrillingReport& report, const ReadingStyle& style) {
    std::vector<Message> sentences{requiredFeedMessage(report.result.scenario, report.feed, style)};
    const bool isSaid = report.result.outcome == DrillingOutcome::pushedBack && report.feed &&
                        report.feed->state() == FeedState::pushedBack;
    if (!isSaid) std::ranges::move(sequenceSentences(report.result, style), std::back_inserter(sentences));
    return sentences;
}

std::string drillingJson(const DrillingReport& report, OutputUnits units) {
    const DrillingResult& result = report.result;
    const DrillingGroups& groups = result.groups;
    const auto number = [&](double value, DrillingMeasure measure) {
        return valueOf(value, measure, result, units);
    };
    JsonObject object = headJson({.scenario = result.scenario,
                                  .scenarioText = report.scenarioText,
                                  .units = unitsJson(result, units),
                                  .runTime = result.runTime});
    object["method"] = drillingMethod;
    object["outcome"] = name(result.outcome);
    object["reason"] =
        result.outcome == DrillingOutcome::done ? Json() : Json(whyNoStatistics(result).text());
    object["blows"] = result.settings.blows;
    object["settle"] = result.settings.settle;
    object["cells_per_duration"] = result.cellsPerDuration;
    object["blow_frequency_used"] = result.frequencyUsed;
    JsonObject groupObject = groupsJson(groups.blow);
    groupObject["phi"] = groups.phi;
    groupObject["round_trips"] = groups.roundTrips;
    groupObject["mu"] = groups.mu;
    groupObject["zeta"] = groups.zeta;
    groupObject["kappa"] = groups.kappa;
    groupObject["wave_loss"] = result.scenario.drill.waveLoss.value_or(0);
    object["groups"] = groupObject;
    object["statistics"] = statisticsJson(result, units);
    const auto ofStatistics = [&](const auto& value) { return result.statistics ? value() : Json(); };
    object["contact_share"] = ofStatistics([&] { return Json(result.statistics->contactShare); });
    object["contact_limit"] = number(contactLimit / lawUnitOfPenetration, length);
    object["regime"] = ofStatistics([&] { return Json(name(result.statistics->regime)); });
    object["period"] = ofStatistics([&] { return Json(result.statistics->period); });
    object["frac_gap"] = ofStatistics([&] {
        JsonArray counts;
        for (const int count : result.statistics->gapParts) counts.emplace_back(count);
        return Json(counts);
    });
    object["ks_distance"] = ofStatistics([&] { return Json(result.statistics->ksDistance); });
    object["ks_level"] = ofStatistics([&] { return Json(result.statistics->ksLevel); });
    object["lyapunov"] = result.lyapunov ? Json(result.lyapunov->value) : Json();
    object["lyapunov_error"] = result.lyapunov ? Json(result.lyapunov->error) : Json();
    object["penetration_rate"] = ofStatistics([&] {
        return Json(result.spread(quantityPlace(&DrillingBlow::penetration)).mean * result.units.length() *
                    result.frequencyUsed);
    });
    const DrillingLedger& ledger = result.ledger;
    const bool hasBlows = !result.blows.empty();
    const auto part = [&](double value) { return hasBlows ? number(value, energy) : Json(); };
    object["ledger"] = JsonObject{{"hammer", part(ledger.hammer)}, {"feed", part(ledger.feed)},
                                  {"rock", part(ledger.rock)},     {"damper", part(ledger.damper)},
                                  {"waves", part(ledger.waves)},   {"faces", part(ledger.faces)},
                                  {"stored", part(ledger.stored)}};
    object["momentum_residual"] = hasBlows ? Json(result.momentumResidual) : Json();
    object["energy_residual"] = hasBlows ? Json(result.energyResidual) : Json();
    object["feed"] = feedJson(report.feed);
    object["sequence"] = sequenceJson(result, units);
    object["statement"] = inOneParagraph(drillingSentences(report));
    object["alerts"] = alertList(result.alerts);
    return Json(object).text();
}

std::vector<std::string> drillingHeaders(const DrillingResult& result, OutputUnits units) {
    std::vector<std::string> headers;
    for (const BlowQuantity& column : blowColumns) {
        const Quantity quantity = scaleOf(column.measure, result).quantity;
        headers.push_back(withUnit(column.name, units == OutputUnits::si && column.measure != count
                                                    ? &unitsOf(quantity).front()
                                                    : nullptr));
    }
    return headers;
}

std::string drillingCsv(const DrillingReport& report, OutputUnits units) {
    const DrillingResult& result = report.result;
    std::vector<std::string> headers{"blow"};
    append(headers, drillingHeaders(result, units));
    return scenarioHeader(report.scenarioText) +
           csvText(
               {headers, result.blows.size(), [&](std::size_t row) {
                    Cells cells{row + 1};
                    for (const BlowQuantity& column : blowColumns)
                        cells.push_back(
                            scaleOf(column.measure, result).value(result.blows[row].*column.value, units));
                    return cells;
                }});
}

std::string drillingHistoriesCsv(const DrillingReport& report, OutputUnits units) {
    struct Column {
        std::string_view name;
        DrillingMeasure measure;
        double DrillingInstant::*value;
    };
    static constexpr Column columns[] = {{"time", time, &DrillingInstant::time},
                                         {"impact_force", force, &DrillingInstant::force},
                                         {"penetration", length, &DrillingInstant::penetration},
                                         {"front_velocity", velocity, &DrillingInstant::frontVelocity},
                                         {"rear_velocity", velocity, &DrillingInstant::rearVelocity},
                                         {"damper_force", force, &DrillingInstant::damperForce},
                                         {"machine_place", length, &DrillingInstant::bodyPlace}};
    const DrillingResult& result = report.result;
    std::vector<std::string> headers;
    for (const Column& column : columns)
        headers.push_back(withUnit(
            column.name,
            units == OutputUnits::si ? &unitsOf(scaleOf(column.measure, result).quantity).front() : nullptr));
    return scenarioHeader(report.scenarioText) +
           csvText(
               {headers, result.instants.size(), [&](std::size_t row) {
                    Cells cells;
                    for (const Column& column : columns)
                        cells.push_back(
                            scaleOf(column.measure, result).value(result.instants[row].*column.value, units));
                    return cells;
                }});
}

}  // namespace drillwave
