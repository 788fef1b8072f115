// SPDX-License-Identifier: GPL-3.0-or-later
// The page Accuracy: only its button runs a study, finished rows stay, a click loads a case.
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTest>

#include "core/report/accuracy_columns.h"
#include "core/report/proof_answer.h"
#include "tests/support/page_words.h"
#include "tests/support/program.h"
#include "ui/pages/accuracy/accuracy_page.h"
#include "ui/pages/accuracy/proof_table.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"

using namespace drillwave;

namespace {

LocalStyle windowStyle() {
    return {QLocale::c(), UnitSystem::si, {}};
}

}  // namespace

class TestAccuracyPage : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void init();
    void nothingIsRunUnasked();
    void theBoundOfTheSolverIsThereAtOnce();
    void whatIsDoneStaysWhenCancelled();
    void anotherScenarioTakesTheMeasurementAway();
    void thePictureShowsTheNumbersOfTheStudy();
    void pointsInAnyOrderAreInView();
    void wordsAtPointsStayWithinTheAxes();
    void theTableShowsTheColumnsOfTheCommand();
    void theWorstCaseComesFirst();
    void aClickLoadsACaseAsOneStep();
    void keysGoFromCaseToCase();
    void theCommandIsThatOfTheTab();
    void aStringIsMeasuredByItsMethods();
    void aRodTakesTheMeasurementOfAStringAway();

  private:
    void measureString();
    QPushButton* button() const { return m_page->findChild<QPushButton*>("run"); }
    QTabWidget* tabs() const { return m_page->findChild<QTabWidget*>("proofs"); }
    QTableView* table(const char* name) const { return m_page->findChild<QTableView*>(name); }
    QString words() const { return pageWords(*m_page); }
    int points() const;

    Accuracy m_measured;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<AccuracyPage> m_page;
};

// Takes two small lattices: quick, and all that a picture needs.
void TestAccuracyPage::initTestCase() {
    QLocale::setDefault(QLocale::c());
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    m_measured = measureAccuracy(scenario, {100, 200});
}

void TestAccuracyPage::init() {
    m_page.reset();
    m_document = std::make_unique<Document>();
    m_document->start();
    m_page = std::make_unique<AccuracyPage>(*m_document);
    m_page->resize(900, 700);
}

int TestAccuracyPage::points() const {
    int count = 0;
    for (int i = 0; i < m_page->plot()->graphCount(); ++i) count += m_page->plot()->graph(i)->dataCount();
    return count;
}

void TestAccuracyPage::nothingIsRunUnasked() {
    m_page->show();
    tabs()->setCurrentIndex(1);
    tabs()->setCurrentIndex(0);
    m_document->assign(*findParameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    QCOMPARE(m_page->studies(), 0);
    QCOMPARE(points(), 0);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

void TestAccuracyPage::theBoundOfTheSolverIsThereAtOnce() {
    m_page->show();
    SolveRequest request;
    request.scenario = m_document->scenario();
    request.units = UnitSystem::si;
    MethodSolver solver;
    const SolvedBlowPtr blow = solveBlow(request, solver);
    m_page->setResult(blow);
    const QLocale c = QLocale::c();
    QVERIFY2(words().contains(numberText(blow->impact.cor, 6, c)), qPrintable(words()));
    QVERIFY2(words().contains(magnitudeText(blow->impact.corError, c)), qPrintable(words()));
    QCOMPARE(m_page->studies(), 0);
}

void TestAccuracyPage::whatIsDoneStaysWhenCancelled() {
    m_page->show();
    QTest::mouseClick(button(), Qt::LeftButton);
    QCOMPARE(m_page->studies(), 1);
    QCOMPARE(button()->text(), QStringLiteral("Cancel"));
    const QAbstractItemModel* rows = table("accuracyTable")->model();
    QTRY_VERIFY(rows->rowCount() >= 2);
    QTest::mouseClick(button(), Qt::LeftButton);
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    QVERIFY(rows->rowCount() >= 2);
    QVERIFY(points() >= 2);
    QVERIFY(button()->text().startsWith(QStringLiteral("Run")));
    // But it is not all that the command writes.
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

void TestAccuracyPage::anotherScenarioTakesTheMeasurementAway() {
    m_page->show();
    button()->click();
    const QAbstractItemModel* rows = table("accuracyTable")->model();
    QTRY_VERIFY(rows->rowCount() >= 1);
    m_document->assign(*findParameter("bit_rock.stiffness"), 2e8, m_document->newGesture());
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    QCOMPARE(rows->rowCount(), 0);
    QCOMPARE(points(), 0);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
    m_document->undoStack().undo();
    QVERIFY(rows->rowCount() >= 1);
}

void TestAccuracyPage::thePictureShowsTheNumbersOfTheStudy() {
    const StudyFigure figure = accuracyAnswer(Scenario(), m_measured)->figure(0);
    const std::vector<FigureSeries>& all = figure.panels.front().series;
    QCOMPARE(all.size(), std::size_t{4});  // exact, two lattices, closed form
    int shown = 0;
    for (const FigureSeries& series : all)
        for (std::size_t i = 0; i < series.x.size(); ++i, ++shown) {
            const AccuracyRow& row = m_measured.rows[series.rows[i]];
            QCOMPARE(series.x[i], row.time.median);
            QCOMPARE(series.y[i], std::max(row.corError, 1e-17));
        }
    QCOMPARE(shown, int(m_measured.rows.size()));
}

/// The first and the last of the points were taken for the ends, and others were out of view.
void TestAccuracyPage::pointsInAnyOrderAreInView() {
    PlotWidget plot;
    FigureFrame frame(&plot);
    StudyPanel panel{.x = {.isLogarithmic = true}, .y = {.isLogarithmic = true}};
    panel.series = {{.x = {1, 1e6, 1e-6, 10}, .y = {1, 2, 3, 4}, .points = SeriesPoints::apart}};
    frame.present({{.panels = {panel}}, {}});
    const QCPRange shown = plot.axisRects().first()->axis(QCPAxis::atBottom)->range();
    QVERIFY(shown.lower < 1e-6 && shown.upper > 1e6);
}

/// At the right edge words stood to the right of their point all the same, and were cut.
void TestAccuracyPage::wordsAtPointsStayWithinTheAxes() {
    PlotWidget plot;
    plot.resize(500, 300);
    FigureFrame frame(&plot);
    const char* words = "10,000, the paper's choice";
    const auto series = [&](double y, TextSide side) {
        return FigureSeries{.legend = "points",
                            .x = {1},
                            .y = {y},
                            .points = SeriesPoints::joined,
                            .texts = {{words}},
                            .textSide = side};
    };
    StudyPanel panel{.x = {.isLogarithmic = true}, .y = {.isLogarithmic = true}};
    panel.series = {series(1e-3, TextSide::below), series(1, TextSide::above)};
    frame.present({{.panels = {panel}}, {}});
    const QCPAxisRect& rect = *plot.axisRects().first();
    for (const double share : {0.05, 0.95}) {
        rect.axis(QCPAxis::atBottom)->setRange(std::pow(10, -share), std::pow(10, 1 - share));
        plot.replot();
        plot.replot();
        int count = 0;
        for (int i = 0; i < plot.itemCount(); ++i) {
            const auto* text = qobject_cast<QCPItemText*>(plot.item(i));
            if (!text || text->text() != QLatin1String(words)) continue;
            const QRect inside = rect.rect().adjusted(-1, 0, 1, 0);
            QVERIFY(text->left->pixelPosition().x() >= inside.left());
            QVERIFY(text->right->pixelPosition().x() <= inside.right());
            ++count;
        }
        QCOMPARE(count, 2);
    }
}

void TestAccuracyPage::theTableShowsTheColumnsOfTheCommand() {
    ProofTable rows;
    rows.present(QStringLiteral("method"), accuracyAnswer(Scenario(), m_measured)->table(windowStyle()));
    QCOMPARE(rows.rowCount(), int(m_measured.rows.size()));
    int column = 1;
    for (const auto& each : accuracyColumns) {
        if (each.title.empty()) continue;
        QCOMPARE(rows.headerData(column, Qt::Horizontal).toString().toStdString(), std::string(each.title));
        ++column;
    }
    QCOMPARE(rows.columnCount(), column);
    QCOMPARE(rows.index(0, 0).data().toString(), QStringLiteral("exact"));
    QCOMPARE(rows.index(0, 1).data().toString(),
             magnitudeText(m_measured.rows.front().corError, QLocale::c()));
}

void TestAccuracyPage::theWorstCaseComesFirst() {
    StabilityReport report;
    for (const StabilityCase& each : stabilityCases()) {
        if (report.rows.size() == 40) break;
        report.rows.push_back(checkStability({each}, 1, {}, [](const StabilityReport&) {}).rows.front());
    }
    report.rows[17].momentumResidual = 1;
    const StudyAnswerPtr answer = stabilityAnswer(report);
    QVERIFY(answer->scenarioOfRow(0) == scenarioOf(report.rows[17].stabilityCase));
    ProofTable rows;
    rows.present(QStringLiteral("case"), answer->table(windowStyle()));
    QCOMPARE(rows.rowCount(), 40);
    QCOMPARE(rows.index(0, 1).data().toString(), QStringLiteral("momentum"));
    double last = HUGE_VAL;
    for (int i = 0; i < rows.rowCount(); ++i) {
        const double percent = rows.index(i, 2).data().toString().section(u' ', 0, 0).toDouble();
        QVERIFY(i == 0 || (percent > 0 && percent <= 100));  // every other case has passed
        QVERIFY(i <= 1 || percent <= last);
        last = percent;
    }
}

void TestAccuracyPage::aClickLoadsACaseAsOneStep() {
    m_page->show();
    tabs()->setCurrentIndex(1);
    button()->click();
    QTableView* cases = table("stabilityTable");
    QTRY_VERIFY_WITH_TIMEOUT(cases->model()->rowCount() > 3, 30000);
    button()->click();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    const QModelIndex second = cases->model()->index(1, 0);
    const QString name = second.data().toString();
    QTest::mouseClick(cases->viewport(), Qt::LeftButton, {}, cases->visualRect(second).center());
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(QString::fromStdString(m_document->scenario().title), name);
    QVERIFY(m_document->scenario().form == ScenarioForm::dimensionless);
    QVERIFY2(m_document->undoStack().undoText().contains(name),
             qPrintable(m_document->undoStack().undoText()));
    // The cases are no scenario's: they stay.
    QVERIFY(cases->model()->rowCount() > 3);
    m_document->undoStack().undo();
    QVERIFY(m_document->scenario().form == ScenarioForm::dimensional);
}

void TestAccuracyPage::keysGoFromCaseToCase() {
    m_page->show();
    tabs()->setCurrentIndex(1);
    button()->click();
    QTRY_VERIFY_WITH_TIMEOUT(table("stabilityTable")->model()->rowCount() > 3, 30000);
    button()->click();
    PlotWidget& plot = *m_page->plot();
    plot.replot();
    QTest::keyClick(&plot, Qt::Key_Return);
    QTest::keyClick(&plot, Qt::Key_Home);
    const QPointF first = plot.keyPoint().place().value_or(QPointF());
    QTest::keyClick(&plot, Qt::Key_Right);
    QVERIFY(plot.keyPoint().place() != first);
    // Its name first, then its numbers.
    const QString name = plot.keyPoint().text().section(QLatin1Char('\n'), 0, 0);
    QTest::keyClick(&plot, Qt::Key_Return);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(QString::fromStdString(m_document->scenario().title), name);
}

void TestAccuracyPage::theCommandIsThatOfTheTab() {
    QVERIFY(m_page->command().startsWith(QStringLiteral("drillwave accuracy - -o - <<'END'\n")));
    tabs()->setCurrentIndex(1);
    QCOMPARE(m_page->command(), QStringLiteral("drillwave stability -o -"));
}

void TestAccuracyPage::measureString() {
    QVERIFY(m_document->open(test::example(QStringLiteral("t38_string"))).isEmpty());
    m_page->show();
    QTest::mouseClick(button(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(m_page->activity()->state(), StudyState::finished, 60'000);
}

void TestAccuracyPage::aStringIsMeasuredByItsMethods() {
    measureString();
    const QAbstractItemModel* rows = table("accuracyTable")->model();
    QCOMPARE(rows->columnCount(), int(stringAccuracyColumns.size()) + 1);
    QCOMPARE(rows->rowCount(), points());
    QCOMPARE(rows->index(0, 0).data().toString(), QStringLiteral("polynomial cells (studies)"));
    QCOMPARE(m_page->plot()->graphCount(), 3);
    QVERIFY(m_page->exports().first().obstacle().isEmpty());
    const QByteArray csv = m_page->exports().first().csv();
    QVERIFY(csv.contains("\nmethod,cell_s,error_efficiency,") && csv.contains("\nplain,"));
    QVERIFY(m_page->command().startsWith(QStringLiteral("drillwave accuracy ")));
    // The cases of the other tab are rods, which it says.
    QVERIFY2(tabs()->tabText(1).contains(QStringLiteral("uniform rods")), qPrintable(tabs()->tabText(1)));
}

void TestAccuracyPage::aRodTakesTheMeasurementOfAStringAway() {
    measureString();
    m_document->start();
    QCOMPARE(table("accuracyTable")->model()->rowCount(), 0);
    QCOMPARE(points(), 0);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

QTEST_MAIN(TestAccuracyPage)
#include "tst_accuracy_page.moc"
