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

/// Kind of a number without a physical quantity: plain number, fraction shown in per cent, error shown as a
/// power of ten, or computing time [s].
enum class PlainNumber { number, percent, magnitude, runTime };

/// Scale of the blow (theory §1) of which the values of an axis are multiples. The enumerators stand for t0,
/// F0, I0, d0, k0, W0, F0/A, L and v0, in this order.
enum class BlowScale { time, force, impulse, penetration, stiffness, energy, stress, length, velocity };

/// Axis quantity with values in SI units. `size` is the typical magnitude of the values (SI), from which a
/// readable unit is chosen.
struct SiValues {
    Quantity quantity = Quantity::ratio;
    double size = 1;
    /// Key of a special set of units, "rate" for m/min; empty for the usual units of the quantity.
    std::string_view kind = {};
    bool operator==(const SiValues&) const = default;
};

/// Quantity of the numbers on an axis, which determines their unit and format. For a KeptParameter the
/// numbers are values of that parameter in SI units.
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
    /// Fixed range of the axis; empty to fit the axis to the values shown.
    std::optional<std::pair<double, double>> range = {};
    /// Parameter that a click on the axis sets; empty if a click has no effect.
    std::optional<AxisTarget> target = {};
    bool isFromZero = false;  ///< whether the axis runs from zero to slightly above all values
    /// Names shown at the values 0, 1, 2, … instead of numbers; empty for numbers. Curves over a named x axis
    /// show no values between the names.
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
/// axis. Only the x axis counts if `parameter` is empty.
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
    /// Function that returns the exact y at an x between the points of a line, for readings in the plot; may
    /// be empty.
    std::function<double(double x)> value = nullptr;
    bool isFaint = false;  ///< whether the series is drawn faintly, behind the others
    /// Upper edge of a strip whose lower edge is `y`, drawn as a thin line; empty for a simple line.
    std::vector<double> upper = {};
    bool isFilled = false;  ///< whether the strip between y and `upper` is shaded
    SeriesPoints points = SeriesPoints::none;
    /// Texts beside the points, the first for the first point. A point with an empty text, or beyond the last
    /// text, has none.
    std::vector<FigureText> texts = {};
    TextSide textSide = TextSide::above;
    /// Row of the study's table that each point belongs to (index from 0). Empty if the points have no rows.
    std::vector<std::size_t> rows = {};
    /// Effect of a click near the line, in addition to that of the axes; empty for none.
    std::optional<SeriesTarget> target = {};
    /// Parameter that the user changes by dragging the line up or down: its value changes by `factor` times
    /// the distance in y. Empty if the line cannot be dragged.
    std::optional<AxisTarget> dragged = {};
    bool isOnRight = false;  ///< whether the y values of the series belong to the right axis of the panel
};

/// Kind of a marked point of a curve.
enum class MarkKind { goal, extreme, crossing, kink };

struct FigureMark {
    MarkKind kind = MarkKind::kink;
    double x = 0;
    double y = 0;
};

/// Horizontal line at the value `y` through all panels of a row, labelled in the last panel.
struct FigureLevel {
    Message name;
    double y = 0;
    bool isMain = false;  ///< whether the line is drawn more prominently than other levels
    std::size_t row = 0;
    /// Whether the y axis always includes the level. Otherwise it does so only if this at most doubles the
    /// range of the axis.
    bool isInView = true;
};

/// Zone of all values of y above `from`, shaded and labelled with `name`.
struct FigureZone {
    Message name;
    double from = 0;
};

/// Vertical band from x = `from` to `to`, shaded and labelled. The label is at the top in the middle; if `at`
/// is given, at the bottom at this x, unless other labels are in the way. A band with from = to is a line
/// labelled at the bottom.
struct FigureBand {
    Message name;
    double from = 0;
    double to = 0;
    std::optional<double> at = {};
};

/// Shaded layers between curves over x, from bottom to top; lower layers are darker.
struct FigureLayers {
    std::vector<Message> names = {};
    std::vector<double> x = {};
    /// Boundaries between neighbouring layers, each given by its y values at the positions `x`.
    std::vector<std::vector<double>> edges = {};
    /// Curve that the names of the layers must not cover, given by its y values at the positions `x`; may be
    /// empty.
    std::vector<double> clear = {};
};

/// Vertical line at a value of x, which the user can drag.
struct FigureHandle {
    Message name;
    double x = 0;
    /// Value of x to which the dragged line snaps within a few pixels; empty for none.
    std::optional<double> snap = {};
};

/// Point of the first panel of a figure, in the units of its axes. Without `y` it means a vertical line at
/// `x`.
struct FigurePoint {
    double x = 0;
    std::optional<double> y = {};
};

/// Colour map of values over the x and y axes of a panel, with a colour scale to the right of the row. The
/// points of the grid are evenly spaced along each axis, or in equal ratios on a logarithmic axis.
struct FigureField {
    std::shared_ptr<const MapGrid> grid;
    double perValue = 1;  ///< factor from values of the grid to numbers on the colour scale
    FigureAxis scale = {};
    /// Value of the grid at which the colours change from one hue to another; empty for a single sequence of
    /// colours.
    std::optional<double> level = {};
    bool hasRows = false;  ///< whether the points of the grid, row by row, are the rows of the study's table
};

/// Returns the smallest and the largest value of the grid so far, slightly widened if they are equal; 0 and 1
/// without values.
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
    /// Ratio of values on the top axis to values on the x axis. It is 0 if the top axis has its own values,
    /// which then belong to series with `isOnTop`.
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
    /// Whether a click selects the table row nearest along x, regardless of its y.
    bool hasRowsAlongX = false;
};

/// Figure of panels in rows, with a caption above them. A newer result of the same study may change series,
/// marks and levels. A figure with another number of panels counts as a different one.
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
