// SPDX-License-Identifier: GPL-3.0-or-later
// The pages by keys: what Enter takes over and Shift+Enter pins is what a click does.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/report/gap_report.h"
#include "core/report/thrust_report.h"
#include "core/yaml/examples.h"
#include "tests/support/window.h"
#include "ui/pages/curve/curve_page.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr int patience = 60'000;  // studies on a machine that is busy with other tests

}  // namespace

class TestPageKeys : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void onStiffnessAMarkIsTakenAsOneStep();
    void onStiffnessAnotherCurveBringsItsFamily();
    void onTheGapThePointIsPinned();
    void onTheMapThePresetIsTaken();
    void onThrustTheFrequencyIsTaken();
    void onTheRodAPeakLeadsToItsPlaceAndTime();

  private:
    SolvedBlowPtr solve(const Page& page) {
        SolveRequest request;
        request.scenario = m_document->scenario();
        request.units = UnitSystem::si;
        if (PreparePage prepare = page.prepare()) request.pages = {prepare};
        return m_job.solveNow(request);
    }
    void show(Page& page) {
        page.resize(900, 700);
        page.setResult(solve(page));
        page.show();
        if (page.activity())
            QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, patience);
        page.findChild<PlotWidget*>()->replot();
    }
    static void press(const PlotPage& page, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(page.plot(), key, modifiers);
    }
    static QPointF place(const PlotPage& page) {
        return page.plot()->keyPoint().place().value_or(QPointF(qQNaN(), qQNaN()));
    }
    QUndoStack& history() { return m_document->undoStack(); }
    const Scenario& scenario() const { return m_document->scenario(); }

    QTemporaryDir m_folder;
    SolveJob m_job;
    Observation m_observation;
    std::unique_ptr<Document> m_document;
};

void TestPageKeys::initTestCase() {
    keepSettingsIn(m_folder.path());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    QLocale::setDefault(QLocale::c());
}

void TestPageKeys::init() {
    QCursor::setPos(-100, -100);
    m_document = std::make_unique<Document>();
    m_document->startFrom(findExample("t38_medium_rock")->text, "example");
}

void TestPageKeys::onStiffnessAMarkIsTakenAsOneStep() {
    CurvePage page(*m_document);
    show(page);
    const std::vector<FigureMark> marks = page.figure()->panels.front().marks;
    QVERIFY(!marks.empty());
    press(page, Qt::Key_Return);
    // It begins where the scenario is.
    QVERIFY(std::abs(place(page).x() / (scenario().bitRock.stiffness / 1e6) - 1) < 1e-9);
    press(page, Qt::Key_N);
    const QPointF mark = place(page);
    QVERIFY(std::ranges::any_of(marks, [&](const FigureMark& each) {
        return std::abs(each.x / 1e6 - mark.x()) < 1e-12 * mark.x() && each.y == mark.y();
    }));
    const double before = scenario().bitRock.stiffness;
    press(page, Qt::Key_Return);
    QCOMPARE(history().count(), 1);
    QVERIFY(history().undoText().contains("stiffness"));
    QCOMPARE(scenario().bitRock.stiffness, mark.x() * 1e6);  // all digits of it
    history().undo();
    QCOMPARE(scenario().bitRock.stiffness, before);
    QTRY_COMPARE_WITH_TIMEOUT(page.activity()->state(), StudyState::finished, patience);
}

void TestPageKeys::onStiffnessAnotherCurveBringsItsFamily() {
    CurvePage page(*m_document);
    show(page);
    press(page, Qt::Key_Return);
    const double x = place(page).x();
    press(page, Qt::Key_Up);
    QCOMPARE(place(page).x(), x);
    QSignalSpy pins(&page, &Page::pinRequested);
    press(page, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(pins.count(), 1);
    const Scenario pinned = pins[0][0].value<ScenarioDocument>().scenario;
    QVERIFY(pinned.bitRock.gamma > scenario().bitRock.gamma);
    QCOMPARE(history().count(), 0);
}

void TestPageKeys::onTheGapThePointIsPinned() {
    FigurePage page(gapStudy(), *m_document);
    show(page);
    press(page, Qt::Key_Return);
    for (int i = 0; i < 5; ++i) press(page, Qt::Key_Right, Qt::ShiftModifier);
    const double gap = place(page).x();
    QVERIFY(gap > 0);
    QVERIFY(page.plot()->keyPoint().text().startsWith(page.figureFrame().graph()->name()));
    QSignalSpy pins(&page, &Page::pinRequested);
    press(page, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(pins.count(), 1);
    const Scenario pinned = pins[0][0].value<ScenarioDocument>().scenario;
    QVERIFY(std::abs(pinned.bitRock.gap / (gap * 1e-3) - 1) < 1e-9);
    QCOMPARE(scenario().bitRock.gap, 0.0);
    press(page, Qt::Key_Return);
    QCOMPARE(history().count(), 1);
    QCOMPARE(scenario().bitRock.gap, pinned.bitRock.gap);
    // The study of the same rod at another gap is the same, and the point stays for the next step.
    QVERIFY(std::abs(place(page).x() - gap) < 1e-9);
}

void TestPageKeys::onTheMapThePresetIsTaken() {
    MapPage page(*m_document);
    show(page);
    QVERIFY(!page.figureFrame().keyPlaces().marks().isEmpty());
    press(page, Qt::Key_Return);
    QVERIFY(!page.plot()->keyPoint().text().isEmpty());
    press(page, Qt::Key_N);
    const auto wanted = page.figureFrame().field()->pointAt(place(page));
    QVERIFY(wanted);
    const MapGrid& grid = page.report()->grid;
    const double stiffness = grid.xs()[wanted->column], gamma = grid.ys()[wanted->row];
    press(page, Qt::Key_Return);
    QCOMPARE(history().count(), 1);
    QCOMPARE(scenario().bitRock.stiffness, stiffness);
    QCOMPARE(scenario().bitRock.gamma, gamma);
}

void TestPageKeys::onThrustTheFrequencyIsTaken() {
    FigurePage page(thrustStudy(), *m_document);
    show(page);
    press(page, Qt::Key_Return);
    press(page, Qt::Key_Right, Qt::ShiftModifier);
    const double frequency = place(page).x();
    press(page, Qt::Key_Return);
    QCOMPARE(history().count(), 1);
    // As many digits as a pixel is worth.
    QVERIFY(std::abs(*scenario().drill.blowFrequency / frequency - 1) < 0.01);
    QVERIFY(*scenario().drill.blowFrequency > 60);
}

void TestPageKeys::onTheRodAPeakLeadsToItsPlaceAndTime() {
    RodPage page(m_observation);
    show(page);
    press(page, Qt::Key_Return);
    press(page, Qt::Key_N);
    const auto force = page.rodPlot()->forceAt(place(page));
    QVERIFY(force && force->size > 0);
    m_observation.setSection(0.123);
    press(page, Qt::Key_Return);
    QCOMPARE(m_observation.section(), force->section);
    QCOMPARE(m_observation.time(), std::optional(force->time));
}

QTEST_MAIN(TestPageKeys)
#include "tst_page_keys.moc"
