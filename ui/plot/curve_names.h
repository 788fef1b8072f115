// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the two numbers of a point of a curve.
#pragma once

#include <qcustomplot.h>

#include "ui/plot/curve_meaning.h"

namespace drillwave {

/// As the meaning has it, else what the axis says without its unit: "time t" of "time t [ms]"; of stacked
/// plots the lowest alone carries the label of the common axis. "x" and "y" where nobody says anything.
QString xNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);
QString yNameOf(const QCPAbstractPlottable& curve, const CurveMeaning& meaning);

/// The label of the horizontal axis of a curve, or that of the lowest of stacked plots; may be empty.
QString xLabelOf(const QCPAbstractPlottable& curve);

}  // namespace drillwave
