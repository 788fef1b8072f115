// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a blow on pages, of a file or of paper.
#pragma once

#include <vector>

#include "ui/export/report_plots.h"

class QPagedPaintDevice;

namespace drillwave {

/// Draws the words of reportHtml() for paper and the plots as vectors, a line with title and program above
/// each page and its number below, with margins of 15 mm; on A4 two to five pages without studies. False if
/// the device takes no pages, for example a printer that is gone.
bool drawReportPages(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style, QPagedPaintDevice& device);

}  // namespace drillwave
