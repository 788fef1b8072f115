// SPDX-License-Identifier: GPL-3.0-or-later
// The report on a blow as a PDF file with pages of A4.
#pragma once

#include <QByteArray>
#include <vector>

#include "ui/export/report_plots.h"

namespace drillwave {

/// Returns the bytes of a PDF file with the pages of drawReportPages(); the file has no date.
QByteArray reportPdf(const BlowReport& report, const std::vector<ReportPlot>& plots,
                     const ReadingStyle& style);

}  // namespace drillwave
