// SPDX-License-Identifier: GPL-3.0-or-later
// The page Map: its study, its plot, and the values that it takes over and passes on.
#include <qcustomplot.h>

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QTest>

#include "core/report/row_csv.h"
#include "core/study/map/map_rows.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "tests/support/map.h"
#include "ui/pages/map/level_field.h"
#include "ui/pages/map/map_page.h"
#include "ui/pages/study/axis_fields.h"
#include "ui/pages/study/output_box.h"
#include "ui/plot/crosshair.h"
#include "ui/plot/figure_frame.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// So few points that a test need not wait.
constexpr int fewPoints = 50;

}  // namespace

class TestMapPage : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void theFirstLookIsRestitutionOverStiffnessAndElasticity();
    void groupsAreMappedOverStiffnessAndGap();
    void aPageThatCannotBeSeenSolvesNothing();
    void everyValueIsTheBlowSolvedAlone();
    void theBorderOfSuperReboundIsDrawn();
    void theCommandWritesWhatThePageExports();
    void theCrosshairIsWhereTheScenarioIs();
    void draggingTheCrosshairMovesBothParametersInOneStep();
    void aLineOfTheCrosshairMovesOneParameter();
    void aDraggedCrosshairAsksForNoOtherMap();
    void anotherParameterAsksForAnotherMap();
    void aClickTakesOverThePoint();
    void cutsGoThroughTheCrosshair();
    void presetsAreNamedPoints();
    void thePointerReadsThePointBelowIt();
    void aCancelledMapKeepsWhatIsThere();
    void whatCannotBeMappedIsSaid();
    void levelsThatAreNoNumbersStayAndSayWhy();
    void aStringIsMappedOverCouplingAndRock();
    void theCommandOfAStringWritesWhatThePageExports();
    void draggingTheCrosshairMovesSectionAndRock();
    void rodsOfAStringAreMappedAsWholeNumbers();
    void theFormOfTheScenarioIsFollowedBack();

  private:
    void open(const char* example);
    void finish();
    void choose(const char* box, const char* parameter);
    void choosePoints(int eachWay);
    QPoint pixelOf(double x, double y) const;
    const QCPAxisRect* mapRect() const;
    QPointF crosshair() const;
    const MapReport& report() const { return *m_page->report(); }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<MapPage> m_page;
};

void TestMapPage::init() {
    m_page.reset();
    m_document = std::make_unique<Document>();
    m_document->start();
    m_page = std::make_unique<MapPage>(*m_document);
    m_page->resize(700, 700);
    auto* points = m_page->findChild<QComboBox*>(QStringLiteral("points"));
    points->setCurrentIndex(points->findData(fewPoints));
}

void TestMapPage::open(const char* example) {
    m_document->startFrom(findExample(example)->text, QString::fromLatin1(example));
    m_page->show();
    finish();
}

void TestMapPage::finish() {
    // A drill string may take seconds on a busy machine.
    QTRY_VERIFY_WITH_TIMEOUT(
        m_page->activity()->state() == StudyState::finished && m_page->activity()->isCurrent(), 60000);
    m_page->plot()->replot();
}

void TestMapPage::choose(const char* box, const char* parameter) {
    auto* fields = m_page->findChild<AxisFields*>(QLatin1String(box));
    auto* parameters = fields->findChild<QComboBox*>(QStringLiteral("parameter"));
    parameters->setCurrentIndex(parameters->findData(QString::fromLatin1(parameter)));
}

void TestMapPage::choosePoints(int eachWay) {
    auto* points = m_page->findChild<QComboBox*>(QStringLiteral("points"));
    points->setCurrentIndex(points->findData(eachWay));
}

const QCPAxisRect* TestMapPage::mapRect() const {
    return m_page->figureFrame().graph()->keyAxis()->axisRect();
}

/// Returns the place of the crosshair, in the units of the axes.
QPointF TestMapPage::crosshair() const {
    return m_page->findChild<Crosshair*>()->place().value_or(QPointF());
}

QPoint TestMapPage::pixelOf(double x, double y) const {
    const QCPAxisRect* rect = mapRect();
    return {qRound(rect->axis(QCPAxis::atBottom)->coordToPixel(x)),
            qRound(rect->axis(QCPAxis::atLeft)->coordToPixel(y))};
}

void TestMapPage::theFirstLookIsRestitutionOverStiffnessAndElasticity() {
    open("t38_medium_rock");
    QCOMPARE(report().study.x.key(), std::string_view("bit_rock.stiffness"));
    QCOMPARE(report().study.y.key(), std::string_view("bit_rock.gamma"));
    QCOMPARE(report().study.output.output->name, std::string_view("cor"));
    QVERIFY(report().grid.isComplete());
    QCOMPARE(report().grid.size(), std::size_t{fewPoints * fewPoints});
    QCOMPARE(report().contours.size(), std::size_t{1});
    QCOMPARE(report().contours[0].level, 1.0);
    QCOMPARE(mapRect()->axis(QCPAxis::atLeft)->label(), QStringLiteral("elasticity γ"));
    QVERIFY(m_page->figureFrame().textSummary().startsWith(QStringLiteral("COR e ranges from ")));
    const QString answer = m_page->findChild<QLabel*>(QStringLiteral("answer"))->text();
    QVERIFY2(answer.startsWith(QStringLiteral("COR e exceeds 1 only where elasticity γ is above 0")),
             qPrintable(answer));
}

void TestMapPage::groupsAreMappedOverStiffnessAndGap() {
    open("paper_fig4a");
    QCOMPARE(report().study.x.key(), std::string_view("beta"));
    QCOMPARE(report().study.y.key(), std::string_view("delta"));
    QCOMPARE(report().study.y.stop, 2.0);
}

void TestMapPage::aPageThatCannotBeSeenSolvesNothing() {
    m_document->startFrom(findExample("t38_medium_rock")->text, QStringLiteral("t38"));
    m_document->assign(*findParameter("rod.length"), 5, m_document->newGesture());
    QCoreApplication::processEvents();
    QCOMPARE(m_page->studies(), 0);
    m_page->show();
    finish();
    const int studies = m_page->studies();
    m_page->hide();
    m_document->assign(*findParameter("rod.length"), 6, m_document->newGesture());
    QCoreApplication::processEvents();
    QCOMPARE(m_page->studies(), studies);
    m_page->show();
    finish();
    QCOMPARE(m_page->studies(), studies + 1);
    QCOMPARE(report().study.base.rod.length, 6.0);
}

void TestMapPage::everyValueIsTheBlowSolvedAlone() {
    open("paper_fig4b");
    const MapGrid& grid = report().grid;
    for (std::size_t n = 0; n < grid.size(); n += 97) {
        Scenario scenario = m_document->scenario();
        const std::size_t column = n % grid.columns(), row = n / grid.columns();
        scenario.groups.beta = grid.xs()[column];
        scenario.groups.delta = grid.ys()[row];
        QCOMPARE(grid.value(column, row), ExactSolver().solve(problemOf(scenario), Detail::cor).cor);
    }
}

void TestMapPage::theBorderOfSuperReboundIsDrawn() {
    open("paper_fig4a");
    QVERIFY(report().contours[0].pointCount() > 100);
    QVERIFY(report().contours[0].worstResidual() < 1e-9);
    // All points, and a gap between lines.
    qsizetype drawn = 0;
    for (int i = 0; i < m_page->plot()->plottableCount(); ++i)
        if (auto* curve = qobject_cast<QCPCurve*>(m_page->plot()->plottable(i));
            curve && curve->keyAxis()->axisRect() == mapRect())
            drawn += curve->data()->size();
    std::size_t points = 0;
    for (const ContourLine& line : report().contours[0].lines) points += line.size() + 1;
    QCOMPARE(std::size_t(drawn), points - 1);
}

// As a shell runs it, beside the file that the export writes.
void TestMapPage::theCommandWritesWhatThePageExports() {
    const QString folder = QFileInfo(QStringLiteral(DRILLWAVE_PROGRAM)).absolutePath();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PATH"), folder + QLatin1Char(':') + environment.value("PATH"));
    for (const char* output : {"cor", "peak_force"}) {
        open("t38_medium_rock");
        m_document->assign(*findParameter("rod.length"), 4.2, m_document->newGesture());
        m_page->findChild<OutputBox*>()->setOutput(*findOutput(output));
        finish();
        const QString command = m_page->command();
        QVERIFY(command.contains(QStringLiteral("drillwave map - --x 'bit_rock.stiffness=10 MN/m")));
        QCOMPARE(command.contains(QStringLiteral("--si")), output != std::string_view("cor"));
        QProcess shell;
        shell.setProcessEnvironment(environment);
        shell.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), command});
        QVERIFY(shell.waitForFinished(60000));
        QCOMPARE(shell.exitCode(), 0);
        QVERIFY(shell.readAllStandardOutput() == m_page->exports().first().csv());
    }
}

void TestMapPage::theCrosshairIsWhereTheScenarioIs() {
    open("t38_medium_rock");
    QCOMPARE(crosshair(), QPointF(105, 0.1));
    m_document->assign(*findParameter("bit_rock.gamma"), 0.4, m_document->newGesture());
    QCOMPARE(crosshair(), QPointF(105, 0.4));
}

void TestMapPage::draggingTheCrosshairMovesBothParametersInOneStep() {
    open("t38_medium_rock");
    PlotWidget* plot = m_page->plot();
    QTest::mousePress(plot, Qt::LeftButton, {}, pixelOf(105, 0.1));
    for (const double gamma : {0.2, 0.3, 0.5}) QTest::mouseMove(plot, pixelOf(gamma * 1000, gamma));
    QTest::mouseRelease(plot, Qt::LeftButton, {}, pixelOf(500, 0.5));
    // As near as pixels are, in numbers that are easily read.
    QVERIFY(std::abs(m_document->scenario().bitRock.gamma - 0.5) < 0.005);
    QVERIFY(std::abs(m_document->scenario().bitRock.stiffness / 500e6 - 1) < 0.02);
    QCOMPARE(m_document->scenario().bitRock.gamma,
             QString::number(m_document->scenario().bitRock.gamma, 'g', 4).toDouble());
    QCOMPARE(m_document->undoStack().count(), 1);
    m_document->undoStack().undo();
    QCOMPARE(m_document->scenario().bitRock.stiffness, 105e6);
    QCOMPARE(m_document->scenario().bitRock.gamma, 0.1);
}

void TestMapPage::aLineOfTheCrosshairMovesOneParameter() {
    open("t38_medium_rock");
    QTest::mousePress(m_page->plot(), Qt::LeftButton, {}, pixelOf(105, 0.6));
    QTest::mouseMove(m_page->plot(), pixelOf(300, 0.8));
    QTest::mouseRelease(m_page->plot(), Qt::LeftButton, {}, pixelOf(300, 0.8));
    QCOMPARE(m_document->scenario().bitRock.gamma, 0.1);
    QVERIFY(std::abs(m_document->scenario().bitRock.stiffness / 300e6 - 1) < 0.02);
}

void TestMapPage::aDraggedCrosshairAsksForNoOtherMap() {
    open("t38_medium_rock");
    const int studies = m_page->studies();
    auto* crosshair = m_page->findChild<Crosshair*>();
    emit crosshair->held();
    for (int n = 1; n <= 20; ++n) {
        emit crosshair->dragged(QPointF(50 * n, 0.04 * n));
        QCoreApplication::processEvents();
    }
    QCOMPARE(m_page->studies(), studies);
    QVERIFY(m_page->activity()->isCurrent());
    QCOMPARE(m_document->scenario().bitRock.stiffness, 1e9);
}

void TestMapPage::anotherParameterAsksForAnotherMap() {
    open("t38_medium_rock");
    const int studies = m_page->studies();
    const double before = report().grid.value(10, 10);
    m_document->assign(*findParameter("bit_rock.gap"), 0.5e-3, m_document->newGesture());
    finish();
    QCOMPARE(m_page->studies(), studies + 1);
    QVERIFY(report().grid.value(10, 10) != before);
    m_document->setTitle(QStringLiteral("another title"));
    QCOMPARE(m_page->studies(), studies + 1);
}

void TestMapPage::aClickTakesOverThePoint() {
    open("t38_medium_rock");
    // Away from the presets: a press near a line of the crosshair takes hold of it.
    m_document->assign(*findParameter("bit_rock.gamma"), 0.9, m_document->newGesture());
    finish();
    const MapGrid& grid = report().grid;
    const QCPAxisRect* rect = mapRect();
    const QPoint crosshair = pixelOf(105, 0.9);
    constexpr int clear = 15;  // [px]
    std::optional<QPoint> mark;
    for (const QPointF& at : m_page->figureFrame().keyPlaces().marks())
        if (const QPoint pixel = pixelOf(at.x(), at.y()); !mark && rect->rect().contains(pixel) &&
                                                          std::abs(pixel.x() - crosshair.x()) > clear &&
                                                          std::abs(pixel.y() - crosshair.y()) > clear)
            mark = pixel;
    QVERIFY(mark);
    const auto place =
        m_page->figureFrame().field()->pointAt({rect->axis(QCPAxis::atBottom)->pixelToCoord(mark->x()),
                                                rect->axis(QCPAxis::atLeft)->pixelToCoord(mark->y())});
    QVERIFY(place);
    const double stiffness = grid.xs()[place->column], gamma = grid.ys()[place->row];
    // Away from lines and presets, a click only gives the plot the focus.
    m_page->plot()->keyPoint().offer({});
    for (QCPAbstractPlottable* line : rect->plottables()) line->setVisible(false);
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, *mark);
    QCOMPARE(m_document->undoStack().count(), 1);
    m_page->plot()->keyPoint().offer(m_page->figureFrame().keyPlaces());
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, *mark);
    QCOMPARE(m_document->scenario().bitRock.stiffness, stiffness);
    QCOMPARE(m_document->scenario().bitRock.gamma, gamma);
    QCOMPARE(m_document->undoStack().count(), 2);
    QVERIFY(m_document->undoStack().undoText().contains(QStringLiteral("stiffness")));
}

void TestMapPage::cutsGoThroughTheCrosshair() {
    open("t38_medium_rock");
    m_document->assign(*findParameter("bit_rock.gamma"), 0.8, m_document->newGesture());
    const MapGrid& grid = report().grid;
    const auto place = m_page->figureFrame().field()->pointAt({105, 0.8});
    QVERIFY(place);
    const auto cut = m_page->figureFrame().graph(std::size_t(MapPanel::alongX))->data();
    QCOMPARE(std::size_t(cut->size()), grid.columns());
    for (std::size_t column = 0; column < grid.columns(); ++column)
        QCOMPARE(cut->at(int(column))->value, grid.value(column, place->row));
}

void TestMapPage::presetsAreNamedPoints() {
    open("t38_medium_rock");
    QStringList names;
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(m_page->plot()->item(i)); text && text->visible())
            names << text->text();
    QVERIFY(names.contains(QStringLiteral("medium rock")) && names.contains(QStringLiteral("hard rock")));
    choose("y", "rod.length");
    finish();
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(m_page->plot()->item(i)))
            QVERIFY(text->text() != QStringLiteral("medium rock"));
}

void TestMapPage::thePointerReadsThePointBelowIt() {
    open("paper_fig4a");
    const MapGrid& grid = report().grid;
    QTest::mouseMove(m_page->plot(), pixelOf(grid.xs()[20], grid.ys()[12]));
    auto* words = m_page->findChild<QLabel*>(QStringLiteral("words"));
    QTRY_VERIFY(words->text().contains(QStringLiteral("stiffness β = ")));
    const QString value = QLocale().toString(grid.value(20, 12), 'g', 3);
    QVERIFY2(words->text().contains(value), qPrintable(words->text()));
}

void TestMapPage::aCancelledMapKeepsWhatIsThere() {
    open("t38_medium_rock");
    auto* points = m_page->findChild<QComboBox*>(QStringLiteral("points"));
    points->setCurrentIndex(points->findData(1000));
    QTRY_VERIFY(report().grid.columns() == 1000 && report().grid.stride() > 0);
    m_page->activity()->cancel();
    QCOMPARE(m_page->activity()->state(), StudyState::stopped);
    QVERIFY(report().grid.done() > 0);
    QVERIFY(!report().grid.isComplete());
    QVERIFY(m_page->figureFrame().field()->field()->grid->done() > 0);
    QVERIFY(!m_page->exports().first().obstacle().isEmpty());
}

void TestMapPage::whatCannotBeMappedIsSaid() {
    open("t38_medium_rock");
    choose("y", "beta");
    QVERIFY(m_page->figureFrame().textSummary().contains(QStringLiteral("set the same thing")));
    QVERIFY(m_page->command().isEmpty());
    choose("y", "bit_rock.gap");
    finish();
    QCOMPARE(report().study.y.key(), std::string_view("bit_rock.gap"));
    QVERIFY(!m_page->command().isEmpty());
}

void TestMapPage::levelsThatAreNoNumbersStayAndSayWhy() {
    open("paper_fig4a");
    const int studies = m_page->studies();
    auto* levels = m_page->findChild<LevelField*>();
    QCOMPARE(levels->text(), QStringLiteral("1"));
    levels->setText(QStringLiteral("1; one"));
    emit levels->editingFinished();
    QVERIFY(levels->problem().contains(QStringLiteral("one")));
    QCOMPARE(levels->text(), QStringLiteral("1; one"));
    QCOMPARE(m_page->studies(), studies);
    levels->setText(QStringLiteral("1; 1.2"));
    emit levels->editingFinished();
    QVERIFY(levels->problem().isEmpty());
    finish();
    QCOMPARE(report().contours.size(), std::size_t{2});
    QCOMPARE(report().contours[1].level, 1.2);
}

/// So few points that a test need not wait.
constexpr int fewPointsOfString = 20;

void TestMapPage::aStringIsMappedOverCouplingAndRock() {
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    m_page->show();
    const auto* points = m_page->findChild<QComboBox*>(QStringLiteral("points"));
    QCOMPARE(points->currentData().toInt(), 40);
    choosePoints(fewPointsOfString);
    finish();
    QCOMPARE(report().study.x.key(), std::string_view("string.coupling.diameter"));
    QCOMPARE(report().study.y.key(), std::string_view("bit_rock.stiffness"));
    QCOMPARE(report().study.y.kind, SweepAxis::Kind::logarithmic);
    QCOMPARE(report().study.output.output->name, std::string_view("efficiency"));
    QCOMPARE(report().grid.size(), std::size_t{fewPointsOfString * fewPointsOfString});
    QVERIFY(report().grid.isComplete());
    QCOMPARE(report().grid.failed(), std::size_t{0});
    QVERIFY(!report().contours.empty());
    QVERIFY(std::ranges::any_of(report().contours, [](const Contour& c) { return c.pointCount() > 5; }));
    const QString answer = m_page->findChild<QLabel*>(QStringLiteral("answer"))->text();
    QVERIFY2(answer.startsWith(QStringLiteral("The largest value of efficiency is 0")), qPrintable(answer));
    QVERIFY2(answer.contains(QStringLiteral(" and diameter of coupling = 80")), qPrintable(answer));
    QCOMPARE(crosshair(), QPointF(56, 100));
    QCOMPARE(m_page->plot()->axisRects().last()->axis(QCPAxis::atBottom)->label(),
             QStringLiteral("diameter of coupling [mm]"));
}

void TestMapPage::theCommandOfAStringWritesWhatThePageExports() {
    const QString folder = QFileInfo(QStringLiteral(DRILLWAVE_PROGRAM)).absolutePath();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PATH"), folder + QLatin1Char(':') + environment.value("PATH"));
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    m_page->show();
    choosePoints(fewPointsOfString);
    choose("x", "hammer.1.diameter");
    finish();
    const QString command = m_page->command();
    QVERIFY2(command.contains(QStringLiteral("drillwave map - --x 'hammer.1.diameter=")),
             qPrintable(command));
    QProcess shell;
    shell.setProcessEnvironment(environment);
    shell.start(QStringLiteral("/bin/sh"), {QStringLiteral("-c"), command});
    QVERIFY(shell.waitForFinished(60000));
    QCOMPARE(shell.readAllStandardError(), QByteArray());
    QVERIFY(shell.readAllStandardOutput() == m_page->exports().first().csv());
}

void TestMapPage::draggingTheCrosshairMovesSectionAndRock() {
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    m_page->show();
    choosePoints(fewPointsOfString);
    finish();
    const int before = m_document->undoStack().count(), studies = m_page->studies();
    QTest::mousePress(m_page->plot(), Qt::LeftButton, {}, pixelOf(56, 100));
    QTest::mouseMove(m_page->plot(), pixelOf(45, 200));
    QTest::mouseRelease(m_page->plot(), Qt::LeftButton, {}, pixelOf(45, 200));
    QCOMPARE(m_document->undoStack().count(), before + 1);
    QCOMPARE(m_page->studies(), studies);
    const double diameter = *findParameter("string.coupling.diameter")->value(m_document->scenario());
    QVERIFY2(std::abs(diameter - 0.045) < 5e-4, qPrintable(QString::number(diameter)));
    QVERIFY(std::abs(m_document->scenario().bitRock.stiffness / 2e8 - 1) < 0.05);
}

void TestMapPage::rodsOfAStringAreMappedAsWholeNumbers() {
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    m_page->show();
    choosePoints(fewPointsOfString);
    choose("x", "string.repeat");
    finish();
    QVERIFY(std::ranges::equal(report().grid.xs(), std::vector<double>{1, 2, 3, 4, 5, 6}));
    QCOMPARE(report().grid.rows(), std::size_t{fewPointsOfString});
}

void TestMapPage::theFormOfTheScenarioIsFollowedBack() {
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    m_page->show();
    open("t38_medium_rock");
    QCOMPARE(report().study.x.key(), std::string_view("bit_rock.stiffness"));
    QCOMPARE(report().study.y.key(), std::string_view("bit_rock.gamma"));
    QCOMPARE(report().study.output.output->name, std::string_view("cor"));
    QCOMPARE(report().contours.front().level, 1.0);
    m_document->startFrom(findExample("t38_string")->text, QStringLiteral("t38"));
    open("paper_fig4a");
    QCOMPARE(report().study.x.key(), std::string_view("beta"));
    QCOMPARE(report().study.y.key(), std::string_view("delta"));
}

QTEST_MAIN(TestMapPage)
#include "tst_map_page.moc"
