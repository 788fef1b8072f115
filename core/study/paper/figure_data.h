// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the paper as data: panels with curves, used for tables and plots.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Curve as points that are joined by straight lines. An abscissa occurs twice where the curve jumps.
struct FigureCurve {
    std::string key;    ///< name of the CSV column, such as "elastic_reference"
    std::string label;  ///< text for legends
    std::vector<double> x;
    std::vector<double> y;
    enum class Line {
        solid,
        dotted,
        dashed,
        none,  ///< not drawn; written to the table only
    } line = Line::solid;
    int colour = 0;  ///< colour index; curves that belong together have the same index
};

/// Diagram with axes and curves.
struct FigurePanel {
    std::string name;    ///< file name of the panel without extension, such as "fig4a"
    std::string title;   ///< title, such as "(a) elastic spring, γ = 1"
    std::string xKey;    ///< name of the CSV column of the abscissas
    std::string xLabel;  ///< label of the x axis
    std::string yKey;    ///< name of the CSV column of the ordinates, if the curves have different abscissas
    std::string yLabel;
    bool logarithmicX = false;
    /// Start of the x axis if it is before the first data point; empty otherwise.
    std::optional<double> xFrom = {};
    std::vector<FigureCurve> curves;
};

struct Figure {
    int number = 0;
    std::string caption;  ///< caption of one sentence, which states the parameters
    std::vector<FigurePanel> panels;
};

/// Returns the CSV table of a panel. If all curves have the same abscissas, there is one column per curve;
/// otherwise the columns are curve, x and y.
std::string panelCsv(const FigurePanel& panel);

}  // namespace drillwave
