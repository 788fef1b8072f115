// SPDX-License-Identifier: GPL-3.0-or-later
// Legend and caption above a plot, where they can hide no part of a curve.
#pragma once

class QCPTextElement;
class QCustomPlot;

namespace drillwave {

/// Moves the legend of a plot above its axes, with a caption of no words yet below it, and `spaceBelow` that
/// [px]. Returns the caption.
QCPTextElement* addPlotHeader(QCustomPlot& plot, int spaceBelow);

}  // namespace drillwave
