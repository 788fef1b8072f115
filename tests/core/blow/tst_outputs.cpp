// SPDX-License-Identifier: GPL-3.0-or-later
// The table of outputs: every number is that of its solution, in every unit, for no more work than it takes.
#include <QTest>

#include <cmath>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
#include "core/blow/outputs.h"
#include "core/model/drill_string.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

std::optional<double> valueOf(const Blow& blow, std::string_view name) {
    const Output* output = findOutput(name);
    if (!output) qFatal("no such output");
    return output->value({blow.summary, blow.scenario});
}

double siOf(const Blow& blow, std::string_view name) {
    return *valueOf(blow, name) * findOutput(name)->scale(blow.scales);
}

Scenario drillOf(double frequency) {
    Scenario scenario;
    scenario.drill.blowFrequency = frequency;
    return scenario;
}

Scenario groupsCase(const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.groups = groups;
    return scenario;
}

}  // namespace

class TestOutputs : public QObject {
    Q_OBJECT

  private slots:
    void everyOutputIsFoundByItsName();
    void everyOutputHasANumberWhereTheScenarioHasIt();
    void anOutputNeedsNoMoreThanItsDetail();
    void siValuesDoNotDependOnTheUnitsOfTheScenario();
    void velocityAndMomentumOfAStringAreInUnitsOfSi();
    void stressIsTheForceInTheRodOverItsArea();
    void thrustIsFrequencyTimesTheImpulseThatComesBack();
    void powerAndRateAreThoseOfOneBlowTimesTheFrequency();
    void theMarginNeedsAnInstalledThrust();
    void manyBlowsNeedAFrequencyAndAThrust();
    void theWindowListsWhatHasAGroup();
    void anOutputIsOfTheBlowsThatItsRowSays_data();
    void anOutputIsOfTheBlowsThatItsRowSays();
    void reportsCallEveryOutputByAName();
    void whatIsToldInJoulesIsAShare();
};

void TestOutputs::everyOutputIsFoundByItsName() {
    QCOMPARE(outputs().size(), std::size_t{39});
    for (const Output& output : outputs()) QCOMPARE(findOutput(output.name), &output);
    QCOMPARE(findOutput("peak"), nullptr);
    // of many blows: behind those of one, for drill_gap_mean is no number of a blow
    QCOMPARE(drillOutputs().size(), std::size_t{19});
    for (const Output& output : drillOutputs()) {
        QCOMPARE(findOutput(output.name), &output);
        QVERIFY(output.needsDrilling() && !output.title.empty());
    }
    for (const Output& output : outputs()) QVERIFY(!output.needsDrilling());
}

void TestOutputs::everyOutputHasANumberWhereTheScenarioHasIt() {
    Scenario complete = drillOf(50);
    complete.drill.thrust = 5000;
    const Blow drill = solveBlow(complete, {}, Detail::histories);
    int told = 0;
    for (const Output& output : outputs()) {
        const std::optional<double> value = output.value({drill.summary, drill.scenario, 0.1});
        if (!output.problem(drill.scenario).isEmpty()) {  // of drill strings
            QVERIFY(!value);
            continue;
        }
        ++told;
        QVERIFY2(value && std::isfinite(*value), std::string(output.name).c_str());
    }
    QCOMPARE(told, 26);
    const Blow groups = solveBlow(groupsCase({0.5, 0.1, 10, 0.2}), {}, Detail::ledger);
    for (const Output& output : outputs()) {
        const bool isThere = output.problem(groups.scenario).isEmpty() && output.detail != Detail::histories;
        QCOMPARE(output.value({groups.summary, groups.scenario}).has_value(), isThere);
    }
}

// Solved with its own detail an output is what it is with all: within the accuracy of the solver, whose
// levels of detail may take different ways.
void TestOutputs::anOutputNeedsNoMoreThanItsDetail() {
    const Scenario scenario = drillOf(50);
    const Blow full = solveBlow(scenario, {}, Detail::histories);
    for (const Output& output : outputs()) {
        if (output.measure == Measure::error || output.needsThrustStudy()) continue;  // rounding; no blow
        if (!output.problem(scenario).isEmpty()) continue;  // of drill strings; without a thrust
        const Blow own = solveBlow(scenario, {}, output.detail);
        const double value = *output.value({own.summary, scenario});
        const double expected = *output.value({full.summary, scenario});
        QVERIFY2(std::abs(value - expected) <= 1e-12 * std::max(1.0, std::abs(expected)),
                 std::string(output.name).c_str());
    }
}

void TestOutputs::siValuesDoNotDependOnTheUnitsOfTheScenario() {
    // The same rod and blow, given by its area and by the mean force.
    Scenario a;
    Scenario b = a;
    b.rod.area = propertiesOf(a.rod).area;
    b.pulse.impulseFromForce = true;
    const Blow x = solveBlow(a, {}, Detail::histories);
    const Blow y = solveBlow(b, {}, Detail::histories);
    for (const Output& output : outputs()) {
        if (output.measure == Measure::error || !output.problem(a).isEmpty()) continue;  // rounding noise
        const double first = siOf(x, output.name), second = siOf(y, output.name);
        QVERIFY2(std::abs(first - second) <= 1e-12 * std::abs(second), std::string(output.name).c_str());
    }
}

// Times a mass of its own, a number in SI is the other kind of number: the hammer's velocity over that of
// impact is no velocity.
void TestOutputs::velocityAndMomentumOfAStringAreInUnitsOfSi() {
    const Scenario scenario = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
    const Blow blow = solveBlow(scenario, {}, Detail::ledger);
    QVERIFY(blow.isSolved());
    const double mass = hammerProperties(scenario.drillString).mass;
    const double velocity = scenario.drillString.hammer.velocity;
    QCOMPARE(findOutput("hammer_rebound_velocity")->quantity(), Quantity::velocity);
    QCOMPARE(findOutput("string_momentum")->quantity(), Quantity::impulse);
    const double rebound = siOf(blow, "hammer_rebound_velocity");
    QCOMPARE(rebound, *valueOf(blow, "hammer_rebound_velocity") * velocity);
    // The energy of the hammer moving back as a whole is that of its mass at this velocity.
    const double energy = *valueOf(blow, "hammer_rebound_energy") * mass * velocity * velocity / 2;
    QVERIFY(std::abs(mass * rebound * rebound / 2 - energy) <= 1e-12 * energy);
    QCOMPARE(siOf(blow, "string_momentum"), *valueOf(blow, "string_momentum") * mass * velocity);
}

void TestOutputs::stressIsTheForceInTheRodOverItsArea() {
    const Scenario scenario;
    const Blow blow = solveBlow(scenario, {}, Detail::histories);
    const Problem problem = problemOf(scenario);
    const RodForces forces =
        largestRodForces(ExactSolver().solve(problem, Detail::histories), problem.force());
    QCOMPARE(*valueOf(blow, "peak_compression"), forces.compression.size);
    QCOMPARE(*valueOf(blow, "peak_tension"), forces.tension.size);
    QCOMPARE(*valueOf(blow, "peak_compression_after"), forces.compressionAfter.size);
    QCOMPARE(*valueOf(blow, "peak_tension_after"), forces.tensionAfter.size);
    // 51 N s in 200 µs over π·(38 mm)²/4
    const double unit = 51 / 200e-6 / (std::acos(-1.0) * 0.038 * 0.038 / 4);
    QVERIFY(std::abs(siOf(blow, "peak_compression") / (forces.compression.size * unit) - 1) < 1e-14);
    QCOMPARE(findOutput("peak_compression")->quantity(), Quantity::stress);
}

void TestOutputs::thrustIsFrequencyTimesTheImpulseThatComesBack() {
    const Blow blow = solveBlow(drillOf(50), {}, Detail::cor);
    QVERIFY(std::abs(siOf(blow, "thrust") / (50 * 51 * (1 + blow.impact.cor)) - 1) < 1e-15);
    const Output& thrust = *findOutput("thrust");
    QCOMPARE(thrust.detail, Detail::cor);
    QVERIFY(thrust.problem(Scenario()) == thrustProblem(Scenario()));
    QVERIFY(!thrust.problem(Scenario()).isEmpty());
}

// Work and penetration of a blow, 50 times a second.
void TestOutputs::powerAndRateAreThoseOfOneBlowTimesTheFrequency() {
    const Blow blow = solveBlow(drillOf(50), {}, Detail::ledger);
    const double work = siOf(blow, "work_ratio") * blow.scales.energy;
    QVERIFY(std::abs(siOf(blow, "percussion_power") / (50 * work) - 1) < 1e-14);
    QVERIFY(std::abs(siOf(blow, "penetration_rate") / (50 * siOf(blow, "residual_penetration")) - 1) < 1e-14);
    QCOMPARE(findOutput("percussion_power")->quantity(), Quantity::power);
    QCOMPARE(findOutput("penetration_rate")->quantity(), Quantity::velocity);
    for (const char* name : {"percussion_power", "penetration_rate"}) {
        QVERIFY(findOutput(name)->isOnlySi());
        QVERIFY(!valueOf(solveBlow(Scenario(), {}, Detail::ledger), name));
        const std::string problem = findOutput(name)->problem(Scenario()).text();
        QVERIFY(problem.find("drill.blow_frequency") != std::string::npos);
        QVERIFY(problem.find("thrust") == std::string::npos);
    }
}

void TestOutputs::theMarginNeedsAnInstalledThrust() {
    const Output& margin = *findOutput("thrust_margin");
    QVERIFY(!margin.isOnlySi());
    QVERIFY(margin.needsThrustStudy());
    QVERIFY(margin.problem(Scenario()).text().find("drill.blow_frequency") != std::string::npos);
    QVERIFY(margin.problem(drillOf(50)).text().find("drill.thrust") != std::string::npos);
    Scenario complete = drillOf(50);
    complete.drill.thrust = 5000;
    QVERIFY(margin.problem(complete).isEmpty());
}

void TestOutputs::manyBlowsNeedAFrequencyAndAThrust() {
    const Blow blow = solveBlow(Scenario(), {}, Detail::cor);
    Scenario complete = drillOf(50);
    complete.drill.thrust = 5000;
    Scenario neverSettles = complete;
    neverSettles.drill.settle = 400;  // of 300 blows
    DrillNumbers numbers;
    numbers.gapMean = 0.25;
    const OutputSource source{blow.summary, complete, {}, &numbers};
    for (const Output& output : drillOutputs()) {
        const auto says = [&](const Scenario& scenario, const char* word) {
            return output.problem(scenario).text().find(word) != std::string::npos;
        };
        QVERIFY(says(Scenario(), "drill.blow_frequency") && says(Scenario(), "drill.thrust"));
        QVERIFY(!says(drillOf(50), "drill.blow_frequency") && says(drillOf(50), "drill.thrust"));
        QVERIFY(says(neverSettles, "drill.settle"));
        QVERIFY(output.problem(complete).isEmpty());
        QVERIFY(!output.value({blow.summary, complete}));  // without a march
        QCOMPARE(output.value(source).has_value(), output.name == "drill_gap_mean");
    }
    QCOMPARE(findOutput("drill_gap_mean")->quantity(), Quantity::length);
    QVERIFY(findOutput("drill_penetration_rate")->isOnlySi());
}

void TestOutputs::theWindowListsWhatHasAGroup() {
    for (const Output& output : outputs()) {
        QCOMPARE(output.label().empty(), output.group == OutputGroup::none);
        QCOMPARE(output.note.empty(), output.group == OutputGroup::none);
        QCOMPARE(output.load.has_value(), output.measure == Measure::stress);
    }
}

void TestOutputs::anOutputIsOfTheBlowsThatItsRowSays_data() {
    QTest::addColumn<Scenario>("scenario");
    QTest::addColumn<bool>("ofString");
    QTest::addColumn<bool>("ofHammer");
    QTest::addColumn<bool>("ofFaces");
    Scenario forced;
    forced.form = ScenarioForm::string;
    forced.drillString.parts.resize(1);
    forced.drillString.parts.front().sections.resize(1);
    Scenario struck = forced;
    struck.drillString.hammer.sections.resize(1);
    Scenario elastic = struck;
    elastic.drillString.hammer.faceStiffness = 1e9;
    QTest::newRow("rod") << Scenario() << false << false << false;
    QTest::newRow("groups") << groupsCase({}) << false << false << false;
    QTest::newRow("string under a force") << forced << true << false << false;
    QTest::newRow("string under a hammer") << struck << true << true << false;
    QTest::newRow("hammer with elastic faces") << elastic << true << true << true;
}

void TestOutputs::anOutputIsOfTheBlowsThatItsRowSays() {
    QFETCH(const Scenario, scenario);
    QFETCH(const bool, ofString);
    QFETCH(const bool, ofHammer);
    QFETCH(const bool, ofFaces);
    QCOMPARE(concerns(OutputOf::uniformRod, scenario), !ofString);
    QCOMPARE(concerns(OutputOf::drillString, scenario), ofString);
    QCOMPARE(concerns(OutputOf::hammer, scenario), ofHammer);
    QCOMPARE(concerns(OutputOf::elasticFaces, scenario), ofFaces);
    const ImpactSummary summary;
    for (const Output& output : outputs()) {
        QCOMPARE(output.concerns(scenario), concerns(output.of, scenario));
        if (output.concerns(scenario)) continue;
        QVERIFY(!output.problem(scenario).isEmpty());
        QVERIFY(!output.value({summary, scenario}));
    }
}

void TestOutputs::reportsCallEveryOutputByAName() {
    for (const Output& output : outputs()) QVERIFY(!output.title.empty());
}

void TestOutputs::whatIsToldInJoulesIsAShare() {
    for (const Output& output : outputs()) {
        QVERIFY(!output.part || output.measure == Measure::energy);
        if (output.measure == Measure::energy) QCOMPARE(output.quantity(), Quantity::ratio);
        QCOMPARE(output.siQuantity() == Quantity::energy, output.measure == Measure::energy);
    }
}

QTEST_GUILESS_MAIN(TestOutputs)
#include "tst_outputs.moc"
