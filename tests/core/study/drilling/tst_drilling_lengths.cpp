// SPDX-License-Identifier: GPL-3.0-or-later
// Strings of any length under many blows: no section is rounded, and losses are those of a single blow.
#include <QTest>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/blow/blow.h"
#include "core/contact/contact_law.h"
#include "core/study/drilling/drilling_mesh.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/drilling/sequence.h"
#include "core/study/scan/drilling_scan.h"
#include "core/text/units.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/lossless_string.h"
#include "tests/support/tries.h"

using namespace drillwave;
using test::tries;

namespace {

QJsonObject lengthCases() {
    QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/drill_lengths.json"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no cases");
    return QJsonDocument::fromJson(file.readAll()).object();
}

Scenario scenarioOf(std::string_view text) {
    return parseScenario(text, "string").scenario;
}

void assign(Scenario& scenario, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    const SweepAxis axis = parseAxis(setting).axis;
    QVERIFY2(equals != std::string::npos && axis.parameter, setting.c_str());
    QVERIFY(axis.assign(scenario, axis.value(0)).isEmpty());
}

/// The example `name` on a machine with dashpot and spring.
Scenario drilled(const char* name, std::initializer_list<const char*> settings) {
    Scenario scenario = scenarioOf(findExample(name)->text);
    for (const char* setting : {"drill.machine_mass=200kg", "drill.damper_damping=8kN s/m",
                                "drill.damper_stiffness=3MN/m", "drill.wave_loss=10%"})
        assign(scenario, setting);
    for (const char* setting : settings) assign(scenario, setting);
    return scenario;
}

/// A string of sections of whole millimetres; half of the hammers have a collar, some a cone.
enum class Cones { none, some };
std::string randomString(std::mt19937& random, Cones cones) {
    const auto whole = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    const auto section = [](int length, double diameter, double bore, double end = 0) {
        std::string text = "{length: " + std::to_string(length) + " mm, diameter: " + formatNumber(diameter) +
                           " mm, bore: " + formatNumber(bore) + " mm";
        if (end > 0) text += ", end_diameter: " + formatNumber(end) + " mm";
        return text + "}";
    };
    std::string hammer = section(whole(200, 350), whole(50, 60), 0);
    const int kind = whole(0, 3);
    if (kind < 2) hammer += ", " + section(whole(12, 29), whole(70, 80), 0);
    if (kind == 2 && cones == Cones::some) hammer += ", " + section(whole(40, 120), 58, 0, 46);
    hammer += ", " + section(whole(150, 300), whole(40, 50), 0);
    std::string chain = section(whole(390, 500), 45, 12);
    for (int i = whole(1, 2); i > 0; --i)
        chain += ", " + section(whole(150, 210), 56, 14.5) + ", " + section(whole(1800, 3700), 39, 14.5);
    chain += ", " + section(whole(50, 210), 56, 14.5) + ", " + section(whole(40, 75), whole(64, 76), 0);
    return "drillwave: 2\nhammer: {velocity: 10 m/s, restrike: " +
           std::string(whole(0, 1) ? "true" : "false") + ", sections: [" + hammer + "]}\nstring: [" + chain +
           "]\nbit_rock: {stiffness: " + std::to_string(whole(60, 400)) + " MN/m, gamma: 0.1}\n" +
           "drill: {blow_frequency: 20 Hz, thrust: 8 kN, blows: 1, settle: 0}\n";
}

/// The first blow where the feed does nothing: Fe = f m_h v0.
DrillingBlow firstBlow(const Scenario& scenario, int cells) {
    DrillingMesh mesh = drillingMeshOf(scenario, cells);
    DrillingMarch march(mesh.problem, mesh.grid);
    mesh.problem.feedForce = march.hammerMomentum() / mesh.grid.interval();
    if (!march.takeBlow({})) qFatal("%s", std::string(march.failureReason()).c_str());
    return march.blow();
}

}  // namespace

class TestDrillingLengths : public QObject {
    Q_OBJECT

  private slots:
    void noSectionIsRounded();
    void aSectionShorterThanTheCellsIsRefused();
    void theFirstBlowIsTheSingleBlow();
    void aConeIsThatOfTheSingleBlow();
    void theFirstBlowHasTheLossesOfTheSingleBlow();
    void blowsAgreeWithThePlainLattice_data();
    void blowsAgreeWithThePlainLattice();
    void meansOverALengthAreSmooth();
    void meansHoldWithinTheirErrors();
    void aFeedBelowTheReactionPushesTheMachineBack_data();
    void aFeedBelowTheReactionPushesTheMachineBack();
    void aFeedAtTheReactionIsMarchedForOneBlow();
};

/// In mass and transit time, at the cells of scans as at others.
void TestDrillingLengths::noSectionIsRounded() {
    std::mt19937 random(52);
    for (int i = 0; i < tries("DRILLWAVE_LENGTH_SCENES", 300, 20'000); ++i) {
        const Scenario scenario = scenarioOf(randomString(random, Cones::some));
        for (const int cells : {10, 20, 40}) {
            const DrillingMesh mesh = drillingMeshOf(scenario, cells);
            QVERIFY2(!mesh.grid.shortSection(), qPrintable(QString::number(cells)));
            QVERIFY(mesh.grid.cell * cells < 1 + 1e-9);
            for (std::size_t j = 0; j < mesh.problem.blow.sections.size(); ++j) {
                const double trip = 2 * mesh.problem.blow.sections[j].transitTime;
                QVERIFY(std::abs(mesh.grid.roundTrips[j] * mesh.grid.cell - trip) < 1e-5 * trip);
            }
            QVERIFY(std::abs(mesh.grid.rounding(mesh.problem)) < 1e-4);
        }
    }
}

void TestDrillingLengths::aSectionShorterThanTheCellsIsRefused() {
    Scenario scenario = drilled("t38_string", {"drill.blows=3", "drill.settle=0"});
    assign(scenario, "string.coupling.length=0.37mm");
    const DrillingResult result = studyDrilling(scenario, drillingSettingsOf(scenario), {.lyapunov = true});
    QCOMPARE(name(result.outcome), std::string_view("not_solved"));
    QVERIFY(result.blows.empty() && !result.statistics);
    QVERIFY(result.reason.text().find("shorter than a time step") != std::string::npos);
}

/// Where faces or bit part for less than a cell, the cells decide: one string in a hundred.
void TestDrillingLengths::theFirstBlowIsTheSingleBlow() {
    std::mt19937 random(7);
    const int count = tries("DRILLWAVE_LENGTH_SCENES", 24, 20'000);
    int off = 0, solved = 0;
    for (int i = 0; i < count; ++i) {
        const std::string text = randomString(random, Cones::none);
        const Scenario scenario = scenarioOf(text);
        const Blow alone = solveBlow(scenario, {}, Detail::ledger, std::stop_token());
        if (!alone.isSolved()) continue;
        ++solved;
        const double penetration = alone.summary.residualPenetration / lawUnitOfPenetration;
        for (const int cells : {20, 40}) {
            const double share = firstBlow(scenario, cells).penetration / penetration - 1;
            if (std::abs(share) < 5e-3) continue;
            ++off;
            qInfo("%d cells: %.3g %%: %s", cells, 100 * share, text.c_str());
        }
    }
    qInfo("%d solved, %d off by more than 0.5 %%", solved, off);
    QVERIFY(solved > count * 9 / 10);
    QVERIFY(off <= std::max(1, solved / 50));
}

/// In pieces, of which the single blow takes others.
void TestDrillingLengths::aConeIsThatOfTheSingleBlow() {
    const Scenario scenario = scenarioOf(
        "drillwave: 2\nhammer: {velocity: 10 m/s, restrike: false, sections: [{length: 300 mm, diameter: 55 "
        "mm}, "
        "{length: 100 mm, diameter: 58 mm, end_diameter: 46 mm}, {length: 200 mm, diameter: 45 mm}]}\n"
        "string: [{length: 450 mm, diameter: 45 mm, bore: 12 mm}, {length: 2400 mm, diameter: 39 mm, bore: "
        "14.5 "
        "mm}, {length: 100 mm, diameter: 56 mm, end_diameter: 70 mm}, {length: 60 mm, diameter: 70 mm}]\n"
        "bit_rock: {stiffness: 200 MN/m, gamma: 0.1}\n"
        "drill: {blow_frequency: 20 Hz, thrust: 8 kN, blows: 1, settle: 0}\n");
    const Blow alone = solveBlow(scenario, {}, Detail::ledger, std::stop_token());
    const double penetration = alone.summary.residualPenetration / lawUnitOfPenetration;
    for (const int cells : {20, 40})
        QVERIFY(std::abs(firstBlow(scenario, cells).penetration / penetration - 1) < 2e-3);
}

void TestDrillingLengths::theFirstBlowHasTheLossesOfTheSingleBlow() {
    for (const auto& [setting, tolerance] :
         {std::pair("string.coupling.loss=5%", 3e-3), std::pair("string.coupling.loss=10%", 1e-2),
          std::pair("string.rod.attenuation=0.02 1/m", 1e-2)}) {
        Scenario scenario = test::losslessString();
        assign(scenario, setting);
        assign(scenario, "drill.blow_frequency=10Hz");
        const Blow alone = solveBlow(scenario, {}, Detail::ledger, std::stop_token());
        const double penetration = alone.summary.residualPenetration / lawUnitOfPenetration;
        const double share = firstBlow(scenario, 40).penetration / penetration - 1;
        QVERIFY2(std::abs(share) < tolerance, qPrintable(QString::number(share)));
    }
}

void TestDrillingLengths::blowsAgreeWithThePlainLattice_data() {
    QTest::addColumn<QJsonObject>("given");
    const QJsonArray cases = lengthCases()["cases"].toArray();
    int number = 0;
    for (const QJsonValue& given : cases)
        if (test::isChosen(number++, 3))
            QTest::newRow(qPrintable(given["id"].toString())) << given.toObject();
}

void TestDrillingLengths::blowsAgreeWithThePlainLattice() {
    QFETCH(QJsonObject, given);
    const Scenario scenario = scenarioOf(given["scenario"].toString().toStdString());
    const QJsonArray penetrations = given["reference"].toObject()["penetration"].toArray();
    const double impulse = given["reference"].toObject()["face_impulse"].toArray()[0].toDouble();
    double mean = 0;
    for (const QJsonValue& value : penetrations)
        mean += value.toDouble() / static_cast<double>(penetrations.size());
    for (const int cells : {20, 40}) {
        DrillingSettings settings = drillingSettingsOf(scenario);
        settings.cells = cells;
        const DrillingResult result =
            studyDrilling(scenario, settings, {.lyapunov = false, .blowAlone = false});
        QVERIFY(result.statistics);
        const double length = result.units.length();
        const DrillingBlow& first = result.blows.front();
        QVERIFY(std::abs(first.penetration * length / penetrations[0].toDouble() - 1) < 5e-3);
        QVERIFY(std::abs(first.faceImpulse * result.units.impulse() / impulse - 1) <
                (cells < 40 ? 1e-2 : 5e-3));
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        QVERIFY(std::abs(result.spread(penetration).mean * length - mean) <
                *result.meanError(penetration) * length + 1e-3 * mean);
    }
}

void TestDrillingLengths::meansOverALengthAreSmooth() {
    const QJsonObject given = lengthCases()["scan"].toObject();
    Scenario base = test::losslessString();
    for (const QJsonValue& setting : given["set"].toArray()) assign(base, setting.toString().toStdString());
    const QJsonArray points = given["points"].toArray();
    for (int i = 0; i < points.size(); ++i) {
        if (!test::isChosen(i, 3)) continue;
        Scenario scenario = base;
        assign(scenario, "string.coupling.length=" +
                             formatNumber(points[i].toObject()["coupling_mm"].toDouble()) + "mm");
        DrillingSettings settings = drillingSettingsOf(scenario);
        settings.cells = scanCells;
        const DrillingResult result =
            studyDrilling(scenario, settings, {.lyapunov = false, .blowAlone = false});
        const double mean =
            result.spread(quantityPlace(&DrillingBlow::penetration)).mean * result.units.length();
        QVERIFY(std::abs(1e3 * mean / points[i].toObject()["penetration_mm"].toDouble() - 1) < 5e-4);
        QVERIFY(std::abs(result.meanImpulse * result.units.impulse() /
                             points[i].toObject()["face_impulse"].toDouble() -
                         1) < 1e-3);
    }
}

/// Compares 50 blows with those on four times as many cells.
void TestDrillingLengths::meansHoldWithinTheirErrors() {
    std::mt19937 random(1);
    const int count = tries("DRILLWAVE_LENGTH_MEANS", 3, 100);
    int held = 0;
    for (int i = 0; i < count; ++i) {
        Scenario scenario = scenarioOf(randomString(random, Cones::some));
        for (const char* setting :
             {"drill.machine_mass=200kg", "drill.damper_damping=8kN s/m", "drill.damper_stiffness=3MN/m",
              "drill.wave_loss=10%", "drill.blow_frequency=50Hz", "drill.blows=50"})
            assign(scenario, setting);
        const DrillingMesh mesh = drillingMeshOf(scenario, 40);
        const double momentum = DrillingMarch(mesh.problem, mesh.grid).hammerMomentum();
        scenario.drill.thrust = 1.8 * momentum * drillingUnitsOf(scenario).impulse() * 50;
        DrillingSettings settings = drillingSettingsOf(scenario);
        const DrillingResult own = studyDrilling(scenario, settings, {.lyapunov = false, .blowAlone = false});
        settings.cells = 160;
        const DrillingResult fine =
            studyDrilling(scenario, settings, {.cellError = false, .lyapunov = false, .blowAlone = false});
        if (!own.statistics || !fine.statistics) continue;
        const std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
        const double off = std::abs(own.spread(penetration).mean - fine.spread(penetration).mean);
        held += off <= *own.meanError(penetration);
        if (off > *own.meanError(penetration))
            qInfo("%d off by %.3g of %.3g", i, off, *own.meanError(penetration));
    }
    qInfo("%d of %d hold", held, count);
    QVERIFY(held >= count * 97 / 100);
}

void TestDrillingLengths::aFeedBelowTheReactionPushesTheMachineBack_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QString>("thrust");
    QTest::newRow("t51") << "t51_string"
                         << "drill.thrust=5kN";
    QTest::newRow("t38, far") << "t38_string"
                              << "drill.thrust=2kN";
    QTest::newRow("t38, near") << "t38_string"
                               << "drill.thrust=4.4kN";
    QTest::newRow("r32") << "r32_string"
                         << "drill.thrust=1kN";
}

void TestDrillingLengths::aFeedBelowTheReactionPushesTheMachineBack() {
    QFETCH(QString, example);
    QFETCH(QString, thrust);
    for (const char* blows : {"drill.blows=40", "drill.blows=120"}) {
        const Scenario scenario =
            drilled(qPrintable(example), {thrust.toStdString().c_str(), blows, "drill.settle=2"});
        const DrillingResult result = studyDrilling(scenario, drillingSettingsOf(scenario));
        QCOMPARE(name(result.outcome), std::string_view("pushed_back"));
        QVERIFY(!result.statistics && !result.lyapunov && !sequenceOf(result));
        QVERIFY(result.groups.phi < 1);
        QVERIFY(std::ranges::none_of(result.alerts,
                                     [](const Alert& alert) { return alert.code == AlertCode::shankOff; }));
    }
}

/// Whatever the last digit of the feed, and of the frequency that is rounded to cells.
void TestDrillingLengths::aFeedAtTheReactionIsMarchedForOneBlow() {
    for (const char* example : {"t38_medium_rock", "t38_string"}) {
        for (const double frequency : {60.0, 43.21}) {
            Scenario scenario = scenarioOf(findExample(example)->text);
            scenario.drill.blowFrequency = frequency;
            scenario.drill.blows = 1;
            scenario.drill.settle = 0;
            scenario.drill.thrust = 1;
            const DrillingMesh mesh = drillingMeshOf(scenario, 40);
            const double momentum =
                DrillingMarch(mesh.problem, mesh.grid).hammerMomentum() * drillingUnitsOf(scenario).impulse();
            for (const double share : {1 - 1e-12, 1.0, 1 + 1e-12}) {
                scenario.drill.thrust = momentum * frequency * share;
                const DrillingResult result = studyDrilling(scenario, drillingSettingsOf(scenario));
                QVERIFY2(result.outcome == DrillingOutcome::done, example);
            }
        }
    }
}

QTEST_GUILESS_MAIN(TestDrillingLengths)
#include "tst_drilling_lengths.moc"
