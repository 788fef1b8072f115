// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/drilling_scan_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/version.h"
#include "core/report/blow_csv.h"
#include "core/report/report_text.h"
#include "core/text/json.h"
#include "core/text/number_text.h"
#include "core/text/unit_heading.h"

namespace drillwave {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// Of blowQuantities.
enum Place : std::size_t {
    gap,
    velocityPlace,
    rockImpulse,
    penetration,
    peakForce,
    contactTime,
    contacts,
    damper
};

template <std::size_t quantity, double BlowSpread::*number>
double ofSpread(const DrillingResult& result) {
    return result.statistics ? result.spread(quantity).*number : noNumber;
}

template <double DrillingStatistics::*number>
double ofStatistics(const DrillingResult& result) {
    return result.statistics ? (*result.statistics).*number : noNumber;
}

double rate(const DrillingResult& result) {
    return ofSpread<penetration, &BlowSpread::mean>(result) * result.units.length() * result.frequencyUsed;
}

using enum DrillingMeasure;
constexpr DrillingOutput outputTable[] = {
    {"drill_gap_mean", "mean gap at the blow", length, false, ofSpread<gap, &BlowSpread::mean>},
    {"drill_gap_deviation", "standard deviation of the gap", length, false,
     ofSpread<gap, &BlowSpread::deviation>},
    {"drill_gap_05", "5 % quantile of the gap", length, false, ofSpread<gap, &BlowSpread::q05>},
    {"drill_gap_50", "median of the gap", length, false, ofSpread<gap, &BlowSpread::q50>},
    {"drill_gap_95", "95 % quantile of the gap", length, false, ofSpread<gap, &BlowSpread::q95>},
    {"drill_penetration", "mean penetration of a blow, an upper limit", length, false,
     ofSpread<penetration, &BlowSpread::mean>},
    {"drill_penetration_error", "its 95 % error", length, false,
     [](const DrillingResult& result) {
         return result.statistics ? result.meanError(penetration).value_or(noNumber) : noNumber;
     }},
    {"drill_penetration_rate", "penetration times frequency, an upper limit", length, true, rate},
    {"drill_rock_impulse", "mean impulse of the rock", impulse, false,
     ofSpread<rockImpulse, &BlowSpread::mean>},
    {"drill_peak_force", "mean of the largest forces of the rock", force, false,
     ofSpread<peakForce, &BlowSpread::mean>},
    {"drill_damper_force", "largest force of the damper", force, false,
     ofSpread<damper, &BlowSpread::largest>},
    {"drill_contact_share", "blows that begin within 0.01 d0 of the rock", count, false,
     ofStatistics<&DrillingStatistics::contactShare>},
    {"drill_contacts", "contacts of a blow", count, false, ofSpread<contacts, &BlowSpread::mean>},
    {"drill_period", "blows after which the motion repeats, 0 where it does not", count, false,
     [](const DrillingResult& result) {
         return result.statistics ? static_cast<double>(result.statistics->period) : noNumber;
     }},
    {"drill_thrust_number", "phi, thrust over mean reaction", count, false,
     [](const DrillingResult& result) { return result.groups.phi; }},
    {"drill_round_trips", "n_b, round trips of a wave from blow to blow", count, false,
     [](const DrillingResult& result) { return result.groups.roundTrips; }},
    {"drill_momentum_residual", "of the whole march, over what the feed gave", count, false,
     [](const DrillingResult& result) { return result.momentumResidual; }},
    {"drill_energy_residual", "of the whole march, over the hammer work", count, false,
     [](const DrillingResult& result) { return result.energyResidual; }},
};

/// A rate has no multiple.
bool isTold(const DrillingOutput& output, OutputUnits units) {
    return !output.isRate || units == OutputUnits::si;
}

double valueOf(const DrillingOutput& output, const DrillingResult& result, OutputUnits units) {
    const double value = output.value(result);
    return output.isRate ? value : scaleOf(output.measure, result).value(value, units);
}

const Unit* unitOf(const DrillingOutput& output, const DrillingResult& result, OutputUnits units) {
    if (units != OutputUnits::si || output.measure == count) return nullptr;
    return &unitsOf(output.isRate ? Quantity::velocity : scaleOf(output.measure, result).quantity).front();
}

const char* nameOf(DrillingStart start) {
    return start == DrillingStart::rest ? "rest" : "bouncing";
}

}  // namespace

std::span<const DrillingOutput> drillingOutputs() {
    return outputTable;
}

std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    const DrillingResult& any = scan.points.front().result;
    const RowColumn axis = scan.axis.column();
    std::string csv = scenarioHeader(report.scenarioText) + axis.header + ",start";
    for (const DrillingOutput& output : outputTable)
        if (isTold(output, units)) csv += "," + withUnit(output.name, unitOf(output, any, units));
    csv += "\n";
    for (const DrillingScanPoint& point : scan.points) {
        axis.appendText(csv, point.value);
        csv += std::string(",") + nameOf(point.start);
        for (const DrillingOutput& output : outputTable) {
            if (!isTold(output, units)) continue;
            csv += ',';
            const double value = valueOf(output, point.result, units);
            if (std::isfinite(value)) appendNumber(csv, value);
        }
        csv += '\n';
    }
    return csv;
}

std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    const RowColumn axis = scan.axis.column();
    const Unit* unit = units == OutputUnits::si ? &unitsOf(Quantity::length).front() : nullptr;
    std::string csv =
        scenarioHeader(report.scenarioText) + axis.header + ",start," + withUnit("gap", unit) + "\n";
    for (const DrillingScanPoint& point : scan.points) {
        if (!point.result.statistics) continue;
        const auto settle = static_cast<std::size_t>(scan.settings.settle);
        for (std::size_t i = settle; i < point.result.blows.size(); ++i) {
            axis.appendText(csv, point.value);
            csv += std::string(",") + nameOf(point.start) + ",";
            appendNumber(csv, scaleOf(length, point.result).value(point.result.blows[i].gap, units));
            csv += '\n';
        }
    }
    return csv;
}

std::string drillingScanText(const DrillingScanReport& report, OutputUnits units, const ReadingStyle& style) {
    const DrillingScan& scan = report.scan;
    std::string text = headingOf(scan.base);
    text += "\n  " + damperWords(scan.base, style) + ", " +
            std::to_string(scan.settings.blows - scan.settings.settle) + " blows at each value\n\n";
    TextGrid grid;
    grid.add({std::string(scan.axis.key()), "start", "phi", "gap", "5 %", "95 %", "penetration", "+-",
              "contact", "motion"});
    for (const DrillingScanPoint& point : scan.points) {
        const DrillingResult& result = point.result;
        std::string value;
        scan.axis.column().appendText(value, point.value);
        if (scan.axis.parameter && scan.axis.unit && !scan.axis.unit->name.empty())
            value += " " + std::string(scan.axis.unit->name);
        if (!result.statistics) {
            grid.add({value, nameOf(point.start), style.number(result.groups.phi, 4), "", "", "", "", "", "",
                      std::string(name(result.outcome))});
            continue;
        }
        const auto told = [&](double number, int digits) {
            const double shown = scaleOf(length, result).value(number, units);
            return units == OutputUnits::si ? style.quantity(shown, Quantity::length, digits)
                                            : style.number(shown, digits);
        };
        const BlowSpread &gaps = result.spread(gap), &depths = result.spread(penetration);
        const std::optional<double> error = result.meanError(penetration);
        grid.add({value, nameOf(point.start), style.number(result.groups.phi, 4), told(gaps.mean, 4),
                  told(gaps.q05, 3), told(gaps.q95, 3), told(depths.mean, 4), error ? told(*error, 2) : "",
                  style.number(100 * result.statistics->contactShare, 3) + " %",
                  result.statistics->period > 0 ? "period " + std::to_string(result.statistics->period)
                                                : "irregular"});
    }
    text += grid.text();
    text += "\n" + paragraph(
                       "Penetrations are upper limits: all rock under the bit gives way and cuttings vanish. "
                       "There is no over-feed side: friction, rotation and buckling are not in the model.");
    return text;
}

std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    JsonArray rows;
    for (const DrillingScanPoint& point : scan.points) {
        JsonObject row{{"value", point.value},
                       {"start", nameOf(point.start)},
                       {"outcome", name(point.result.outcome)},
                       {"verdict", verdictSentence(point.result)}};
        for (const DrillingOutput& output : outputTable)
            if (isTold(output, units)) row[output.name] = valueOf(output, point.result, units);
        rows.emplace_back(row);
    }
    return Json(JsonObject{{"version", versionText},
                           {"title", scan.base.title},
                           {"method", "cells"},
                           {"key", scan.axis.key()},
                           {"blows", scan.settings.blows},
                           {"settle", scan.settings.settle},
                           {"run_time", scan.runTime},
                           {"rows", rows},
                           {"scenario", report.scenarioText}})
        .text();
}

}  // namespace drillwave
