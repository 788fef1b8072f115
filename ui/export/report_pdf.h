// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a blow as pages of A4.
#pragma once

#include <QByteArray>
#include <vector>

#include "ui/export/report_plots.h"

namespace drillwave {

/// Returns the pages of drawReportPages() as a file, without a date.
QByteArray reportPdf(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style);

}  // namespace drillwave
