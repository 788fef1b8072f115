// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a blow as files.
#pragma once

#include "core/report/blow_report.h"
#include "ui/export/paper_plots.h"
#include "ui/export/pictures.h"

class QPrinter;

namespace drillwave {

/// Prints the report: the pages of the PDF. False where the printer takes none. Requires what drawReport()
/// does.
bool printReport(const BlowReport& report, const PaperReader& reader, QPrinter& printer);

/// Draws the report in the formats of the order, "html" and "pdf": the same words and plots. The HTML is the
/// same bytes for the same report and reader on one machine, whatever the window shows. Requires a solved
/// blow and a QApplication (any platform, also offscreen). Not all of them after a stop.
Pictures drawReport(const BlowReport& report, const PictureOrder& order, const PaperReader& reader = {});

}  // namespace drillwave
