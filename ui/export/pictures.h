// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as the bytes of files.
#pragma once

#include <QString>
#include <vector>

#include "core/archive/result_files.h"
#include "core/disk/whole_folder.h"
#include "ui/plot/plot_rendering.h"

namespace drillwave {

/// Pictures as files, or why there are none.
struct Pictures {
    std::vector<NamedFile> files;
    QString problem;  ///< one line
};

/// Renders the plot once in each format of the order, PNG at 200 dpi; `title` goes into the files'
/// properties. Not all of them after a stop. A plot meant for files has text in the C locale and
/// PlotStyle::forPaper(): then PNG and SVG are the same bytes for the same plot on one machine. Requires a
/// QApplication (any platform, also offscreen).
Pictures renderPictures(QCustomPlot& plot, Millimetres size, const QString& title, const PictureOrder& order);

}  // namespace drillwave
