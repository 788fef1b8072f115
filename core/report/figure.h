// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as data: curves, axes and marks. Units, language, pens and colours are chosen by the code that
// draws them.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/model/parameter.h"
#include "core/study/map/map_grid.h"
#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

/// Kind of a number without a physical quantity. It is a plain number, a fraction shown as per cent, an error
/// shown by its power of ten, or a computing time [s].
enum class PlainNumber { number, percent, magnitude, runTime };

/// Characteristic quantity of the blow of which values are multiples (theory §1). In this order: t0, F0, I0,
/// d0, k0, W0, F0/A, L, v0.
enum class BlowScale { time, force, impulse, penetration, stiffness, energy, stress, length, velocity };

/// Values of a physical quantity in SI units. `size` is their typical magnitude (SI), by which a unit is
/// chosen.
struct SiValues {
    Quantity quantity = Quantity::ratio;
    double size = 1;
    std::string_view kind = {};  ///< "rate": key of the kind of units, of a quantity with several
    bool operator==(const SiValues&) const = default;
};

/// Quantity of the numbers of a figure. Values of a parameter (KeptParameter) are in SI units.
using FigureQuantity = std::variant<PlainNumber, BlowScale, SiValues, KeptParameter>;

/// Action of a click on an axis: sets `parameter` to `factor` times the value clicked (SI).
struct AxisTarget {
    KeptParameter parameter;
    double factor = 1;
};

/// Number in a caption, with its quantity and number of digits.
struct FigureNumber {
    double value = 0;
    FigureQuantity quantity = PlainNumber::number;
    int digits = 4;
    Message words = {};  ///< text shown instead of the number, such as a name or a reason
};

/// Sentence with numbers at the placeholders %1, %2, …
struct FigureText {
    const char* pattern = "";
    std::vector<FigureNumber> numbers = {};
};

struct FigureAxis {
    Message title = {};
    FigureQuantity quantity = PlainNumber::number;
    bool isLogarithmic = false;
    /// Fixed range of the axis; empty if all values shall be visible.
    std::optional<std::pair<double, double>> range = {};
    /// Parameter that a click on the axis sets; empty if a click has no effect.
    std::optional<AxisTarget> target = {};
    bool isFromZero = false;  ///< whether the axis runs from zero to slightly above all values
    /// Names of the values 0, 1, 2, … instead of numbers; empty for numbers. Between the names of an x axis,
    /// lines have no values.
    std::vector<FigureText> names = {};
};

/// Kind of a series. `line` is y over ascending x, or marked points in any order. `path` joins the points in
/// their order; `area` is a closed, filled path.
enum class SeriesKind { line, path, area };

/// Colour and dashes of a series. Numbers beyond those named here give further pens.
enum class SeriesRole { result, second, third, fourth };

/// Pen of a series: `usual`, `wide` and `dotted` (thin) have the colour of the role; `dashed` (long dashes),
/// `strong` (a thick line) and `shortDashed` have the text colour; `none` draws no line. An area is filled
/// with its colour if it is `strong`, else shaded.
enum class SeriesStroke { usual, wide, dotted, dashed, strong, shortDashed, none };

/// Marks at the points of a line: none; marks or small discs (`beads`) with the line; or marks without the
/// line. `apart`, `stars`, `dots` and `discs` have the colour of the role, all others the text colour; `here`
/// is the mark of the present scenario.
enum class SeriesPoints {
    none,
    joined,
    beads,
    apart,
    stars,
    dots,
    discs,
    rings,
    circles,
    diamonds,
    openDiamonds,
    squares,
    here
};

/// Effect of a click near a line: `parameter`, if there is one, becomes `value` [SI], besides that of the x
/// axis.
struct SeriesTarget {
    KeptParameter parameter = {};
    double value = 0;
};

/// Place of the texts beside the points of a series: to the upper right, to the lower left, or over them.
enum class TextSide { above, below, over };

struct FigureSeries {
    SeriesKind kind = SeriesKind::line;
    SeriesRole role = SeriesRole::result;
    SeriesStroke stroke = SeriesStroke::usual;
    Message legend = {};  ///< text in the legend; the series is not listed if it is empty
    std::vector<double> x = {};
    std::vector<double> y = {};
    bool isOnTop = false;  ///< whether its x values belong to the top axis of the panel
    /// Function that gives y between the points of a line; may be empty.
    std::function<double(double x)> value = nullptr;
    bool isFaint = false;  ///< whether the series is drawn faintly, behind the others
    /// Second edge of a strip that begins at the line y, drawn thin; empty for a simple line.
    std::vector<double> upper = {};
    bool isFilled = false;  ///< whether the strip between y and `upper` is shaded
    SeriesPoints points = SeriesPoints::none;
    /// Texts beside the first points; empty texts for points without one.
    std::vector<FigureText> texts = {};
    TextSide textSide = TextSide::above;
    std::vector<std::size_t> rows = {};  ///< row of the study's table for each point
    /// Effect of a click near the line; empty if only the place of the click counts.
    std::optional<SeriesTarget> target = {};
    /// Parameter that changes by the distance by which the user drags the line up or down; empty if it cannot
    /// be dragged.
    std::optional<AxisTarget> dragged = {};
    bool isOnRight = false;  ///< whether its y values belong to the right axis of the panel
};

/// Kind of a marked point of a curve.
enum class MarkKind { goal, extreme, crossing, kink };

struct FigureMark {
    MarkKind kind = MarkKind::kink;
    double x = 0;
    double y = 0;
};

/// Level of y, drawn as a line through all panels of a row and labelled in the last panel.
struct FigureLevel {
    Message name;
    double y = 0;
    bool isMain = false;  ///< whether the level is drawn more prominently than others
    std::size_t row = 0;
    bool isInView = true;  ///< whether axes reach it at any rate; else only if curves keep half of the height
};

/// Zone of all values of y above `from`, shaded and labelled.
struct FigureZone {
    Message name;
    double from = 0;
};

/// Band of all values of x from `from` to `to`, shaded and labelled: at the top in the middle, or, with `at`,
/// at the foot at that x if the labels of other bands leave room. A band of one value is a line labelled at
/// the foot.
struct FigureBand {
    Message name;
    double from = 0;
    double to = 0;
    std::optional<double> at = {};
};

/// Layers of y along x, from bottom to top; lower layers are darker.
struct FigureLayers {
    std::vector<Message> names = {};
    std::vector<double> x = {};
    /// Boundaries between neighbouring layers, each as values of y at `x`.
    std::vector<std::vector<double>> edges = {};
    /// Line that the names of the layers must not cover, as values of y at `x`; may be empty.
    std::vector<double> clear = {};
};

/// Vertical line at a value of x that the reader can drag.
struct FigureHandle {
    Message name;
    double x = 0;
    /// Value that the line snaps to when it is within a few pixels; empty for none.
    std::optional<double> snap = {};
};

/// Point of the first panel of a figure; without y, a vertical line at x.
struct FigurePoint {
    double x = 0;
    std::optional<double> y = {};
};

/// Values over x and y of a panel as colours, with their scale at the right of the row. The values of the
/// grid are along the axes of the panel, evenly spaced or, on a logarithmic axis, in equal ratios.
struct FigureField {
    std::shared_ptr<const MapGrid> grid;
    double perValue = 1;  ///< number of the figure for 1 in the grid
    FigureAxis scale = {};
    /// Value in the grid on whose two sides the colours differ; empty if they only rise.
    std::optional<double> level = {};
    bool hasRows = false;  ///< whether its points, row by row, are the rows of the study's table
};

/// Returns the smallest and the largest value so far, with room about a single value; 0 and 1 without values.
std::pair<double, double> rangeOf(const MapGrid& grid);

/// One plot of a figure. Panels in the same row share their y axis.
struct StudyPanel {
    /// Row of the panel, counted from the top. Panels are listed row by row.
    std::size_t row = 0;
    double width = 1;   ///< width relative to the first panel of its row
    double height = 1;  ///< height relative to the first row; only that of the first panel in a row is used
    bool sharesX = false;  ///< whether its x axis shows the same range as that of the first panel
    FigureAxis x = {};
    FigureAxis y = {};                   ///< y axis; only that of the first panel in a row is used
    std::optional<FigureAxis> top = {};  ///< second x axis, along the top; empty for none
    /// Ratio of values on the top axis to values on the x axis. It is 0 if the top axis has its own values,
    /// for series with `isOnTop`.
    double topPerX = 0;
    std::vector<FigureSeries> series = {};
    std::vector<FigureMark> marks = {};  ///< marks on the series with the index `marked`
    std::size_t marked = 0;
    std::optional<FigureZone> zone = {};
    std::vector<FigureBand> bands = {};
    FigureLayers layers = {};
    std::optional<FigureHandle> handle = {};
    std::optional<FigureAxis> right = {};  ///< a second y axis
    bool hasOwnY = false;                  ///< its y axis is not that of its row
    bool isHidden = false;                 ///< leaves its room to the others
    std::optional<FigureField> field = {};
    FigureText title = {};       ///< text above the panel; empty for none
    bool hasRowsAlongX = false;  ///< whether a click takes the row that is nearest along x, at any height
};

/// Figure of panels in rows, with a caption above them. From one result to the next, series, marks and levels
/// may change. A different number of panels means a different figure.
struct StudyFigure {
    std::vector<FigureText> caption = {};
    std::vector<StudyPanel> panels = {};
    std::vector<FigureLevel> levels = {};
    bool isPreview = false;  ///< whether this is a preview that lacks what needs the whole result
    std::vector<FigureText> summary = {};  ///< summary in words, if the caption says less
    bool hasCrosshair = false;  ///< whether the present scenario is a crosshair that the reader can drag
    int paperHeight = 110;      ///< height on paper for a width of 180 mm [mm]
};

}  // namespace drillwave
