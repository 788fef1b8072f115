// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_export.h"

#include <QPrinter>

#include "ui/export/report_pages.h"
#include "ui/export/report_pdf.h"
#include "ui/export/report_plots.h"

namespace drillwave {
namespace {

/// The page with its pictures in it.
std::string htmlOf(const BlowReport& report, const std::vector<ReportPlot>& plots, const QString& title) {
    std::vector<ReportPicture> pictures;
    for (const ReportPlot& plot : plots) {
        const QByteArray svg = renderPlot(*plot.paper.plot, plot.paper.size, QStringLiteral("svg"), title);
        ReportPicture picture = plot.picture;
        picture.source = "data:image/svg+xml;base64," + svg.toBase64().toStdString();
        pictures.push_back(std::move(picture));
    }
    return reportHtml(report, pictures, ReportMedium::screen);
}

}  // namespace

bool printReport(const BlowReport& report, QPrinter& printer) {
    return drawReportPages(report, reportPlots(report, {}), printer);
}

Pictures drawReport(const BlowReport& report, const PictureOrder& order) {
    Pictures drawn;
    const QString title = QString::fromStdString(reportTitle(report));
    const std::vector<ReportPlot> plots = reportPlots(report, order.stop);
    for (const std::string& format : order.formats) {
        if (order.stop.stop_requested()) return drawn;
        const std::string name = order.stem + "." + format;
        if (format == "html")
            drawn.files.push_back({name, htmlOf(report, plots, title)});
        else
            drawn.files.push_back({name, reportPdf(report, plots).toStdString()});
    }
    return drawn;
}

}  // namespace drillwave
