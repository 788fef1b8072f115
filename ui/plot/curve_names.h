// SPDX-License-Identifier: GPL-3.0-or-later
// Names of x and y of a curve, for the texts that give a point of it.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Returns the name of x for readings: `xName` of `meaning`, else the label of the horizontal axis without
/// its unit ("time t" for "time t [ms]"). A stacked plot without a label uses that of the lowest plot.
/// Without any label the name is "x".
QString xNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);
/// Returns the name of y for readings: `yName` of `meaning`, else the label of the vertical axis without its
/// unit, else "y".
QString yNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);

/// Returns the label of the horizontal axis of a curve, with its unit. If that axis has no label because
/// plots are stacked, returns the label of the lowest plot; may be empty.
QString xLabelOf(const QCPAbstractPlottable& curve);

}  // namespace drillwave
