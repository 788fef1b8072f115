// SPDX-License-Identifier: GPL-3.0-or-later
// The page Rod: its curves and their numbers, strengths, and where a click leads.
#include <QLabel>
#include <QTest>

#include "core/blow/result_alerts.h"
#include "core/wave/field/wave_field.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

class TestRodPage : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void askedForItsCurvesTheWorkerBuildsThem();
    void theExtremesAreThePeaksOfTheResult();
    void tensionIsAboveZeroAndCompressionBelow();
    void strengthsAreDrawnWhereTheRodHasThem();
    void aClickOnAPeakLeadsToItsPlaceAndTime();
    void aClickBesideACurveLeadsToTheLargestThere();
    void aClickBesideTheRodLeadsNowhere();
    void theSectionIsReadInWords();
    void theDataHaveThePlaceAndTimeOfEveryPoint();
    void anUnsolvedBlowSaysWhy();
    void anAnswerToAnotherPageChangesNothing();
    void aGhostStaysUntilItIsTakenAway();
    void aDimensionlessRodHasForces();
    void darkAndLightAreFollowed();

  private:
    SolvedBlowPtr solved(double stiffness = 105e6, UnitSystem units = UnitSystem::si) const;
    /// Clicks where a force of the line is drawn.
    void click(RodLine line, const RodForce& force, QPoint beside = {}) const;
    int visibleStrengths() const;
    QString readout() const {
        QString text = m_page->findChild<QLabel*>(QStringLiteral("readout"))->text();
        return text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    }

    std::unique_ptr<Observation> m_observation;
    std::unique_ptr<RodPage> m_page;
};

void TestRodPage::init() {
    QLocale::setDefault(QLocale::c());
    m_page.reset();
    m_observation = std::make_unique<Observation>();
    m_page = std::make_unique<RodPage>(*m_observation);
    m_page->resize(700, 500);
    m_page->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
}

SolvedBlowPtr TestRodPage::solved(double stiffness, UnitSystem units) const {
    SolveRequest request;
    request.scenario.bitRock.stiffness = stiffness;
    request.scenario.rod.yieldStrength = 900e6;
    request.units = units;
    request.pages = {m_page->prepare()};
    MethodSolver solver;
    return solveBlow(request, solver);
}

void TestRodPage::click(RodLine line, const RodForce& force, QPoint beside) const {
    const SolvedBlowPtr blow = solved();
    const RodCurves& curves = *blow->page<RodCurves>();
    PlotWidget& plot = *m_page->plot();
    plot.replot();
    const QPoint at(static_cast<int>(std::lround(plot.xAxis->coordToPixel(curves.position(force)))),
                    static_cast<int>(std::lround(plot.yAxis->coordToPixel(curves.stress(line, force)))));
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at + beside);
}

int TestRodPage::visibleStrengths() const {
    int lines = 0;
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (const auto* line = qobject_cast<QCPItemStraightLine*>(m_page->plot()->item(i)))
            lines += line->visible() && line->layer()->name() == QLatin1String("main");
    return lines;
}

void TestRodPage::askedForItsCurvesTheWorkerBuildsThem() {
    SolveRequest request;
    MethodSolver solver;
    QVERIFY(!solveBlow(request, solver)->page<RodCurves>());
    const SolvedBlowPtr blow = solved();
    QVERIFY(blow->page<RodCurves>());
    QCOMPARE(blow->pages.size(), std::size_t{1});
    std::stop_source stop;
    stop.request_stop();
    const RodCurves none =
        rodCurves(blow->impact, blow->solved.hammer, blow->scenario, blow->units, stop.get_token());
    QCOMPARE(none.envelope.steps, 0);
}

void TestRodPage::theExtremesAreThePeaksOfTheResult() {
    const SolvedBlowPtr blow = solved();
    const RodCurves& curves = *blow->page<RodCurves>();
    QCOMPARE(curves.envelope.largest, *blow->summary.rodForces);
    for (const RodLine line : rodLines) {
        double most = 0;
        for (const QCPGraphData& point : *curves.curve(line)) most = std::max(most, std::abs(point.value));
        QCOMPARE(most, curves.largest(line).size * blow->units.stress.factor);
    }
}

void TestRodPage::tensionIsAboveZeroAndCompressionBelow() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    QCOMPARE(m_page->plot()->graphCount(), 4);
    for (const RodLine line : rodLines) {
        bool found = false;
        const QCPRange range = m_page->rodPlot()->graph(line)->getValueRange(found);
        QVERIFY(found);
        QVERIFY(isTension(line) ? range.lower >= 0 && range.upper > 0 : range.upper <= 0 && range.lower < 0);
        QVERIFY(m_page->plot()->yAxis->range().contains(range.lower));
        QVERIFY(m_page->plot()->yAxis->range().contains(range.upper));
    }
    QVERIFY(m_page->plot()->yAxis->label().contains(QStringLiteral("tension positive")));
    QVERIFY(m_page->plot()->yAxis->label().contains(QStringLiteral("MPa")));
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("tension")));
}

void TestRodPage::strengthsAreDrawnWhereTheRodHasThem() {
    m_page->setResult(solved());
    QCOMPARE(visibleStrengths(), 2);  // yield, in compression too
    SolveRequest request;
    request.units = UnitSystem::si;
    request.scenario.rod.yieldStrength = 900e6;
    request.scenario.rod.fatigueStrength = 400e6;
    request.pages = {m_page->prepare()};
    MethodSolver solver;
    m_page->setResult(solveBlow(request, solver));
    QCOMPARE(visibleStrengths(), 3);
    QVERIFY(m_page->plot()->yAxis->range().contains(900));
    request.scenario.rod.yieldStrength.reset();
    request.scenario.rod.fatigueStrength.reset();
    m_page->setResult(solveBlow(request, solver));
    QCOMPARE(visibleStrengths(), 0);
}

void TestRodPage::aClickOnAPeakLeadsToItsPlaceAndTime() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    const RodCurves& curves = *blow->page<RodCurves>();
    for (const RodLine line : {RodLine::compression, RodLine::tension, RodLine::tensionAfter}) {
        const RodForce largest = curves.largest(line);
        click(line, largest, {0, isTension(line) ? -3 : 3});
        QCOMPARE(m_observation->section(), largest.section);
        QCOMPARE(m_observation->time(), std::optional(largest.time));
    }
    // The waves left push as hard at the same place: the time is that of the blow, until that is hidden.
    const RodForce left = curves.largest(RodLine::compressionAfter);
    QVERIFY(std::abs(left.section - curves.largest(RodLine::compression).section) < 1e-9);
    click(RodLine::compressionAfter, left);
    QCOMPARE(m_observation->time(), std::optional(curves.largest(RodLine::compression).time));
    m_page->rodPlot()->graph(RodLine::compression)->setVisible(false);
    click(RodLine::compressionAfter, left);
    QCOMPARE(m_observation->time(), std::optional(left.time));
}

void TestRodPage::aClickBesideACurveLeadsToTheLargestThere() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    const RodCurves& curves = *blow->page<RodCurves>();
    click(RodLine::tension, forceAt(curves.forces(RodLine::tension), 0.4), {0, -40});
    QVERIFY(std::abs(m_observation->section() - 0.4) < 0.01);
    QVERIFY(m_observation->time().has_value());
    // The wave field has that stress there and then, on one side of a jump.
    const RodForce there = forceAt(curves.forces(RodLine::tension), m_observation->section());
    const RodForce left = forceAt(curves.forces(RodLine::tensionAfter), m_observation->section());
    QVERIFY(*m_observation->time() == there.time || *m_observation->time() == left.time);
}

void TestRodPage::aClickBesideTheRodLeadsNowhere() {
    m_page->setResult(solved());
    m_page->plot()->xAxis->setRange(-1, 5);
    m_page->plot()->replot();
    const double before = m_observation->section();
    QVERIFY(!m_page->rodPlot()->forceAt({-0.5, 100}));
    QVERIFY(m_page->rodPlot()->forceAt({0.5, 100}));
    QCOMPARE(m_observation->section(), before);
}

void TestRodPage::theSectionIsReadInWords() {
    m_page->setResult(solved());
    const QString middle = readout();
    QVERIFY2(middle.contains(QStringLiteral("MPa at ")) && middle.contains(QStringLiteral(" ms")),
             qPrintable(middle));
    m_observation->setSection(0.9);
    QVERIFY(readout() != middle);
}

void TestRodPage::theDataHaveThePlaceAndTimeOfEveryPoint() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    const QList<QByteArray> rows = m_page->plot()->csv().trimmed().split('\n');
    QCOMPARE(rows.first(),
             QByteArray("position [m],compression [MPa],time [ms],position [m],tension [MPa],time [ms],"
                        "position [m],compression of the waves left [MPa],time [ms],"
                        "position [m],tension of the waves left [MPa],time [ms]"));
    const RodCurves& curves = *blow->page<RodCurves>();
    std::size_t most = 0;
    for (const RodLine line : rodLines) most = std::max(most, curves.forces(line).size());
    QCOMPARE(std::size_t(rows.size()), most + 1);
    for (const QByteArray& row : rows) QCOMPARE(row.count(','), 11);
    const QList<QByteArray> first = rows.at(1).split(',');
    QCOMPARE(first.at(0).toDouble(), 0.0);
    QCOMPARE(first.at(1).toDouble(),
             -curves.forces(RodLine::compression).front().size * blow->units.stress.factor);
}

void TestRodPage::anUnsolvedBlowSaysWhy() {
    m_page->setResult(solved());
    m_page->setResult(failedBlow({}, QStringLiteral("The rod has melted.")));
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("The rod has melted.")));
    QVERIFY(!m_page->plot()->hasData());
    QVERIFY(!m_page->rodPlot()->forceAt({0.5, 0}));
    m_page->setResult(solved());
    QVERIFY(m_page->plot()->hasData());
}

void TestRodPage::anAnswerToAnotherPageChangesNothing() {
    m_page->setResult(solved());
    const QString before = m_page->plot()->accessibleDescription();
    SolveRequest request;
    MethodSolver solver;
    m_page->setResult(solveBlow(request, solver));
    QCOMPARE(m_page->plot()->accessibleDescription(), before);
}

void TestRodPage::aGhostStaysUntilItIsTakenAway() {
    const SolvedBlowPtr before = solved();
    m_page->setResult(before);
    m_page->setGhost(before);
    m_page->setResult(solved(50e6));
    QCOMPARE(m_page->plot()->graphCount(), 6);
    m_page->setGhost(nullptr);
    QCOMPARE(m_page->plot()->graphCount(), 4);
}

void TestRodPage::aDimensionlessRodHasForces() {
    m_page->setResult(solved(105e6, UnitSystem::dimensionless));
    QVERIFY(m_page->plot()->yAxis->label().contains(QStringLiteral("force N")));
    QCOMPARE(m_page->plot()->xAxis->range(), QCPRange(0, 1));
}

void TestRodPage::darkAndLightAreFollowed() {
    m_page->setResult(solved());
    QPalette palette = m_page->palette();
    palette.setColor(QPalette::Base, QColor(30, 30, 32));
    palette.setColor(QPalette::Text, QColor(225, 225, 225));
    m_page->setPalette(palette);
    QCoreApplication::processEvents();
    QCOMPARE(m_page->plot()->grab().toImage().pixelColor(2, 2), QColor(30, 30, 32));
    QVERIFY(m_page->rodPlot()->graph(RodLine::tension)->pen().color().lightness() > 128);
}

QTEST_MAIN(TestRodPage)
#include "tst_rod_page.moc"
