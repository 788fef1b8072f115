// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of force against penetration: its area, its marks, its work.
#include <QTest>
#include <cmath>

#include "core/model/form_conversion.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/scales.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "ui/pages/rock/rock_plot.h"
#include "ui/plot/plot_widget.h"

using namespace drillwave;

namespace {

struct Solved {
    Impact impact;
    RockCurve curve;
};

Solved solved(const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = groups;
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    return {blow.impact, rockCurve(blow, shownUnits(UnitSystem::dimensionless, {}))};
}

RockCurve curveOf(const Scenario& scenario) {
    MethodSolver solver(WorkLimits{.pieces = mostWorkLimit});
    return rockCurve(solveBlow(scenario, {}, Detail::histories, {}, Stresses::asNeeded, solver),
                     shownUnits(UnitSystem::si, scalesOf(scenario)));
}

// ∫F dU by the trapezium rule, exact on straight lines.
double enclosedArea(const QCPCurveDataContainer& path) {
    double area = 0;
    for (auto point = path.constBegin() + 1; point != path.constEnd(); ++point)
        area += (point->value + (point - 1)->value) / 2 * (point->key - (point - 1)->key);
    return area;
}

}  // namespace

class TestRockPlot : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void theEnergyIsTheEnclosedArea();
    void theEnergyIsThatOfTheUnitsShown();
    void theEnergyOfAStringUnderAForceIsAShareOfItsWork();
    void theMarksAreTheNumbersOfTheBlow();
    void manyReflectionsAreDrawnWithBoundedWork();
    void aPointOfThePathBelongsToItsTime();
    void anElasticRockKeepsNothing();
    void numbersAreNamedInThePlot();
    void cornersAreMarkedAndLinesNamed();
    void theNumbersOfThePeakAreInViewInALowPlot_data();
    void theNumbersOfThePeakAreInViewInALowPlot();
    void aZoomedViewStaysWhileTheResultChanges();
    void ghostAndPathAreBothInView();
    void withoutAPathTheReasonIsShown();

  private:
    QStringList labels() const;

    std::unique_ptr<PlotWidget> m_widget;
    RockPlot* m_plot = nullptr;
};

void TestRockPlot::init() {
    QLocale::setDefault(QLocale::c());
    m_widget = std::make_unique<PlotWidget>();
    m_widget->resize(500, 400);
    m_plot = new RockPlot(m_widget.get());
    m_widget->followPalette([this](const PlotStyle& style) { m_plot->setStyle(style); });
}

QStringList TestRockPlot::labels() const {
    QStringList texts;
    for (int i = 0; i < m_widget->itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(m_widget->item(i)); text && text->visible())
            texts.append(text->text());
    return texts;
}

void TestRockPlot::theEnergyIsTheEnclosedArea() {
    for (const double gamma : {0.9, 0.3, 0.01}) {
        const Solved blow = solved({0.5, gamma, 10, 0.3});
        // F0·d0 = 2 I0²/(Z t0) = 4τ W0; 1e-3 because a peak may lie between samples.
        QVERIFY(std::abs(4 * 10 * enclosedArea(*blow.curve.path) / blow.curve.energy - 1) < 1e-3);
        QVERIFY(std::abs(blow.curve.energyShare - blow.impact.rockWork / blow.impact.hammerWork) < 1e-15);
    }
}

void TestRockPlot::theEnergyIsThatOfTheUnitsShown() {
    const Scenario scenario;  // the default rod, in SI
    const RockCurve curve = curveOf(scenario);
    QCOMPARE(curve.units.force.unit, QStringLiteral("kN"));
    QCOMPARE(curve.units.penetration.unit, QStringLiteral("mm"));
    QCOMPARE(curve.units.energy.unit, QStringLiteral("J"));  // = kN mm
    QVERIFY(std::abs(enclosedArea(*curve.path) / curve.energy - 1) < 1e-3);
    QVERIFY(std::abs(curve.loading / (scenario.bitRock.stiffness / 1e6) - 1) < 1e-12);
    QVERIFY(std::abs(curve.unloading * scenario.bitRock.gamma / curve.loading - 1) < 1e-12);
    // A triangle of two slopes: Fm = k Um, and Fm = (k/γ)(Um − Ur).
    QVERIFY(std::abs(curve.peakForce / (curve.loading * curve.maxPenetration) - 1) < 1e-12);
    QVERIFY(
        std::abs(curve.peakForce / (curve.unloading * (curve.maxPenetration - curve.residualPenetration)) -
                 1) < 1e-12);
}

// A force does another work on a string than I0²/(2 m), which its share was once taken of.
void TestRockPlot::theEnergyOfAStringUnderAForceIsAShareOfItsWork() {
    Scenario rod;  // the default one, in SI
    rod.pulse.shape = PulseShape::halfSine;
    const Blow blow = solveBlow(stringOf(rod).scenario, {}, Detail::histories);
    QVERIFY(blow.isSolved());
    const RockCurve curve = rockCurve(blow, shownUnits(UnitSystem::si, blow.scales));
    QVERIFY(std::abs(blow.summary.workRatio - 1) > 0.1);
    // 1e-3 because a peak may lie between samples
    QVERIFY(std::abs(enclosedArea(*curve.path) / curve.energy - 1) < 1e-3);
}

void TestRockPlot::theMarksAreTheNumbersOfTheBlow() {
    const RockCurve curve = solved({0.5, 0.1, 10, 0}).curve;
    double force = 0, penetration = 0;
    for (auto point = curve.path->constBegin(); point != curve.path->constEnd(); ++point) {
        force = std::max(force, point->value);
        penetration = std::max(penetration, point->key);
    }
    // The turn to unloading is an event, so it is a sample.
    QVERIFY(std::abs(force / curve.peakForce - 1) < 1e-9);
    QVERIFY(std::abs(penetration / curve.maxPenetration - 1) < 1e-9);
    QVERIFY(std::abs((curve.path->constEnd() - 1)->key / curve.residualPenetration - 1) < 1e-9);
}

// Filling between hundreds of thousands of lines on top of each other held the window up for minutes.
void TestRockPlot::manyReflectionsAreDrawnWithBoundedWork() {
    Scenario scenario = parseScenario(findExample("t51_soft_rock")->text, "").scenario;
    QCOMPARE(assignText(scenario, "rod.area", "10 mm^2"), Message());
    const RockCurve curve = curveOf(scenario);
    QVERIFY2(curve.path->size() > 20000, qPrintable(QString::number(curve.path->size())));
    QVERIFY2(curve.outline->size() <= 20000, qPrintable(QString::number(curve.outline->size())));
    double force = 0;
    for (auto point = curve.outline->constBegin(); point != curve.outline->constEnd(); ++point)
        force = std::max(force, point->value);
    QVERIFY(std::abs(force / curve.peakForce - 1) < 1e-9);
    QCOMPARE((curve.outline->constEnd() - 1)->key, (curve.path->constEnd() - 1)->key);
}

void TestRockPlot::aPointOfThePathBelongsToItsTime() {
    const RockCurve curve = solved({0.5, 1, 10, 0}).curve;
    QCOMPARE(rockPoint(curve, -5), QPointF(0, 0));
    QCOMPARE(rockPoint(curve, 10), QPointF(0, 0));
    // [paper (11)]: F = 2(1 − e^(−βs)); U/d0 = F/(2β).
    const QPointF point = rockPoint(curve, 10.6);
    const double force = 2 * (1 - std::exp(-0.5 * 0.6));
    QVERIFY(std::abs(point.y() - force) < 1e-4);
    QVERIFY(std::abs(point.x() - force) < 1e-4);
    const QPointF after = rockPoint(curve, 1e9);
    QVERIFY(std::abs(after.y()) < 1e-12);
}

void TestRockPlot::anElasticRockKeepsNothing() {
    m_plot->present(solved({0.5, 1, 10, 0}).curve);
    QVERIFY(m_plot->textSummary().contains(QStringLiteral("no energy left in the rock")));
    QCOMPARE(labels().size(), 2);  // neither an unloading line of its own nor a residual penetration
}

void TestRockPlot::numbersAreNamedInThePlot() {
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    const QString all = labels().join(QLatin1Char('|'));
    for (const char* text : {"Fₘ = ", "Uₘ = ", "Uᵣ = ", "k = 0.5", "k/γ = 5", "d₀", "F₀"})
        QVERIFY2(all.contains(QString::fromUtf8(text)), qPrintable(all));
    QVERIFY(m_plot->textSummary().contains(QStringLiteral("% of the blow")));
    QVERIFY(m_widget->xAxis->label().contains(QStringLiteral("penetration U / d₀")));
}

void TestRockPlot::cornersAreMarkedAndLinesNamed() {
    const Scenario scenario = parseScenario(findExample("rock_that_yields")->text, "").scenario;
    const RockCurve curve = curveOf(scenario);
    QCOMPARE(curve.lines.size(), 2);
    QVERIFY(std::abs(curve.lines[0].to.y() / 90 - 1) < 1e-12);    // kN
    QVERIFY(std::abs(curve.lines[0].to.x() / 0.36 - 1) < 1e-12);  // mm: 90 kN at 250 MN/m
    QVERIFY(std::abs(curve.lines[1].to.y() / curve.peakForce - 1) < 1e-12);
    QVERIFY(std::abs(curve.lines[1].to.x() / curve.maxPenetration - 1) < 1e-12);
    m_plot->present(curve);
    QVERIFY2(labels().contains(QStringLiteral("0.35\u00a0k")), qPrintable(labels().join(QLatin1Char('|'))));
    QVERIFY(m_plot->textSummary().contains(QStringLiteral("corners")));
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    QVERIFY(!m_plot->textSummary().contains(QStringLiteral("corners")));
}

void TestRockPlot::theNumbersOfThePeakAreInViewInALowPlot_data() {
    QTest::addColumn<int>("height");
    QTest::addRow("high") << 600;
    QTest::addRow("low, as in a report") << 280;
}

void TestRockPlot::theNumbersOfThePeakAreInViewInALowPlot() {
    QFETCH(int, height);
    m_widget->resize(500, height);
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    m_widget->toPixmap(500, height);
    const QCPItemText* peak = nullptr;
    for (int i = 0; i < m_widget->itemCount(); ++i)
        if (auto* text = qobject_cast<QCPItemText*>(m_widget->item(i));
            text && text->text().startsWith(QStringLiteral("Fₘ = ")))
            peak = text;
    QVERIFY(peak);
    QVERIFY(peak->text().contains(QStringLiteral("Uₘ = ")));
    QVERIFY(peak->topLeft->pixelPosition().y() >= m_widget->axisRect()->top());
    QVERIFY(peak->left->pixelPosition().x() >= m_widget->axisRect()->left());
}

void TestRockPlot::aZoomedViewStaysWhileTheResultChanges() {
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    const double before = m_widget->yAxis->range().upper;
    m_plot->present(solved({5, 0.1, 10, 0}).curve);
    QVERIFY(m_widget->yAxis->range().upper > 1.2 * before);  // fitted, it follows
    m_widget->xAxis->setRange(0.1, 0.2);
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    QCOMPARE(m_widget->xAxis->range(), QCPRange(0.1, 0.2));
    m_plot->fit();
    QVERIFY(std::abs(m_widget->yAxis->range().upper - before) < 1e-12);
}

void TestRockPlot::ghostAndPathAreBothInView() {
    const RockCurve before = solved({5, 0.1, 10, 0}).curve;
    m_plot->present(before);
    m_plot->setGhost(&before);
    QCOMPARE(m_widget->legend->itemCount(), 1);
    QCOMPARE(m_widget->plottableCount(), 2);
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    QVERIFY(m_widget->yAxis->range().upper > before.peakForce);
    m_plot->setGhost(nullptr);
    QCOMPARE(m_widget->plottableCount(), 1);
    QVERIFY(m_widget->yAxis->range().upper < before.peakForce);
}

void TestRockPlot::withoutAPathTheReasonIsShown() {
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    m_plot->showNothing(QStringLiteral("no rock"));
    QCOMPARE(m_plot->textSummary(), QStringLiteral("no rock"));
    QCOMPARE(labels(), QStringList{QStringLiteral("no rock")});
    m_plot->present(solved({0.5, 0.1, 10, 0}).curve);
    QVERIFY(!labels().contains(QStringLiteral("no rock")));
}

QTEST_MAIN(TestRockPlot)
#include "tst_rock_plot.moc"
