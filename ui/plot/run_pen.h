// SPDX-License-Identifier: GPL-3.0-or-later
// Pens of pinned runs: each has its own colour and dash.
#pragma once

#include "ui/plot/plot_style.h"

class QIcon;
class QSize;

namespace drillwave {

/// Returns the pen of run 0, 1, 2 …: a colour that no curve of a page has, of contrast 4.5 at least with the
/// background, and a dash. The first six differ in both, thirty-six in one of them; none is solid.
QPen runPen(int number, const PlotStyle& style);

/// A piece of that line, for a list. Takes the colours of the palette.
QIcon runIcon(int number, const QPalette& palette, QSize size);

}  // namespace drillwave
