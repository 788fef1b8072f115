// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/map/map_picture.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/yaml/preset_file.h"
#include "ui/job/output_text.h"
#include "ui/pages/map/map_raster.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// A side of the level has at least this share of the whole scale: where values hardly pass the level they
/// shall not look as far from it as those on the other side.
constexpr double leastSide = 0.1;

QString text(const QString& name, double value, const ShownUnit& unit, const QLocale& locale) {
    const QString number = numberText(value * unit.factor, 5, locale);
    return name + QStringLiteral(" = ") +
           (unit.unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit.unit);
}

QString name(const SweepAxis& axis) {
    return parameterName(*axis.parameter);
}

const Unit& axisUnit(const SweepAxis& axis, const ShownUnits& units) {
    const auto kind = kindOf(*axis.parameter);
    const auto own = kind ? units.chosen.find(*kind) : units.chosen.end();
    return own != units.chosen.end() ? *own->second : customaryUnit(*axis.parameter, units.system);
}

}  // namespace

std::optional<QPointF> MapPicture::placeOf(const Scenario& scenario) const {
    const auto shown = [&](const SweepAxis& axis, const ShownUnit& unit) -> std::optional<double> {
        if (!axis.parameter->applies(scenario)) return std::nullopt;
        const std::optional<double> si = axis.parameter->value(scenario);
        return si ? std::optional(*si * unit.factor) : std::nullopt;
    };
    const auto atX = shown(report->study.x, x), atY = shown(report->study.y, y);
    return atX && atY ? std::optional(QPointF(*atX, *atY)) : std::nullopt;
}

std::optional<MapGrid::Place> MapPicture::pointAt(QPointF shown) const {
    const auto column = AxisPlaces(report->study.x).nearest(shown.x() / x.factor);
    const auto row = AxisPlaces(report->study.y).nearest(shown.y() / y.factor);
    if (!column || !row) return std::nullopt;
    return MapGrid::Place{*column, *row};
}

QString MapPicture::textAt(MapGrid::Place place, const QLocale& locale) const {
    const double value = grid().value(place.column, place.row);
    QString result = outputText(value, locale);
    if (!grid().isThere(place.column, place.row))
        result = drillwave::tr("not solved yet");
    else if (const Message& reason = grid().reason(place.column, place.row); !reason.isEmpty())
        result = drillwave::tr("not solved: %1").arg(translated(reason));
    else if (std::isnan(value))
        result = drillwave::tr("no such result here");
    return drillwave::tr("%1 · %2 · %3")
        .arg(xText(grid().xs()[place.column], locale), yText(grid().ys()[place.row], locale), result);
}

bool haveSameAxes(const MapPicture& a, const MapPicture& b) {
    const auto isSameAxis = [](const SweepAxis& one, const SweepAxis& other) {
        return one.parameter == other.parameter && one.kind == other.kind && one.start == other.start &&
               one.stop == other.stop;
    };
    return isSameAxis(a.report->study.x, b.report->study.x) &&
           isSameAxis(a.report->study.y, b.report->study.y) && a.x == b.x && a.y == b.y;
}

double MapColours::share(double value) const {
    if (!level) return 2 * (value - least) / (largest - least) - 1;
    const double side = leastSide * (largest - least);
    if (value < *level) return (value - *level) / std::max(*level - least, side);
    return (value - *level) / std::max(largest - *level, side);
}

const ColourScale& MapColours::scale() const {
    return level ? ColourScale::aboutLevel() : ColourScale::ramp();
}

QCPColorGradient MapColours::gradient() const {
    constexpr int stops = 128;
    const ColourScale& colours = scale();
    QMap<double, QColor> map;
    for (int i = 0; i <= stops; ++i)
        map[double(i) / stops] =
            QColor::fromRgb(colours.colour(share(least + (largest - least) * i / stops)));
    QCPColorGradient gradient;
    gradient.setColorStops(map);
    return gradient;
}

QString MapPicture::xLabel() const {
    return x.axisLabel(name(report->study.x));
}

QString MapPicture::yLabel() const {
    return y.axisLabel(name(report->study.y));
}

QString MapPicture::outputLabel() const {
    return output.axisLabel(outputName(*report->study.output.output));
}

QString MapPicture::xText(double si, const QLocale& locale) const {
    return text(name(report->study.x), si, x, locale);
}

QString MapPicture::yText(double si, const QLocale& locale) const {
    return text(name(report->study.y), si, y, locale);
}

QString MapPicture::outputText(double value, const QLocale& locale) const {
    return text(outputName(*report->study.output.output), value, output, locale);
}

std::optional<double> decisiveLevel(const Output& output) {
    if (output.name == "cor") return 1;
    if (output.name == "thrust_margin") return 0;
    return std::nullopt;
}

std::vector<double> usualLevels(const Output& output) {
    if (const std::optional<double> level = decisiveLevel(output)) return {*level};
    if (output.name == "efficiency") return {0.4, 0.5, 0.6, 0.7};
    return {};
}

OutputUnits mapUnits(const Output& output, UnitSystem system) {
    const bool isNumber = output.quantity() == Quantity::ratio;
    return isNumber || system == UnitSystem::dimensionless ? OutputUnits::dimensionless : OutputUnits::si;
}

ShownUnit mapUnit(const OutputColumn& output, const Scenario& scenario, const ShownUnits& units) {
    constexpr double aThrust = 1e4, aPower = 1e4, aRate = 1e-2;  // [N], [W], [m/s]: sizes usual with drills
    const Scales scales = output.units == OutputUnits::si ? scalesOf(scenario) : Scales{};
    const Measure measure = output.output->measure;
    const double size = measure == Measure::newton ? aThrust : measure == Measure::watt ? aPower : aRate;
    ShownUnit unit = columnUnit(output, units, size);
    unit.factor /= output.scale(scales);
    return unit;
}

MapColours coloursOf(const MapGrid& grid, std::optional<double> level) {
    MapColours colours;
    const std::optional<MapGrid::Extent>& extent = grid.extent();
    if (!extent) return colours;
    colours.level = level;
    colours.least = extent->least;
    colours.largest = extent->largest;
    if (colours.largest > colours.least) return colours;
    const double room = std::max(std::abs(colours.least), 1.0) / 100;
    colours.least -= room;
    colours.largest += room;
    return colours;
}

MapPicture mapPicture(std::shared_ptr<const MapReport> report, const ShownUnits& units) {
    const MapStudy& study = report->study;
    const Unit &xUnit = axisUnit(study.x, units), &yUnit = axisUnit(study.y, units);
    return {.report = report,
            .xUnit = &xUnit,
            .yUnit = &yUnit,
            .x = shownUnit(xUnit),
            .y = shownUnit(yUnit),
            .output = mapUnit(study.output, study.base, units),
            .colours = coloursOf(report->grid, decisiveLevel(*study.output.output)),
            .presets = presetPoints(builtInPresets(), *study.x.parameter, *study.y.parameter, study.base)};
}

}  // namespace drillwave
