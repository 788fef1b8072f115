// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a blow as the bytes of files, on white whatever the colours of the window.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/blow.h"
#include "ui/export/paper_plots.h"
#include "ui/export/pictures.h"

namespace drillwave {

/// Returns the plots of a blow, each in every format; see renderPictures().
/// The file blow.* has waves, impact force, impulse and momentum (180 × 240 mm).
/// The file rock.* has force over penetration (120 × 90 mm).
/// The file wave_picture.* has force over position and time (180 × 110 mm).
/// The file rod.* has the largest stresses along rod or string (180 × 110 mm).
/// Requires a blow solved with Detail::histories; a drill string also needs its stored waves. A stop request
/// ends the work after the present picture.
Pictures drawBlowPlots(const Blow& blow, const std::vector<std::string>& formats,
                       const std::stop_token& stop = {}, const PaperReader& reader = {});

}  // namespace drillwave
