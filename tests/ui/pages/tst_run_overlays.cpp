// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs laid over the plots: their own numbers in the units on show, and nothing solved out of sight.
#include <QPointer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/blow/feed_estimate.h"
#include "core/report/gap_report.h"
#include "core/report/thrust_report.h"
#include "core/wave/field/wave_field.h"
#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/rock/rock_page.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/pages/study/figure_page.h"
#include "ui/pages/wave_picture/rod_profile.h"
#include "ui/pages/wave_picture/wave_picture_page.h"
#include "ui/pages/wave_picture/wave_picture_plot.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/legend_entries.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/run_marks.h"
#include "ui/plot/run_pen.h"
#include "ui/runs/runs.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

// Studies on a machine that is busy with other tests.
constexpr int patience = 60'000;
// Products of two or three factors in another order.
constexpr double rounding = 1e-13;

bool isNear(double a, double b) {
    return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

class TestRunOverlays : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void theBlowHasForceImpulseAndMomentum();
    void runsAreLettersInALegendWithoutRoomForNames();
    void sumsOfRunsDoNotLookLikeWaves();
    void inGroupsEachHasItsOwnUnits();
    void aRunWithoutUnitsIsNotLaidOverForces();
    void hiddenRunsAreNotDrawn();
    void aDragDrawsNoRunAnew();
    void aRemovedRunIsFreed();
    void whatIsHiddenByTheLegendStaysHidden();
    void theRockHasThePaths();
    void manyRunsLeaveRoomForThePlot();
    void runsAtOnePlaceAreOneMark();
    void theRodHasTheEnvelopes();
    void theWavePictureHasTheRunsAlongTheRod();
    void withoutRunsThePictureHasItsRoom();
    void theGapHasTheCurveOfTheRunsScenario();
    void curvesFarBelowSuperReboundHaveTheHeight();
    void outOfSightNoGapIsStudied();
    void whatIsKnownIsNotStudiedAgain();
    void whatFailsIsNotStudiedAgain();
    void stiffnessHasTheCurveOfTheRunsScenario();
    void aDragOfTheScenarioStudiesNoRunAnew();
    void outOfSightNoStiffnessIsStudied();
    void aRunWithoutTheParameterHasNoCurve();
    void theMapHasThemByName();
    void stiffnessAndThrustHaveTheirPoints();
    void shiftAndAClickPin();

  private:
    SolvedBlowPtr solve(const Page& page, UnitSystem units = UnitSystem::si) {
        SolveRequest request;
        request.scenario = m_document->scenario();
        request.units = units;
        request.pages = {page.prepare()};
        return m_job.solveNow(request);
    }
    void pin(const char* key, double si) {
        m_document->assign(*findParameter(key), si, m_document->newGesture());
        const SolvedBlowPtr blow = m_job.solveNow(
            {.scenario = m_document->scenario(), .units = UnitSystem::si, .chosenUnits = {}, .pages = {}});
        QCOMPARE(m_runs->pin(m_document->contents(), blow, "first"), QString());
    }
    const Run& run(int number) { return *m_runs->find(number); }
    /// Studies are asked only of a page that is seen.
    static void show(Page& page) {
        page.resize(900, 600);
        page.show();
    }
    void present(Page& page, UnitSystem units = UnitSystem::si) {
        page.setRuns(m_runs->list());
        page.setResult(solve(page, units));
    }

    QTemporaryDir m_folder;
    SolveJob m_job;
    Observation m_observation;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Runs> m_runs;
};

void TestRunOverlays::initTestCase() {
    keepSettingsIn(m_folder.path());
    QLocale::setDefault(QLocale::c());
}

void TestRunOverlays::init() {
    m_document = std::make_unique<Document>();
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    m_runs = std::make_unique<Runs>(m_document->units());
    pin("bit_rock.stiffness", 3e8);
    pin("pulse.impulse", 102);
}

void TestRunOverlays::theBlowHasForceImpulseAndMomentum() {
    BlowPage page(m_observation);
    present(page);
    m_document->assign(*findParameter("rod.length"), 2, 0);
    present(page);
    const QVector<QCPGraph*>& graphs = page.plots()->forcesOfRuns();
    QCOMPARE(graphs.size(), 2);
    for (const int number : {0, 1}) {
        bool found = false;
        const double peak = graphs[number]->getValueRange(found).upper;
        const SolvedBlow& blow = *run(number).blow;
        QVERIFY(isNear(peak, blow.summary.peakForce * blow.scales.force / 1e3));  // kN
        QCOMPARE(graphs[number]->name(), run(number).title());
        const QPen expected = runPen(number, PlotStyle::forScreen(page.palette(), page.font()));
        QCOMPARE(graphs[number]->pen().color(), expected.color());
        QCOMPARE(graphs[number]->pen().dashPattern(), expected.dashPattern());
    }
    // Twice the impulse of the same shape: twice everything.
    QVERIFY(run(1).blow->scales.impulse == 2 * run(0).blow->scales.impulse);
    // All of the longest is in view.
    const double end = page.plots()->axisRect(0)->axis(QCPAxis::atBottom)->range().upper;
    QVERIFY(end >= run(0).blow->summary.separationTime * run(0).blow->scales.time * 1e3);
    // Copied with the others, under their names.
    QVERIFY(page.plot()->csv().contains("A  first [kN]"));
}

void TestRunOverlays::runsAreLettersInALegendWithoutRoomForNames() {
    BlowPage page(m_observation);
    m_runs->rename(0, "medium rock, worn bit");
    present(page);
    page.show();
    const auto replotAt = [&](int width) {
        page.resize(width, 600);
        QCoreApplication::processEvents();
        page.plot()->replot(QCustomPlot::rpImmediateRefresh);
    };
    const QVector<QCPGraph*>& graphs = page.plots()->forcesOfRuns();
    replotAt(420);
    QCOMPARE(graphs[0]->name(), QString("A"));
    QCOMPARE(graphs[1]->name(), QString("B"));
    for (const QCPLayoutElement* element : page.plot()->plotLayout()->elements(true))
        if (const auto* legend = qobject_cast<const QCPLegend*>(element);
            legend && legend->itemWithPlottable(graphs[0]))
            QVERIFY(legend->outerRect().width() >= legend->minimumOuterSizeHint().width());
    replotAt(1400);
    QCOMPARE(graphs[0]->name(), run(0).title());
}

void TestRunOverlays::sumsOfRunsDoNotLookLikeWaves() {
    BlowPage page(m_observation);
    present(page);
    const QVector<QCPGraph*>& sums = page.plots()->sumsOfRuns();
    QCOMPARE(sums.size(), 2);
    for (const int number : {0, 1}) {
        const QPen pen = sums[number]->pen();
        // As broad as the sum of the present blow, and broader than any of its waves.
        QCOMPARE(pen.widthF(), page.plots()->sectionForceGraph()->pen().widthF());
        for (int wave = 0; wave < BlowCurves::waveCount; ++wave)
            QVERIFY(pen.widthF() > 2 * page.plots()->waveGraph(wave)->pen().widthF());
        QCOMPARE(sums[number]->name(), "N " + run(number).title().left(1));
    }
}

void TestRunOverlays::inGroupsEachHasItsOwnUnits() {
    BlowPage page(m_observation);
    present(page, UnitSystem::dimensionless);
    bool found = false;
    const auto peak = [&](int number) {
        return page.plots()->forcesOfRuns()[number]->getValueRange(found).upper;
    };
    QCOMPARE(peak(0), run(0).blow->summary.peakForce);
    // The same groups: the same blow, whatever its impulse.
    QVERIFY(isNear(peak(0), peak(1)));
}

void TestRunOverlays::aRunWithoutUnitsIsNotLaidOverForces() {
    m_document->startFrom(findExample("paper_fig4b")->text, "example");
    pin("beta", 0.7);
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    BlowPage page(m_observation);
    present(page);
    QCOMPARE(page.plots()->forcesOfRuns().size(), 2);
    present(page, UnitSystem::dimensionless);
    QCOMPARE(page.plots()->forcesOfRuns().size(), 3);
}

void TestRunOverlays::hiddenRunsAreNotDrawn() {
    BlowPage page(m_observation);
    QSignalSpy needs(&page, &Page::needsChanged);
    m_runs->setShown(0, false);
    present(page);
    QCOMPARE(needs.count(), 1);
    QCOMPARE(page.plots()->forcesOfRuns().size(), 1);
    QCOMPARE(page.plots()->forcesOfRuns().first()->name(), run(1).title());
    // Nothing of those that went is drawn, nor in the legend.
    page.plot()->replot();
    m_runs->setShown(1, false);
    present(page);
    page.plot()->replot();
    int entries = 0;
    for (int i = 0; i < page.plot()->plotLayout()->elements(true).size(); ++i) {
        auto* item = qobject_cast<QCPPlottableLegendItem*>(page.plot()->plotLayout()->elements(true).at(i));
        if (!item) continue;
        ++entries;
        QVERIFY(page.plot()->hasPlottable(item->plottable()));
    }
    QVERIFY(entries > 4);  // the waves, the force and the others
    m_runs->setShown(1, true);
    present(page);
    QCOMPARE(page.plots()->forcesOfRuns().size(), 1);
    page.setResult(failedBlow({}, "out of rock"));
    QVERIFY(page.plots()->forcesOfRuns().isEmpty());
}

// (factors of a run's units: the last digit varies with the present scales)
void TestRunOverlays::aDragDrawsNoRunAnew() {
    BlowPage blow(m_observation);
    present(blow);
    QVector<QPointer<QObject>> drawn;
    for (QCPGraph* graph : blow.plots()->forcesOfRuns()) drawn << graph;
    QCOMPARE(drawn.size(), 2);
    int made = 0;
    std::vector<RunOverlay<double>> overlays;
    const auto make = [&](const SolvedBlow&, const ShownUnits&) { return double(++made); };
    for (int step = 0; step < 40; ++step) {
        m_document->assign(*findParameter("rod.length"), 3 + 0.0137 * step, 0);
        present(blow);
        overlays = runOverlays(*m_runs->list(), *solve(blow), overlays, make);
        QCOMPARE(overlays.size(), 2u);
    }
    QCOMPARE(made, 2);
    for (const auto& graph : std::as_const(drawn)) QVERIFY(graph);
    // Another name is drawn, with the same curves.
    m_runs->rename(0, "other");
    overlays = runOverlays(*m_runs->list(), *solve(blow), overlays, make);
    QCOMPARE(made, 2);
    QCOMPARE(overlays[0].title, run(0).title());
    present(blow);
    QCOMPARE(blow.plots()->forcesOfRuns()[0]->name(), run(0).title());
    // Other units are other curves.
    overlays = runOverlays(*m_runs->list(), *solve(blow, UnitSystem::us), overlays, make);
    QCOMPARE(made, 4);
}

// Also by a later one that was solved while it was laid over the page.
void TestRunOverlays::aRemovedRunIsFreed() {
    BlowPage page(m_observation);
    present(page);
    m_document->assign(*findParameter("bit_rock.gap"), 1e-3, 0);
    present(page);
    const SolvedBlowPtr later = solve(page);
    QCOMPARE(later->page<BlowCurves>()->runs.size(), 2u);
    QCOMPARE(m_runs->pin(m_document->contents(), later, "later"), QString());
    const std::weak_ptr<const SolvedBlow> removed = run(0).blow;
    m_runs->remove(0);
    present(page);
    present(page);
    QVERIFY(removed.expired());
    QVERIFY(run(2).blow == later);
}

void TestRunOverlays::whatIsHiddenByTheLegendStaysHidden() {
    BlowPage page(m_observation);
    present(page);
    page.plot()->setCurveVisible(page.plots()->forcesOfRuns()[0], false);
    m_runs->setReference(1);
    m_document->assign(*findParameter("rod.length"), 2, 0);
    present(page, UnitSystem::us);
    QVERIFY(!page.plots()->forcesOfRuns()[0]->visible());
    QVERIFY(page.plots()->forcesOfRuns()[1]->visible());
}

void TestRunOverlays::theRockHasThePaths() {
    RockPage page(m_observation);
    present(page);
    QCOMPARE(page.rockPlot()->runs().size(), 2);
    for (const int number : {0, 1}) {
        bool found = false;
        const QCPRange range = page.rockPlot()->runs()[number]->getKeyRange(found);
        const SolvedBlow& blow = *run(number).blow;
        QVERIFY(isNear(range.upper, blow.summary.maxPenetration * blow.scales.penetration * 1e3));  // mm
        QVERIFY(page.plot()->xAxis->range().contains(range.upper));
    }
}

void TestRunOverlays::manyRunsLeaveRoomForThePlot() {
    RockPage page(m_observation);
    present(page);
    QCOMPARE(page.rockPlot()->runs().size(), 2);
    QCOMPARE(page.plot()->legend->rowCount(), 2);
    for (int number = 2; number < mostRuns; ++number) pin("bit_rock.stiffness", 1e8 + 1e7 * number);
    present(page);
    QCOMPARE(page.rockPlot()->runs().size(), mostRuns);
    QCOMPARE(page.plot()->legend->rowCount(), 3);
    for (int number = 2; number < mostRuns; ++number) m_runs->remove(number);
    present(page);
    QCOMPARE(page.rockPlot()->runs().size(), 2);
    QCOMPARE(page.plot()->legend->rowCount(), 2);
}

// One over the other they could not be read; e of the same groups differs in its last digits.
void TestRunOverlays::runsAtOnePlaceAreOneMark() {
    QCustomPlot plot;
    RunMarks marks(&plot, plot.xAxis, plot.yAxis);
    marks.present({{0, "A  first", {0, 0.4}},
                   {1, "B  k 300 MN/m", {0, 0.634447860414}},
                   {2, "C  L 2.4 m", {0, 0.634447860414 + 3e-14}}});
    QStringList texts;
    for (int i = 0; i < plot.itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(plot.item(i))) texts << text->text();
    QCOMPARE(texts, QStringList({"A  first", "B, C"}));
}

void TestRunOverlays::theRodHasTheEnvelopes() {
    m_document->assign(*findParameter("rod.length"), 2, 0);
    RodPage page(m_observation);
    QSignalSpy needs(&page, &Page::needsChanged);
    present(page);
    QCOMPARE(needs.count(), 1);
    const QVector<QCPCurve*>& paths = page.rodPlot()->runs();
    QCOMPARE(paths.size(), 2);
    for (const int number : {0, 1}) {
        bool found = false;
        const SolvedBlow& blow = *run(number).blow;
        const QCPRange stresses = paths[number]->getValueRange(found);
        const double unit = blow.scales.stress / 1e6;  // MPa
        QVERIFY(isNear(stresses.lower, -blow.summary.rodForces->compression.size * unit));
        QVERIFY(isNear(stresses.upper, blow.summary.rodForces->tension.size * unit));
        // Longer than the rod on show, and all of it in view.
        const double length = run(number).contents.scenario.rod.length;
        QVERIFY(length > 2);
        QVERIFY(isNear(paths[number]->getKeyRange(found).upper, length));
        QVERIFY(page.plot()->xAxis->range().contains(length * (1 - rounding)));
        QVERIFY(page.plot()->yAxis->range().contains(stresses.lower));
        QVERIFY(run(number).title().startsWith(paths[number]->name()));  // its letter where names do not fit
        const QPen expected = runPen(number, PlotStyle::forScreen(page.palette(), page.font()));
        QCOMPARE(paths[number]->pen().color(), expected.color());
        QCOMPARE(paths[number]->pen().dashPattern(), expected.dashPattern());
    }
    // Along the compression of the run, then back along its tension.
    const RodCurves curves = rodCurves(*run(0).blow, run(0).blow->units);
    const auto& points = *paths[0]->data();
    const int compression = curves.curve(Load::compression)->size();
    QCOMPARE(points.size(), compression + 1 + curves.curve(Load::tension)->size());
    QVERIFY(std::isnan(points.at(compression)->value));  // two lines
    QVERIFY(points.at(compression / 2)->value < 0 && points.at(compression + 2)->value > 0);
    // Nothing of them is left where there is nothing.
    page.setResult(failedBlow({}, "out of rock"));
    QVERIFY(page.rodPlot()->runs().isEmpty());
    // Their legend takes no room either, and comes back with them.
    const RunListPtr list = m_runs->list();
    m_runs->clear();
    present(page);
    page.plot()->replot();
    QCOMPARE(page.plot()->axisRect()->outerRect().width(), page.plot()->plotLayout()->rect().width());
    page.setRuns(list);
    page.setResult(solve(page));
    page.plot()->replot();
    QCOMPARE(page.plot()->axisRect()->outerRect().width(), page.plot()->plotLayout()->rect().width());
    QCOMPARE(page.rodPlot()->runs().size(), 2);
    QVERIFY(namedCurves(*page.plot()).contains(page.rodPlot()->runs()[1]));
}

void TestRunOverlays::theWavePictureHasTheRunsAlongTheRod() {
    m_document->assign(*findParameter("rod.length"), 2, 0);
    WavePicturePage page(m_observation);
    show(page);
    present(page);
    m_observation.setTime(5);
    const QVector<RodProfile::Line>& lines = page.rodProfile()->lines();
    QCOMPARE(lines.size(), 3);
    QTRY_VERIFY(lines[0].points.size() > 300);  // laid out
    const SolvedBlowPtr now = page.picture()->shown();
    const double seconds = 5 * now->scales.time;
    for (const RodProfile::Line& line : lines) {
        const SolvedBlow& blow = line.number < 0 ? *now : *run(line.number).blow;
        QVERIFY(line.points.size() > 300);
        // The same instant at the same place, each by its own scales; the rod on show is the shorter one.
        const QPointF point = line.points[line.points.size() / 3];
        const double force =
            WaveField(blow.impact).force(point.x() / blow.scales.length, seconds / blow.scales.time) *
            blow.scales.force / 1e3;     // kN
        constexpr double single = 1e-6;  // precision of the raster
        QVERIFY(std::abs(point.y() - force) <= single * blow.scales.force / 1e3);
        QVERIFY(line.points.last().x() < 2);
    }
    QCOMPARE(lines[2].title, run(1).title());
    const QString words = page.rodProfile()->readout(0.25);
    for (const RodProfile::Line& line : lines) QVERIFY2(words.contains(line.title + ": "), qPrintable(words));
    // A longer rod than those of the runs: they end before it does.
    m_document->assign(*findParameter("rod.length"), 12, 0);
    present(page);
    QVERIFY(lines[1].points.last().x() <= run(0).contents.scenario.rod.length);
    QVERIFY(!page.rodProfile()->readout(0.9).contains(run(0).title()));
    QVERIFY(page.rodProfile()->readout(0.9).contains("this blow"));
    m_observation.setTime({});
}

void TestRunOverlays::withoutRunsThePictureHasItsRoom() {
    WavePicturePage page(m_observation);
    show(page);
    page.setResult(solve(page));
    QVERIFY(page.rodProfile()->isHidden());
    QVERIFY(page.rodProfile()->lines().isEmpty());
    present(page);
    QVERIFY(page.rodProfile()->isVisible());
    page.setResult(failedBlow({}, "out of rock"));
    QVERIFY(page.rodProfile()->isHidden());
    present(page);
    QVERIFY(page.rodProfile()->isVisible());
    m_runs->clear();
    present(page);
    QVERIFY(page.rodProfile()->isHidden());
}

void TestRunOverlays::theGapHasTheCurveOfTheRunsScenario() {
    m_document->assign(*findParameter("bit_rock.stiffness"), 1e8, 0);
    FigurePage page(gapStudy(), *m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    for (const int number : {0, 1}) {
        const QCPGraph* graph = page.figureFrame().runCurves()[number];
        QVERIFY(graph->dataCount() > 200);
        const auto point = graph->data()->at(graph->dataCount() / 3);
        Scenario scenario = run(number).contents.scenario;
        findParameter("bit_rock.gap")->assign(scenario, point->key / 1e3);
        // The curve is known to 1e-10.
        QVERIFY(std::abs(point->value - solveBlow(scenario, {}, Detail::cor).summary.cor) < 2e-10);
    }
    // The first repeats within the range of the present one, which has twice the impulse.
    const QCPGraph* half = page.figureFrame().runCurves()[0];
    const QCPGraph* present = page.figureFrame().graph();
    bool found = false;
    QVERIFY(half->getKeyRange(found).upper > 0.99 * present->getKeyRange(found).upper);
}

void TestRunOverlays::curvesFarBelowSuperReboundHaveTheHeight() {
    FigurePage page(gapStudy(), *m_document);
    page.show();
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    const QCPAxis* values = page.figureFrame().graph()->valueAxis();
    const auto curve = [](double from, double to) {
        const GraphData data = GraphData::create();
        data->set({{0, from}, {1, to}}, true);
        return QVector<RunCurve>{{0, "A", data}};
    };
    page.figureFrame().setRuns({}, curve(0.2, 0.7));
    QVERIFY(0.5 > 0.75 * values->range().size());
    page.figureFrame().setRuns({}, curve(0.2, 0.95));
    QVERIFY(values->range().upper > 1);  // near to it, where it begins is in view
}

void TestRunOverlays::outOfSightNoGapIsStudied() {
    FigurePage page(gapStudy(), *m_document);
    present(page);
    QCOMPARE(page.runStudies(), 0);
    page.show();
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    QCOMPARE(page.runStudies(), 1);
    page.hide();
    m_runs->setShown(0, false);
    page.setRuns(m_runs->list());
    QCOMPARE(page.runStudies(), 1);
}

void TestRunOverlays::whatIsKnownIsNotStudiedAgain() {
    using Finder = RunCurveFinder<int, int>;
    int found = 0;
    std::stop_source stop;
    Finder finder([&](int question, const std::stop_token&) -> std::optional<int> {
        ++found;
        if (question == 9) stop.request_stop();
        return question % 2 ? std::optional(10 * question) : std::nullopt;
    });
    std::size_t shown = 0;
    const auto feed = [&] {
        return StudyFeed<Finder::Answers>{stop.get_token(), [](StudyProgress) {},
                                          [&](const Finder::Answers& so) { shown = so.size(); }};
    };
    const Finder::Answers first = finder({1, 2}, feed());
    QCOMPARE(found, 2);
    QCOMPARE(*first[0]->curve, 10);
    QVERIFY(!first[1]->curve);  // which is known as well
    const Finder::Answers more = Finder(finder)({3, 2, 1}, feed());
    QCOMPARE(found, 3);
    QCOMPARE(more.size(), 3u);
    QVERIFY(std::ranges::find(more, first[0]) != more.end());
    QCOMPARE(shown, 3u);
    // A stopped finder goes on from there, and needs no more questions.
    const Finder::Answers stopped = finder({1, 9, 11, 3}, feed());
    QCOMPARE(found, 4);
    QCOMPARE(stopped.size(), 2u);
    stop = {};
    QCOMPARE(finder({3, 1, 5}, feed()).size(), 3u);
    QCOMPARE(found, 5);
    // A question that is not repeated is forgotten.
    finder({2}, feed());
    QCOMPARE(found, 6);
}

void TestRunOverlays::whatFailsIsNotStudiedAgain() {
    RunStudies<int, int> studies(
        [](int, const std::stop_token&) -> std::optional<int> { throw std::runtime_error("out of rock"); });
    studies.ask({1});
    QTRY_COMPARE_WITH_TIMEOUT(studies.activity().state(), StudyState::failed, patience);
    studies.ask({1});
    QCOMPARE(studies.started(), 1);
    QVERIFY(!studies.find(1));
    studies.ask({1, 2});
    QCOMPARE(studies.started(), 2);
}

void TestRunOverlays::stiffnessHasTheCurveOfTheRunsScenario() {
    CurvePage page(*m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    const auto& graphs = page.figureFrame().runCurves();
    for (const int number : {0, 1}) {
        const QCPGraph* graph = graphs[number];
        QVERIFY(graph->dataCount() > 200);
        const auto point = graph->data()->at(graph->dataCount() / 3);
        Scenario scenario = run(number).contents.scenario;
        findParameter("bit_rock.stiffness")->assign(scenario, point->key * 1e6);
        // The curve is known to 1e-10.
        QVERIFY(std::abs(point->value - solveBlow(scenario, {}, Detail::cor).summary.cor) < 2e-10);
        QCOMPARE(graph->name(), run(number).title());
        const QPen expected = runPen(number, PlotStyle::forScreen(page.palette(), page.font()));
        QCOMPARE(graph->pen().color(), expected.color());
        QCOMPARE(graph->pen().dashPattern(), expected.dashPattern());
        bool found = false;
        const QCPRange values = graph->getValueRange(found);
        QVERIFY(graph->valueAxis()->range().contains(values.lower));
        QVERIFY(graph->valueAxis()->range().contains(values.upper));
        // The mark of the run lies on its curve.
        QVERIFY(isNear(page.figureFrame().runMarks()[number].at.y(), run(number).blow->summary.cor));
    }
    // One line each: no more work than a family of as many.
    std::uint64_t solves = 0;
    for (const auto& answer : *page.runLines().answers()) solves += answer->curve->solves;
    QVERIFY(solves > 100);
    QVERIFY2(solves <= page.study().value()->curve.solves, qPrintable(QString::number(solves)));
}

void TestRunOverlays::aDragOfTheScenarioStudiesNoRunAnew() {
    CurvePage page(*m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    const auto& graphs = page.figureFrame().runCurves();
    const QPointer<QCPGraph> drawn = graphs[0];
    graphs[1]->setVisible(false);
    const auto answer = page.runLines().answers()->front();
    const int studies = page.study().started();
    for (const double gamma : {0.2, 0.25, 0.3}) {
        m_document->assign(*findParameter("gamma"), gamma, 1);
        page.setResult(solve(page));
        QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, patience);
    }
    QVERIFY(page.study().started() > studies);
    QCOMPARE(page.runLines().started(), 1);
    QVERIFY(drawn && graphs[0] == drawn);
    QVERIFY(!graphs[1]->visible());
    // One more run is the only one that is studied.
    QCOMPARE(m_runs->pin(m_document->contents(), solve(page), "third"), QString());
    page.setRuns(m_runs->list());
    QTRY_COMPARE_WITH_TIMEOUT(graphs.size(), 3, patience);
    QVERIFY(std::ranges::find(*page.runLines().answers(), answer) != page.runLines().answers()->end());
}

void TestRunOverlays::outOfSightNoStiffnessIsStudied() {
    CurvePage page(*m_document);
    present(page);
    QCOMPARE(page.runLines().started(), 0);
    page.show();
    QTRY_VERIFY_WITH_TIMEOUT(page.runLines().started() > 0, patience);
    page.hide();
    QVERIFY(page.runLines().activity().state() != StudyState::running);
    m_runs->setShown(0, false);
    page.setRuns(m_runs->list());
    QCOMPARE(page.runLines().started(), 1);
    // Seen again it goes on.
    page.show();
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 1, patience);
}

// The slope of a scenario in groups is no stiffness.
void TestRunOverlays::aRunWithoutTheParameterHasNoCurve() {
    m_document->startFrom(findExample("paper_fig4b")->text, "example");
    pin("beta", 0.7);
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
    CurvePage page(*m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runCurves().size(), 2, patience);
    QTRY_COMPARE_WITH_TIMEOUT(page.runLines().activity().state(), StudyState::finished, patience);
    QCOMPARE(page.runLines().answers()->size(), 2u);
}

void TestRunOverlays::theMapHasThemByName() {
    MapPage page(*m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.figureFrame().runMarks().size(), 2, patience);
    QCOMPARE(page.figureFrame().runMarks()[0].title, run(0).title());
    QVERIFY(isNear(page.figureFrame().runMarks()[0].at.x(), 300));  // MN/m
    QVERIFY(isNear(page.figureFrame().runMarks()[0].at.y(), 0.1));
    m_runs->setShown(0, false);
    page.setRuns(m_runs->list());
    QCOMPARE(page.figureFrame().runMarks().size(), 1);
}

void TestRunOverlays::stiffnessAndThrustHaveTheirPoints() {
    CurvePage stiffness(*m_document);
    stiffness.resize(900, 600);
    stiffness.show();
    present(stiffness);
    const auto* curves = &stiffness.figureFrame();
    QTRY_COMPARE_WITH_TIMEOUT(curves->runMarks().size(), 2, patience);
    QVERIFY(isNear(curves->runMarks()[1].at.x(), 300));
    QCOMPARE(curves->runMarks()[1].at.y(), run(1).blow->summary.cor);
    stiffness.hide();
    FigurePage thrust(thrustStudy(), *m_document);
    thrust.resize(900, 600);
    thrust.show();
    present(thrust);
    QTRY_COMPARE_WITH_TIMEOUT(thrust.activity()->state(), StudyState::finished, patience);
    const FigureFrame* needs = &thrust.figureFrame();
    QTRY_COMPARE_WITH_TIMEOUT(needs->runMarks().size(), 2, patience);
    QVERIFY(isNear(needs->runMarks()[0].at.x(), 60));  // Hz
    const double need = *thrustNeeded(run(0).contents.scenario, run(0).blow->summary.cor);
    QVERIFY(isNear(needs->runMarks()[0].at.y(), need / 1e3));
}

void TestRunOverlays::shiftAndAClickPin() {
    FigurePage page(gapStudy(), *m_document);
    show(page);
    present(page);
    QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, patience);
    QSignalSpy pins(&page, &Page::pinRequested);
    const QCPGraph* graph = page.figureFrame().graph();
    const QPoint pixel(int(graph->keyAxis()->coordToPixel(1)),
                       int(graph->valueAxis()->coordToPixel(chordValue(*graph->data(), 1))));
    QTest::mouseClick(page.plot(), Qt::LeftButton, Qt::ShiftModifier, pixel);
    QCOMPARE(pins.count(), 1);
    const auto contents = pins[0][0].value<ScenarioDocument>();
    QVERIFY(std::abs(contents.scenario.bitRock.gap - 1e-3) < 0.02e-3);  // within the pixel
    QVERIFY(contents.text.find("gap:") != std::string::npos);
    QCOMPARE(parseScenario(contents.text, "").scenario, contents.scenario);
    QCOMPARE(m_document->scenario().bitRock.gap, 0.0);
}

QTEST_MAIN(TestRunOverlays)
#include "tst_run_overlays.moc"
