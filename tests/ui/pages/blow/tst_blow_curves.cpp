// SPDX-License-Identifier: GPL-3.0-or-later
// The curves of a blow: their numbers, their jumps, their ends.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "ui/pages/blow/blow_curves.h"
#include "ui/pages/blow/blow_plots.h"
#include "ui/pages/rock/rock_plot.h"

using namespace drillwave;

namespace {

Blow solved(Groups groups, PulseShape shape = PulseShape::rectangular) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = groups;
    scenario.pulse.shape = shape;
    return solveBlow(scenario, {}, Detail::histories);
}

BlowCurves curvesOf(const Blow& blow, double section = 0.5) {
    return blowCurves(blow, shownUnits(UnitSystem::dimensionless, {}), section);
}

double largest(const GraphData& data) {
    double value = 0;
    for (auto point = data->constBegin(); point != data->constEnd(); ++point)
        value = std::max(value, point->value);
    return value;
}

double last(const GraphData& data) {
    return (data->constEnd() - 1)->value;
}

double valueAt(const GraphData& data, double time) {
    const auto after = data->findBegin(time, false);
    const auto before = after == data->constBegin() ? after : after - 1;
    if (after == data->constEnd() || after->key == before->key) return before->value;
    return before->value + (after->value - before->value) * (time - before->key) / (after->key - before->key);
}

}  // namespace

class TestBlowCurves : public QObject {
    Q_OBJECT

  private slots:
    void curvesEndAtTheNumbersOfTheBlow_data();
    void curvesEndAtTheNumbersOfTheBlow();
    void momentumRisesWithTheHammer();
    void theFirstWaveIsThePulsePassingBy();
    void aWaveEndsBeforeTheJumpOfTheNext();
    void theForceAtTheSectionIsTheSumOfAllWaves();
    void curvesScaleWithTheirUnits();
    void thePlaceIsCalledAsInTheTableOfSections();
    void everyPointIsFinite();
    void aCutTailEndsOnTheCurve();
    void theRockCurveEnclosesTheRockWork();
};

void TestBlowCurves::curvesEndAtTheNumbersOfTheBlow_data() {
    QTest::addColumn<double>("gamma");
    QTest::addColumn<PulseShape>("shape");
    QTest::newRow("paper Fig. 4 (a)") << 1.0 << PulseShape::rectangular;
    QTest::newRow("paper Fig. 4 (b)") << 0.1 << PulseShape::rectangular;
    QTest::newRow("half sine") << 0.3 << PulseShape::halfSine;
    QTest::newRow("exponential") << 0.3 << PulseShape::exponential;
    QTest::newRow("reference case") << 0.3 << PulseShape::rigidBody;
}

void TestBlowCurves::curvesEndAtTheNumbersOfTheBlow() {
    QFETCH(double, gamma);
    QFETCH(PulseShape, shape);
    const Blow blow = solved({0.5, gamma, 10, 0}, shape);
    const BlowCurves curves = curvesOf(blow);
    // The peak lies between samples that follow the curve to 1e-4; impulse and momentum end exactly.
    QVERIFY(std::abs(largest(curves.force) / blow.impact.peakForce - 1) < 1e-3);
    QVERIFY(std::abs(last(curves.impulse) - (1 + blow.impact.cor)) < 1e-12);
    QVERIFY(std::abs(last(curves.momentum) + blow.impact.cor) < 1e-12);
}

void TestBlowCurves::momentumRisesWithTheHammer() {
    const BlowCurves curves = curvesOf(solved({0.5, 1, 10, 0}));
    for (const double t : {0.0, 0.25, 0.5, 1.0}) QVERIFY(std::abs(valueAt(curves.momentum, t) - t) < 1e-12);
    QVERIFY(std::abs(valueAt(curves.momentum, 9.5) - 1) < 1e-12);  // nothing has reached the bit yet
}

void TestBlowCurves::theFirstWaveIsThePulsePassingBy() {
    const double section = 0.3;
    const BlowCurves curves = curvesOf(solved({0.5, 1, 10, 0}), section);
    QVERIFY(std::abs(curves.waves[0]->constBegin()->key - section * 10) < 1e-12);
    QVERIFY(std::abs(valueAt(curves.waves[0], 3.5) + 1) < 1e-12);  // compressive: negative
    QVERIFY(std::abs(valueAt(curves.waves[0], 5)) < 1e-12);
}

void TestBlowCurves::aWaveEndsBeforeTheJumpOfTheNext() {
    // N2p begins with a jump to −1 just where N0p, by then zero, ends.
    const BlowCurves curves = curvesOf(solved({0.5, 1, 10, 0}));
    QCOMPARE(last(curves.waves[0]), 0.0);
}

void TestBlowCurves::theForceAtTheSectionIsTheSumOfAllWaves() {
    // Short against the blow: twenty waves are there, which overlap.
    const BlowCurves curves = curvesOf(solved({0.5, 0.2, 0.4, 0}, PulseShape::halfSine), 0.3);
    int summed = 0;
    for (double t = 0.0137; t < curves.timeEnd; t += 0.0071) {
        double sum = 0;
        const auto add = [&](const GraphData& wave) {
            if (wave->isEmpty() || t < wave->constBegin()->key || t > (wave->constEnd() - 1)->key) return;
            sum += valueAt(wave, t);
        };
        for (const GraphData& wave : curves.waves) add(wave);
        for (const GraphData& wave : curves.laterWaves) add(wave);
        QVERIFY(std::abs(valueAt(curves.sectionForce, t) - sum) < 1e-3);
        ++summed;
    }
    QVERIFY(summed > 100);
    for (const GraphData& wave : curves.laterWaves) {
        QVERIFY(!wave->isEmpty());
        QVERIFY(last(wave) != 0 && (wave->constEnd() - 1)->key <= curves.timeEnd * (1 + 1e-12));
    }
}

void TestBlowCurves::curvesScaleWithTheirUnits() {
    Scenario scenario;  // the default rod, in SI
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    const BlowCurves curves = blowCurves(blow, shownUnits(UnitSystem::si, blow.scales), 0.5);
    QCOMPARE(curves.units.force.unit, QStringLiteral("kN"));
    QCOMPARE(curves.units.time.unit, QStringLiteral("ms"));
    QVERIFY(std::abs(largest(curves.force) / (blow.impact.peakForce * blow.scales.force / 1000) - 1) < 1e-3);
    QVERIFY(std::abs(last(curves.impulse) / ((1 + blow.impact.cor) * scenario.pulse.impulse) - 1) < 1e-12);
}

// By the number along the chain, "section 4 (rod)", nobody found the rod in the table of the page String.
void TestBlowCurves::thePlaceIsCalledAsInTheTableOfSections() {
    const Scenario scenario = parseScenario(findExample("t38_string")->text, "").scenario;
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    const ShownUnits units = shownUnits(UnitSystem::si, blow.scales);
    const QString near = BlowPlots::placeText(blowCurves(blow, units, 0.5), QLocale::c());
    QVERIFY2(near.startsWith(QStringLiteral("2nd rod, ")) && near.endsWith(QStringLiteral("from its rear")),
             qPrintable(near));
    const QString bit = BlowPlots::placeText(blowCurves(blow, units, 0.999), QLocale::c());
    QVERIFY2(bit.startsWith(QStringLiteral("bit head, ")), qPrintable(bit));
}

void TestBlowCurves::everyPointIsFinite() {
    const BlowCurves curves = curvesOf(solved({1e9, 1e-6, 10, 0.3}));
    for (const GraphData& data : {curves.waves[0], curves.waves[3], curves.laterWaves[0], curves.sectionForce,
                                  curves.force, curves.impulse, curves.momentum})
        for (auto point = data->constBegin(); point != data->constEnd(); ++point)
            QVERIFY(std::isfinite(point->key) && std::isfinite(point->value));
}

void TestBlowCurves::aCutTailEndsOnTheCurve() {
    const Blow blow = solved({0.5, 0.3, 0.4, 0}, PulseShape::exponential);
    const ShownUnits units = shownUnits(UnitSystem::dimensionless, {});
    const BlowCurves kept = blowCurves(blow, units, 0.5);
    const BlowCurves cut = blowCurves(blow, units, 0.5, Tail::cut);
    QVERIFY((kept.momentum->constEnd() - 1)->key > kept.timeEnd);
    QCOMPARE((cut.momentum->constEnd() - 1)->key, cut.timeEnd);
    QVERIFY(std::abs(last(cut.momentum) - valueAt(kept.momentum, cut.timeEnd)) < 1e-12);
}

void TestBlowCurves::theRockCurveEnclosesTheRockWork() {
    const Groups groups{0.5, 0.1, 10, 0};
    const Blow blow = solved(groups);
    const RockCurve curve = rockCurve(blow, shownUnits(UnitSystem::dimensionless, {}));
    double area = 0;  // ∫F dU by the trapezium rule, exact on straight lines
    for (auto point = curve.path->constBegin() + 1; point != curve.path->constEnd(); ++point)
        area += (point->value + (point - 1)->value) / 2 * (point->key - (point - 1)->key);
    // Penetration is in d0, twice the displacement unit of `rockWork`; 1e-3 because the peak lies between
    // samples.
    QVERIFY(std::abs(2 * area / blow.impact.rockWork - 1) < 1e-3);
}

QTEST_MAIN(TestBlowCurves)
#include "tst_blow_curves.moc"
