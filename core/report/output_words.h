// SPDX-License-Identifier: GPL-3.0-or-later
// Names of outputs for people, and their numbers in figures.
#pragma once

#include "core/report/figure.h"
#include "core/study/rows/output_column.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the name of an output for selection boxes and axis titles: "peak force", "COR e".
Message outputMessage(const Output& output);

/// Returns the quantity that the axis of a figure shows for an output column. It is a multiple of a scale
/// such as F0, a plain number, or an SI value for outputs without a dimensionless form. `size` is the typical
/// magnitude of such SI values.
FigureQuantity figureQuantity(const OutputColumn& column, double size);

}  // namespace drillwave
