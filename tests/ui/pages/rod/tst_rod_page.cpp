// SPDX-License-Identifier: GPL-3.0-or-later
// The page Rod: its curves and their numbers, strengths, and where a click leads.
#include <QLabel>
#include <QTest>

#include "core/blow/blow_waves.h"
#include "core/blow/result_alerts.h"
#include "core/model/drill_string.h"
#include "core/wave/field/wave_field.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/pinned_run.h"
#include "tests/support/without_strengths.h"
#include "ui/pages/rod/rod_page.h"
#include "ui/pages/rod/rod_plot.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;
using namespace drillwave::test;

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
    void aStringHasTheStressesOfItsSections();
    void aStringHasItsJointsAndStrengthsAsSteps();
    void aClickInAStringLeadsToPlaceAndTime();
    void aClickInTheHammerLeadsThere();
    void theDataOfAStringHaveTheWavesLeft();
    void aStringWhoseWavesAreNotKeptSaysSo();
    void runsAreLaidOverTheirOwnKind();
    void rodsAndStringsTakeTurns();

  private:
    SolvedBlowPtr solvedString(const std::function<void(Scenario&)>& change = {},
                               UnitSystem units = UnitSystem::si) const;
    /// Visible ones of a string on a layer.
    int straightLines(const QString& layer) const;
    SolvedBlowPtr solved(double stiffness = 105e6, UnitSystem units = UnitSystem::si) const;
    /// Clicks where a force of the line is drawn.
    void click(Load line, const RodForce& force, QPoint beside = {}) const;
    int visibleStrengths() const;
    QString answer() const { return m_page->findChild<QLabel*>(QStringLiteral("answer"))->text(); }
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

void TestRodPage::click(Load line, const RodForce& force, QPoint beside) const {
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
    const RodCurves none = rodCurves(*blow, blow->units, stop.get_token());
    QCOMPARE(none.envelope.steps, 0);
}

void TestRodPage::theExtremesAreThePeaksOfTheResult() {
    const SolvedBlowPtr blow = solved();
    const RodCurves& curves = *blow->page<RodCurves>();
    QCOMPARE(curves.envelope.largest, *blow->summary.rodForces);
    for (const Load line : loads) {
        double most = 0;
        for (const QCPGraphData& point : *curves.curve(line)) most = std::max(most, std::abs(point.value));
        QCOMPARE(most, curves.largest(line).size * blow->units.stress.factor);
    }
}

void TestRodPage::tensionIsAboveZeroAndCompressionBelow() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    QCOMPARE(m_page->plot()->graphCount(), 4);
    for (const Load line : loads) {
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
    for (const Load line : {Load::compression, Load::tension, Load::tensionAfter}) {
        const RodForce largest = curves.largest(line);
        click(line, largest, {0, isTension(line) ? -3 : 3});
        QCOMPARE(m_observation->section(), largest.section);
        QCOMPARE(m_observation->time(), std::optional(largest.time));
    }
    // The waves left push as hard at the same place: the time is that of the blow, until that is hidden.
    const RodForce left = curves.largest(Load::compressionAfter);
    QVERIFY(std::abs(left.section - curves.largest(Load::compression).section) < 1e-9);
    click(Load::compressionAfter, left);
    QCOMPARE(m_observation->time(), std::optional(curves.largest(Load::compression).time));
    m_page->rodPlot()->graph(Load::compression)->setVisible(false);
    click(Load::compressionAfter, left);
    QCOMPARE(m_observation->time(), std::optional(left.time));
}

void TestRodPage::aClickBesideACurveLeadsToTheLargestThere() {
    const SolvedBlowPtr blow = solved();
    m_page->setResult(blow);
    const RodCurves& curves = *blow->page<RodCurves>();
    click(Load::tension, forceAt(curves.forces(Load::tension), 0.4), {0, -40});
    QVERIFY(std::abs(m_observation->section() - 0.4) < 0.01);
    QVERIFY(m_observation->time().has_value());
    // The wave field has that stress there and then, on one side of a jump.
    const RodForce there = forceAt(curves.forces(Load::tension), m_observation->section());
    const RodForce left = forceAt(curves.forces(Load::tensionAfter), m_observation->section());
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
                        "position [m],compression of residual waves [MPa],time [ms],"
                        "position [m],tension of residual waves [MPa],time [ms]"));
    const RodCurves& curves = *blow->page<RodCurves>();
    std::size_t most = 0;
    for (const Load line : loads) most = std::max(most, curves.forces(line).size());
    QCOMPARE(std::size_t(rows.size()), most + 1);
    for (const QByteArray& row : rows) QCOMPARE(row.count(','), 11);
    const QList<QByteArray> first = rows.at(1).split(',');
    QCOMPARE(first.at(0).toDouble(), 0.0);
    QCOMPARE(first.at(1).toDouble(),
             -curves.forces(Load::compression).front().size * blow->units.stress.factor);
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
    QVERIFY(m_page->rodPlot()->graph(Load::tension)->pen().color().lightness() > 128);
}

SolvedBlowPtr TestRodPage::solvedString(const std::function<void(Scenario&)>& change,
                                        UnitSystem units) const {
    SolveRequest request;
    request.scenario = test::withoutStrengths(
        parseScenario(std::string(findExample("t38_string")->text), "t38_string.yaml").scenario);
    if (change) change(request.scenario);
    request.units = units;
    request.pages = {m_page->prepare()};
    MethodSolver solver;
    return solveBlow(request, solver);
}

int TestRodPage::straightLines(const QString& layer) const {
    int lines = 0;
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (const auto* line = qobject_cast<QCPItemStraightLine*>(m_page->plot()->item(i)))
            lines += line->visible() && line->layer()->name() == layer;
    return lines;
}

void TestRodPage::aStringHasTheStressesOfItsSections() {
    const SolvedBlowPtr blow = solvedString();
    m_page->setResult(blow);
    const RodCurves& curves = *blow->page<RodCurves>();
    QVERIFY(curves.string && curves.string->waves);
    const double scale = scalesOf(blow->scenario).stress;
    const std::vector<SectionStress> stresses = sectionStresses(blow->scenario, blow->impact);
    const std::vector<RodStretch>& stretches = curves.string->stretches;
    QCOMPARE(stretches.size(), stresses.size());
    for (std::size_t j = 0; j < stretches.size(); ++j) {
        const auto most = [&](Load line) {
            double size = 0;
            for (const RodForce& force : curves.forces(line))
                if (force.section > stretches[j].rear + 1e-9 && force.section < stretches[j].front - 1e-9)
                    size = std::max(size, force.size);
            return size * scale;
        };
        // the ends are those of the neighbours too
        QVERIFY(most(Load::compression) <= stresses[j].compression.stress * (1 + 1e-6));
        QVERIFY(most(Load::tension) <= stresses[j].tension.stress * (1 + 1e-6));
        QVERIFY(most(Load::compression) > stresses[j].compression.stress * 0.8);
    }
    QCOMPARE(curves.largest(Load::compression).size, *blow->summary.largest.compression);
    QCOMPARE(curves.largest(Load::tension).size, *blow->summary.largest.tension);
    QVERIFY(curves.rear() < 0);
    const QCPRange range = m_page->plot()->xAxis->range();
    QCOMPARE(range.lower, curves.rear() * blow->units.length.factor);
    QCOMPARE(range.upper, blow->units.length.factor);
    QVERIFY(m_page->plot()->xAxis->label().contains(QStringLiteral("struck end")));
    QVERIFY2(readout().endsWith(QStringLiteral("in 2nd rod")), qPrintable(readout()));
    QVERIFY2(answer().startsWith(QStringLiteral("During the blow, the largest compression is ")),
             qPrintable(answer()));
    QVERIFY2(answer().contains(QStringLiteral(". No section has a strength")), qPrintable(answer()));
}

void TestRodPage::aStringHasItsJointsAndStrengthsAsSteps() {
    const SolvedBlowPtr blow = solvedString([](Scenario& scenario) {
        for (StringPart& part : scenario.drillString.parts)
            for (Section& section : part.sections) {
                section.yieldStrength = section.name == "rod" ? 250e6 : 400e6;
                if (section.name == "rod") section.fatigueStrength = 100e6;
            }
    });
    m_page->setResult(blow);
    QVERIFY2(readout().contains(QStringLiteral("in 2nd rod; the largest stress of this section uses ")),
             qPrintable(readout()));
    QVERIFY2(answer().startsWith(QStringLiteral("During the blow, the most heavily loaded section (")),
             qPrintable(answer()));
    const RodCurves& curves = *blow->page<RodCurves>();
    QCOMPARE(straightLines(QStringLiteral("grid")), static_cast<int>(curves.string->stretches.size()) - 1);
    QCOMPARE(visibleStrengths(), 0);
    QVector<QPair<double, double>> steps;
    double covered = 0;
    for (int i = 0; i < m_page->plot()->itemCount(); ++i)
        if (const auto* step = qobject_cast<QCPItemLine*>(m_page->plot()->item(i))) {
            const double height = step->start->value();
            QCOMPARE(step->end->value(), height);
            QVERIFY(std::abs(std::abs(height) - 250) < 1e-6 || std::abs(std::abs(height) - 400) < 1e-6 ||
                    std::abs(height - 100) < 1e-6);
            if (std::abs(height - 250) < 1e-6) covered += step->end->key() - step->start->key();
        }
    double rods = 0;
    for (const Section* section : allSections(blow->scenario.drillString))
        if (section->name == "rod") rods += section->length;
    QVERIFY(rods > 10 && std::abs(covered - rods) < 1e-9 * rods);
}

void TestRodPage::aClickInAStringLeadsToPlaceAndTime() {
    const SolvedBlowPtr blow = solvedString();
    m_page->setResult(blow);
    const RodCurves& curves = *blow->page<RodCurves>();
    PlotWidget& plot = *m_page->plot();
    plot.replot();
    const double x = 0.4 * blow->units.length.factor;
    const RodForce pull = curves.forceAt(Load::tension, 0.4);
    const QPoint at(
        static_cast<int>(std::lround(plot.xAxis->coordToPixel(x))),
        static_cast<int>(std::lround(plot.yAxis->coordToPixel(curves.stress(Load::tension, pull)))));
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at - QPoint(0, 30));
    QVERIFY(std::abs(m_observation->section() - 0.4) < 0.005);
    // what is read there is what the waves have there and then
    const RodForce there = curves.forceAt(Load::tension, m_observation->section());
    QCOMPARE(m_observation->time(), std::optional(there.time));
    const StringPlace place = stringPlace(blow->scenario.drillString, m_observation->section());
    double force = 0;
    for (const TimeSide side : {TimeSide::before, TimeSide::after})
        force = std::min(force, curves.string->waves->force(place.section, place.share, there.time, side));
    QVERIFY(std::abs(stressOf(curves.string->stretches[place.section], -force, place.share) - there.size) <
            1e-9 * there.size);
}

void TestRodPage::aClickInTheHammerLeadsThere() {
    const SolvedBlowPtr blow = solvedString();
    m_page->setResult(blow);
    m_observation->setSection(0.7);
    const RodCurves& curves = *blow->page<RodCurves>();
    m_observation->setRear(curves.rear());
    const double middle = curves.rear() / 2;
    m_page->plot()->xAxis->setRange(curves.rear() * blow->units.length.factor, 0);
    m_page->plot()->replot();
    const RodForce push = curves.forceAt(Load::compression, middle);
    QVERIFY(push.size > 0);
    const QPoint at(
        static_cast<int>(m_page->plot()->xAxis->coordToPixel(middle * blow->units.length.factor)),
        static_cast<int>(m_page->plot()->yAxis->coordToPixel(curves.stress(Load::compression, push))));
    QTest::mouseClick(m_page->plot(), Qt::LeftButton, {}, at);
    const double pixel =
        std::abs(m_page->plot()->xAxis->pixelToCoord(1) - m_page->plot()->xAxis->pixelToCoord(0));
    QVERIFY(std::abs(m_observation->section() - middle) * blow->units.length.factor <= pixel);
    QVERIFY(m_observation->time().has_value());
}

void TestRodPage::theDataOfAStringHaveTheWavesLeft() {
    const SolvedBlowPtr blow = solvedString();
    m_page->setResult(blow);
    const QList<QByteArray> rows = m_page->plot()->csv().trimmed().split('\n');
    QVERIFY(rows.first().startsWith(
        "position [m],compression [MPa],time [ms],position [m],tension [MPa],time [ms]"));
    QVERIFY(rows.first().endsWith("tension of residual waves [MPa],time [ms]"));
    QCOMPARE(std::size_t(rows.size()), blow->page<RodCurves>()->forces(Load::tension).size() + 1);
    for (const QByteArray& row : rows) QCOMPARE(row.count(','), 11);
    QVERIFY(rows.at(1).toDouble() < 0 || rows.at(1).startsWith('-'));  // the hammer
    QCOMPARE(m_page->plot()->legend->itemCount(), 4);
}

void TestRodPage::aStringWhoseWavesAreNotKeptSaysSo() {
    auto blow = std::make_shared<SolvedBlow>(*solvedString());
    blow->impact.waves.reset();
    blow->impact.incident = {};
    blow->pages = {PageData::of(rodCurves(*blow, blow->units))};
    m_page->setResult(blow);
    QVERIFY(m_page->plot()->accessibleDescription().contains(QStringLiteral("too many waves")));
    QVERIFY(!m_page->plot()->hasData());
    m_observation->setTime(1);
    m_observation->setSection(0.2);
    QVERIFY(!m_page->rodPlot()->forceAt({0.5, 0}));
    QVERIFY(blow->page<RodCurves>()->forces(Load::tension).empty());
}

void TestRodPage::runsAreLaidOverTheirOwnKind() {
    const SolvedBlowPtr rod = solved(), string = solvedString();
    m_page->setRuns(std::make_shared<const RunList>(RunList{pinnedRun(1, rod), pinnedRun(2, string)}));
    for (const SolvedBlowPtr& now : {solvedString(), solved(), solvedString()}) {
        m_page->setResult(now);
        const RodCurves& curves = *now->page<RodCurves>();
        QCOMPARE(curves.runs.size(), std::size_t{1});
        QCOMPARE(curves.runs.front().curves->string.has_value(), curves.string.has_value());
        QCOMPARE(m_page->rodPlot()->runs().size(), 1);
    }
}

void TestRodPage::rodsAndStringsTakeTurns() {
    m_page->setResult(solved());
    const int items = m_page->plot()->itemCount();
    m_page->setResult(solvedString());
    QVERIFY(m_page->plot()->itemCount() > items);
    m_page->setGhost(solved());
    m_page->setResult(solvedString({}, UnitSystem::dimensionless));
    QVERIFY(m_page->plot()->yAxis->label().contains(QStringLiteral("stress")));
    m_page->setGhost(nullptr);
    m_page->setResult(solved());
    QCOMPARE(m_page->plot()->itemCount(), items);
    QCOMPARE(m_page->plot()->legend->itemCount(), 4);
    QCOMPARE(visibleStrengths(), 2);
    QCOMPARE(m_page->plot()->xAxis->range().lower, 0.0);
}

QTEST_MAIN(TestRodPage)
#include "tst_rod_page.moc"
