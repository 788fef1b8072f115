// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing the report on a blow on the pages of a file or of a printer.
#pragma once

#include <vector>

#include "ui/export/report_plots.h"

class QPagedPaintDevice;

namespace drillwave {

/// Draws the words of reportHtml() and the plots, as vectors, on pages with margins of 15 mm. Title and
/// program are above each page, its number is below. A4 without studies takes two to five pages. Returns
/// false if the device accepts no pages, for example an unplugged printer.
bool drawReportPages(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style, QPagedPaintDevice& device);

}  // namespace drillwave
