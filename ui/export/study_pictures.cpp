// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/study_pictures.h"

#include "core/report/sequence_words.h"
#include "core/yaml/preset_file.h"
#include "ui/export/figure_plot.h"
#include "ui/export/sweep_panels.h"
#include "ui/pages/accuracy/proof_plot.h"
#include "ui/pages/curve/curve_plot.h"
#include "ui/pages/design/design_plot.h"
#include "ui/pages/drilling/drilling_plot.h"
#include "ui/pages/drilling/drilling_question.h"
#include "ui/pages/map/map_plot.h"
#include "ui/text/shown_text.h"

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
    CurvePageStudy study;
    study.question.curve = asked;
    study.curve = report.study;
    std::optional<double> here;
    if (asked.family && asked.family->parameter && asked.family->parameter->applies(asked.base))
        here = asked.family->parameter->value(asked.base);
    const bool isSi = asked.columns.front().units == OutputUnits::si;
    const ShownUnits units =
        shownUnits(isSi ? UnitSystem::si : UnitSystem::dimensionless, scalesOf(asked.base));
    const Unit& unit = customaryUnit(*asked.along.parameter, UnitSystem::si);
    return drawn(paperPlot<CurvePlot>(curvePicture(study, units, unit, here, builtInPresets(), reader.locale),
                                      {180, 120}, reader.locale),
                 asked.base.title, order);
}

Pictures drawStudy(const DesignReport& report, const PictureOrder& order, const PaperReader& reader) {
    const DesignUnits units(
        report.study, reader.unitsFor(report.study.base),
        [&](const Parameter& parameter) -> const Unit& { return reader.unitFor(parameter); }, reader.locale);
    return drawn(paperPlot<DesignPlot>(designPicture(report, units), {180, 180}, reader.locale),
                 report.study.base.title, order);
}

Pictures drawStudy(const DrillingReport& report, const PictureOrder& order, const PaperReader& reader) {
    const DrillingResult& result = report.result;
    DrillingPicture picture;
    picture.units = drillingShown(result.scenario, reader.unitFor(*findParameter("drill.thrust")),
                                  reader.unitsFor(result.scenario));
    if (result.blows.empty())
        picture.message = QString::fromStdString(sequenceText(result));
    else
        picture.march = marchPicture(result.blows, result.settings, result.units, &result,
                                     corOverPeriod(result.scenario, order.stop), picture.units);
    return drawn(paperPlot<DrillingPlot>(picture, {180, 130}, reader.locale), result.scenario.title, order);
}

Pictures drawStudy(const DrillingScanReport& report, const PictureOrder& order, const PaperReader& reader) {
    const DrillingScan& scan = report.scan;
    DrillingPicture picture;
    picture.units =
        drillingShown(scan.base, reader.unitFor(*scan.axis.parameter), reader.unitsFor(scan.base));
    picture.scan = scanPicture(scan, nullptr, nullptr, picture.units);
    if (scan.axis.parameter->applies(scan.base))
        if (const std::optional<double> value = scan.axis.parameter->value(scan.base))
            picture.installed = *value * picture.units.along.factor;
    if (picture.scan->scan.rate.isEmpty()) picture.message = tr("No value has statistics.");
    return drawn(paperPlot<DrillingPlot>(picture, {180, 80}, reader.locale), scan.base.title, order);
}

Pictures drawStudy(const StudyAnswer& answer, const PictureOrder& order, const PaperReader& reader) {
    return drawn(figurePaperPlot(answer.figure(0), answer.scenario(), reader), answer.scenario().title,
                 order);
}

// The report outlives the picture.
Pictures drawStudy(const MapReport& report, const PictureOrder& order, const PaperReader& reader) {
    const std::shared_ptr<const MapReport> shared(std::shared_ptr<const MapReport>(), &report);
    return drawn(
        paperPlot<MapPlot>(mapPicture(shared, reader.unitsFor(report.study.base)), {180, 140}, reader.locale),
        report.study.base.title, order);
}

Pictures drawStudy(const ThrustReport& report, const PictureOrder& order, const PaperReader& reader) {
    return drawn(thrustPaperPlot(report, reader), report.scenario.title, order);
}

Pictures drawStudy(const Accuracy& accuracy, const PictureOrder& order, const PaperReader& reader) {
    return drawn(paperPlot<ProofPlot>(accuracyPicture(accuracy, reader.locale), {160, 110}, reader.locale),
                 {}, order);
}

Pictures drawStudy(const StringAccuracy& accuracy, const PictureOrder& order, const PaperReader& reader) {
    return drawn(paperPlot<ProofPlot>(accuracyPicture(accuracy, reader.locale), {160, 110}, reader.locale),
                 {}, order);
}

Pictures drawStudy(const StabilityReport& report, const PictureOrder& order, const PaperReader& reader) {
    return drawn(paperPlot<ProofPlot>(stabilityPicture(report, reader.locale), {180, 120}, reader.locale), {},
                 order);
}

Pictures drawStudy(const SweepRows& rows, const PictureOrder& order, const PaperReader& reader) {
    return drawPanels(sweepPanels(rows), QString::fromStdString(rows.title), order, reader.locale);
}

}  // namespace drillwave
