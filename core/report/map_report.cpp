// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/map_report.h"

#include "core/model/version.h"
#include "core/report/json_value.h"
#include "core/report/report_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

constexpr int mapDigits = 6;

/// The output in its units, for people.
std::string outputText(const OutputColumn& column, double value) {
    return column.hasUnit() ? inHandyUnit(value, column.output->quantity(), mapDigits)
                            : rounded(value, mapDigits);
}

std::string placeText(const MapReport& report, const MapGrid::Place& place) {
    const auto valueText = [](const SweepAxis& axis, double value) {
        return std::string(axis.key()) + " = " + inHandyUnit(value, axis.parameter->quantity, mapDigits);
    };
    return valueText(report.study.x, report.grid.xs()[place.column]) + ", " +
           valueText(report.study.y, report.grid.ys()[place.row]);
}

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void addRange(const MapReport& report, TextGrid& table) {
    const std::optional<MapGrid::Extent>& extent = report.grid.extent();
    if (!extent) return;
    const auto add = [&](const char* label, double value, const MapGrid::Place& place) {
        table.add({label, outputText(report.study.output, value), "at " + placeText(report, place)});
    };
    add("smallest", extent->least, extent->leastPlace);
    add("largest", extent->largest, extent->largestPlace);
}

std::string contourText(const MapReport& report, const Contour& contour) {
    std::string text = "  " + std::string(report.study.output.output->name) + " = " +
                       outputText(report.study.output, contour.level) + ": ";
    if (contour.lines.empty()) {
        text += "nowhere between the points";
    } else {
        text += counted(contour.pointCount(), "point") + " on " + counted(contour.lines.size(), "line") +
                ", within " + boundText(contour.worstResidual());
        if (report.study.output.hasUnit())
            text += " " + std::string(unitsOf(report.study.output.output->quantity()).front().name);
        if (const std::uint64_t jumps = contour.jumpCount(); jumps > 0)
            text += ", but for " + std::to_string(jumps) + " where it jumps across";
        if (const std::uint64_t irregular = contour.irregularCount(); irregular > 0)
            text += "; " + counted(irregular, "point") +
                    " where the blows do not repeat: a mean scatters there, and the contour with it";
    }
    if (contour.unplaced > 0)
        text += "; " + counted(contour.unplaced, "crossing") + " not placed: " + contour.reason;
    return text + "\n";
}

JsonObject axisJson(const SweepAxis& axis) {
    return {{"parameter", axis.key()}, {"unit", unitJson(axis.parameter->quantity)},
            {"start", axis.start},     {"stop", axis.stop},
            {"count", axis.count},     {"logarithmic", axis.kind == SweepAxis::Kind::logarithmic}};
}

Json rangeJson(const MapReport& report) {
    const std::optional<MapGrid::Extent>& extent = report.grid.extent();
    if (!extent) return {};
    const auto json = [&](double value, const MapGrid::Place& place) {
        return JsonObject{
            {"value", value}, {"x", report.grid.xs()[place.column]}, {"y", report.grid.ys()[place.row]}};
    };
    return JsonObject{{"min", json(extent->least, extent->leastPlace)},
                      {"max", json(extent->largest, extent->largestPlace)}};
}

JsonArray unsolvedJson(const MapGrid& grid) {
    JsonArray array;
    for (const RowFailure& failure : grid.failures())
        array.emplace_back(JsonObject{{"points", failure.rows}, {"reason", failure.reason}});
    return array;
}

JsonObject lineJson(const ContourLine& line) {
    JsonArray x, y, residual, jump;
    for (const ContourPoint& point : line) {
        x.emplace_back(point.x);
        y.emplace_back(point.y);
        residual.emplace_back(point.residual);
        jump.emplace_back(point.jumpWidth);
    }
    return {{"x", x}, {"y", y}, {"residual", residual}, {"jump_width", jump}};
}

JsonObject contourJson(const Contour& contour, bool isOfManyBlows) {
    JsonArray lines;
    for (const ContourLine& line : contour.lines) lines.emplace_back(lineJson(line));
    JsonObject object{{"level", contour.level},       {"points", contour.pointCount()},
                      {"jumps", contour.jumpCount()}, {"worst_residual", contour.worstResidual()},
                      {"unplaced", contour.unplaced}, {"reason", contour.reason},
                      {"solves", contour.solves},     {"lines", lines}};
    if (isOfManyBlows) object["irregular"] = contour.irregularCount();
    return object;
}

}  // namespace

std::string axisText(const SweepAxis& axis) {
    const auto value = [&](double si) { return inHandyUnit(si, axis.parameter->quantity, mapDigits); };
    return std::string(axis.key()) + " = " + value(axis.start) + " to " + value(axis.stop) + ", " +
           counted(axis.count, "value") + (axis.kind == SweepAxis::Kind::logarithmic ? ", log" : "");
}

std::string mapText(const MapReport& report) {
    const MapStudy& study = report.study;
    std::uint64_t blows = report.grid.size();
    for (const Contour& contour : report.contours) blows += contour.solves;
    std::string text = headingOf(study.base) + "\n  " + study.output.header() + " over " + axisText(study.x) +
                       "; " + axisText(study.y) + "\n\n";
    TextGrid table(CellAlignment::left);
    addRange(report, table);
    text += table.text();
    for (const RowFailure& failure : report.grid.failures())
        text += "  " + counted(failure.rows, "point") + " not solved: " + failure.reason + "\n";
    for (const Contour& contour : report.contours) text += contourText(report, contour);
    return text + "  " + counted(blows, "blow") + " in " + inHandyUnit(report.runTime, Quantity::time, 3) +
           ".\n";
}

std::string mapJson(const MapReport& report) {
    JsonArray contours;
    const OutputColumn& output = report.study.output;
    for (const Contour& contour : report.contours)
        contours.emplace_back(contourJson(contour, output.output->needsDrilling()));
    return Json(JsonObject{{"version", versionText},
                           {"title", report.study.base.title},
                           {"scenario", report.scenarioText},
                           {"output", output.output->name},
                           {"unit", unitJson(output.hasUnit() ? output.output->quantity() : Quantity::ratio)},
                           {"x", axisJson(report.study.x)},
                           {"y", axisJson(report.study.y)},
                           {"points", report.grid.size()},
                           {"range", rangeJson(report)},
                           {"unsolved", unsolvedJson(report.grid)},
                           {"contours", contours},
                           {"run_time", report.runTime}})
        .text();
}

std::string contoursCsv(const MapReport& report) {
    const RowColumn x = report.study.x.column(), y = report.study.y.column();
    std::string csv = std::string(contoursCsvBegin) + x.header + "," + y.header + "," +
                      report.study.output.header() + ",residual,jump_width\n";
    std::uint64_t number = 0;
    for (const Contour& contour : report.contours)
        for (const ContourLine& line : contour.lines) {
            ++number;
            for (const ContourPoint& point : line) {
                appendNumber(csv, contour.level);
                csv += "," + std::to_string(number) + ",";
                x.appendText(csv, point.x);
                csv += ',';
                y.appendText(csv, point.y);
                for (const double value : {point.value, point.residual}) {
                    csv += ',';
                    appendNumber(csv, value);
                }
                csv += ',';
                if (point.isJump()) appendNumber(csv, point.jumpWidth);
                csv += '\n';
            }
        }
    return csv;
}

}  // namespace drillwave
