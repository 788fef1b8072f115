// SPDX-License-Identifier: GPL-3.0-or-later
// Pens of pinned runs (results kept for comparison): each has its own colour and dash pattern.
#pragma once

#include "ui/plot/plot_style.h"

class QIcon;
class QSize;

namespace drillwave {

/// Returns the pen of pinned run `number` (from 0). Its colour is used by no curve of a page and has a
/// contrast of at least 4.5 to the background. The first six pens differ in both colour and dashes, the first
/// thirty-six in at least one of them; no pen is solid.
QPen runPen(int number, const PlotStyle& style);

/// Returns an icon with a line in the pen of pinned run `number` (from 0), for a list of runs. The palette
/// decides whether the colours are for a light or a dark background.
QIcon runIcon(int number, const QPalette& palette, QSize size);

}  // namespace drillwave
