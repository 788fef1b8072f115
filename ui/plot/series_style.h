// SPDX-License-Identifier: GPL-3.0-or-later
// Pens and marks of the series of a figure.
#pragma once

#include <qcustomplot.h>

#include <QPen>
#include <cstddef>

#include "core/report/figure.h"
#include "ui/plot/plot_style.h"

namespace drillwave {

/// Returns the mark at each point of a series. `index` (from 0) chooses the shape where series of a kind
/// differ; `colour` is that of the line.
QCPScatterStyle scatterOf(SeriesPoints points, std::size_t index, const QColor& colour,
                          const PlotStyle& style);
/// Returns the pen of the line or outline of a series.
QPen penOf(const FigureSeries& series, const PlotStyle& style);
/// Returns whether a line joins the points of a series, or a strip is shaded between two lines.
bool isLine(const FigureSeries& series);

}  // namespace drillwave
