// SPDX-License-Identifier: GPL-3.0-or-later
// The page Blow: section, time cursor, readings, ghosts.
#include <QAbstractButton>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "core/wave/field/wave_curves.h"
#include "core/wave/field/wave_field.h"
#include "tests/support/window.h"
#include "tests/support/window_parts.h"
#include "ui/document/measured_list.h"
#include "ui/form/quantity_slider.h"
#include "ui/form/scenario_panel.h"
#include "ui/job/output_text.h"
#include "ui/job/solve_job.h"
#include "ui/pages/blow/blow_meanings.h"
#include "ui/pages/blow/blow_page.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

SolvedBlowPtr solved(const BlowPage& page, const Scenario& scenario, UnitSystem units) {
    SolveRequest request;
    request.scenario = scenario;
    request.units = units;
    request.pages = {page.prepare()};
    MethodSolver solver;
    return solveBlow(request, solver);
}

Scenario dimensionless(const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = groups;
    return scenario;
}

}  // namespace

class TestBlowPage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void theAnswerHasTheLargestForcesAndTheRebound();
    void arrowKeysMoveTheSection();
    void aSectionOfManyDigitsIsKept();
    void thePlaceIsGivenInMetresWhereThereIsALength();
    void theInstantOfTheTimeCursorIsRead();
    void anUnsolvedBlowSaysWhy();
    void inOtherUnitsAMeasuredCurveIsFittedLikeTheRest();
    void theTimeCursorIsShared();
    void cursorsStayInTheirPlaceInOtherUnits();
    void cursorsReadExactImpulses_data();
    void cursorsReadExactImpulses();
    void whatIsReadOutlivesTheBlow();
    void aHeldSliderLeavesAGhostUntilItIsReleased();

  private:
    QLabel* label(const char* name) const { return m_page->findChild<QLabel*>(QLatin1String(name)); }
    QDoubleSpinBox* section() const { return m_page->findChild<QDoubleSpinBox*>(QStringLiteral("section")); }

    QTemporaryDir m_folder;
    std::unique_ptr<Observation> m_observation;
    std::unique_ptr<BlowPage> m_page;
};

void TestBlowPage::initTestCase() {
    keepSettingsIn(m_folder.path());
}

void TestBlowPage::init() {
    QLocale::setDefault(QLocale::c());
    m_page.reset();
    m_observation = std::make_unique<Observation>();
    m_page = std::make_unique<BlowPage>(*m_observation);
    m_page->resize(700, 700);
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
}

void TestBlowPage::inOtherUnitsAMeasuredCurveIsFittedLikeTheRest() {
    QUndoStack history;
    MeasuredList measured(history);
    MeasuredSignal signal;
    signal.name = "gauge";
    signal.quantity = MeasuredQuantity::normalForce;
    signal.points = TablePoints{{0, 0}, {1e-3, -400e3}, {2e-3, 300e3}};
    measured.add(signal);
    const UnitChoice units;
    m_page->follow(measured, units);
    const auto largest = [&] {
        const QCPRange range = m_page->plot()->axisRect(0)->axis(QCPAxis::atLeft)->range();
        return std::max(range.upper, -range.lower);
    };
    const Scenario scenario;
    m_page->setResult(solved(*m_page, scenario, UnitSystem::si));
    const double kilonewtons = largest();
    m_page->setResult(solved(*m_page, scenario, UnitSystem::us));
    constexpr double kipOfKilonewton = 1 / 4.4482216;
    QVERIFY2(std::abs(largest() / kilonewtons / kipOfKilonewton - 1) < 0.02,
             qPrintable(QStringLiteral("%1 kip of %2 kN").arg(largest()).arg(kilonewtons)));
}

void TestBlowPage::theAnswerHasTheLargestForcesAndTheRebound() {
    const SolvedBlowPtr blow = solved(*m_page, Scenario(), UnitSystem::si);
    m_page->setResult(blow);
    const QString answer = label("answer")->text();
    const QString peak = outputText(*findOutput("peak_force"), *blow);
    QVERIFY2(answer.startsWith(QStringLiteral("The largest impact force on the rock is %1, at ").arg(peak)),
             qPrintable(answer));
    QVERIFY2(answer.contains(QStringLiteral("the force in this plot is between −")), qPrintable(answer));
    QVERIFY2(answer.endsWith(
                 QStringLiteral("The rod rebounds with e = %1.").arg(outputText(*findOutput("cor"), *blow))),
             qPrintable(answer));
    m_page->findChild<QAbstractButton*>(QStringLiteral("copyAnswer"))->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), answer);
}

void TestBlowPage::arrowKeysMoveTheSection() {
    section()->setFocus();
    QTest::keyClick(section(), Qt::Key_Up);
    QCOMPARE(m_observation->section(), 0.51);
    QTest::keyClick(section(), Qt::Key_PageDown);
    QCOMPARE(m_observation->section(), 0.41);
    QCOMPARE(section()->text(), QStringLiteral("0.410"));
}

void TestBlowPage::aSectionOfManyDigitsIsKept() {
    m_observation->setSection(0.123456);
    QCOMPARE(section()->text(), QStringLiteral("0.123"));
    QCOMPARE(m_observation->section(), 0.123456);
}

void TestBlowPage::thePlaceIsGivenInMetresWhereThereIsALength() {
    Scenario scenario;
    scenario.rod.length = 3.66;
    m_page->setResult(solved(*m_page, scenario, UnitSystem::si));
    QVERIFY(label("place")->isVisible());
    QCOMPARE(label("place")->text(), QStringLiteral("1.83\u00a0m from the struck end"));
    m_observation->setSection(1);
    QCOMPARE(label("place")->text(), QStringLiteral("3.66\u00a0m from the struck end"));
    m_page->setResult(solved(*m_page, dimensionless({0.5, 0.1, 10, 0}), UnitSystem::dimensionless));
    QCOMPARE(label("place")->text(), QStringLiteral("0: struck end, 1: bit"));
}

void TestBlowPage::theInstantOfTheTimeCursorIsRead() {
    m_page->setResult(solved(*m_page, dimensionless({0.5, 1, 10, 0}), UnitSystem::dimensionless));
    const QRect place = label("instant")->geometry();
    QVERIFY(label("instant")->text().startsWith(QStringLiteral("To mark a time")));
    m_observation->setTime(5.5);
    QCOMPARE(label("instant")->geometry(), place);
    QString text = label("instant")->text();
    text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    // The blow is just passing the middle of the rod.
    QCOMPARE(text, QStringLiteral("t = 5.5 t₀ · N = −1 F₀ · F = 0 F₀ · I = 0 I₀ · p = 1 I₀"));
    m_page->setResult(failedBlow({}, QStringLiteral("no more")));
    QVERIFY(label("instant")->text().startsWith(QStringLiteral("To mark a time")));
    QCOMPARE(label("instant")->geometry(), place);
}

void TestBlowPage::anUnsolvedBlowSaysWhy() {
    m_page->setResult(failedBlow({}, QStringLiteral("The rod has melted.")));
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("The rod has melted.")));
}

void TestBlowPage::theTimeCursorIsShared() {
    const SolvedBlowPtr blow = solved(*m_page, Scenario(), UnitSystem::si);
    m_page->setResult(blow);
    m_observation->setTime(4.0);
    const double shown = 4 * blow->units.time.factor;
    QCOMPARE(m_page->plot()->reader().position(PlotCursor::time), std::optional(shown));
    emit m_page->plot()->timeCursorDragged(5 * blow->units.time.factor);
    QVERIFY(std::abs(*m_observation->time() - 5) < 1e-12);
    // The same time in other units.
    const SolvedBlowPtr other = solved(*m_page, Scenario(), UnitSystem::dimensionless);
    m_page->setResult(other);
    QVERIFY(std::abs(*m_page->plot()->reader().position(PlotCursor::time) - 5) < 1e-12);
    m_observation->setTime({});
    QVERIFY(!m_page->plot()->reader().position(PlotCursor::time));
}

void TestBlowPage::cursorsStayInTheirPlaceInOtherUnits() {
    const SolvedBlowPtr blow = solved(*m_page, Scenario(), UnitSystem::si);
    m_page->setResult(blow);
    PlotWidget& plot = *m_page->plot();
    plot.reader().place(PlotCursor::b, 3 * blow->units.time.factor);
    m_page->setResult(solved(*m_page, Scenario(), UnitSystem::dimensionless));
    QVERIFY(!plot.reader().position(PlotCursor::a));
    QVERIFY(std::abs(*plot.reader().position(PlotCursor::b) - 3) < 1e-12);
    // A longer blow in the same units moves nothing.
    m_page->setResult(blow);
    Scenario longer;
    longer.pulse.duration *= 1.5;
    m_page->setResult(solved(*m_page, longer, UnitSystem::si));
    QVERIFY(std::abs(*plot.reader().position(PlotCursor::b) - 3 * blow->units.time.factor) < 1e-12);
}

void TestBlowPage::cursorsReadExactImpulses_data() {
    QTest::addColumn<bool>("si");
    QTest::addColumn<PulseShape>("shape");
    QTest::addColumn<double>("gap");
    QTest::newRow("rectangular, SI") << true << PulseShape::rectangular << 0.0;
    QTest::newRow("rectangular, dimensionless") << false << PulseShape::rectangular << 0.0;
    QTest::newRow("half sine with a gap, SI") << true << PulseShape::halfSine << 3e-4;
    QTest::newRow("far from the rock, dimensionless") << false << PulseShape::rectangular << 0.1;
}

void TestBlowPage::cursorsReadExactImpulses() {
    QFETCH(bool, si);
    QFETCH(PulseShape, shape);
    QFETCH(double, gap);
    Scenario scenario;
    scenario.pulse.shape = shape;
    scenario.bitRock.gap = gap;
    const SolvedBlowPtr blow = solved(*m_page, scenario, si ? UnitSystem::si : UnitSystem::dimensionless);
    QCOMPARE(blow->fault, QString());
    m_page->setResult(blow);
    PlotWidget& plot = *m_page->plot();
    const double end = blow->page<BlowCurves>()->timeEnd;
    plot.reader().place(PlotCursor::a, 0);
    plot.reader().place(PlotCursor::b, end);
    plot.reader().setGraph(m_page->plots()->forceGraph());
    const double unit = blow->units.impulse.factor;
    const double impulse = blow->summary.impulse * unit;
    QVERIFY(std::abs(plot.reader().reading()->integral / impulse - 1) < 1e-9);
    QVERIFY(plot.reader().text().contains(si ? QStringLiteral("N s") : QStringLiteral("I₀")));
    QVERIFY(std::abs(plot.reader().reading()->mean * end -
                     impulse / unit * blow->units.force.factor * blow->units.time.factor) <
            1e-9 * plot.reader().reading()->mean * end);
    plot.reader().setGraph(m_page->plots()->waveGraph(0));  // the blow itself, compressive
    QVERIFY(std::abs(plot.reader().reading()->integral / -unit - 1) < 1e-9);
    // At the middle section what runs up has taken back all but the rebound.
    plot.reader().setGraph(m_page->plots()->sectionForceGraph());
    const double atSection = sectionImpulse(blow->impact, 0.5, end / blow->units.time.factor) -
                             sectionImpulse(blow->impact, 0.5, 0);
    QVERIFY(std::abs(plot.reader().reading()->integral / (atSection * unit) - 1) < 1e-9);
    plot.reader().setGraph(m_page->plots()->impulseGraph());
    QVERIFY(std::abs(plot.reader().reading()->yB / impulse - 1) < 1e-12);
    plot.reader().setGraph(m_page->plots()->momentumGraph());
    QVERIFY(std::abs(plot.reader().reading()->yB / (-blow->summary.cor * unit) - 1) < 1e-9);
    // Between the cursors in the middle of the rising force the curve itself is read, not its chords.
    const double arrival = blow->summary.firstContactTime;
    plot.reader().place(PlotCursor::a, (arrival + 0.31) * blow->units.time.factor);
    plot.reader().setGraph(m_page->plots()->forceGraph());
    const double force = WaveField(blow->impact).impactForce(arrival + 0.31);
    QVERIFY(std::abs(plot.reader().reading()->yA / (force * blow->units.force.factor) - 1) < 1e-9);
}

void TestBlowPage::whatIsReadOutlivesTheBlow() {
    SolvedBlowPtr blow = solved(*m_page, Scenario(), UnitSystem::si);
    const BlowMeanings meanings = blowMeanings(blow);
    const double impulse = blow->summary.impulse * blow->units.impulse.factor;
    const double end = 2 * blow->page<BlowCurves>()->timeEnd;
    const std::weak_ptr<const SolvedBlow> watched = blow;
    blow.reset();
    QVERIFY(!watched.expired());
    QVERIFY(std::abs(meanings.force.integral(0, end) * meanings.force.integralFactor / impulse - 1) < 1e-9);
}

// Through the whole window: the panel tells of the drag, the window gives the page what was shown.
void TestBlowPage::aHeldSliderLeavesAGhostUntilItIsReleased() {
    ScriptedAnswers answers;
    MainWindow window(std::make_unique<ScriptedQuestions>(answers), exactSolve());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const int curves = part<BlowPage>(window).plot()->graphCount();
    auto* slider = part<ScenarioPanel>(window).findChild<QuantitySlider*>(QStringLiteral("beta.slider"));
    const SolvedBlowPtr before = window.shown();
    slider->setSliderDown(true);
    for (const int position : {300, 500, 700}) {
        slider->setValue(position);
        QTRY_VERIFY_WITH_TIMEOUT(!part<SolveJob>(window).isBusy(), 60000);
    }
    QVERIFY(window.shown() != before);
    QCOMPARE(part<BlowPage>(window).plot()->graphCount(), curves + 7);
    QCOMPARE(part<BlowPage>(window).plot()->graph(curves)->data().get(),
             before->page<BlowCurves>()->waves[0].get());
    slider->setSliderDown(false);
    QCOMPARE(part<BlowPage>(window).plot()->graphCount(), curves);
}

QTEST_MAIN(TestBlowPage)
#include "tst_blow_page.moc"
