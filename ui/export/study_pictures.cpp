// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/study_pictures.h"

#include "core/file/preset_file.h"
#include "ui/export/figure_plot.h"
#include "ui/export/sweep_panels.h"
#include "ui/pages/accuracy/proof_plot.h"
#include "ui/pages/gap/gap_plot.h"
#include "ui/pages/map/map_plot.h"
#include "ui/pages/stiffness/stiffness_plot.h"
#include "ui/pages/thrust/thrust_plot.h"

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

// Of several outputs the first: the page shows one at a time.
Pictures drawStudy(const CurveReport& report, const PictureOrder& order) {
    const CurveQuestion& asked = report.study.question;
    StiffnessStudy study;
    study.question.curve = asked;
    study.curve = report.study;
    std::optional<double> here;
    if (asked.family && asked.family->parameter && asked.family->parameter->applies(asked.base))
        here = asked.family->parameter->value(asked.base);
    const bool isSi = asked.columns.front().units == OutputUnits::si;
    const ShownUnits units =
        shownUnits(isSi ? UnitSystem::si : UnitSystem::dimensionless, scalesOf(asked.base));
    const Unit& unit = customaryUnit(*asked.along.parameter, UnitSystem::si);
    return drawnBy<StiffnessPlot>(stiffnessPicture(study, units, unit, here, builtInPresets(), QLocale::c()),
                                  {180, 120}, asked.base.title, order);
}

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

Pictures drawStudy(const ThrustReport& report, const PictureOrder& order) {
    const Scenario& scenario = report.scenario;
    const ThrustUnits units =
        thrustUnits(scenario, report.along->axis.parameter->displayUnit(), unitsFor(scenario));
    return drawnBy<ThrustPlot>(thrustPicture(*report.along, units), {180, 120}, scenario.title, order);
}

Pictures drawStudy(const Accuracy& accuracy, const PictureOrder& order) {
    return drawnBy<ProofPlot>(accuracyPicture(accuracy, QLocale::c()), {160, 110}, {}, order);
}

Pictures drawStudy(const StabilityReport& report, const PictureOrder& order) {
    return drawnBy<ProofPlot>(stabilityPicture(report, QLocale::c()), {180, 120}, {}, order);
}

Pictures drawStudy(const SweepRows& rows, const PictureOrder& order) {
    return drawPanels(sweepPanels(rows), QString::fromStdString(rows.title), order);
}

}  // namespace drillwave
