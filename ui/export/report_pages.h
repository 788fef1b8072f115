// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing the report on a blow on the pages of a file or of a printer.
#pragma once

#include <vector>

#include "ui/export/report_plots.h"

class QPagedPaintDevice;

namespace drillwave {

/// Draws the text of reportHtml() and the plots, as vectors, on pages with margins of 15 mm. Each page has
/// the title and the program's name at the top, and its number at the bottom. Returns false if the device
/// accepts no pages, for example an unplugged printer.
bool drawReportPages(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style, QPagedPaintDevice& device);

}  // namespace drillwave
