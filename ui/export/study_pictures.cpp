// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/study_pictures.h"

#include "ui/export/figure_plot.h"
#include "ui/export/sweep_panels.h"
#include "ui/pages/gap/gap_plot.h"
#include "ui/pages/map/map_plot.h"

namespace drillwave {
namespace {

/// By the plot of a page: a Plot is made around a QCustomPlot, and has setStyle() and present(shown).
template <class Plot, class Shown>
Pictures drawnBy(const Shown& shown, Millimetres size, const std::string& title, const PictureOrder& order) {
    QCustomPlot widget;
    widget.setLocale(QLocale::c());
    Plot plot(&widget);
    plot.setStyle(PlotStyle::forPaper());
    plot.present(shown);
    return renderPictures(widget, size, QString::fromStdString(title), order);
}

ShownUnits unitsFor(const Scenario& scenario) {
    return shownUnits(naturalUnits(scenario), scalesOf(scenario));
}

}  // namespace

Pictures drawStudy(const GapReport& report, const PictureOrder& order) {
    return drawnBy<GapPlot>(gapPicture(report, GapOutput::cor, unitsFor(report.scenario)), {180, 110},
                            report.scenario.title, order);
}

// The report outlives the picture.
Pictures drawStudy(const MapReport& report, const PictureOrder& order) {
    const std::shared_ptr<const MapReport> shared(std::shared_ptr<const MapReport>(), &report);
    return drawnBy<MapPlot>(mapPicture(shared, unitsFor(report.study.base)), {180, 140},
                            report.study.base.title, order);
}

Pictures drawStudy(const SweepRows& rows, const PictureOrder& order) {
    return drawPanels(sweepPanels(rows), QString::fromStdString(rows.title), order);
}

}  // namespace drillwave
