// SPDX-License-Identifier: GPL-3.0-or-later
// One of many blows as it begins: its waves are those of the march before it, and lead on to the next
// (drilling §5).
#include <QTest>

#include <cmath>

#include "core/blow/blow_waves.h"
#include "core/contact/contact_law.h"
#include "core/model/drill_string.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/drilling/marched_blow.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Scenario exampleOf(const char* name) {
    const bool isString = std::string_view(name).ends_with("_string");
    Scenario scenario =
        isString ? test::losslessString(name) : parseScenario(findExample(name)->text, name).scenario;
    scenario.drill.blowFrequency = 60;
    scenario.drill.thrust = 3800;
    scenario.drill.waveLoss = 0.1;
    return scenario;
}

/// Scenario of a row of wavesLeadOnFromBlowToBlow_data().
Scenario fetchedScenario() {
    QFETCH(QString, name);
    QFETCH(double, thrust);
    QFETCH(double, damping);
    Scenario scenario = exampleOf(qPrintable(name));
    scenario.drill.thrust = thrust;
    scenario.drill.machineMass = 200;
    if (damping > 0) scenario.drill.damperDamping = damping;
    return scenario;
}

DrillingSettings settingsOf(long blows) {
    DrillingSettings settings;
    settings.blows = blows;
    settings.settle = 0;
    return settings;
}

DrillingResult marchOf(const Scenario& scenario, const DrillingSettings& settings) {
    DrillingRequest wants;
    wants.cellError = wants.lyapunov = wants.blowAlone = false;
    return studyDrilling(scenario, settings, wants);
}

}  // namespace

class TestMarchedBlow : public QObject {
    Q_OBJECT

  private slots:
    void theFirstBlowIsTheSingleOne();
    void wavesLeadOnFromBlowToBlow_data();
    void wavesLeadOnFromBlowToBlow();
    void itBeginsWhereTheMarchHasIt_data();
    void itBeginsWhereTheMarchHasIt();
    void aPistonComesAnew();
    void aCraterThatStaysIsRemembered();
    void itStops();
};

/// At rest, touching, pressed by no more than the blows take.
void TestMarchedBlow::theFirstBlowIsTheSingleOne() {
    Scenario scenario = exampleOf("t38_medium_rock");
    scenario.drill.waveLoss = 0;
    scenario.drill.machineMass.reset();
    scenario.drill.damperDamping.reset();
    scenario.drill.damperStiffness.reset();
    scenario.drill.inclination.reset();
    const Blow single = solveBlow(scenario, {}, Detail::histories);
    scenario.drill.thrust = 60 * single.scales.impulse;
    DrillingSettings settings = settingsOf(1);
    settings.cells = 200;
    const Blow first = marchedBlow(scenario, settings, 1);
    QVERIFY2(first.isSolved(), first.impact.reason.text().c_str());
    QCOMPARE(first.marched->number, 1L);
    const BlowWaves one(single), many(first);
    for (const double x : {0.0, 0.3, 1.0})
        for (double t = 0.05; t < 12; t += 0.37) {
            const double expected = one.value(WaveQuantity::force, x, t);
            const double got = many.value(WaveQuantity::force, x, t);
            QVERIFY2(std::abs(got - expected) < 3e-3,
                     qPrintable(QString("%1 %2: %3 %4").arg(x).arg(t).arg(got).arg(expected)));
            QVERIFY(std::abs(many.impactForce(t) - one.impactForce(t)) < 1e-3);
            QVERIFY(std::abs(many.state(x, t).momentum - one.state(x, t).momentum) < 1e-3);
        }
    QVERIFY(std::abs(first.summary.maxPenetration - single.summary.maxPenetration) < 1e-5);
    QVERIFY(std::abs(first.summary.energy.rockWork - single.summary.energy.rockWork) < 1e-4);
    QVERIFY(std::abs(first.drivenEnergy() - single.drivenEnergy()) < 1e-4);
}

void TestMarchedBlow::wavesLeadOnFromBlowToBlow_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("thrust");
    QTest::addColumn<double>("damping");
    QTest::newRow("rod, constant force") << "t38_medium_rock" << 3800. << 0.;
    QTest::newRow("rod with a damper") << "t38_medium_rock" << 5000. << 6300.;
    QTest::newRow("rod that rests") << "t38_medium_rock" << 9000. << 0.;
    QTest::newRow("string") << "t38_string" << 6000. << 0.;
    QTest::newRow("string with a damper") << "t38_string" << 8000. << 6300.;
}

/// The waves at the end of a blow that was followed to the next one are those that the next one begins with.
void TestMarchedBlow::wavesLeadOnFromBlowToBlow() {
    const Scenario scenario = fetchedScenario();
    const DrillingSettings settings = settingsOf(12);
    const DrillingResult march = marchOf(scenario, settings);
    const Blow ninth = marchedBlow(scenario, settings, 9), tenth = marchedBlow(scenario, settings, 10);
    QVERIFY(ninth.isSolved() && tenth.isSolved());
    const BlowWaves before(ninth), after(tenth);
    const double interval = (march.blows[9].time - march.blows[8].time);
    double largest = 0;
    // a hammer of a string is replaced by then: in the string, where all is known
    for (double x = 0.02; x < 1; x += 0.07)
        for (double t = -1.5; t < -1; t += 0.1) {
            const double known = before.value(WaveQuantity::force, x, interval + t);
            const double began = after.value(WaveQuantity::force, x, t);
            largest = std::max(largest, std::abs(known));
            QVERIFY2(std::abs(known - began) < 1e-9,
                     qPrintable(QString("%1 %2: %3 %4").arg(x).arg(t).arg(known).arg(began)));
        }
    QVERIFY(largest > 1e-4);  // there are waves
    const RodState begun = after.state(0.5, 0);
    const double mass = tenth.problem.mass();
    QVERIFY(std::abs(begun.momentum * tenth.impact.hammerImpulse - march.blows[9].velocity * mass) < 1e-12);
}

void TestMarchedBlow::itBeginsWhereTheMarchHasIt_data() {
    wavesLeadOnFromBlowToBlow_data();
}

/// Momentum by the waves along the rod, gap, the sums of the cycle.
void TestMarchedBlow::itBeginsWhereTheMarchHasIt() {
    const Scenario scenario = fetchedScenario();
    const DrillingSettings settings = settingsOf(12);
    const DrillingResult march = marchOf(scenario, settings);
    const Blow blow = marchedBlow(scenario, settings, 10);
    const DrillingBlow& taken = march.blows[9];
    const BlowWaves waves(blow);
    const std::vector<ContactInterval> contacts = waves.contacts();
    const BitState bit = waves.bit(contacts, 0);
    QCOMPARE(bit.touching, taken.gap == 0);
    QVERIFY(std::abs(bit.gap - taken.gap * lawUnitOfPenetration) < 1e-12);
    QCOMPARE(blow.impact.peakForce, taken.peakForce);
    QVERIFY(std::abs(blow.summary.residualPenetration - taken.penetration * lawUnitOfPenetration) < 1e-12);
    // ∫ v ζ dτ of the waves along the chain, in slices that follow joints
    double momentum = 0;
    const StringWaves& kept = *blow.impact.waves;
    for (std::size_t j = kept.hammerSections(); j < kept.sections(); ++j) {
        const SectionWaves& piece = kept.pieces()[j];
        constexpr int slices = 2000;
        for (int i = 0; i < slices; ++i)
            momentum +=
                kept.velocity(j, (i + 0.5) / slices, 0) * piece.impedance * piece.transitTime / slices;
    }
    const double expected = taken.velocity * blow.problem.mass();
    // waves that fade are drawn before they have
    QVERIFY2(std::abs(momentum - expected) < 0.02, qPrintable(QString("%1 %2").arg(momentum).arg(expected)));
}

void TestMarchedBlow::aPistonComesAnew() {
    const Scenario scenario = exampleOf("t38_string");
    const Blow blow = marchedBlow(scenario, settingsOf(5), 5);
    QVERIFY2(blow.isSolved(), blow.impact.reason.text().c_str());
    const BlowWaves waves(blow);
    const double v0 = blow.problem.hammer().velocity;
    for (const double share : {0.02, 0.4, 0.98}) {
        const double x = waves.rear() * share;
        QVERIFY(std::abs(waves.value(WaveQuantity::velocity, x, 0) - v0) < 1e-12);
        QVERIFY(std::abs(waves.value(WaveQuantity::force, x, 0)) < 1e-12);
    }
    QVERIFY(!waves.faceContacts().empty());
    QVERIFY(std::abs(waves.faceContacts().front().begin) < 1e-12);
    QVERIFY(blow.summary.energy.rockWork > 0.1 && blow.summary.energy.rockWork < 1);
}

/// There the path of the rock begins at the force that it remembers.
void TestMarchedBlow::aCraterThatStaysIsRemembered() {
    Scenario scenario = exampleOf("t38_medium_rock");
    scenario.drill.indexing = RockIndexing::same;
    const Blow fresh = marchedBlow(exampleOf("t38_medium_rock"), settingsOf(5), 5);
    const Blow same = marchedBlow(scenario, settingsOf(5), 5);
    QVERIFY(fresh.marched->rememberedForce < 0.5 * fresh.summary.peakForce);
    QVERIFY(same.marched->rememberedForce > 0.9 * same.summary.peakForce);
    QVERIFY(same.summary.maxPenetration >= fresh.summary.maxPenetration - 1e-9);
}

void TestMarchedBlow::itStops() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!marchedBlow(exampleOf("t38_medium_rock"), settingsOf(100'000), 100'000, stop.get_token())
                 .isSolved());
}

QTEST_GUILESS_MAIN(TestMarchedBlow)
#include "tests/support/lossless_string.h"
#include "tst_marched_blow.moc"
