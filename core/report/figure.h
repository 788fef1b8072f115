// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as data: what is drawn over which axes. Units, language, pens and colours belong to who draws it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/model/parameter.h"
#include "core/text/message.h"
#include "core/text/units.h"

namespace drillwave {

/// A mere number, a number of hundredths that is followed by "%", a number of which the power of ten matters
/// (errors), or seconds that the program takes.
enum class PlainNumber { number, percent, magnitude, runTime };

/// Multiple of a characteristic quantity of the blow (theory §1): t0, F0, I0, d0, k0, W0, F0/A, L, v0.
enum class BlowScale { time, force, impulse, penetration, stiffness, energy, stress, length, velocity };

/// SI values of a quantity, most of them about as large as `size` [SI].
struct SiValues {
    Quantity quantity = Quantity::ratio;
    double size = 1;
    std::string_view kind = {};  ///< "rate": key of the kind of units, of a quantity with several
};

/// Quantity of the numbers of a figure. Values of a parameter are in SI.
using FigureQuantity = std::variant<PlainNumber, BlowScale, SiValues, KeptParameter>;

/// A click at a value of an axis sets `parameter` to `factor` times that value [SI].
struct AxisTarget {
    KeptParameter parameter;
    double factor = 1;
};

/// A number in a caption.
struct FigureNumber {
    double value = 0;
    FigureQuantity quantity = PlainNumber::number;
    int digits = 4;
    Message words = {};  ///< instead of the number: a name or a reason
};

/// A sentence with numbers in the places %1, %2 and so on.
struct FigureText {
    const char* pattern = "";
    std::vector<FigureNumber> numbers = {};
};

struct FigureAxis {
    Message title = {};
    FigureQuantity quantity = PlainNumber::number;
    bool isLogarithmic = false;
    std::optional<std::pair<double, double>> range = {};  ///< fixed; else all values are in view
    std::optional<AxisTarget> target = {};                ///< nothing: a click sets nothing
    bool isFromZero = false;                              ///< from zero to a little above all values
    std::vector<FigureText> names = {};                   ///< instead of the numbers 0, 1, 2, …
};

/// line: y over ascending x, or marked points in any order. path: through points in their order. area: the
/// same, closed and filled.
enum class SeriesKind { line, path, area };

/// The pen and colour of a series; `reference` is a strong line in the colour of the words.
enum class SeriesRole { result, second, third, fourth, reference };

/// Marks at the points of a line: none, with the line through them, without it, or stars or dots without it.
enum class SeriesPoints { none, joined, apart, stars, dots };

struct FigureSeries {
    SeriesKind kind = SeriesKind::line;
    SeriesRole role = SeriesRole::result;
    Message legend = {};  ///< empty: it is not in the legend
    std::vector<double> x = {};
    std::vector<double> y = {};
    bool isOnTop = false;                             ///< its x are those of the top axis
    std::function<double(double x)> value = nullptr;  ///< of a line, y between its points; may be empty
    bool isFaint = false;                             ///< stays behind the others
    std::vector<double> upper = {};                   ///< of a line, the other edge of a strip, drawn thin
    bool isFilled = false;                            ///< whether the strip is shaded
    SeriesPoints points = SeriesPoints::none;
    std::vector<FigureText> texts = {};      ///< beside the first points, empty ones beside those without
    bool isTextBelow = false;                ///< texts are left below their points, not right above
    std::vector<std::size_t> rows = {};      ///< row of the study's table of each point
    std::optional<AxisTarget> dragged = {};  ///< changes by as much as the user drags the line up or down
    bool isOnRight = false;                  ///< its y are those of the right axis
};

/// Kind of a marked place of a curve.
enum class MarkKind { goal, extreme, crossing, kink };

struct FigureMark {
    MarkKind kind = MarkKind::kink;
    double x = 0;
    double y = 0;
};

/// A value of y, drawn as a line through all panels of a row and named in the last one.
struct FigureLevel {
    Message name;
    double y = 0;
    bool isMain = false;  ///< stands out among the others
    std::size_t row = 0;
};

/// All values of y above `from`, shaded and named.
struct FigureZone {
    Message name;
    double from = 0;
};

/// All values of x between two, shaded and named at the top; a single one is a line named at the foot.
struct FigureBand {
    Message name;
    double from = 0;
    double to = 0;
};

/// Layers of y along x, from below; the lower, the darker.
struct FigureLayers {
    std::vector<Message> names = {};
    std::vector<double> x = {};
    std::vector<std::vector<double>> edges = {};  ///< y over x between each layer and the next one
    std::vector<double> clear = {};               ///< y over x of a line that names keep clear of, or none
};

/// A line at a value of x that the reader can drag.
struct FigureHandle {
    Message name;
    double x = 0;
    std::optional<double> snap = {};  ///< a value that the line jumps to within a few pixels
};

/// A point of the first panel; without y a line.
struct FigurePoint {
    double x = 0;
    std::optional<double> y = {};
};

/// One plot. Panels of a row share the axis of y.
struct StudyPanel {
    std::size_t row = 0;   ///< from the top; rows follow each other in the list of panels
    double width = 1;      ///< over that of the first panel of its row
    double height = 1;     ///< over that of the first row; of the first panel of its row
    bool sharesX = false;  ///< its x axis shows the same values as that of the first panel
    FigureAxis x = {};
    FigureAxis y = {};                   ///< of the first panel of its row
    std::optional<FigureAxis> top = {};  ///< a second x axis
    double topPerX = 0;  ///< the top axis shows that many times x (values of `top` over values of `x`); 0: it
                         ///< has values of its own, of series that are `isOnTop`
    std::vector<FigureSeries> series = {};
    std::vector<FigureMark> marks = {};  ///< of the first series
    std::optional<FigureZone> zone = {};
    std::vector<FigureBand> bands = {};
    FigureLayers layers = {};
    std::optional<FigureHandle> handle = {};
    std::optional<FigureAxis> right = {};  ///< a second y axis
    bool hasOwnY = false;                  ///< its y axis is not that of its row
    bool isHidden = false;                 ///< leaves its room to the others
};

/// Panels in rows, with what stands above them. A figure with another number of panels is another figure:
/// series, marks and levels may change from one result to the next.
struct StudyFigure {
    std::vector<FigureText> caption = {};
    std::vector<StudyPanel> panels = {};
    std::vector<FigureLevel> levels = {};
    bool isPreview = false;  ///< a first look, without what needs the whole result
    Message summary = {};    ///< in words, where the caption says less
    int paperHeight = 110;   ///< [mm], of a figure 180 mm wide
};

}  // namespace drillwave
