// SPDX-License-Identifier: GPL-3.0-or-later
// Names of x and y of a curve, for the texts that give a point of it.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Returns the name of x: that of the meaning, else the label of the horizontal axis without its unit ("time
/// t" for "time t [ms]"). Stacked plots take the label of the lowest axis. Without a label the name is "x".
QString xNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);
/// Returns the name of y: that of the meaning, else the label of the vertical axis without its unit, else
/// "y".
QString yNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);

/// Returns the label of the horizontal axis of a curve, with its unit. If that axis has none, returns the
/// label of the lowest of the stacked plots; may be empty.
QString xLabelOf(const QCPAbstractPlottable& curve);

}  // namespace drillwave
