// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows against 18 cases of an independent plain lattice (tests/cases/drill_cases.json).
#include <QTest>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/study/drilling/drilling_study.h"
#include "core/study/drilling/sequence.h"
#include "core/study/scan/drilling_scan.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/tries.h"

using namespace drillwave;

namespace {

QJsonArray cases() {
    QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/drill_cases.json"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no cases");
    return QJsonDocument::fromJson(file.readAll()).object()["cases"].toArray();
}

struct Compared {
    const char* name;
    double DrillingBlow::*value;
    double tolerance;  ///< of the scale of the case, beside its error
};
constexpr Compared comparedTable[] = {{"gap", &DrillingBlow::gap, 2e-3},
                                      {"velocity", &DrillingBlow::velocity, 2e-3},
                                      {"rock_impulse", &DrillingBlow::rockImpulse, 5e-4},
                                      {"penetration", &DrillingBlow::penetration, 5e-4},
                                      {"peak_force", &DrillingBlow::peakForce, 2e-3},
                                      {"face_impulse", &DrillingBlow::faceImpulse, 5e-4}};

double siOf(const char* name, const DrillingUnits& units) {
    const QLatin1String quantity(name);
    if (quantity == QLatin1String("gap") || quantity == QLatin1String("penetration")) return units.length();
    if (quantity == QLatin1String("velocity")) return units.velocity;
    return quantity == QLatin1String("peak_force") ? units.force : units.impulse();
}

Scenario scenarioOf(const char* example, std::initializer_list<std::pair<const char*, double>> values) {
    Scenario scenario = parseScenario(findExample(example)->text, example).scenario;
    for (const auto& [key, value] : values) findParameter(key)->assign(scenario, value);
    return scenario;
}

}  // namespace

class TestDrillingCases : public QObject {
    Q_OBJECT

  private slots:
    void casesHold_data();
    void casesHold();
    void aChaoticTransientEnds();
    void aThrustBelowTheReactionPushesTheMachineBack();
    void gapsWithoutBoundPushTheMachineBack();
    void sequencesFollowTheThrust();
    void whatCannotBeDrilledIsToldAtOnce();
    void aScanIsTheSameOnAnyNumberOfThreads();
    void aStopEndsAMarch();
};

void TestDrillingCases::casesHold_data() {
    QTest::addColumn<QJsonObject>("given");
    // the chaos of string_period is a transient: when it ends is chance
    int number = 0;
    for (const QJsonValue& given : cases())
        if (test::isChosen(number++, 3) && given["id"] != "string_period")
            QTest::newRow(qPrintable(given["id"].toString())) << given.toObject();
}

void TestDrillingCases::casesHold() {
    QFETCH(QJsonObject, given);
    const Scenario scenario = parseScenario(given["scenario"].toString().toStdString(), "case").scenario;
    const QString kind = given["kind"].toString();
    DrillingSettings settings = drillingSettingsOf(scenario);
    // means of an irregular motion need no more cells than they scatter, and fewer blows than the reference
    if (kind == "statistics") settings.blows = std::min(settings.blows, 1200L);
    settings.cells = kind == "statistics" ? 40 : 160;
    QVERIFY(drillingRefusals(scenario, settings).empty());
    const DrillingResult result = studyDrilling(
        scenario, settings,
        {.cellError = kind == "statistics", .lyapunov = kind == "statistics", .blowAlone = false});
    QVERIFY2(result.outcome == DrillingOutcome::done, result.reason.text().c_str());
    QVERIFY(std::abs(result.momentumResidual) < 1e-12);
    QVERIFY(std::abs(result.energyResidual) < 1e-3);
    const QJsonObject reference = given["reference"].toObject();
    for (const Compared& compared : comparedTable) {
        const QJsonObject expected = reference[QLatin1String(compared.name)].toObject();
        if (expected.isEmpty()) continue;
        // where the crater no longer grows, the reference has recorded no force
        const bool isShakenDown =
            given["id"] == "same_crater" && QLatin1String(compared.name) == QLatin1String("peak_force");
        const double si = siOf(compared.name, result.units), scale = expected["scale"].toDouble();
        const auto check = [&](double value, double wanted, double tolerance, int blow) {
            QVERIFY2(std::abs(value * si - wanted) <= tolerance,
                     qPrintable(QStringLiteral("%1 of blow %2: %3, not %4")
                                    .arg(QLatin1String(compared.name))
                                    .arg(blow)
                                    .arg(value * si)
                                    .arg(wanted)));
        };
        const BlowSpread& spread = result.spread(quantityPlace(compared.value));
        if (kind == "statistics") {
            const double errors = expected["error"].toDouble() +
                                  result.meanError(quantityPlace(compared.value)).value_or(0) * si;
            check(spread.mean, expected["value"].toDouble(), std::max(3 * errors, 0.01 * scale), 0);
        } else if (kind == "periodic" && !isShakenDown) {
            check(spread.mean, expected["value"].toDouble(),
                  compared.tolerance * scale + expected["error"].toDouble(), 0);
        }
        const QJsonArray first = reference["blows"][QLatin1String(compared.name)].toArray();
        double error = reference["blows_error"][QLatin1String(compared.name)].toDouble();
        for (int n = 0; n < first.size() && kind == "blows"; ++n, error *= 1.6)
            check(result.blows[static_cast<std::size_t>(n)].*compared.value, first[n].toDouble(),
                  compared.tolerance * scale + error, n);
    }
    if (kind == "periodic") QCOMPARE(result.statistics->period, reference["period"].toInt());
    const double lyapunov = reference["lyapunov"]["value"].toDouble();
    if (kind == "statistics" && std::abs(lyapunov) > 0.05) QVERIFY(result.lyapunov->value * lyapunov > 0);
}

/// When it ends is chance: the reference rests before 80 % of its blows.
void TestDrillingCases::aChaoticTransientEnds() {
    for (const QJsonValue& given : cases()) {
        if (given["id"] != "string_period") continue;
        const Scenario scenario = parseScenario(given["scenario"].toString().toStdString(), "case").scenario;
        const DrillingResult result = studyDrilling(scenario, {.blows = 8000, .settle = 7500, .cells = 20},
                                                    {.cellError = false, .blowAlone = false});
        QCOMPARE(result.statistics->period, 1);
        QVERIFY(result.lyapunov->value < 0);
        const DrillingStatistics first = statisticsOf(std::span(result.blows).first(500), 100, 2);
        QCOMPARE(first.period, 0);
        QVERIFY(first.spreads[0].mean > 5 * result.spread(0).mean);
        return;
    }
    QFAIL("no such case");
}

void TestDrillingCases::aThrustBelowTheReactionPushesTheMachineBack() {
    const Scenario scenario = scenarioOf("t38_medium_rock", {{"drill.thrust", 3000}});
    const DrillingResult result = studyDrilling(scenario, drillingSettingsOf(scenario));
    QCOMPARE(name(result.outcome), std::string_view("pushed_back"));
    QVERIFY(result.blows.empty() && !result.statistics);
    QCOMPARE(result.alerts.front().code, AlertCode::pushedBack);
}

/// A bit that is a thousand d0 away does not come back.
void TestDrillingCases::gapsWithoutBoundPushTheMachineBack() {
    const Scenario scenario = scenarioOf("t38_medium_rock", {{"bit_rock.gap", 3}});
    const DrillingResult result = studyDrilling(scenario, drillingSettingsOf(scenario));
    QVERIFY(result.outcome == DrillingOutcome::pushedBack);
    QCOMPARE(result.blows.size(), std::size_t{1});
}

void TestDrillingCases::sequencesFollowTheThrust() {
    const auto sequenceAt = [](double thrust) {
        const Scenario scenario = scenarioOf("t38_medium_rock", {{"drill.thrust", thrust},
                                                                 {"drill.wave_loss", 0.1},
                                                                 {"drill.machine_mass", 200},
                                                                 {"drill.damper_damping", 6300},
                                                                 {"drill.blows", 300}});
        DrillingSettings settings = drillingSettingsOf(scenario);
        settings.cells = 20;
        return sequenceOf(studyDrilling(scenario, settings, {.lyapunov = false}));
    };
    QVERIFY(!sequenceAt(3000));  // pushed back
    const Sequence low = *sequenceAt(3200), high = *sequenceAt(8000);
    QVERIFY(low.contactShare < 0.05 && high.contactShare == 1.0);
    QVERIFY(low.isResolved() && high.isResolved());
    QVERIFY(low.singleBlowShare->value + *low.singleBlowShare->error < 0.95);
    QVERIFY(high.singleBlowShare->value - *high.singleBlowShare->error > low.singleBlowShare->value);
}

void TestDrillingCases::whatCannotBeDrilledIsToldAtOnce() {
    Scenario scenario =
        scenarioOf("t38_medium_rock", {{"drill.damper_damping", 6300}, {"drill.damper_stiffness", 1e6}});
    scenario.drill.blowFrequency.reset();
    scenario.drill.thrust.reset();
    scenario.drill.machineMass.reset();
    DrillingSettings settings = drillingSettingsOf(scenario);
    settings.settle = settings.blows;
    const std::vector<Message> problems = drillingRefusals(scenario, settings);
    QCOMPARE(problems.size(), std::size_t{5});
    for (const char* key : {"drill.blow_frequency", "drill.thrust", "drill.damper_damping",
                            "drill.damper_stiffness", "drill.settle"})
        QVERIFY2(std::ranges::any_of(problems,
                                     [&](const Message& problem) { return problem.text().starts_with(key); }),
                 key);
    QCOMPARE(drillingRefusals(scenarioOf("paper_fig4a", {}), {}).size(), std::size_t{1});
    QCOMPARE(drillingRefusals(scenarioOf("t38_medium_rock", {{"drill.blow_frequency", 8000}}), {}).size(),
             std::size_t{2});
}

void TestDrillingCases::aScanIsTheSameOnAnyNumberOfThreads() {
    const Scenario scenario =
        scenarioOf("t38_medium_rock",
                   {{"drill.machine_mass", 200}, {"drill.damper_damping", 6300}, {"drill.wave_loss", 0.1}});
    const ParsedAxis parsed = parseAxis("drill.thrust=3.2kN:8kN:7");
    QVERIFY(parsed.problem.isEmpty());
    const DrillingSettings settings{.blows = 60, .settle = 20, .cells = 20};
    const DrillingScan one = scanDrilling(scenario, parsed.axis, settings, {.jobs = 1});
    const DrillingScan seven = scanDrilling(scenario, parsed.axis, settings, {.jobs = 7});
    QVERIFY(one.points.size() >= 7);
    QCOMPARE(one.points.size(), seven.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
        QCOMPARE(one.points[i].value, seven.points[i].value);
        for (std::size_t n = 0; n < one.points[i].result.blows.size(); ++n)
            QVERIFY(one.points[i].result.blows[n].gap == seven.points[i].result.blows[n].gap);
    }
}

void TestDrillingCases::aStopEndsAMarch() {
    const Scenario scenario = scenarioOf("t38_medium_rock", {{"drill.blows", 1'000'000}});
    std::stop_source stop;
    long done = 0;
    const DrillingResult result =
        studyDrilling(scenario, drillingSettingsOf(scenario), {}, stop.get_token(), [&](long more) {
            if ((done += more) > 20) stop.request_stop();
        });
    QVERIFY(result.outcome == DrillingOutcome::stopped);
    QVERIFY(done < 30);
}

QTEST_GUILESS_MAIN(TestDrillingCases)
#include "tst_drilling_cases.moc"
