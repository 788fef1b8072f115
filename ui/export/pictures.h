// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of plots to the bytes of picture files.
#pragma once

#include <QString>
#include <vector>

#include "core/archive/result_files.h"
#include "core/disk/whole_folder.h"
#include "ui/plot/plot_rendering.h"

namespace drillwave {

/// Pictures as files in memory, or the reason why they could not be drawn.
struct Pictures {
    std::vector<NamedFile> files;
    QString problem;  ///< reason in one line; empty on success
};

/// Returns pictures of the plot, one for each format in `order`; PNG has 200 dpi. `title` is stored in the
/// files' properties. After a stop request, returns only those drawn so far. With text in the C locale and
/// PlotStyle::forPaper(), PNG and SVG are reproducible byte for byte on one machine. Requires a QApplication
/// (any platform, also offscreen).
Pictures renderPictures(QCustomPlot& plot, Millimetres size, const QString& title, const PictureOrder& order);

}  // namespace drillwave
