// SPDX-License-Identifier: GPL-3.0-or-later
// The x–t picture of a blow as numbers for other programs.
#pragma once

#include <QByteArray>
#include <QString>

#include "ui/job/solved_blow.h"
#include "ui/pages/wave_picture/wave_picture.h"

namespace drillwave {

/// Returns one row for each place and time: position, time, field, in the units of the picture, under
/// `names`; 101 places evenly over the part of rod, or hammer and string, in the window, ends included, at
/// each of 201 times (for a string none later than it was followed). Exact at every one of them; at a jump
/// the value after it. `separator` as in plotCsv(). Requires a blow with a picture.
QByteArray wavePictureCsv(const SolvedBlow& blow, WaveQuantity field, const PictureWindow& window,
                          const QStringList& names, char separator);

}  // namespace drillwave
