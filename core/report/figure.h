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

/// Kind of a number on an axis that has no physical quantity. It is a plain number, a value in per cent, an
/// error shown as a power of ten, or a computing time [s].
enum class PlainNumber { number, percent, magnitude, runTime };

/// Scale of the blow (theory §1) of which the values of an axis are multiples. The enumerators stand for t0,
/// F0, I0, d0, k0, W0, F0/A, L and v0, in this order.
enum class BlowScale { time, force, impulse, penetration, stiffness, energy, stress, length, velocity };

/// Axis quantity with values in SI units. `size` is the typical magnitude of the values (SI), from which a
/// readable unit is chosen.
struct SiValues {
    Quantity quantity = Quantity::ratio;
    double size = 1;
    /// Key of a special choice of units, such as "rate" for penetration rates in m/min. Empty for the usual
    /// units of the quantity.
    std::string_view kind = {};
    bool operator==(const SiValues&) const = default;
};

/// Quantity of the numbers on an axis, which determines their unit and format. A KeptParameter means values
/// of that parameter in SI units.
using FigureQuantity = std::variant<PlainNumber, BlowScale, SiValues, KeptParameter>;

/// Effect of a click on an axis: sets `parameter` to `factor` times the clicked value of the axis (SI).
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
    /// Fixed range of the axis; empty to fit the axis to the values shown.
    std::optional<std::pair<double, double>> range = {};
    /// Parameter that a click on the axis sets; empty if a click has no effect.
    std::optional<AxisTarget> target = {};
    bool isFromZero = false;  ///< whether the axis runs from zero to slightly above all values
    /// Names shown at the values 0, 1, 2, … instead of numbers; empty for an axis with numbers. If the x axis
    /// has names, a curve is drawn as a short horizontal line at each name.
    std::vector<FigureText> names = {};
};

/// Kind of a series. `line` is a function y of ascending x, or marked points in any order without a line.
/// `path` joins the points in the given order; `area` is a closed, filled path.
enum class SeriesKind { line, path, area };

/// Role of a curve or of points in a figure, which selects the colour and dashes. Larger integers cast to
/// this type select further colours.
enum class SeriesRole { result, second, third, fourth };

/// Pen of a series: `usual`, `wide` and `dotted` (thin) have the colour of the role; `dashed` (long dashes),
/// `strong` (a thick line) and `shortDashed` have the text colour; `none` draws no line. An area is filled
/// with its colour if it is `strong`, else shaded.
enum class SeriesStroke { usual, wide, dotted, dashed, strong, shortDashed, none };

/// Marks at the points of a series. `none` draws no marks; `joined` (marks) and `beads` (small discs) are
/// drawn together with the line. All others are marks without the line.
/// `apart`, `stars`, `dots` and `discs` have the colour of the role, the others the text colour. `here` marks
/// the present scenario.
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

/// Effect of a click near a line: sets `parameter` to `value` [SI], in addition to the parameter of the x
/// axis. If `parameter` is empty, only the parameter of the x axis is set.
struct SeriesTarget {
    KeptParameter parameter = {};
    double value = 0;
};

/// Position of the texts beside the points of a series: `above` to the upper right, `below` to the lower
/// left, `over` centred on the points.
enum class TextSide { above, below, over };

struct FigureSeries {
    SeriesKind kind = SeriesKind::line;
    SeriesRole role = SeriesRole::result;
    SeriesStroke stroke = SeriesStroke::usual;
    Message legend = {};  ///< name in the legend; a series with an empty name is not listed
    std::vector<double> x = {};
    std::vector<double> y = {};
    bool isOnTop = false;  ///< whether the x values of the series belong to the top axis of the panel
    /// Function that returns the exact y of the line at any x, for the values shown at the cursor. If it is
    /// empty, the cursor interpolates linearly between the points.
    std::function<double(double x)> value = nullptr;
    bool isFaint = false;  ///< whether the series is drawn faintly, behind the others
    /// Upper edge of a strip, given by its y values at the positions `x`; the lower edge is `y`. It is drawn
    /// as a thin line. Empty if the series is a single line.
    std::vector<double> upper = {};
    bool isFilled = false;  ///< whether the strip between y and `upper` is shaded
    SeriesPoints points = SeriesPoints::none;
    /// Texts beside the points, the first for the first point. A point with an empty text, or beyond the last
    /// text, has none.
    std::vector<FigureText> texts = {};
    TextSide textSide = TextSide::above;
    /// Index (from 0) of the row in the study's table to which each point belongs. Empty if the points have
    /// no rows.
    std::vector<std::size_t> rows = {};
    /// Additional effect of a click near the line, beyond the parameters that the axes set; empty for none.
    std::optional<SeriesTarget> target = {};
    /// Parameter that the user changes by dragging the line up or down: its value changes by `factor` times
    /// the distance in y. Empty if the line cannot be dragged.
    std::optional<AxisTarget> dragged = {};
    bool isOnRight = false;  ///< whether the y values of the series belong to the right axis of the panel
};

/// Kind of a marked point of a curve: goal value, minimum or maximum, crossing of a level (such as e = 1), or
/// kink or jump.
enum class MarkKind { goal, extreme, crossing, kink };

struct FigureMark {
    MarkKind kind = MarkKind::kink;
    double x = 0;
    double y = 0;
};

/// Horizontal line at the value `y` through all panels of a row; its label is in the rightmost panel.
struct FigureLevel {
    Message name;
    double y = 0;
    bool isMain = false;  ///< whether the line is drawn more prominently than other levels
    std::size_t row = 0;
    /// Whether the y axis is always extended to include this line. Otherwise it is extended only if this at
    /// most doubles its range.
    bool isInView = true;
};

/// Zone of all values of y above `from`, shaded and labelled with `name`.
struct FigureZone {
    Message name;
    double from = 0;
};

/// Vertical band from x = `from` to `to`, shaded and labelled. The label is at the top in the middle of the
/// band. If `at` is given, it is at the bottom at this x, unless other labels are in the way. A band with
/// from = to is a line labelled at the bottom.
struct FigureBand {
    Message name;
    double from = 0;
    double to = 0;
    std::optional<double> at = {};
};

/// Shaded layers over x, one above the other; the lower ones are darker.
struct FigureLayers {
    std::vector<Message> names = {};
    std::vector<double> x = {};
    /// Boundaries between neighbouring layers, each given by its y values at the positions `x`.
    std::vector<std::vector<double>> edges = {};
    /// Curve given by its y values at the positions `x`. The names of the layers are placed so that they do
    /// not cover it. May be empty.
    std::vector<double> clear = {};
};

/// Vertical line at a value of x, which the user can drag.
struct FigureHandle {
    Message name;
    double x = 0;
    /// Value of x to which the dragged line snaps within a few pixels; empty for none.
    std::optional<double> snap = {};
};

/// Point in the first panel of a figure, in the units of its axes. Without `y` it stands for a vertical line
/// at `x`.
struct FigurePoint {
    double x = 0;
    std::optional<double> y = {};
};

/// Colour map of values over the x and y axes of a panel, with a colour scale to the right of the panels in
/// its row. The points of the grid are evenly spaced along each axis, or in equal ratios on a logarithmic
/// axis.
struct FigureField {
    std::shared_ptr<const MapGrid> grid;
    double perValue = 1;  ///< factor from values of the grid to numbers on the colour scale
    FigureAxis scale = {};
    /// Value of the grid at which the colours change from one hue to another. Empty if the colour scale has
    /// only one hue.
    std::optional<double> level = {};
    bool hasRows = false;  ///< whether the points of the grid, row by row, are the rows of the study's table
};

/// Returns the smallest and the largest of the values of the grid that are already computed. They are
/// slightly widened if they are equal; 0 and 1 without values.
std::pair<double, double> rangeOf(const MapGrid& grid);

/// Panel of a figure: one plot with its axes. Panels in the same row share a y axis unless `hasOwnY` is set.
struct StudyPanel {
    /// Row of the panel, counted from 0 at the top. Panels are listed row by row.
    std::size_t row = 0;
    double width = 1;   ///< width relative to the first panel of its row
    double height = 1;  ///< height relative to the first row; only that of the first panel in a row is used
    bool sharesX = false;  ///< whether the x axis shows the same range as that of the first panel
    FigureAxis x = {};
    FigureAxis y = {};                   ///< y axis; only that of the first panel in a row is used
    std::optional<FigureAxis> top = {};  ///< second x axis, along the top; empty for none
    /// Ratio of the values on the top axis to those on the x axis. 0 if the top axis has values of its own,
    /// which apply to the series with `isOnTop`.
    double topPerX = 0;
    std::vector<FigureSeries> series = {};
    std::vector<FigureMark> marks = {};  ///< marks on points of the series with index `marked`
    std::size_t marked = 0;
    std::optional<FigureZone> zone = {};
    std::vector<FigureBand> bands = {};
    FigureLayers layers = {};
    std::optional<FigureHandle> handle = {};
    std::optional<FigureAxis> right = {};  ///< second y axis, along the right side; empty for none
    bool hasOwnY = false;                  ///< whether the panel has its own y axis, not that of its row
    bool isHidden = false;  ///< whether the panel is hidden, so that other panels take its space
    std::optional<FigureField> field = {};
    FigureText title = {};  ///< text above the panel; empty for none
    /// Whether a click selects the table row whose point is nearest along x, at any distance. Otherwise the
    /// point must be within a few pixels.
    bool hasRowsAlongX = false;
};

/// Figure of panels in rows, with a caption above them. A newer result of the same study may have other
/// series, marks and levels. If it has another number of panels or other axes, the plot treats it as a new
/// figure and resets the zoom.
struct StudyFigure {
    std::vector<FigureText> caption = {};
    std::vector<StudyPanel> panels = {};
    std::vector<FigureLevel> levels = {};
    /// Whether this is a preview, which lacks everything that needs the complete result.
    bool isPreview = false;
    /// Description of the figure in sentences, for readers who cannot see it; empty if the caption is
    /// sufficient.
    std::vector<FigureText> summary = {};
    /// Whether the figure marks the present scenario by a crosshair that the user can drag to another one.
    bool hasCrosshair = false;
    int paperHeight = 110;  ///< height on paper for a width of 180 mm [mm]
};

}  // namespace drillwave
