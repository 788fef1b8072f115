// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/drilling_scan_report.h"

#include <algorithm>
#include <optional>

#include "core/report/blow_csv.h"
#include "core/report/curve_text.h"
#include "core/report/feed_json.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/report/sequence_words.h"
#include "core/study/drilling/drilling_numbers.h"
#include "core/text/handy_text.h"
#include "core/text/units.h"

namespace drillwave {

namespace {

constexpr std::size_t gapPlace = quantityPlace(&DrillingBlow::gap);
constexpr std::size_t penetrationPlace = quantityPlace(&DrillingBlow::penetration);

/// Returns the values of one point, one for each column.
std::vector<std::optional<double>> valuesOf(const std::vector<OutputColumn>& columns,
                                            const DrillingResult& result) {
    const DrillNumbers numbers = drillNumbersOf(result);
    const ImpactSummary emptySummary;
    std::vector<std::optional<double>> values;
    for (const OutputColumn& column : columns)
        values.push_back(column.value({emptySummary, result.scenario, {}, &numbers}, result.scales));
    return values;
}

/// Whether the damper is another one at every value.
bool isOfDamper(const SweepAxis& axis) {
    const std::string_view key = axis.key();
    return key == "drill.machine_mass" || key == "drill.damper_damping" || key == "drill.damper_stiffness";
}

constexpr int scanDigits = 4;  ///< of the values of the parameter

/// In files, and for people in their language.
const char* nameOf(DrillingStart start) {
    return start == DrillingStart::rest ? translatable("rest") : translatable("bouncing");
}

Message motionWord(const DrillingStatistics& statistics) {
    if (statistics.period > 0) return {translatable("period %1"), {std::to_string(statistics.period)}};
    return translatable("irregular");
}

std::string scanTable(const DrillingScan& scan, OutputUnits units, const ReadingStyle& style) {
    TextGrid grid;
    const auto title = [&](const char* english) { return style.said(english); };
    grid.add({std::string(scan.axis.key()), title(translatable("start")), "phi", title(translatable("gap")),
              "5 %", "95 %", title(translatable("penetration")), "+-", title(translatable("contact")),
              title(translatable("motion"))});
    for (const DrillingScanPoint& point : scan.points) {
        const DrillingResult& result = point.result;
        std::vector<std::string> cells{valueText(scan.axis, point.value, scanDigits, style),
                                       style.said(nameOf(point.start)), style.number(result.groups.phi, 4)};
        if (!result.statistics) {
            cells.insert(cells.end(), 6, "");
            cells.push_back(style.said(Message::ofTable(name(result.outcome))));
            grid.add(cells);
            continue;
        }
        const auto formatted = [&](double number, int digits) {
            const double shown = scaleOf(DrillingMeasure::length, result).value(number, units);
            return units == OutputUnits::si ? style.quantity(shown, Quantity::length, digits)
                                            : style.number(shown, digits);
        };
        const BlowSpread &gaps = result.spread(gapPlace), &depths = result.spread(penetrationPlace);
        const std::optional<double> error = result.meanError(penetrationPlace);
        cells.insert(cells.end(),
                     {formatted(gaps.mean, 4), formatted(gaps.q05, 3), formatted(gaps.q95, 3),
                      formatted(depths.mean, 4), error ? formatted(withoutRounding(*error), 2) : "",
                      style.number(100 * result.statistics->contactShare, 3) + " %",
                      style.said(motionWord(*result.statistics))});
        grid.add(cells);
    }
    return grid.text();
}

/// The sequence of the scan at the value of the scenario itself; nothing where that is none of the values.
std::optional<Sequence> sequenceAtBase(const DrillingScan& scan) {
    const KeptParameter& parameter = scan.axis.parameter;
    if (!parameter || !parameter->applies(scan.base)) return std::nullopt;
    const std::optional<double> own = parameter->value(scan.base);
    for (const DrillingScanPoint& point : scan.points)
        if (own == point.value && point.start == DrillingStart::rest) return sequenceOf(point.result);
    return std::nullopt;
}

Message blowsAtEachValue(const DrillingScan& scan, const ReadingStyle& style) {
    const std::string blows = std::to_string(scan.settings.blows - scan.settings.settle);
    if (isOfDamper(scan.axis)) return {translatable("%1 blows at each value"), {blows}};
    return {translatable("with %1, %2 blows at each value"), {feedModelWords(scan.base, style), blows}};
}

}  // namespace

std::vector<OutputColumn> drillingScanColumns(OutputUnits units) {
    std::vector<OutputColumn> columns;
    for (const Output& output : drillOutputs()) columns.push_back({&output, units});
    return columns;
}

std::string drillingScanCsv(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    const std::vector<OutputColumn> columns = drillingScanColumns(units);
    const RowColumn axis = scan.axis.column();
    std::vector<std::string> headers{axis.header, "start"};
    for (const OutputColumn& column : columns) headers.push_back(column.header());
    return scenarioHeader(report.scenarioText) +
           csvText({headers, scan.points.size(), [&](std::size_t row) {
                        const DrillingScanPoint& point = scan.points[row];
                        Cells cells{axis.cell(point.value), nameOf(point.start)};
                        for (const std::optional<double>& value : valuesOf(columns, point.result))
                            cells.push_back(value);
                        return cells;
                    }});
}

std::string drillingGapsCsv(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    const RowColumn axis = scan.axis.column();
    const Unit* unit = units == OutputUnits::si ? &unitsOf(Quantity::length).front() : nullptr;
    std::vector<std::pair<const DrillingScanPoint*, std::size_t>> blows;
    for (const DrillingScanPoint& point : scan.points)
        if (point.result.statistics)
            for (auto i = static_cast<std::size_t>(scan.settings.settle); i < point.result.blows.size(); ++i)
                blows.emplace_back(&point, i);
    return scenarioHeader(report.scenarioText) +
           csvText({{axis.header, "start", withUnit("gap", unit)}, blows.size(), [&](std::size_t row) {
                        const auto& [point, blow] = blows[row];
                        return Cells{axis.cell(point->value), nameOf(point->start),
                                     scaleOf(DrillingMeasure::length, point->result)
                                         .value(point->result.blows[blow].gap, units)};
                    }});
}

std::string drillingScanText(const DrillingScanReport& report, OutputUnits units, const ReadingStyle& style) {
    const DrillingScan& scan = report.scan;
    std::string text = headingOf(scan.base, style) + "\n  " + style.said(blowsAtEachValue(scan, style)) +
                       "\n\n" + scanTable(scan, units, style);
    text += "\n";
    const std::optional<Sequence> present = sequenceAtBase(scan);
    for (const Message& sentence : scanSentences(scan, present, style))
        text += paragraph(style.said(sentence));
    return text + paragraph(style.said(
                      translatable("+- is the 95 % error: the scatter of the blows plus three times the "
                                   "change with half or twice the time step. Penetrations are upper limits: "
                                   "all rock under the bit breaks and cuttings are removed.")));
}

std::string drillingScanJson(const DrillingScanReport& report, OutputUnits units) {
    const DrillingScan& scan = report.scan;
    const std::vector<OutputColumn> columns = drillingScanColumns(units);
    const std::optional<ScanComparison> comparison = compareScan(scan);
    JsonArray rows;
    for (const DrillingScanPoint& point : scan.points) {
        JsonObject row{
            {"value", point.value},
            {"start", nameOf(point.start)},
            {"outcome", name(point.result.outcome)},
            {"sequence", sequenceJson(point.result, OutputUnits::si, comparison ? &*comparison : nullptr)}};
        const std::vector<std::optional<double>> values = valuesOf(columns, point.result);
        for (std::size_t i = 0; i < columns.size(); ++i)
            row[columns[i].output->name] = values[i] ? Json(*values[i]) : Json();
        rows.emplace_back(row);
    }
    JsonObject unitNames;
    if (scan.axis.parameter) unitNames[scan.axis.key()] = unitJson(scan.axis.parameter->quantity);
    for (const OutputColumn& column : columns) unitNames[column.output->name] = unitJson(column.quantity());
    JsonObject object = headJson({.scenario = scan.base,
                                  .scenarioText = report.scenarioText,
                                  .units = unitNames,
                                  .runTime = scan.runTime});
    object["method"] = drillingMethod;
    object["key"] = scan.axis.key();
    object["blows"] = scan.settings.blows;
    object["settle"] = scan.settings.settle;
    object["best_at"] = comparison && comparison->isResolved() ? Json(comparison->best().at) : Json();
    object["resolved"] = comparison && comparison->isResolved();
    object["unresolved_reason"] = comparison && comparison->unresolved
                                      ? Json(name(*comparison->unresolved->sequence.unresolved))
                                      : Json();
    const std::optional<Sequence> present = sequenceAtBase(scan);
    object["statement"] = inOneParagraph(scanSentences(scan, present));
    object["rows"] = rows;
    return Json(object).text();
}

}  // namespace drillwave
