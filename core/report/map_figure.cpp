// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/map_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/assignments.h"
#include "core/model/preset_places.h"
#include "core/model/scales.h"
#include "core/report/output_words.h"
#include "core/report/parameter_words.h"
#include "core/text/handy_text.h"
#include "core/text/printed_text.h"

namespace drillwave {
namespace {

constexpr int shownDigits = 5, levelDigits = 4;
constexpr double sectionShare = 0.28;       // width of a section, relative to the map
constexpr double sectionHeightShare = 0.5;  // so that its axis title fits

/// Level of an output on whose two sides the colours differ.
std::optional<double> decisiveLevel(const Output& output) {
    if (output.name == "cor") return 1;
    if (output.name == "thrust_margin") return 0;
    return std::nullopt;
}

FigureAxis axisOf(const SweepAxis& axis) {
    return {.quantity = axis.parameter, .isLogarithmic = axis.isLogarithmic(), .range = axis.range()};
}

FigureNumber named(const Parameter& parameter) {
    return {.words = titleMessage(parameter, printedWords(parameter.symbol))};
}

FigureNumber valueOf(const SweepAxis& axis, double value, int digits = shownDigits) {
    return {value, axis.parameter, digits};
}

/// A value of the output in SI, shown in the unit of the map.
FigureNumber valueOf(const MapOutput& output, double value, int digits) {
    return {value * output.perValue, output.axis.quantity, digits};
}

/// Points of the map rarely are where the scenario is: their values must not be taken for those of it.
FigureText titleOf(const SweepAxis& axis, double value, bool isHere) {
    constexpr int roughDigits = 3;
    return isHere ? FigureText{"%1 = %2", {named(*axis.parameter), valueOf(axis, value)}}
                  : FigureText{translatable("at %1 ≈ %2"),
                               {named(*axis.parameter), valueOf(axis, value, roughDigits)}};
}

/// Names of neighbours are on different sides.
void addPresets(StudyPanel& panel, const MapStudy& study, std::span<const Preset> presets) {
    FigureSeries sides[] = {{.points = SeriesPoints::squares},
                            {.points = SeriesPoints::squares, .textSide = TextSide::below}};
    bool isBelow = true;
    for (const PresetPoint& preset :
         presetPoints(presets, *study.x.parameter, *study.y.parameter, study.base)) {
        FigureSeries& series = sides[isBelow];
        series.x.push_back(preset.x);
        series.y.push_back(preset.y);
        series.texts.push_back({"%1", {{.words = preset.name}}});
        isBelow = !isBelow;
    }
    for (FigureSeries& series : sides) panel.series.push_back(std::move(series));
}

/// The first contour is solid, others are dashed. Each has its level in the middle of its longest line.
void addContours(StudyPanel& panel, const MapReport& report, const MapOutput& output) {
    FigureSeries levels{.stroke = SeriesStroke::none, .textSide = TextSide::over};
    std::vector<FigureSeries> contours;
    for (const Contour& contour : report.contours) {
        if (contour.lines.empty()) continue;
        constexpr SeriesStroke strokes[] = {SeriesStroke::strong, SeriesStroke::dashed,
                                            SeriesStroke::shortDashed};
        FigureSeries& series = contours.emplace_back(
            FigureSeries{.kind = SeriesKind::path, .stroke = strokes[contours.size() % std::size(strokes)]});
        for (const ContourLine& line : contour.lines) {
            if (!series.x.empty()) series.x.push_back(NAN), series.y.push_back(NAN);
            for (const ContourPoint& point : line) series.x.push_back(point.x), series.y.push_back(point.y);
        }
        const auto longest = std::ranges::max_element(contour.lines, {}, &ContourLine::size);
        levels.x.push_back((*longest)[longest->size() / 2].x);
        levels.y.push_back((*longest)[longest->size() / 2].y);
        levels.texts.push_back({"%1", {{contour.level * output.perValue, PlainNumber::number, levelDigits}}});
    }
    panel.series.push_back(std::move(levels));
    for (FigureSeries& series : contours) panel.series.push_back(std::move(series));
}

/// Returns the points with the least and the largest value.
std::pair<ContourPoint, ContourPoint> extremesOf(const MapGrid& grid) {
    std::pair<ContourPoint, ContourPoint> points;
    for (std::size_t row = 0; row < grid.rows(); ++row)
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            if (!grid.isThere(column, row)) continue;
            const ContourPoint point{grid.xs()[column], grid.ys()[row]};
            if (grid.value(column, row) == grid.extent()->least) points.first = point;
            if (grid.value(column, row) == grid.extent()->largest) points.second = point;
        }
    return points;
}

std::vector<FigureText> summaryOf(const MapReport& report, const MapOutput& output) {
    const MapGrid& grid = report.grid;
    const auto count = [](std::uint64_t value) { return FigureNumber{.words = std::to_string(value)}; };
    if (!grid.extent())
        return {{grid.failed() > 0 ? translatable("No point could be solved.")
                                   : translatable("The map follows.")}};
    std::vector<FigureText> parts{{translatable("%1 ranges from %2 to %3"),
                                   {{.words = output.axis.title},
                                    valueOf(output, grid.extent()->least, shownDigits),
                                    valueOf(output, grid.extent()->largest, shownDigits)}}};
    for (const Contour& contour : report.contours)
        if (contour.lines.empty())
            parts.push_back(
                {translatable("%1 is not reached"), {valueOf(output, contour.level, levelDigits)}});
    if (grid.failed() > 0)
        parts.push_back({translatable("%1 of %2 points not solved (hatched)"),
                         {count(grid.failed()), count(grid.size())}});
    return parts;
}

}  // namespace

std::pair<double, double> rangeOf(const MapGrid& grid) {
    const std::optional<MapGrid::Extent>& extent = grid.extent();
    if (!extent) return {0, 1};
    const double room = extent->least < extent->largest ? 0 : std::max(std::abs(extent->least), 1.0) / 100;
    return {extent->least - room, extent->largest + room};
}

std::vector<double> usualLevels(const Output& output) {
    if (const std::optional<double> level = decisiveLevel(output)) return {*level};
    if (output.name == "efficiency") return {0.4, 0.5, 0.6, 0.7};
    return {};
}

std::optional<FigurePoint> mapPlaceOf(const MapStudy& study, const Scenario& scenario) {
    const auto x = valueIn(scenario, *study.x.parameter), y = valueIn(scenario, *study.y.parameter);
    return x && y ? std::optional(FigurePoint{*x, y}) : std::nullopt;
}

MapSection mapSectionAt(const MapReport& report, const std::optional<FigurePoint>& here) {
    const MapGrid& grid = report.grid;
    MapSection section{{grid.columns() / 2, grid.rows() / 2}};
    if (!here) return section;
    const auto nearest = [](std::span<const double> values, const SweepAxis& axis, double at) {
        return nearestIndex(values, axis.isLogarithmic(), at);
    };
    const auto column = nearest(grid.xs(), report.study.x, here->x);
    const auto row = nearest(grid.ys(), report.study.y, *here->y);
    if (column && row) section.point = {*column, *row};
    const auto isAt = [](double point, double value) {
        return rounded(point, shownDigits) == rounded(value, shownDigits);
    };
    section.isAtX = isAt(grid.xs()[section.point.column], here->x);
    section.isAtY = isAt(grid.ys()[section.point.row], *here->y);
    return section;
}

MapOutput mapOutput(const MapStudy& study) {
    constexpr double usualForce = 1e4, usualPower = 1e4, usualRate = 1e-2;  // [N], [W], [m/s] of drills
    const OutputColumn& column = study.output;
    const Measure measure = column.output->measure;
    const double size = measure == Measure::newton ? usualForce
                        : measure == Measure::watt ? usualPower
                                                   : usualRate;
    const Scales scales = column.units == OutputUnits::si ? scalesOf(study.base) : Scales{};
    return {{.title = outputMessage(*column.output), .quantity = figureQuantity(column, size)},
            1 / column.scale(scales)};
}

StudyFigure mapFigure(const std::shared_ptr<const MapReport>& report, const MapSection& section,
                      std::span<const Preset> presets) {
    const MapStudy& study = report->study;
    const MapGrid& grid = report->grid;
    const MapOutput output = mapOutput(study);
    const auto [column, row] = section.point;
    FigureAxis values = output.axis;
    const auto [least, largest] = rangeOf(grid);
    const double room = 0.05 * (largest - least);
    values.range = std::pair((least - room) * output.perValue, (largest + room) * output.perValue);
    StudyPanel map{.x = axisOf(study.x),
                   .y = axisOf(study.y),
                   .field = FigureField{.grid = {report, &grid},
                                        .perValue = output.perValue,
                                        .scale = output.axis,
                                        .level = decisiveLevel(*study.output.output)}};
    addPresets(map, study, presets);
    addContours(map, *report, output);
    StudyPanel alongY{.width = sectionShare,
                      .x = values,
                      .y = map.y,
                      .series = {{.kind = SeriesKind::path}},
                      .title = titleOf(study.x, grid.xs()[column], section.isAtX)};
    for (std::size_t i = 0; i < grid.rows(); ++i) {
        if (!grid.isThere(column, i)) continue;
        alongY.series[0].x.push_back(grid.value(column, i) * output.perValue);
        alongY.series[0].y.push_back(grid.ys()[i]);
    }
    StudyPanel alongX{.row = 1,
                      .height = sectionHeightShare,
                      .sharesX = true,
                      .x = map.x,
                      .y = values,
                      .series = {{}},
                      .title = titleOf(study.y, grid.ys()[row], section.isAtY)};
    for (std::size_t i = 0; i < grid.columns(); ++i) {
        if (!grid.isThere(i, row)) continue;
        alongX.series[0].x.push_back(grid.xs()[i]);
        alongX.series[0].y.push_back(grid.value(i, row) * output.perValue);
    }
    return {.panels = {std::move(map), std::move(alongY), std::move(alongX)},
            .summary = summaryOf(*report, output),
            .hasCrosshair = true,
            .paperHeight = 140};
}

std::optional<FigureText> mapAnswer(const MapReport& report) {
    if (!report.grid.isComplete() || !report.grid.extent()) return std::nullopt;
    const MapStudy& study = report.study;
    const MapOutput output = mapOutput(study);
    const auto text = [&](const char* pattern, FigureNumber value,
                          std::initializer_list<ContourPoint> points) {
        FigureText answer{pattern,
                          {{.words = output.axis.title},
                           std::move(value),
                           named(*study.y.parameter),
                           named(*study.x.parameter)}};
        for (const ContourPoint& point : points) {
            answer.numbers.push_back(valueOf(study.y, point.y, levelDigits));
            answer.numbers.push_back(valueOf(study.x, point.x, levelDigits));
        }
        return answer;
    };
    const auto rank = [&](const Contour& contour) {
        return std::pair(contour.level == decisiveLevel(*study.output.output), contour.level);
    };
    const Contour* deciding = nullptr;
    for (const Contour& contour : report.contours)
        if (!contour.lines.empty() && (!deciding || rank(contour) > rank(*deciding))) deciding = &contour;
    if (const auto extent = deciding ? extentOf(*deciding) : std::nullopt) {
        const FigureNumber level = valueOf(output, deciding->level, levelDigits);
        const LevelSide side = sideOf(report.grid, deciding->level);
        if (side == LevelSide::above)
            return text(
                translatable("%1 exceeds %2 only where %3 is above %5. At %4 = %6, %3 = %5 is enough."),
                level, {extent->lowest});
        if (side == LevelSide::below)
            return text(
                translatable("%1 exceeds %2 only where %3 is below %5. At %4 = %6, %3 = %5 is low enough."),
                level, {extent->highest});
    }
    const auto [least, largest] = extremesOf(report.grid);
    FigureText answer = text(translatable("The largest value of %1 is %2, at %3 = %5 and %4 = %6. The "
                                          "smallest is %9, at %3 = %7 and %4 = %8."),
                             valueOf(output, report.grid.extent()->largest, levelDigits), {largest, least});
    answer.numbers.push_back(valueOf(output, report.grid.extent()->least, levelDigits));
    return answer;
}

}  // namespace drillwave
