// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/paper_plots.h"

#include <qcustomplot.h>

#include <algorithm>

#include "core/model/assignments.h"
#include "core/report/design_figure.h"
#include "core/report/drilling_figure.h"
#include "core/report/sequence_words.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/blow/measured_curves.h"
#include "ui/pages/blow/measured_force.h"
#include "ui/pages/design/design_units.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/pages/string/string_sketch.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/figure_frame.h"
#include "ui/text/language.h"
#include "ui/text/shown_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {

namespace {

FigureFrame& frameOf(const PaperPlot& paper) {
    return *paper.plot->findChild<FigureFrame*>();
}

}  // namespace

PaperReader PaperReader::of(const UnitChoice& units) {
    const PaperReader reader{units.physicalSystem(), units.chosen(), QLocale(), !isEnglish(spokenLanguage())};
    return reader.isPlain() ? PaperReader() : reader;
}

bool PaperReader::isPlain() const {
    const QLocale plain = QLocale::c();
    return !isSpokenTo && system == UnitSystem::si && chosen.empty() &&
           locale.decimalPoint() == plain.decimalPoint() && locale.zeroDigit() == plain.zeroDigit();
}

ShownUnits PaperReader::unitsFor(const Scenario& scenario) const {
    return shownUnits(hasUnits(scenario) ? system : UnitSystem::dimensionless, scalesOf(scenario), chosen);
}

const Unit& PaperReader::unitFor(const Parameter& parameter) const {
    const std::optional<UnitKind> kind = kindOf(parameter);
    const auto own = kind ? chosen.find(*kind) : chosen.end();
    return own == chosen.end() ? customaryUnit(parameter, system) : *own->second;
}

std::shared_ptr<QCustomPlot> emptyPaperPlot(const QLocale& locale) {
    auto plot = std::make_shared<QCustomPlot>();
    plot->setLocale(locale);
    return plot;
}

PaperPlot blowPaperPlot(const Blow& blow, const PaperReader& reader,
                        const std::vector<MeasuredSignal>& measured) {
    const ShownUnits units = reader.unitsFor(blow.scenario);
    const double share = shareOnPaper(blow.scenario, measured);
    PaperPlot paper =
        paperPlot<BlowPlots>(blowCurves(blow, units, share, Tail::cut), {180, 240}, reader.locale);
    if (measured.empty()) return paper;
    auto* plots = paper.plot->findChild<BlowPlots*>();
    (new MeasuredCurves(plots))->present(measured, blow.scenario, units);
    plots->fit();
    return paper;
}

const MeasuredSignal* firstInside(const std::vector<MeasuredSignal>& measured) {
    const auto found = std::ranges::find(measured, MeasuredQuantity::normalForce, &MeasuredSignal::quantity);
    return found == measured.end() ? nullptr : &*found;
}

// Returns the middle of a rod; in a string the middle of its longest section, as in histories.csv.
double shareOnPaper(const Scenario& scenario, const std::vector<MeasuredSignal>& measured) {
    if (const MeasuredSignal* inside = firstInside(measured)) return shareAt(scenario, inside->place);
    return shareOfString(scenario.drillString, middleOfLongest(scenario.drillString));
}

PaperPlot rockPaperPlot(const Blow& blow, const PaperReader& reader) {
    return paperPlot<RockPlot>(rockCurve(blow, reader.unitsFor(blow.scenario)), {120, 90}, reader.locale);
}

PaperPlot rodPaperPlot(const Blow& blow, const std::stop_token& stop, const PaperReader& reader) {
    return paperPlot<RodPlot>(rodCurves(blow, reader.unitsFor(blow.scenario), stop), {180, 110},
                              reader.locale);
}

PaperPlot stringPaperPlot(const Scenario& scenario, const PaperReader& reader) {
    const auto unitOf = [&](std::string_view key) { return shownUnit(reader.unitFor(*findParameter(key))); };
    return paperPlot<StringSketch>(
        SketchedString{.drillString = scenario.drillString,
                       .length = unitOf("rod.length"),  // sections are in mm, the whole is longer
                       .across = unitOf("string.1.diameter")},
        {180, 44}, reader.locale);
}

PaperPlot wavePaperPlot(const Blow& blow, const PaperReader& reader) {
    // About 150 cells per inch at 180 mm.
    constexpr WavePictureNeed need{.field = WaveQuantity::force, .window = {}, .columns = 900, .rows = 450};
    auto solved = std::make_shared<SolvedBlow>();
    static_cast<Blow&>(*solved) = blow;
    solved->request.scenario = blow.scenario;
    solved->units = reader.unitsFor(blow.scenario);
    solved->request.units = solved->units.system;
    solved->pages.push_back(PageData::of(wavePicture(blow, solved->units, need)));
    return paperPlot<WavePicturePlot>(SolvedBlowPtr(std::move(solved)), {180, 110}, reader.locale);
}

PaperPlot figurePaperPlot(const StudyFigure& figure, const Scenario& scenario, const PaperReader& reader,
                          const std::optional<FigurePoint>& here) {
    const FigureUnits units{reader.unitsFor(scenario), [&](const Parameter& parameter) -> const Unit& {
                                return reader.unitFor(parameter);
                            }};
    PaperPlot paper =
        paperPlot<FigureFrame>(ShownFigure{figure, units}, {180, double(figure.paperHeight)}, reader.locale);
    FigureFrame& frame = frameOf(paper);
    if (here)
        frame.setHere(here->x * frame.xUnit().factor,
                      here->y ? std::optional(*here->y * frame.yUnit().factor) : std::nullopt);
    return paper;
}

PaperPlot drillingPaperPlot(const DrillingResult& result, const std::stop_token& stop,
                            const PaperReader& reader) {
    const ShownSequence sequence{result.scenario, result.settings, result.blows, &result,
                                 corOverPeriod(result.scenario, stop)};
    PaperPlot paper = figurePaperPlot(drillingFigure(&sequence, nullptr), result.scenario, reader);
    if (result.blows.empty()) frameOf(paper).showNothing(QString::fromStdString(sequenceText(result)));
    return paper;
}

PaperPlot scanPaperPlot(const DrillingScan& scan, const PaperReader& reader) {
    const ShownScan shown{scan};
    const std::optional<double> value = valueIn(scan.base, *scan.axis.parameter);
    PaperPlot paper = figurePaperPlot(drillingFigure(nullptr, &shown), scan.base, reader,
                                      value ? std::optional(FigurePoint{*value}) : std::nullopt);
    FigureFrame& frame = frameOf(paper);
    if (frame.graph()->data()->isEmpty()) frame.showNothing(tr("No value has statistics."));
    return paper;
}

PaperPlot designPaperPlot(const DesignReport& report, const PaperReader& reader) {
    const DesignUnits units(
        report.study, reader.unitsFor(report.study.base),
        [&](const Parameter& parameter) -> const Unit& { return reader.unitFor(parameter); }, reader.locale);
    return figurePaperPlot(designFigure(report, units), report.study.base, reader);
}

}  // namespace drillwave
