// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the two numbers of a point of a curve.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// Returns the name in the meaning, else the label of the axis without its unit: "time t" of "time t [ms]";
/// in stacked plots only the lowest has the label of the common axis. "x" and "y" if there is neither.
QString xNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);
QString yNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);

/// The label of the horizontal axis of a curve, or that of the lowest of stacked plots; may be empty.
QString xLabelOf(const QCPAbstractPlottable& curve);

}  // namespace drillwave
