// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_plots.h"

#include <qcustomplot.h>

#include "core/model/chain_words.h"
#include "core/report/gap_report.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// Gives a plot as much of a page of A4 as it can have together with the others.
ReportPlot placed(const char* name, const QString& caption, PaperPlot paper, Millimetres size) {
    paper.size = size;
    return {{name, caption.toStdString(), name}, std::move(paper)};
}

QString blowCaption(const BlowReport& report) {
    const ChainWords& words = chainWords(report.blow.scenario);
    const MeasuredSignal* inside = firstInside(report.measured);
    const QString where = inside ? tr("where \"%1\" was measured").arg(QString::fromStdString(inside->name))
                                 : translated(words.historyPlace);
    return translated(words.blowCaption).arg(where) +
           (report.measured.empty() ? QString() : QLatin1Char(' ') + tr("Measured signals are dashed."));
}

// Adds the curves if the waves were kept. On paper, the first one of a rod fills the page of the tables, the
// next two a page, the others the last one.
void addCurves(std::vector<ReportPlot>& plots, const BlowReport& report, const PaperReader& reader,
               const std::stop_token& stop) {
    const Blow& blow = report.blow;
    plots.push_back(placed("rock", tr("Force over penetration: the area inside stays in the rock as energy."),
                           rockPaperPlot(blow, reader), {120, 66}));
    plots.push_back(
        placed("blow", blowCaption(report), blowPaperPlot(blow, reader, report.measured), {180, 128}));
    if (report.sections.empty())
        plots.push_back(placed("wave_picture",
                               tr("The force in the rod over place and time, tension positive; bars at the "
                                  "right show contact of bit and rock. On the colour scale, lines mark the "
                                  "smallest and largest force, triangles forces beyond the colours."),
                               wavePaperPlot(blow, reader), {180, 86}));
    plots.push_back(placed("rod", translated(chainWords(blow.scenario).stressCaption),
                           rodPaperPlot(blow, stop, reader), {180, 84}));
}

void addStudies(std::vector<ReportPlot>& plots, const ReportStudies& studies, const PaperReader& reader,
                const std::stop_token& stop) {
    if (studies.drilling)
        plots.push_back(placed("drilling",
                               tr("Continuous drilling: gap and penetration of every blow, how the gaps "
                                  "scatter and follow each other, and the shares of the energy."),
                               drillingPaperPlot(*studies.drilling, stop, reader), {180, 110}));
    if (studies.scan && studies.scan->axis.parameter)
        plots.push_back(placed("scan",
                               tr("Penetration rate, contact and gaps of continuous drilling over "
                                  "one parameter."),
                               scanPaperPlot(*studies.scan, reader), {180, 100}));
    if (studies.design)
        plots.push_back(
            placed("design",
                   tr("The designs: the first aim over the choice, with its scatter. Several aims and "
                      "several uncertain inputs are compared below."),
                   designPaperPlot(*studies.design, reader), {180, 120}));
}

}  // namespace

std::vector<ReportPlot> reportPlots(const BlowReport& report, const PaperReader& reader,
                                    const std::stop_token& stop) {
    std::vector<ReportPlot> plots;
    if (!report.sections.empty())
        plots.push_back(placed(stringPicture.data(),
                               tr("Hammer (dark) and string, lengths and diameters each to scale, with the "
                                  "numbers of the sections; the bore is dashed, the rock is at the right."),
                               stringPaperPlot(report.blow.scenario, reader), {180, 44}));
    if (report.blow.impact.hasHistories()) addCurves(plots, report, reader, stop);
    if (report.gap)
        plots.push_back(
            placed("gap",
                   tr("Restitution over one period of the gap between bit and rock, and its distribution "
                      "when all gaps are equally likely."),
                   figurePaperPlot(gapFigure(*report.gap, GapOutput::cor), report.blow.scenario, reader),
                   {180, 72}));
    if (report.thrust && report.thrust->along)
        plots.push_back(placed("thrust", tr("Required and installed feed force over the blow frequency."),
                               figurePaperPlot(thrustFigure(*report.thrust), report.blow.scenario, reader),
                               {180, 58}));
    addStudies(plots, report.studies, reader, stop);
    return plots;
}

}  // namespace drillwave
