// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a blow as the bytes of files, always on white, whatever the window looks like.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/blow/blow.h"
#include "ui/export/pictures.h"

namespace drillwave {

/// Draws blow.* (waves, impact force, impulse, momentum; 180 × 240 mm) and rock.* (force–penetration; 120 ×
/// 90 mm), of a rod rod.* too, once per format, in naturalUnits(); see renderPictures(). Requires an impact
/// solved with Detail::histories. A stop ends it between two pictures.
Pictures drawBlowPlots(const Blow& blow, const std::vector<std::string>& formats,
                       const std::stop_token& stop = {});
Pictures drawBlowPlots(const Scenario& scenario, const Impact& impact,
                       const std::vector<std::string>& formats, const std::stop_token& stop = {});

}  // namespace drillwave
