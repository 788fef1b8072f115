// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/paper_plots.h"

#include <qcustomplot.h>

#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/gap/gap_plot.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/pages/string/string_sketch.h"
#include "ui/pages/thrust/thrust_plot.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"

namespace drillwave {
namespace {

ShownUnits unitsFor(const Scenario& scenario) {
    return shownUnits(naturalUnits(scenario), scalesOf(scenario));
}

/// The middle of a rod; in a string that of its longest section, where histories.csv has its waves too.
double shownSection(const Blow& blow) {
    if (!blow.string) return 0.5;
    const DrillString& drill = blow.scenario.drillString;
    return shareOfString(drill, middleOfLongest(drill));
}

}  // namespace

std::shared_ptr<QCustomPlot> emptyPaperPlot() {
    auto plot = std::make_shared<QCustomPlot>();
    plot->setLocale(QLocale::c());
    return plot;
}

PaperPlot blowPaperPlot(const Blow& blow) {
    return paperPlot<BlowPlots>(blowCurves(blow, unitsFor(blow.scenario), shownSection(blow), Tail::cut),
                                {180, 240});
}

PaperPlot rockPaperPlot(const Blow& blow) {
    return paperPlot<RockPlot>(rockCurve(blow, unitsFor(blow.scenario)), {120, 90});
}

PaperPlot blowPaperPlot(const Scenario& scenario, const Impact& impact) {
    const Problem problem = problemOf(scenario);
    return paperPlot<BlowPlots>(blowCurves(impact, problem.hammer, unitsFor(scenario), 0.5, Tail::cut),
                                {180, 240});
}

PaperPlot rockPaperPlot(const Scenario& scenario, const Impact& impact) {
    return paperPlot<RockPlot>(rockCurve(impact, problemOf(scenario), unitsFor(scenario)), {120, 90});
}

PaperPlot rodPaperPlot(const Scenario& scenario, const Impact& impact, const std::stop_token& stop) {
    const Problem problem = problemOf(scenario);
    return paperPlot<RodPlot>(rodCurves(impact, problem.hammer, scenario, unitsFor(scenario), stop),
                              {180, 110});
}

PaperPlot rodPaperPlot(const Blow& blow, const std::stop_token& stop) {
    return paperPlot<RodPlot>(rodCurves(blow, unitsFor(blow.scenario), stop), {180, 110});
}

PaperPlot stringPaperPlot(const Scenario& scenario) {
    return paperPlot<StringSketch>(scenario, {180, 44});
}

PaperPlot wavePaperPlot(const Blow& blow) {
    // At 180 mm about 150 cells an inch.
    constexpr WavePictureNeed need{.field = WaveQuantity::force, .window = {}, .columns = 900, .rows = 450};
    auto solved = std::make_shared<SolvedBlow>();
    static_cast<Blow&>(*solved) = blow;
    solved->request.scenario = blow.scenario;
    solved->request.units = naturalUnits(blow.scenario);
    solved->units = unitsFor(blow.scenario);
    solved->pages.push_back(PageData::of(wavePicture(blow, solved->units, need)));
    return paperPlot<WavePicturePlot>(SolvedBlowPtr(std::move(solved)), {180, 110});
}

PaperPlot gapPaperPlot(const GapReport& report) {
    return paperPlot<GapPlot>(gapPicture(report, GapOutput::cor, unitsFor(report.scenario)), {180, 110});
}

PaperPlot thrustPaperPlot(const ThrustReport& report) {
    const Scenario& scenario = report.scenario;
    const ThrustUnits units =
        thrustUnits(scenario, report.along->axis.parameter->displayUnit(), unitsFor(scenario));
    return paperPlot<ThrustPlot>(thrustPicture(*report.along, units), {180, 120});
}

}  // namespace drillwave
