// SPDX-License-Identifier: GPL-3.0-or-later
// Writing the report on a blow to files or to a printer.
#pragma once

#include "core/report/blow_report.h"
#include "ui/export/paper_plots.h"
#include "ui/export/pictures.h"

class QPrinter;

namespace drillwave {

/// Prints the pages of the report. Returns false if the printer accepts no pages. Requires a solved blow and
/// a QApplication (any platform, also offscreen).
bool printReport(const BlowReport& report, const PaperReader& reader, QPrinter& printer);

/// Returns the report on a blow as files, one for each format in `order` ("html" or "pdf"), with the same
/// words and plots. After a stop request, returns only the finished files. The HTML is reproducible byte for
/// byte on one machine. Requires a solved blow and a QApplication (any platform, also offscreen).
Pictures drawReport(const BlowReport& report, const PictureOrder& order, const PaperReader& reader = {});

}  // namespace drillwave
