// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/study_pictures.h"

#include "core/report/curve_figure.h"
#include "core/report/map_figure.h"
#include "core/yaml/preset_file.h"
#include "ui/export/figure_plot.h"
#include "ui/export/sweep_panels.h"
#include "ui/text/language.h"

namespace drillwave {
namespace {

/// Draws a plot in the formats of an order.
Pictures drawn(const PaperPlot& paper, const std::string& title, const PictureOrder& order) {
    return renderPictures(*paper.plot, paper.size, QString::fromStdString(title), order);
}

}  // namespace

// Draws the first of several outputs: the page shows one at a time.
Pictures drawStudy(const CurveReport& report, const PictureOrder& order, const PaperReader& reader) {
    const CurveQuestion& asked = report.study.question;
    std::optional<double> here;
    if (asked.family && asked.family->parameter && asked.family->parameter->applies(asked.base))
        here = asked.family->parameter->value(asked.base);
    const LocalStyle style(reader.locale, reader.system, reader.chosen);
    const StudyFigure figure = curveFigure({{asked}, report.study, {}, {}}, here, builtInPresets(), style);
    return drawn(figurePaperPlot(figure, asked.base, reader), asked.base.title, order);
}

Pictures drawStudy(const DesignReport& report, const PictureOrder& order, const PaperReader& reader) {
    return drawn(designPaperPlot(report, reader), report.study.base.title, order);
}

Pictures drawStudy(const DrillingReport& report, const PictureOrder& order, const PaperReader& reader) {
    return drawn(drillingPaperPlot(report.result, order.stop, reader), report.result.scenario.title, order);
}

Pictures drawStudy(const DrillingScanReport& report, const PictureOrder& order, const PaperReader& reader) {
    return drawn(scanPaperPlot(report.scan, reader), report.scan.base.title, order);
}

Pictures drawStudy(const StudyAnswer& answer, const PictureOrder& order, const PaperReader& reader) {
    return drawn(figurePaperPlot(answer.figure(0), answer.scenario(), reader), answer.scenario().title,
                 order);
}

Pictures drawStudy(const IdentifyReport& report, const PictureOrder& order, const PaperReader& reader) {
    const Scenario& scenario = report.question.scenario;
    const StudyFigure figure = identifyFigure(report.findings, report.findings.main());
    return drawn(figurePaperPlot(figure, scenario, reader), scenario.title, order);
}

// The report outlives the picture.
Pictures drawStudy(const MapReport& report, const PictureOrder& order, const PaperReader& reader) {
    const std::shared_ptr<const MapReport> shared(std::shared_ptr<const MapReport>(), &report);
    const Scenario& base = report.study.base;
    const std::optional<FigurePoint> here = mapPlaceOf(report.study, base);
    const StudyFigure figure = mapFigure(shared, mapSectionAt(report, here), builtInPresets());
    return drawn(figurePaperPlot(figure, base, reader, here), base.title, order);
}

Pictures drawStudy(const SweepRows& rows, const PictureOrder& order, const PaperReader& reader) {
    return drawPanels(sweepPanels(rows), QString::fromStdString(rows.title), order, reader.locale);
}

}  // namespace drillwave
