// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about the feed, on rods and strings as they are drilled with: the state of single blows by its
// definition, and no number of a sequence off by more than its error.
#include <QTest>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <random>

#include "core/model/scales.h"
#include "core/report/feed_words.h"
#include "core/report/report_text.h"
#include "core/report/sequence_words.h"
#include "core/study/drilling/quick_march.h"
#include "core/study/drilling/sequence.h"
#include "core/study/thrust/thrust_study.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/tries.h"

using namespace drillwave;
using test::tries;

namespace {

void assign(Scenario& scenario, const std::string& setting) {
    const SweepAxis axis = parseAxis(setting).axis;
    QVERIFY2(axis.parameter || axis.kind == SweepAxis::Kind::words, setting.c_str());
    QVERIFY(axis.assign(scenario, axis.value(0)).isEmpty());
}

/// A scene with its name for messages.
struct Scene {
    QByteArray name;
    Scenario scenario;
};

Scene rodOf(const QJsonArray& settings, int number) {
    Scenario scenario = parseScenario(findExample("t38_medium_rock")->text, "rod").scenario;
    scenario.drill.machineMass.reset();
    scenario.drill.damperDamping.reset();
    scenario.drill.damperStiffness.reset();
    for (const QJsonValue& setting : settings) assign(scenario, setting.toString().toStdString());
    return {"rod " + QByteArray::number(number), scenario};
}

std::vector<Scene> givenRods() {
    QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/feed_rods.json"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no cases");
    std::vector<Scene> scenes;
    const QJsonArray cases = QJsonDocument::fromJson(file.readAll()).object()["cases"].toArray();
    for (const QJsonValue& each : cases) scenes.push_back(rodOf(each.toArray(), int(scenes.size()) + 1));
    return scenes;
}

class Random {
  public:
    explicit Random(unsigned seed) : m_random(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(m_random); }
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(m_random); }
    double oneOf(std::initializer_list<double> values) {
        return *(values.begin() + whole(0, int(values.size()) - 1));
    }

  private:
    std::mt19937 m_random;
};

/// A machine with one of six dampers, and a feed between that of a machine which is pushed back and plenty.
void addDrill(Scenario& scenario, Random& random) {
    scenario.drill.blowFrequency = random.whole(35, 90);
    scenario.drill.waveLoss = random.oneOf({0.02, 0.05, 0.1, 0.15});
    const double damping = random.oneOf({0, 1500, 6000, 15000});
    if (damping > 0) {
        scenario.drill.machineMass = random.oneOf({90, 200, 400});
        scenario.drill.damperDamping = damping;
        if (random.whole(0, 1)) scenario.drill.damperStiffness = random.oneOf({3e6, 6.3e6, 20e6});
    }
    const double balance = *scenario.drill.blowFrequency * pulseImpulse(scenario);
    scenario.drill.thrust = balance * random.between(0.9, 4);
}

Scene randomRod(unsigned seed) {
    Random random(seed);
    Scenario scenario = parseScenario(findExample("t38_medium_rock")->text, "rod").scenario;
    scenario.drill = {};
    scenario.rod.diameter = random.oneOf({0.032, 0.038, 0.045, 0.051});
    scenario.rod.length = random.oneOf({3.05, 3.66, 6.1, 9.15, 12.2, 18.3});
    scenario.pulse.shape = std::array{PulseShape::rectangular, PulseShape::halfSine, PulseShape::triangular,
                                      PulseShape::exponential}[std::size_t(random.whole(0, 3))];
    scenario.pulse.duration = random.oneOf({120e-6, 160e-6, 200e-6, 250e-6});
    scenario.pulse.impulse = random.between(15, 60);
    scenario.bitRock.stiffness = std::exp(random.between(std::log(40e6), std::log(600e6)));
    scenario.bitRock.gamma = random.oneOf({0.05, 0.1, 0.2, 0.4});
    addDrill(scenario, random);
    return {"random rod " + QByteArray::number(seed), scenario};
}

/// Adapter, one to six rods with couplings, a bit of two sections; lengths on one millimetre.
Scene randomString(unsigned seed) {
    Random random(seed);
    const auto section = [&](int low, int high, double diameter, const char* more) {
        return "{length: " + std::to_string(random.whole(low, high)) +
               " mm, diameter: " + formatNumber(diameter) + " mm" + more + "}";
    };
    std::string chain = section(350, 550, 45, ", bore: 12 mm, loss: 5 %");
    for (int i = random.whole(1, 6); i > 0; --i)
        chain += ", " + section(150, 240, 56, ", bore: 14.5 mm, loss: 5 %") + ", " +
                 section(1800, 6100, 39, ", bore: 14.5 mm, loss: 5 %");
    chain += ", " + section(50, 90, 56, ", bore: 14.5 mm") + ", " + section(50, 80, 76, "");
    const std::string text = "drillwave: 2\nhammer: {velocity: " + formatNumber(random.whole(8, 11)) +
                             " m/s, restrike: false, sections: [" + section(250, 320, 50, "") + ", " +
                             section(200, 300, 39, "") + "]}\nstring: [" + chain +
                             "]\nbit_rock: {stiffness: " + std::to_string(random.whole(50, 400)) +
                             " MN/m, gamma: 0.1}\n";
    Scenario scenario = parseScenario(text, "string").scenario;
    addDrill(scenario, random);
    return {"random string " + QByteArray::number(seed), scenario};
}

/// The state by the definition of each, from e of the blow and of its gaps.
QByteArray stateByDefinition(const Scenario& scenario, const ThrustStudy& study, double transferred) {
    if (*roundTripsBetweenBlows(scenario) < 1) return "not_applicable";
    const double balance = *scenario.drill.blowFrequency * pulseImpulse(scenario) * transferred;
    const double effective = *scenario.drill.thrust;
    const double own = balance * (1 + std::max(study.need(ThrustCase::scenario).cor.value, 0.0));
    double largest = std::max(study.need(ThrustCase::scenario).cor.value, 1.0);
    if (!isString(scenario))
        largest = std::max({largest, study.rebounds->quantile.cor.value, study.rebounds->worst.cor.value});
    if (effective < balance) return "pushed_back";
    if (effective < own) return "below_required";
    if (effective < balance * (1 + largest)) return "required_at_this_gap";
    return effective < balance * (1 + 2 * largest) ? "required_met" : "return_met";
}

/// Compares what the sequence says with four times the blows at half the step; empty where it holds.
QByteArray falseStatement(const Scenario& scenario) {
    DrillingSettings settings = windowSettingsOf(scenario);
    const DrillingResult result = studyDrilling(scenario, settings, quickWants());
    settings.blows = 4 * settings.blows;
    settings.cells = 2 * settings.cells;
    const DrillingResult finer = studyDrilling(scenario, settings, quickWants());
    if (result.outcome != finer.outcome)
        return QByteArray("outcome ") + name(result.outcome).data() + ", of more blows " +
               name(finer.outcome).data();
    const std::optional<Sequence> said = sequenceOf(result), known = sequenceOf(finer);
    if (!said || !known) return {};
    const auto check = [](const char* what, const SequenceMean& mean, const SequenceMean& reference) {
        const double errors = mean.error.value_or(0) + reference.error.value_or(0);
        if (std::abs(mean.value - reference.value) <= errors + 1e-9 * std::abs(reference.value))
            return QByteArray();
        return what + QByteArray(" ") + QByteArray::number(mean.value) + " +- " +
               QByteArray::number(mean.error.value_or(0)) + ", of more blows " +
               QByteArray::number(reference.value) + " +- " + QByteArray::number(reference.error.value_or(0));
    };
    for (const QByteArray& fault : {check("penetration", said->penetration, known->penetration),
                                    check("rate", said->penetrationRate, known->penetrationRate),
                                    check("share", said->singleBlowShare.value_or(SequenceMean{}),
                                          known->singleBlowShare.value_or(SequenceMean{}))})
        if (!fault.isEmpty()) return fault;
    return {};
}

}  // namespace

class TestStatements : public QObject {
    Q_OBJECT

  private slots:
    void statesAreAsDefined_data() { addScenes(); }
    void statesAreAsDefined();
    void noSequenceIsOffByMoreThanItsError_data() { addScenes(); }
    void noSequenceIsOffByMoreThanItsError();

  private:
    static void addScenes();
    static Scene sceneOf(const QString& kind, int number);
};

// A part of all per change; all of them at night.
void TestStatements::addScenes() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<int>("number");
    const auto add = [](const char* kind, int number) {
        QTest::addRow("%s %d", kind, number) << QString(kind) << number;
    };
    constexpr int given = 126, rods = 150, strings = 150;
    for (int i = 0; i < given; ++i)
        if (test::isChosen(i, 15)) add("given", i);
    for (int i = 0; i < rods; ++i)
        if (test::isChosen(i, 25)) add("rod", i);
    for (int i = 0; i < strings; ++i)
        if (test::isChosen(i, 25)) add("string", i);
}

Scene TestStatements::sceneOf(const QString& kind, int number) {
    if (kind == "rod") return randomRod(unsigned(number));
    if (kind == "string") return randomString(unsigned(number));
    static const std::vector<Scene> given = givenRods();
    return given.at(std::size_t(number));
}

void TestStatements::statesAreAsDefined() {
    QFETCH(QString, kind);
    QFETCH(int, number);
    const Scenario scenario = sceneOf(kind, number).scenario;
    const ThrustStudy study = studyThrust(scenario);
    QCOMPARE(study.reason.text(), std::string());
    const QByteArray expected = stateByDefinition(scenario, study, study.transferred);
    QCOMPARE(QByteArray(name(*study.feed.state()).data()), expected);
    // One sentence for the state, and none that says what the bit does.
    const QString text = QString::fromStdString(estimateText(scenario, study.feed));
    QCOMPARE(text.contains("pushed back"), expected == "pushed_back");
    QCOMPARE(text.contains("probably be lost"), expected == "below_required");
    QCOMPARE(text.contains("does not apply"), expected == "not_applicable");
}

void TestStatements::noSequenceIsOffByMoreThanItsError() {
    QFETCH(QString, kind);
    QFETCH(int, number);
    const Scenario scenario = sceneOf(kind, number).scenario;
    if (!drillingRefusals(scenario, windowSettingsOf(scenario)).empty()) return;
    const QByteArray fault = falseStatement(scenario);
    QVERIFY2(fault.isEmpty(), fault.constData());
}

QTEST_GUILESS_MAIN(TestStatements)
#include "tst_statements.moc"
