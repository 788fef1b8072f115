// SPDX-License-Identifier: GPL-3.0-or-later
// Names of outputs for people, and their numbers in figures.
#pragma once

#include "core/report/figure.h"
#include "core/study/rows/output_column.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns what a box or an axis calls an output: "peak force", "COR e".
Message outputMessage(const Output& output);

/// Returns the quantity of a column on the axis of a figure. Values there are the column's values divided by
/// its scale; those without a dimensionless number are in SI, most of them about as large as `size`.
FigureQuantity figureQuantity(const OutputColumn& column, double size);

}  // namespace drillwave
