// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of a report with their captions.
#pragma once

#include <stop_token>
#include <vector>

#include "core/report/report_html.h"
#include "ui/export/paper_plots.h"

namespace drillwave {

/// Plot of a report with its caption. In the text of the report, `picture.source` is the name of the plot.
struct ReportPlot {
    ReportPicture picture;
    PaperPlot paper;
};

/// Returns the plots of a report; plots without data are left out. After a stop request, the plots must not
/// be used.
std::vector<ReportPlot> reportPlots(const BlowReport& report, const PaperReader& reader,
                                    const std::stop_token& stop);

}  // namespace drillwave
