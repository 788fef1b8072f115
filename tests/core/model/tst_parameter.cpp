// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter table: every key once, set and read alike by every user of it.
#include <QTest>

#include <cmath>
#include <random>
#include <set>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/scales.h"
#include "core/model/validation.h"
#include "core/text/name_text.h"
#include "tests/support/scenario.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Scenario dimensional(PulseShape shape) {
    Scenario scenario;
    scenario.pulse.shape = shape;
    return scenario;
}

double valueOf(std::string_view key, const Scenario& scenario) {
    return findParameter(key)->value(scenario).value();
}

}  // namespace

class TestParameter : public QObject {
    Q_OBJECT

  private slots:
    void groupsOfAStringWithoutSectionsAreRefused();
    void whatDoesNotReadBackIsRefused();
    void everyKeyIsThereOnce();
    void everyParameterIsDescribed();
    void plausibleRangesLieInsideTheHardOnes();
    void rulesFitWhatTheValuesDo();
    void aValueThatWasSetReadsBackExactly();
    void settingAGroupMovesItsPhysicalParameterOnly_data();
    void settingAGroupMovesItsPhysicalParameterOnly();
    void aGroupIsHitOrMissedByLessThanADoubleCanTell();
    void groupsOfADimensionlessScenarioAreSetDirectly();
    void aGivenMeanForceIsKeptWhenTheDurationChanges();
    void aGivenImpulseIsKeptWhenTheDurationChanges();
    void areaAndDiameterReplaceEachOther();
    void textIsAssignedWithItsUnit();
    void aBareCellIsTakenInTheUnitOfItsColumn();
    void wrongTextLeavesTheScenarioAloneAndSaysWhy_data();
    void wrongTextLeavesTheScenarioAloneAndSaysWhy();
    void mistypedNamesFindTheirNeighbour_data();
    void mistypedNamesFindTheirNeighbour();
    void rangesDescribeThemselves();
};

void TestParameter::everyKeyIsThereOnce() {
    std::set<std::string_view> keys;
    for (const Parameter& parameter : parameters()) {
        QVERIFY2(keys.insert(parameter.key).second, std::string(parameter.key).c_str());
        QCOMPARE(&*findParameter(parameter.key), &parameter);
    }
    for (const char* key : {"rod.length", "rod.bore", "pulse.impedance_ratio", "bit_rock.stiffness",
                            "drill.thrust", "beta", "gamma", "tau", "delta"})
        QVERIFY2(keys.contains(key), key);
    QVERIFY(findParameter("rod.lenght") == nullptr);
}

void TestParameter::everyParameterIsDescribed() {
    for (const Parameter& parameter : parameters()) {
        QVERIFY(!parameter.label.empty());
        QVERIFY(!parameter.meaning.empty());
        QVERIFY(parameter.meaning.find('\n') == std::string_view::npos);
        QVERIFY(findUnit(parameter.quantity, parameter.unit) == &parameter.displayUnit());
        const bool group = parameter.section() == "groups";
        QCOMPARE(group, parameter.isGroup());
        // The end time of a string stands at the top level of a file, as no section.
        QCOMPARE(group || parameter.section().empty(), parameter.localKey() == parameter.key);
    }
}

void TestParameter::plausibleRangesLieInsideTheHardOnes() {
    for (const Parameter& parameter : parameters()) {
        QVERIFY2(parameter.hard.contains(parameter.plausible.low), std::string(parameter.key).c_str());
        QVERIFY2(parameter.hard.contains(parameter.plausible.high), std::string(parameter.key).c_str());
        QVERIFY(parameter.plausible.low < parameter.plausible.high);
        if (parameter.slider == SliderScale::logarithmic) QVERIFY(parameter.plausible.low > 0);
    }
}

void TestParameter::rulesFitWhatTheValuesDo() {
    int cleared = 0;
    for (const Parameter& parameter : parameters()) {
        const ParameterRules& rules = parameter.rules;
        const QByteArray key(parameter.key.data(), static_cast<qsizetype>(parameter.key.size()));
        QVERIFY2(rules.rival.empty() || findParameter(rules.rival), key);
        QVERIFY2(rules.presence != Presence::either || !rules.rival.empty(), key);
        QVERIFY2(parameter.label.ends_with(rules.shortLabel), key);
        // Parameters that may be missing in a file have a default, or none until a value is given.
        const std::optional<double> value = parameter.value(Scenario());
        QVERIFY2(value || rules.clear, key);
        if (!rules.clear) continue;
        QCOMPARE(rules.presence, Presence::optional);
        Scenario scenario;
        parameter.assign(scenario, parameter.plausible.high);
        QVERIFY2(parameter.value(scenario).has_value(), key);
        rules.clear(scenario);
        QVERIFY2(!parameter.value(scenario) && scenario == Scenario(), key);
        ++cleared;
    }
    QCOMPARE(cleared, 18);
}

void TestParameter::aValueThatWasSetReadsBackExactly() {
    std::mt19937_64 random(3);
    for (const PulseShape shape : {PulseShape::rectangular, PulseShape::trapezoid, PulseShape::piston}) {
        for (const Scenario& base : {dimensionless(shape), dimensional(shape)}) {
            for (const Parameter& parameter : parameters()) {
                if (!parameter.applies(base)) continue;
                std::uniform_real_distribution<double> plausible(parameter.plausible.low,
                                                                 parameter.plausible.high);
                for (int i = 0; i < 50; ++i) {
                    Scenario scenario = base;
                    const double value = plausible(random);
                    parameter.assign(scenario, value);
                    QVERIFY(parameter.value(scenario).has_value());
                    const double read = *parameter.value(scenario);
                    // A value stored as a product is within one rounding where no double leads back exactly.
                    const bool product = parameter.section() == "groups" || parameter.key == "pulse.force";
                    const double tolerance =
                        product && base.form == ScenarioForm::dimensional ? 5e-16 * value : 0;
                    QVERIFY2(std::abs(read - value) <= tolerance, std::string(parameter.key).c_str());
                }
            }
        }
    }
}

void TestParameter::settingAGroupMovesItsPhysicalParameterOnly_data() {
    QTest::addColumn<QString>("group");
    QTest::addColumn<QString>("physical");
    QTest::addColumn<double>("value");
    QTest::newRow("beta moves the stiffness") << "beta"
                                              << "bit_rock.stiffness" << 0.7;
    QTest::newRow("gamma is the rock's") << "gamma"
                                         << "bit_rock.gamma" << 0.7;
    QTest::newRow("tau moves the rod length") << "tau"
                                              << "rod.length" << 7.0;
    QTest::newRow("delta moves the gap") << "delta"
                                         << "bit_rock.gap" << 0.7;
}

void TestParameter::settingAGroupMovesItsPhysicalParameterOnly() {
    QFETCH(QString, group);
    QFETCH(QString, physical);
    QFETCH(double, value);
    Scenario scenario;
    findParameter(group.toStdString())->assign(scenario, value);
    QCOMPARE(valueOf(group.toStdString(), scenario), value);
    for (const Parameter& parameter : parameters()) {
        if (!parameter.applies(scenario) || !parameter.value(scenario)) continue;
        const bool moved = parameter.key == group.toStdString() || parameter.key == physical.toStdString() ||
                           (parameter.key == "gamma" && group == "gamma");
        QCOMPARE(*parameter.value(scenario) != *parameter.value(Scenario()), moved);
    }
}

// The physical value is rounded too: where no double gives the group that was asked for, the nearest one
// does.
void TestParameter::aGroupIsHitOrMissedByLessThanADoubleCanTell() {
    for (const std::string_view key : {"beta", "tau", "delta"})
        for (double wanted = 1e-3; wanted < 1e10; wanted *= 1.7) {
            Scenario scenario;
            findParameter(key)->assign(scenario, wanted);
            const double given = *findParameter(key)->value(scenario);
            QVERIFY2(std::abs(given - wanted) <= std::nextafter(wanted, HUGE_VAL) - wanted, key.data());
            // Asked for again, it stays: no drift from edit to edit.
            findParameter(key)->assign(scenario, given);
            QVERIFY(*findParameter(key)->value(scenario) == given);
        }
}

void TestParameter::groupsOfADimensionlessScenarioAreSetDirectly() {
    Scenario scenario = dimensionless();
    QCOMPARE(QString::fromStdString(assignText(scenario, "beta", "0.25").text()), QString());
    QCOMPARE(scenario.groups.beta, 0.25);
    QVERIFY(scenario.bitRock == BitRock());
}

void TestParameter::aGivenMeanForceIsKeptWhenTheDurationChanges() {
    Scenario scenario;
    QCOMPARE(QString::fromStdString(assignText(scenario, "pulse.force", "300 kN").text()), QString());
    QVERIFY(scenario.pulse.impulseFromForce);
    QCOMPARE(QString::fromStdString(assignText(scenario, "pulse.duration", "150 us").text()), QString());
    QCOMPARE(meanForce(scenario.pulse), 300e3);
    QCOMPARE(scenario.pulse.impulse, 45.0);
}

void TestParameter::aGivenImpulseIsKeptWhenTheDurationChanges() {
    Scenario scenario;
    QCOMPARE(QString::fromStdString(assignText(scenario, "pulse.duration", "100 us").text()), QString());
    QCOMPARE(scenario.pulse.impulse, 51.0);
    QCOMPARE(valueOf("pulse.force", scenario), 510e3);
}

void TestParameter::areaAndDiameterReplaceEachOther() {
    Scenario scenario;
    QVERIFY(!findParameter("rod.area")->value(scenario));
    QCOMPARE(QString::fromStdString(assignText(scenario, "rod.area", "1000 mm^2").text()), QString());
    QCOMPARE(propertiesOf(scenario.rod).area, 1e-3);
    QVERIFY(!findParameter("rod.diameter")->value(scenario));
    QVERIFY(!findParameter("rod.bore")->applies(scenario));
    QCOMPARE(QString::fromStdString(assignText(scenario, "rod.diameter", "40 mm").text()), QString());
    QVERIFY(!scenario.rod.area);
    QVERIFY(findParameter("rod.bore")->applies(scenario));
}

void TestParameter::textIsAssignedWithItsUnit() {
    Scenario scenario;
    QCOMPARE(QString::fromStdString(assignText(scenario, "rod.diameter", "1.5 in").text()), QString());
    QCOMPARE(scenario.rod.diameter, 0.0381);
    QCOMPARE(QString::fromStdString(assignText(scenario, "pulse.shape", "half_sine").text()), QString());
    QVERIFY(scenario.pulse.shape == PulseShape::halfSine);
    QCOMPARE(QString::fromStdString(assignText(scenario, "drill.thrust", "8 kN").text()), QString());
    QCOMPARE(scenario.drill.thrust.value(), 8000.0);
}

void TestParameter::aBareCellIsTakenInTheUnitOfItsColumn() {
    Scenario scenario;
    const Unit* mm = findUnit(Quantity::length, "mm");
    QCOMPARE(QString::fromStdString(assignText(scenario, "rod.length", "3660", mm).text()), QString());
    QCOMPARE(scenario.rod.length, 3.66);
}

void TestParameter::wrongTextLeavesTheScenarioAloneAndSaysWhy_data() {
    QTest::addColumn<QString>("form");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    QTest::newRow("range") << "si"
                           << "bit_rock.gamma"
                           << "1.3"
                           << "bit_rock.gamma = 1.3 (must be in (0, 1])";
    QTest::newRow("open end") << "si"
                              << "rod.length"
                              << "0 m"
                              << "rod.length = 0 m (must be greater than 0)";
    QTest::newRow("closed end") << "si"
                                << "delta"
                                << "-1"
                                << "delta = -1 (must be in [0, 1e+09])";
    QTest::newRow("no unit") << "si"
                             << "rod.diameter"
                             << "38"
                             << "write for example `38 mm`";
    QTest::newRow("unknown key") << "si"
                                 << "rod.lenght"
                                 << "3 m"
                                 << "did you mean `rod.length`?";
    QTest::newRow("unknown key, no neighbour") << "si"
                                               << "xyzzy"
                                               << "3"
                                               << "`xyzzy` is not a parameter";
    QTest::newRow("section left out") << "si"
                                      << "stiffness"
                                      << "3"
                                      << "did you mean `bit_rock.stiffness`?";
    QTest::newRow("shape") << "si"
                           << "pulse.shape"
                           << "square"
                           << "rectangular, triangular, half_sine";
    QTest::newRow("not this shape") << "si"
                                    << "pulse.rise"
                                    << "0.1"
                                    << "only for a trapezoid";
    QTest::newRow("piston only") << "si"
                                 << "pulse.velocity"
                                 << "10 m/s"
                                 << "only for a piston";
    QTest::newRow("ratio in SI") << "si"
                                 << "pulse.impedance_ratio"
                                 << "2"
                                 << "only for a piston";
    QTest::newRow("rod without dimensions") << "none"
                                            << "rod.length"
                                            << "3 m"
                                            << "set `tau` instead";
    QTest::newRow("rock without dimensions") << "none"
                                             << "bit_rock.gamma"
                                             << "0.1"
                                             << "set `gamma` instead";
    QTest::newRow("drill without dimensions") << "none"
                                              << "drill.thrust"
                                              << "1 kN"
                                              << "dimensionless groups";
    QTest::newRow("pulse without dimensions") << "none"
                                              << "pulse.duration"
                                              << "1 us"
                                              << "dimensionless groups";
    QTest::newRow("duration of a piston") << "piston"
                                          << "pulse.duration"
                                          << "1 us"
                                          << "follows from the data";
    QTest::newRow("ratio of a piston") << "piston"
                                       << "pulse.impedance_ratio"
                                       << "2"
                                       << "follows from the diameters";
    QTest::newRow("bore beside area") << "area"
                                      << "rod.bore"
                                      << "3 mm"
                                      << "given by its area";
}

void TestParameter::wrongTextLeavesTheScenarioAloneAndSaysWhy() {
    QFETCH(QString, form);
    QFETCH(QString, key);
    QFETCH(QString, text);
    QFETCH(QString, message);
    Scenario scenario = form == "none" ? dimensionless() : Scenario();
    if (form == "piston") scenario.pulse.shape = PulseShape::piston;
    if (form == "area") scenario.rod.area = 1e-3;
    const Scenario before = scenario;
    const std::string answer = assignText(scenario, key.toStdString(), text.toStdString()).text();
    QVERIFY2(answer.find(message.toStdString()) != std::string::npos, answer.c_str());
    QVERIFY(scenario == before);
}

void TestParameter::mistypedNamesFindTheirNeighbour_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("near");
    QTest::newRow("swapped") << "rod.lenght"
                             << "rod.length";
    QTest::newRow("left out") << "bit_rock.stifness"
                              << "bit_rock.stiffness";
    QTest::newRow("one too many") << "betaa"
                                  << "beta";
    QTest::newRow("upper case") << "Rod.Length"
                                << "rod.length";
    QTest::newRow("American rock") << "bitrock.gamma"
                                   << "bit_rock.gamma";
    QTest::newRow("nothing like it") << "colour"
                                     << "";
    QTest::newRow("empty") << ""
                           << "";
    QTest::newRow("huge") << QString(100000, 'a') << "";
}

void TestParameter::mistypedNamesFindTheirNeighbour() {
    QFETCH(QString, typed);
    QFETCH(QString, near);
    QCOMPARE(QString::fromStdString(nearestKey(typed.toStdString())), near);
}

void TestParameter::rangesDescribeThemselves() {
    const double infinity = std::numeric_limits<double>::infinity();
    QCOMPARE(QString::fromStdString(Range({0, 1, true}).ends()), QString("(0, 1]"));
    QCOMPARE(QString::fromStdString(Range({0, 1}).ends()), QString("[0, 1]"));
    QVERIFY(!Range({0, infinity}).contains(infinity));
    QVERIFY(!Range({0, 1}).contains(std::nan("")));
    QVERIFY(!Range({0, 1, true}).contains(0));
    QVERIFY(Range({0, 1, true}).contains(1));
}

// The stiffness is kept, not beta: where it is at the end of double precision, beta would be another.
void TestParameter::whatDoesNotReadBackIsRefused() {
    Scenario scenario;
    for (const char* text : {"1e-300", "1e290", "0.1"})
        QCOMPARE(assignText(scenario, "beta", text), Message());
    for (const char* text : {"1e301", "1e308"}) {
        const std::string problem = assignText(scenario, "beta", text).text();
        QVERIFY2(problem.starts_with(std::string("beta = ") + text + " (cannot be stored"), problem.c_str());
    }
    scenario = {};
    QCOMPARE(assignText(scenario, "pulse.force", "255 kN"), Message());
    scenario.form = ScenarioForm::dimensionless;
    QCOMPARE(assignText(scenario, "beta", "1e301"), Message());
}

// A group is a multiple of a scale, which no section gives here.
void TestParameter::groupsOfAStringWithoutSectionsAreRefused() {
    Scenario scenario;
    scenario.form = ScenarioForm::string;
    for (const char* key : {"beta", "delta"}) {
        const std::string problem = assignNumber(scenario, *findParameter(key), 0.5).text();
        QVERIFY2(problem.find("must have at least one section") != std::string::npos, problem.c_str());
    }
    // Repeats are counted, not written out.
    StringPart repeat;
    repeat.sections.push_back({});
    repeat.repeat = 1'000'000'000;
    scenario.drillString.parts = {repeat};
    scenario.drillString.hammer.sections.push_back({});
    const std::string problem = assignNumber(scenario, *findParameter("beta"), 0.5).text();
    QVERIFY2(problem.find("has 1000000000 sections") != std::string::npos, problem.c_str());
}

QTEST_APPLESS_MAIN(TestParameter)
#include "tst_parameter.moc"
