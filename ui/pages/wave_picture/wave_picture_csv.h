// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of a blow as numbers for other programs.
#pragma once

#include <QByteArray>
#include <QString>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"

namespace drillwave {

/// Returns a table with one row for each position and time: position, time and field, in the units of the
/// picture, with the titles `names`. It has 101 equally spaced positions in the window, ends included, at
/// each of 201 times. For a drill string, no time is later than the end of its computation. Values are exact;
/// at a jump, the value after the jump is given. `separator` stands between the cells. Requires a blow with a
/// wave picture.
QByteArray wavePictureCsv(const SolvedBlow& blow, WaveQuantity field, const PictureWindow& window,
                          const QStringList& names, char separator);

}  // namespace drillwave
