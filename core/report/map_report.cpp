// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/map_report.h"

#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

constexpr int mapDigits = 6;

/// The output in its units, for people.
std::string outputText(const OutputColumn& column, double value, const ReadingStyle& style) {
    return column.hasUnit() ? style.quantity(value, column.output->quantity(), mapDigits)
                            : style.number(value, mapDigits);
}

std::string placeText(const MapReport& report, const MapGrid::Place& place, const ReadingStyle& style) {
    const auto valueText = [&](const SweepAxis& axis, double value) {
        return std::string(axis.key()) + " = " + style.quantity(value, axis.parameter->quantity, mapDigits);
    };
    return valueText(report.study.x, report.grid.xs()[place.column]) + ", " +
           valueText(report.study.y, report.grid.ys()[place.row]);
}

Message points(std::uint64_t count) {
    return counted(count, translatable("%1 point"), translatable("%1 points"));
}

void addRange(const MapReport& report, TextGrid& table, const ReadingStyle& style) {
    const std::optional<MapGrid::Extent>& extent = report.grid.extent();
    if (!extent) return;
    const auto add = [&](const char* label, double value, const MapGrid::Place& place) {
        table.add({style.said(label), outputText(report.study.output, value, style),
                   style.said({translatable("at %1"), {placeText(report, place, style)}})});
    };
    add(translatable("smallest"), extent->least, extent->leastPlace);
    add(translatable("largest"), extent->largest, extent->largestPlace);
}

/// How many points of a contour are how near.
Message linesMessage(const MapReport& report, const Contour& contour, const ReadingStyle& style) {
    if (contour.lines.empty()) return translatable("nowhere between the points");
    std::string within = style.bound(contour.worstResidual());
    if (report.study.output.hasUnit())
        within += " " + std::string(unitsOf(report.study.output.quantity()).front().name);
    Message message{
        translatable("%1 on %2, within %3"),
        {points(contour.pointCount()),
         counted(contour.lines.size(), translatable("%1 line"), translatable("%1 lines")), within}};
    if (const std::uint64_t jumps = contour.jumpCount(); jumps > 0)
        message = {translatable("%1, except %2 where it jumps across"), {message, std::to_string(jumps)}};
    if (const std::uint64_t irregular = contour.irregularCount(); irregular > 0)
        message = {translatable("%1; %2 where the blows do not repeat: a mean scatters there, and the "
                                "contour with it"),
                   {message, points(irregular)}};
    return message;
}

/// The lowest and the highest point of a contour; empty without one.
std::string extentText(const MapReport& report, const Contour& contour, const ReadingStyle& style) {
    const std::optional<ContourExtent> extent = extentOf(contour);
    if (!extent) return {};
    const auto shown = [&](const SweepAxis& axis, double value) {
        return style.quantity(value, axis.parameter->quantity, mapDigits);
    };
    const SweepAxis &x = report.study.x, &y = report.study.y;
    return "    " +
           style.said(
               {translatable("lowest %1 = %2 at %3 = %4; highest %1 = %5 at %3 = %6"),
                {std::string(y.key()), shown(y, extent->lowest.y), std::string(x.key()),
                 shown(x, extent->lowest.x), shown(y, extent->highest.y), shown(x, extent->highest.x)}}) +
           "\n";
}

std::string contourText(const MapReport& report, const Contour& contour, const ReadingStyle& style) {
    Message message{
        "%1 = %2: %3",
        {std::string(report.study.output.output->name), outputText(report.study.output, contour.level, style),
         linesMessage(report, contour, style)}};
    if (contour.unplaced > 0)
        message = {contour.unplaced == 1 ? translatable("%1; %2 crossing not placed: %3")
                                         : translatable("%1; %2 crossings not placed: %3"),
                   {message, std::to_string(contour.unplaced), contour.reason}};
    return "  " + style.said(message) + "\n" + extentText(report, contour, style);
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
        array.emplace_back(JsonObject{{"points", failure.rows}, {"reason", failure.reason.text()}});
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
                      {"unplaced", contour.unplaced}, {"reason", contour.reason.text()},
                      {"solves", contour.solves},     {"lines", lines}};
    if (isOfManyBlows) object["irregular"] = contour.irregularCount();
    return object;
}

}  // namespace

std::string axisText(const SweepAxis& axis, const ReadingStyle& style) {
    const auto value = [&](double si) { return style.quantity(si, axis.parameter->quantity, mapDigits); };
    const Message values = counted(axis.count, translatable("%1 value"), translatable("%1 values"));
    return style.said({axis.kind == SweepAxis::Kind::logarithmic ? translatable("%1 = %2 to %3, %4, log")
                                                                 : translatable("%1 = %2 to %3, %4"),
                       {std::string(axis.key()), value(axis.start), value(axis.stop), values}});
}

std::string mapText(const MapReport& report, const ReadingStyle& style) {
    const MapStudy& study = report.study;
    std::uint64_t solved = report.grid.size();
    for (const Contour& contour : report.contours) solved += contour.solves;
    // a point of drill_… takes many blows
    const bool hasSequences = study.output.output->needsDrilling();
    const char* solvedIn =
        hasSequences ? (solved == 1 ? translatable("%1 point in %2.") : translatable("%1 points in %2."))
                     : (solved == 1 ? translatable("%1 blow in %2.") : translatable("%1 blows in %2."));
    std::string text =
        headingOf(study.base, style) + "\n  " +
        style.said({translatable("%1 over %2; %3"),
                    {study.output.header(), axisText(study.x, style), axisText(study.y, style)}}) +
        "\n\n";
    TextGrid table(CellAlignment::left);
    addRange(report, table, style);
    text += table.text();
    for (const RowFailure& failure : report.grid.failures())
        text += "  " +
                style.said({translatable("%1 not solved: %2"), {points(failure.rows), failure.reason}}) +
                "\n";
    for (const Contour& contour : report.contours) text += contourText(report, contour, style);
    return text + "  " +
           style.said(
               {solvedIn, {std::to_string(solved), style.quantity(report.runTime, Quantity::time, 3)}}) +
           "\n";
}

std::string mapJson(const MapReport& report) {
    JsonArray contours;
    const OutputColumn& output = report.study.output;
    for (const Contour& contour : report.contours)
        contours.emplace_back(contourJson(contour, output.output->needsDrilling()));
    const MapStudy& study = report.study;
    JsonObject object = headJson({.scenario = study.base,
                                  .scenarioText = report.scenarioText,
                                  .method = study.method,
                                  .units = {{study.x.key(), unitJson(study.x.parameter->quantity)},
                                            {study.y.key(), unitJson(study.y.parameter->quantity)},
                                            {output.output->name, unitJson(output.quantity())}},
                                  .runTime = report.runTime});
    object["output"] = output.output->name;
    object["unit"] = unitJson(output.quantity());
    object["x"] = axisJson(study.x);
    object["y"] = axisJson(study.y);
    object["points"] = report.grid.size();
    object["range"] = rangeJson(report);
    object["unsolved"] = unsolvedJson(report.grid);
    object["contours"] = contours;
    return Json(object).text();
}

std::string contoursCsv(const MapReport& report) {
    const RowColumn x = report.study.x.column(), y = report.study.y.column();
    struct Place {
        double level;
        std::uint64_t line;
        const ContourPoint* point;
    };
    std::vector<Place> places;
    std::uint64_t number = 0;
    for (const Contour& contour : report.contours)
        for (const ContourLine& line : contour.lines) {
            ++number;
            for (const ContourPoint& point : line) places.push_back({contour.level, number, &point});
        }
    std::vector<std::string> headers{"level", "line"};  // contoursCsvBegin
    append(headers, {x.header, y.header, report.study.output.header(), "residual", "jump_width"});
    return csvText({headers, places.size(), [&](std::size_t row) {
                        const auto& [level, line, point] = places[row];
                        return Cells{level,
                                     line,
                                     x.cell(point->x),
                                     y.cell(point->y),
                                     point->value,
                                     point->residual,
                                     point->isJump() ? Cell(point->jumpWidth) : Cell()};
                    }});
}

}  // namespace drillwave
