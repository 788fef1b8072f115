// SPDX-License-Identifier: GPL-3.0-or-later
// A figure as data: panels of curves, for tables and for plots.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Curve as points to be joined by straight lines; an abscissa occurs twice where the curve jumps.
struct FigureCurve {
    std::string key;    ///< name of a CSV column, "elastic_reference"
    std::string label;  ///< for legends
    std::vector<double> x;
    std::vector<double> y;
    enum class Line {
        solid,
        dotted,
        dashed,
        none,  ///< in the table only
    } line = Line::solid;
    int colour = 0;  ///< the same for lines that belong together
};

/// A diagram.
struct FigurePanel {
    std::string name;    ///< of its file: "fig4a"
    std::string title;   ///< "(a) elastic spring, γ = 1"
    std::string xKey;    ///< name of a CSV column
    std::string xLabel;  ///< for the axis
    std::string yKey;    ///< name of the column where the curves have one each of their own
    std::string yLabel;
    bool logarithmicX = false;
    std::optional<double> xFrom = {};  ///< where the axis begins, if before the data
    std::vector<FigureCurve> curves;
};

struct Figure {
    int number = 0;
    std::string caption;  ///< one sentence with the parameters
    std::vector<FigurePanel> panels;
};

/// Returns the table of a panel: one column per curve if all have the same abscissas, otherwise the columns
/// curve, x and y.
std::string panelCsv(const FigurePanel& panel);

}  // namespace drillwave
