// SPDX-License-Identifier: GPL-3.0-or-later
// The page COR–gap: the numbers of `drillwave gap`, where the scenario is, and what a click does.
#include <QComboBox>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include "core/report/gap_report.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "ui/form/quantity_field.h"
#include "ui/pages/study/figure_page.h"
#include "ui/plot/curve_reading.h"
#include "ui/plot/here_mark.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/shown_text.h"

using namespace drillwave;

namespace {

const Parameter& parameter(const char* key) {
    return *findParameter(key);
}

}  // namespace

class TestGapPage : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void outOfSightNothingIsComputed();
    void aGapThatIsDraggedMovesTheMarkAndAsksNothing();
    void theCurveIsThatOfTheCommand_data();
    void theCurveIsThatOfTheCommand();
    void aScatteredGapIsStudiedAsItIsTyped();
    void aClickTakesTheGapOverAsOneStep();
    void aClickOnTheDistributionTakesNothingOver();
    void otherResultsAreShownWithoutAnotherStudy();
    void aRodWithoutWavesSaysThatTheGapDoesNotMatter();
    void aScatterThatCannotBeIsSaid();
    void fieldsFollowTheFormOfTheScenario();
    void aSlowCurveIsShownCoarseFirst();
    void aQuickCurveIsNotShownTwice();
    void aRodAfterAStringHasItsCurveAgain();

  private:
    void start(const char* example);
    bool isDone() const { return m_page->activity()->state() == StudyState::finished; }
    QCPGraph* graph() const { return m_page->figureFrame().graph(); }
    HereMark* here() const { return m_page->findChild<HereMark*>(); }
    QByteArray exported() const { return m_page->exports().first().csv(); }
    void click(QPointF at);

    std::unique_ptr<Document> m_document;
    std::unique_ptr<FigurePage> m_page;
};

void TestGapPage::init() {
    QLocale::setDefault(QLocale::c());
    start("t38_medium_rock");
}

void TestGapPage::start(const char* name) {
    m_page.reset();
    m_document = std::make_unique<Document>();
    m_document->startFrom(findExample(name)->text, QString::fromLatin1(name));
    m_page = std::make_unique<FigurePage>(gapStudy(), *m_document);
    m_page->resize(900, 700);
}

void TestGapPage::click(QPointF at) {
    const QPoint pixel(int(graph()->keyAxis()->coordToPixel(at.x())),
                       int(graph()->valueAxis()->coordToPixel(at.y())));
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, pixel);
}

void TestGapPage::outOfSightNothingIsComputed() {
    m_document->assign(parameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    QCOMPARE(m_page->studies(), 0);
    m_page->show();
    QTRY_VERIFY(isDone());
    QCOMPARE(m_page->studies(), 1);
    QVERIFY(graph()->dataCount() > 400);
}

void TestGapPage::aGapThatIsDraggedMovesTheMarkAndAsksNothing() {
    m_page->show();
    QTRY_VERIFY(isDone());
    QVERIFY(here()->x().has_value());
    const double d0 = scalesOf(m_document->scenario()).penetration;
    const int gesture = m_document->newGesture();
    for (const double gap : {0.2, 0.4, 0.6, 2.25}) {
        m_document->assign(parameter("bit_rock.gap"), gap * d0, gesture);
        const double shown = gap > 1 ? gap - 2 : gap;
        QVERIFY(std::abs(*here()->x() / (shown * d0 * 1000) - 1) < 1e-12);
        const double y = *here()->y();
        // The solver at that very gap; the curve is known to 1e-10.
        const double cor = solveBlow(m_document->scenario(), {}, Detail::cor).impact.cor;
        QVERIFY2(std::abs(y - cor) < 2e-10, qPrintable(QString::number(y - cor)));
    }
    QCOMPARE(m_page->studies(), 1);
}

void TestGapPage::theCurveIsThatOfTheCommand_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<bool>("scattered");
    QTest::newRow("units") << "t38_medium_rock" << false;
    QTest::newRow("units, scattered") << "t38_medium_rock" << true;
    QTest::newRow("groups") << "paper_fig8_minimum" << false;
    QTest::newRow("groups, scattered") << "paper_fig8_minimum" << true;
    QTest::newRow("piston") << "t51_soft_rock" << false;
}

// Export writes what the copied command prints, byte for byte.
void TestGapPage::theCurveIsThatOfTheCommand() {
    QFETCH(QString, example);
    QFETCH(bool, scattered);
    start(qPrintable(example));
    m_document->assign(parameter("gamma"), 0.37, m_document->newGesture());
    m_document->assign(parameter("delta"), 0.123456789, m_document->newGesture());
    m_page->findChild<QComboBox*>("scatter")->setCurrentIndex(scattered ? 1 : 0);
    m_page->show();
    QTRY_VERIFY(isDone());
    const test::Finished command = test::shell(m_page->command());
    QVERIFY2(command.exitCode == 0, command.error.constData());
    QVERIFY(command.out.count('\n') > 400);
    QCOMPARE(exported(), command.out);
    QCOMPARE(m_page->command().contains("--gap-deviation"), scattered);
    // And the curve on show goes through these points.
    const QList<QByteArray> last = command.out.trimmed().split('\n').last().split(',');
    const double scale = m_document->scenario().form == ScenarioForm::dimensional ? 1000 : 1;
    QCOMPARE((graph()->data()->constEnd() - 1)->key, last[0].toDouble() * scale);
    QCOMPARE((graph()->data()->constEnd() - 1)->value, last[1].toDouble());
}

void TestGapPage::aScatteredGapIsStudiedAsItIsTyped() {
    m_page->show();
    m_page->findChild<QComboBox*>("scatter")->setCurrentIndex(1);
    auto* mean = m_page->findChild<QuantityField*>("gap-mean");
    QVERIFY(mean && mean->isVisible());
    mean->selectAll();
    QTest::keyClicks(mean, "1.5 mm");
    auto* deviation = m_page->findChild<QuantityField*>("gap-deviation");
    deviation->selectAll();
    QTest::keyClicks(deviation, "300 um");
    QTRY_VERIFY(isDone());
    QVERIFY2(m_page->command().contains("--gap-mean '1.5 mm' --gap-deviation '0.3 mm'"),
             qPrintable(m_page->command()));
    const QString summary = m_page->figureFrame().textSummary();
    QVERIFY2(summary.startsWith("scattered gap"), qPrintable(summary));
    deviation->selectAll();
    QTest::keyClicks(deviation, "0 mm");
    QVERIFY(deviation->problem().contains("deviation"));
}

void TestGapPage::aClickTakesTheGapOverAsOneStep() {
    m_page->show();
    QTRY_VERIFY(isDone());
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    m_page->plot()->replot();
    // Beside the curve, a click only gives the plot the focus.
    const double value = chordValue(*graph()->data(), 1.2);
    click({1.2, graph()->valueAxis()->pixelToCoord(graph()->valueAxis()->coordToPixel(value) - 20)});
    QCOMPARE(m_document->undoStack().count(), 0);
    click({1.2, value});
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY(std::abs(m_document->scenario().bitRock.gap - 1.2e-3) < 1e-5);
    QVERIFY(std::abs(*here()->x() - m_document->scenario().bitRock.gap * 1000) < 1e-9);
    QCOMPARE(m_page->studies(), 1);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().bitRock.gap, 0.0);
}

void TestGapPage::aClickOnTheDistributionTakesNothingOver() {
    m_page->show();
    QTRY_VERIFY(isDone());
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    m_page->plot()->replot();
    const QCPAxisRect* beside = m_page->plot()->axisRects().last();
    QVERIFY(!m_page->figureFrame().targetIn(beside));
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, beside->rect().center());
    QCOMPARE(m_document->undoStack().count(), 0);
}

void TestGapPage::otherResultsAreShownWithoutAnotherStudy() {
    m_page->show();
    QTRY_VERIFY(isDone());
    const double cor = graph()->data()->constBegin()->value;
    m_page->findChild<QComboBox*>("output")->setCurrentIndex(1);
    QCOMPARE(m_page->studies(), 1);
    const double force = graph()->data()->constBegin()->value;
    QVERIFY(force > 100 && force < 400);  // kN
    QVERIFY(cor < 1);
    QVERIFY(graph()->valueAxis()->label().contains("kN"));
}

void TestGapPage::aRodWithoutWavesSaysThatTheGapDoesNotMatter() {
    start("reference_case");
    m_page->show();
    QTRY_VERIFY(isDone());
    QVERIFY(pageWords(*m_page).contains("does not depend on the gap"));
    QVERIFY(graph()->dataCount() > 0);
}

void TestGapPage::aScatterThatCannotBeIsSaid() {
    start("paper_fig8_minimum");
    m_page->show();
    m_page->findChild<QComboBox*>("scatter")->setCurrentIndex(1);
    auto* deviation = m_page->findChild<QuantityField*>("gap-deviation");
    deviation->selectAll();
    QTest::keyClicks(deviation, "101");
    QVERIFY(deviation->problem().contains("100"));
    QTRY_VERIFY(isDone());
}

void TestGapPage::fieldsFollowTheFormOfTheScenario() {
    m_page->show();
    m_page->findChild<QComboBox*>("scatter")->setCurrentIndex(1);
    QVERIFY(m_page->findChild<QuantityField*>("gap-mean")->unitButton()->isVisible());
    // A page is no wider than its widest control, whatever is chosen.
    QVERIFY(m_page->minimumSizeHint().width() < 376);
    QVERIFY(m_document->startFrom(findExample("paper_fig4b")->text, "paper").isEmpty());
    QTRY_VERIFY(isDone());
    auto* mean = m_page->findChild<QuantityField*>("gap-mean");
    QVERIFY(mean->isVisible() && !mean->unitButton());
    QCOMPARE(*m_page->findChild<QuantityField*>("gap-deviation")->value(), 0.1);
    m_page->findChild<QComboBox*>("scatter")->setCurrentIndex(0);
    QVERIFY(!m_page->findChild<QuantityField*>("gap-mean"));
    QTRY_VERIFY(isDone());
}

// A measured blow of many points: five blows, then nine, and so on, long before the curve.
void TestGapPage::aSlowCurveIsShownCoarseFirst() {
    Scenario scenario;
    scenario.pulse.shape = PulseShape::table;
    std::vector<TablePoint> points;
    constexpr int count = 8000;
    for (int i = 0; i <= count; ++i)
        points.push_back({200e-6 * i / count, 2e5 * std::sin(M_PI * i / count) * (1 + 0.1 * (i % 2))});
    scenario.pulse.tablePoints = points;
    std::stop_source stop;
    std::vector<StudyAnswerPtr> shown;
    const StudyWork work{.stop = stop.get_token(), .show = [&](StudyAnswerPtr answer) {
                             shown.push_back(std::move(answer));
                             if (shown.size() == 2) stop.request_stop();
                         }};
    gapStudy().run(gapStudy().question(scenario, {}), work);
    QCOMPARE(shown.size(), std::size_t{2});
    const auto curve = [&](std::size_t i) { return shown[i]->figure(0).panels.front().series.front(); };
    QCOMPARE(curve(0).x.size(), std::size_t{5});
    QCOMPARE(curve(1).x.size(), std::size_t{9});
    for (std::size_t i = 0; i < 9; ++i) QCOMPARE(curve(1).x[i], double(i) / 8);
    Problem problem = problemOf(scenario);
    problem.gap = 0.5;
    QCOMPARE(curve(1).y[4], ExactSolver().solve(problem, Detail::events).cor);
    QVERIFY(!shown[1]->gap().isEmpty());
    QVERIFY(shown[1]->figure(0).isPreview);
    QVERIFY(shown[1]->figure(0).panels.back().series.front().x.empty());
}

void TestGapPage::aQuickCurveIsNotShownTwice() {
    int shown = 0;
    const StudyWork work{.show = [&](const StudyAnswerPtr&) { ++shown; }};
    QVERIFY(gapStudy().run(gapStudy().question(Scenario(), {}), work)->gap().isEmpty());
    QCOMPARE(shown, 0);
}

// Before the page knows of a rod again it has been asked for nothing.
void TestGapPage::aRodAfterAStringHasItsCurveAgain() {
    start("t38_string");
    QVERIFY(!m_page->shows(m_document->scenario()));
    QVERIFY(m_page->elsewhere().contains(QStringLiteral("Efficiency–stiffness")));
    QVERIFY(m_document->open(test::example(QStringLiteral("t38_medium_rock"))).isEmpty());
    m_page->show();
    QTRY_VERIFY(isDone() && m_page->activity()->isCurrent());
    QVERIFY(graph()->dataCount() > 100);
    QVERIFY(graph()->keyAxis()->realVisibility());
    QVERIFY(m_page->exports().first().obstacle().isEmpty());
}

QTEST_MAIN(TestGapPage)
#include "tst_gap_page.moc"
