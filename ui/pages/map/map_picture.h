// SPDX-License-Identifier: GPL-3.0-or-later
// Picture of a map: its values in the units on show, and its colours.
#pragma once

#include <QLocale>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>

#include "core/model/preset_places.h"
#include "core/report/map_report.h"
#include "ui/plot/colour_scale.h"
#include "ui/text/shown_units.h"

class QCPColorGradient;

namespace drillwave {

/// Mapping of values to colours: about a level that matters, or from the smallest to the largest.
struct MapColours {
    double least = 0;             ///< in the units of the map, as the next two
    double largest = 1;           ///< > least
    std::optional<double> level;  ///< that matters: e = 1, margin 0

    /// Maps a value to −1 … 1 for ColourScale::colour(); NaN for none.
    double share(double value) const;
    const ColourScale& scale() const;
    /// Returns the colours of a bar from `least` to `largest`.
    QCPColorGradient gradient() const;
};

/// A map and the units in which it is shown: shown = value in the map · factor.
struct MapPicture {
    std::shared_ptr<const MapReport> report;
    const Unit* xUnit = nullptr;  ///< of the axes
    const Unit* yUnit = nullptr;
    ShownUnit x, y, output;  ///< without a `unit` for plain numbers
    MapColours colours;
    std::vector<PresetPoint> presets;

    const MapGrid& grid() const { return report->grid; }
    /// Labels of axes and colours, with units.
    QString xLabel() const;
    QString yLabel() const;
    QString outputLabel() const;
    /// "k = 120 MN/m", "COR e = 0.4297".
    QString xText(double si, const QLocale& locale) const;
    QString yText(double si, const QLocale& locale) const;
    QString outputText(double value, const QLocale& locale) const;
    /// Returns the place of a scenario, in shown units; nullopt if it lacks a value of a parameter.
    std::optional<QPointF> placeOf(const Scenario& scenario) const;
    /// The point of the map nearest to a place in shown units; nullopt outside.
    std::optional<MapGrid::Place> pointAt(QPointF shown) const;
    /// Describes a point: both parameters, and the value or the reason for none: "k = 120 MN/m · e = 0.43".
    QString textAt(MapGrid::Place place, const QLocale& locale) const;
};

/// Whether both are over the same ranges of the same parameters, in the same units.
bool haveSameAxes(const MapPicture& a, const MapPicture& b);

/// The level of an output that decides something: 1 of e, 0 of the margin of the thrust.
std::optional<double> decisiveLevel(const Output& output);

/// The levels of which a map of an output has contours at first: what decides, or tenths of an efficiency.
std::vector<double> usualLevels(const Output& output);

/// The colours of the values of a map, about a level that matters where there is one.
MapColours coloursOf(const MapGrid& grid, std::optional<double> level);

/// Returns the units in which a map of an output is computed for results on show in `system`.
OutputUnits mapUnits(const Output& output, UnitSystem system);

/// The unit in which such a map is shown.
ShownUnit mapUnit(const OutputColumn& output, const Scenario& scenario, const ShownUnits& units);

/// Makes the picture with the built-in presets; `units` are those on show, for the study's scenario.
MapPicture mapPicture(std::shared_ptr<const MapReport> report, const ShownUnits& units);

}  // namespace drillwave
