// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as the bytes of files, always on white, whatever the window looks like.
#pragma once

#include <QString>
#include <QStringList>
#include <stop_token>
#include <vector>

#include "core/file/whole_folder.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Pictures as files, or why there are none.
struct BlowPictures {
    std::vector<NamedFile> files;
    QString problem;  ///< one line
};

/// Draws blow.* (waves, impact force, impulse, momentum; 180 × 240 mm) and rock.* (force–penetration; 120 ×
/// 90 mm), once per format, in naturalUnits(); PNG at 200 dpi. Text is in the C locale, and PNG and SVG are
/// the same bytes for the same input on one machine. Requires an impact solved with Detail::histories and a
/// QApplication (any platform, also offscreen). A stop ends it between two pictures.
BlowPictures drawBlowPlots(const Scenario& scenario, const Impact& impact, const QStringList& formats,
                           const std::stop_token& stop = {});

}  // namespace drillwave
