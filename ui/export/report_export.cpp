// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_export.h"

#include <QPrinter>
#include <optional>

#include "ui/export/report_pages.h"
#include "ui/export/report_pdf.h"
#include "ui/export/report_plots.h"
#include "ui/text/language.h"

namespace drillwave {
namespace {

/// The page with its pictures in it.
std::string htmlOf(const BlowReport& report, const std::vector<ReportPlot>& plots,
                   const ReadingStyle& style) {
    const QString title = QString::fromStdString(reportTitle(report, style));
    std::vector<ReportPicture> pictures;
    for (const ReportPlot& plot : plots) {
        const QByteArray svg = renderPlot(*plot.paper.plot, plot.paper.size, QStringLiteral("svg"), title);
        ReportPicture picture = plot.picture;
        picture.source = "data:image/svg+xml;base64," + svg.toBase64().toStdString();
        pictures.push_back(std::move(picture));
    }
    return reportHtml(report, pictures, ReportMedium::screen, style);
}

/// For a reader with the words and numbers of the commands, the page has the bytes of the commands.
template <class Use>
auto inStyleOf(const PaperReader& reader, const Use& use) {
    std::optional<EnglishTexts> english;
    if (!reader.isSpokenTo) english.emplace();
    if (reader.isPlain()) return use(plainStyle());
    return use(LocalStyle(reader.locale, reader.system, reader.chosen));
}

}  // namespace

bool printReport(const BlowReport& report, const PaperReader& reader, QPrinter& printer) {
    return inStyleOf(reader, [&](const ReadingStyle& style) {
        return drawReportPages(report, reportPlots(report, reader, {}), style, printer);
    });
}

Pictures drawReport(const BlowReport& report, const PictureOrder& order, const PaperReader& reader) {
    Pictures drawn;
    inStyleOf(reader, [&](const ReadingStyle& style) {
        const std::vector<ReportPlot> plots = reportPlots(report, reader, order.stop);
        for (const std::string& format : order.formats) {
            if (order.stop.stop_requested()) return;
            const std::string bytes = format == "html" ? htmlOf(report, plots, style)
                                                       : reportPdf(report, plots, style).toStdString();
            drawn.files.push_back({order.stem + "." + format, bytes});
        }
    });
    return drawn;
}

}  // namespace drillwave
