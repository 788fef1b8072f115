// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a report with their captions.
#pragma once

#include <stop_token>
#include <vector>

#include "core/report/report_html.h"
#include "ui/export/paper_plots.h"

namespace drillwave {

/// A plot of a report; the source of its picture is its name.
struct ReportPlot {
    ReportPicture picture;
    PaperPlot paper;
};

/// Draws the plots of a report that have data. A stop ends the work early; the plots must not be used then.
std::vector<ReportPlot> reportPlots(const BlowReport& report, const PaperReader& reader,
                                    const std::stop_token& stop);

}  // namespace drillwave
