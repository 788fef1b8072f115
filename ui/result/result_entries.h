// SPDX-License-Identifier: GPL-3.0-or-later
// What the rows of the result panel say.
#pragma once

#include <QList>

#include "ui/result/result_row.h"
#include "ui/result/worst_need.h"

namespace drillwave {

/// By this name the rows are found that wait for the study of all gaps.
inline const QString worstName = QStringLiteral("worstNeed");

/// Of all outputs of a group, in its order; of a largest stress the place, too, in a row below.
QList<ResultEntry> outputEntries(OutputGroup group);

/// Required and installed feed. `worst` is of the blow on show and must outlive the
/// rows; `worstOf` gives the need of any blow.
QList<ResultEntry> thrustEntries(const WorstNeed& worst, const ResultEntry::Number& worstOf);

/// What all shares of the energy are of, where the hammer is followed, whose work on the string is less.
ResultEntry hammerEnergyEntry();

/// The coefficient of restitution, with its error in the tooltip.
ResultEntry corEntry();

}  // namespace drillwave
