// SPDX-License-Identifier: GPL-3.0-or-later
// How the curves of an earlier blow stay faintly behind those of the present one.
#pragma once

#include <QPen>

#include "ui/plot/plot_style.h"

class QCPLayer;
class QCustomPlot;

namespace drillwave {

/// Thin, translucent and dotted, in the colour of the index-th curve.
QPen ghostPen(const PlotStyle& style, int index);

/// The layer below the curves, made when there is none.
QCPLayer* ghostLayer(QCustomPlot& plot);

}  // namespace drillwave
