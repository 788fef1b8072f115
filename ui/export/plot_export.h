// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a blow as the bytes of files, always on white, whatever the window looks like.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/blow.h"
#include "ui/export/paper_plots.h"
#include "ui/export/pictures.h"

namespace drillwave {

/// Draws blow.* (waves, impact force, impulse, momentum; 180 × 240 mm), rock.* (force–penetration; 120 × 90
/// mm), wave_picture.* (force over place and time; 180 × 110 mm) and rod.* (largest stresses along rod or
/// string; 180 × 110 mm), once per format; see renderPictures(). Requires a blow solved with
/// Detail::histories, for drill strings with its waves kept. A stop ends it between two pictures.
Pictures drawBlowPlots(const Blow& blow, const std::vector<std::string>& formats,
                       const std::stop_token& stop = {}, const PaperReader& reader = {});

}  // namespace drillwave
