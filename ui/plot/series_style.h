// SPDX-License-Identifier: GPL-3.0-or-later
// Pens and marks of the series of a figure.
#pragma once

#include <qcustomplot.h>

#include <QPen>
#include <cstddef>

#include "core/report/figure.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Returns the mark drawn at each point of a series of a figure. `colour` is that of the series. For some
/// kinds of `points`, `index` (from 0) chooses the shape, so that series differ.
QCPScatterStyle scatterOf(SeriesPoints points, std::size_t index, const QColor& colour,
                          const PlotStyle& style);
/// Returns the pen for a series (curve or set of points) of a figure: for its line, or for the outline of its
/// area.
QPen penOf(const FigureSeries& series, const PlotStyle& style);
/// Returns whether a series of a figure is drawn as a line through its points or as a strip between two
/// lines. False if it is drawn as separate marks.
bool isLine(const FigureSeries& series);

}  // namespace drillwave
