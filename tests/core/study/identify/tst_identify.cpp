// SPDX-License-Identifier: GPL-3.0-or-later
// Rocks identified from records that small steps and the solvers have made.

#include <QTest>

#include "tests/core/study/identify/scene_kinds.h"

using namespace drillwave;

namespace {

/// A rod, a half sine of 200 kN, and a bilinear rock.
struct PlainScene {
    RodRig rig;
    double stiffness = 150e6, gamma = 0.2, gap = 1e-4, noise = 0;
    double step = 1e-6;

    IdentifyQuestion question(std::uint64_t seed = 1) const {
        const IncidentWave f = [](double t) {
            return t > 0 && t < 220e-6 ? 200e3 * std::pow(std::sin(std::numbers::pi * t / 220e-6), 2) : 0.0;
        };
        const double k = stiffness;
        std::vector<double> record = rodRecord(
            rig, f, loadingRock([k](double u) { return k * u; }, k / gamma), gap, step, 200e-6, 1.35e-3);
        SceneRandom random(seed);
        addNoise(record, "white", noise * 200e3, step, random);
        GaugeRecord made;
        made.file = "plain";
        for (std::size_t i = 0; i < record.size(); ++i) made.time.push_back(static_cast<double>(i) * step);
        made.gauges.push_back({"strain", rig.stated, std::move(record), {}});
        IdentifyQuestion question;
        question.scenario = rodScenario(rig);
        question.records.push_back(std::move(made));
        return question;
    }
};

RecordAnswer answerOf(const IdentifyQuestion& question) {
    return runIdentify(question).records.front();
}

bool holds(const IdentifiedParameter& parameter, double truth) {
    return parameter.low.value_or(0) <= truth && truth <= parameter.high.value_or(1e300);
}

}  // namespace

class TestIdentify : public QObject {
    Q_OBJECT

  private slots:
    void noiseFreeRecord_comesBack();
    void whiteNoise_isHeldByIntervals();
    void string_isIdentifiedWithTwoGauges();
    void reversedSign_changesNothing();
    void largerGain_changesOnlyGapAndForces();
    void answer_doesNotDependOnThreads();
    void stop_endsWithoutAnAnswer();
    void recordWithoutFront_isRefused();
    void shortZero_isRefused();
    void gapInTheRecord_isRefused();
    void clippedIncidentWave_isRefused();
    void missingHead_isRejected();
    void exchangedGauges_areRefused();
    void wrongDistance_isFound();
    void wrongDistanceOfBothGauges_isFound();
    void yieldingRock_isNeverNarrowAndWrongWhenForcedBilinear();
    void cutRecord_showsNoGamma();
    void posteriorDraws_areValidLaws();
    void knownSizeBehindTheGauge_isRefused();
    void waveBehindTheSpecimen_isPredicted();
    void sharpFronts_leaveTheZeroLinesAlone();
    void bitInItsCrater_isNotNarrowAndWrong();
};

void TestIdentify::noiseFreeRecord_comesBack() {
    const PlainScene scene;
    const RecordAnswer answer = answerOf(scene.question());
    QVERIFY(!answer.refusal);
    QCOMPARE(answer.model, ModelVerdict::accepted);
    // steps of 0.05 µs move the force by half a step: 1e-3 of the rise
    QVERIFY(std::abs(answer.parameters[0].value / scene.stiffness - 1) < 0.003);
    QVERIFY(std::abs(answer.parameters[1].value / scene.gamma - 1) < 0.004);
    QVERIFY(std::abs(answer.parameters[2].value - scene.gap) < 2e-6);
}

void TestIdentify::whiteNoise_isHeldByIntervals() {
    PlainScene scene;
    scene.noise = 0.01;
    int held = 0, intervals = 0, identified = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const RecordAnswer answer = answerOf(scene.question(seed));
        QVERIFY(!answer.refusal);
        QVERIFY(answer.model != ModelVerdict::rejected);
        const double truths[] = {scene.stiffness, scene.gamma, scene.gap};
        for (std::size_t i = 0; i < 3; ++i) {
            ++intervals;
            held += holds(answer.parameters[i], truths[i]) ? 1 : 0;
        }
        identified += answer.parameters[0].verdict == ParameterVerdict::identified ? 1 : 0;
    }
    QVERIFY2(identified >= 9, qPrintable(QString::number(identified)));
    QVERIFY2(held >= intervals * 9 / 10, qPrintable(QString::number(held)));
}

void TestIdentify::string_isIdentifiedWithTwoGauges() {
    const GaugeScene scene = sceneOf("string", 2);
    const RecordAnswer answer = answerOf(scene.question);
    QVERIFY(!answer.refusal);
    QCOMPARE(answer.parameters[0].verdict, ParameterVerdict::identified);
    QVERIFY(holds(answer.parameters[0], scene.stiffness));
    QVERIFY(holds(answer.parameters[1], scene.gamma));
}

void TestIdentify::reversedSign_changesNothing() {
    PlainScene scene;
    scene.noise = 0.005;
    IdentifyQuestion question = scene.question();
    const RecordAnswer one = answerOf(question);
    for (double& value : question.records[0].gauges[0].force) value = -value;
    const RecordAnswer other = answerOf(question);
    QCOMPARE(one.sign, 1);
    QCOMPARE(other.sign, -1);
    QVERIFY(std::abs(other.parameters[0].value / one.parameters[0].value - 1) < 1e-9);
    QVERIFY(std::abs(other.parameters[1].value / one.parameters[1].value - 1) < 1e-9);
}

void TestIdentify::largerGain_changesOnlyGapAndForces() {
    PlainScene scene;
    scene.noise = 0.003;
    IdentifyQuestion question = scene.question();
    const RecordAnswer one = answerOf(question);
    for (double& value : question.records[0].gauges[0].force) value *= 1.2;
    const RecordAnswer other = answerOf(question);
    // minima are found to 1e-9 of the sum of squares, values to its root
    QVERIFY(std::abs(other.parameters[0].value / one.parameters[0].value - 1) < 1e-3);
    QVERIFY(std::abs(other.parameters[1].value / one.parameters[1].value - 1) < 1e-3);
    QVERIFY(std::abs(other.parameters[2].value / one.parameters[2].value - 1.2) < 1e-2);
}

void TestIdentify::answer_doesNotDependOnThreads() {
    PlainScene scene;
    scene.noise = 0.01;
    IdentifyQuestion question = scene.question(1);
    question.records.push_back(scene.question(2).records[0]);
    question.records.push_back(scene.question(3).records[0]);
    const IdentifyFindings one = runIdentify(question, 1), three = runIdentify(question, 3);
    QCOMPARE(one.records.size(), std::size_t(3));
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(one.records[r].parameters[i].value, three.records[r].parameters[i].value);
            QCOMPARE(one.records[r].parameters[i].halfWidth, three.records[r].parameters[i].halfWidth);
        }
    QCOMPARE(one.nextBlow.size(), std::size_t(3));
}

void TestIdentify::stop_endsWithoutAnAnswer() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(runIdentify(PlainScene().question(), 1, stop.get_token()).isStopped);
}

void TestIdentify::recordWithoutFront_isRefused() {
    IdentifyQuestion question = PlainScene().question();
    for (double& value : question.records[0].gauges[0].force) value = 0;
    QCOMPARE(answerOf(question).refusal->code, std::string("no_front"));
}

void TestIdentify::shortZero_isRefused() {
    IdentifyQuestion question = PlainScene().question();
    GaugeRecord& record = question.records[0];
    record.time.erase(record.time.begin(), record.time.begin() + 180);
    record.gauges[0].force.erase(record.gauges[0].force.begin(), record.gauges[0].force.begin() + 180);
    QCOMPARE(answerOf(question).refusal->code, std::string("short_zero"));
}

void TestIdentify::gapInTheRecord_isRefused() {
    IdentifyQuestion question = PlainScene().question();
    GaugeRecord& record = question.records[0];
    record.time.erase(record.time.begin() + 400, record.time.begin() + 460);
    record.gauges[0].force.erase(record.gauges[0].force.begin() + 400, record.gauges[0].force.begin() + 460);
    QCOMPARE(answerOf(question).refusal->code, std::string("gap"));
}

void TestIdentify::clippedIncidentWave_isRefused() {
    PlainScene scene;
    scene.noise = 0.01;
    IdentifyQuestion question = scene.question();
    for (double& value : question.records[0].gauges[0].force)
        value = std::clamp(std::round(value / 100) * 100, -180e3, 180e3);
    QCOMPARE(answerOf(question).refusal->code, std::string("clipped"));
}

void TestIdentify::missingHead_isRejected() {
    const RecordAnswer answer = answerOf(sceneOf("head_missing", 1).question);
    QVERIFY(answer.refusal || answer.model == ModelVerdict::rejected);
}

void TestIdentify::exchangedGauges_areRefused() {
    IdentifyQuestion question = sceneOf("string", 2).question;
    std::swap(question.records[0].gauges[0].force, question.records[0].gauges[1].force);
    QCOMPARE(answerOf(question).refusal->code, std::string("exchanged"));
}

void TestIdentify::wrongDistance_isFound() {
    PlainScene scene;
    scene.noise = 0.005;
    scene.rig.stated = 1.98;
    const RecordAnswer answer = answerOf(scene.question());
    QVERIFY(answer.has("distance_off"));
    QVERIFY(holds(answer.parameters[0], scene.stiffness));
    QVERIFY(std::abs(answer.match.roundTrip - 2 * scene.rig.ahead / scene.rig.speed()) < 6e-6);
}

// The gauges are as far apart as stated, so the waves are separated rightly and only the arrival differs.
void TestIdentify::wrongDistanceOfBothGauges_isFound() {
    GaugeScene scene = sceneOf("string", 2);
    std::vector<GaugeChannel>& gauges = scene.question.records[0].gauges;
    const double distance = gauges[0].distance;
    QVERIFY(!answerOf(scene.question).has("distance_off"));
    for (GaugeChannel& gauge : gauges) gauge.distance -= 0.07;
    const RecordAnswer answer = answerOf(scene.question);
    QVERIFY(answer.model != ModelVerdict::rejected);
    QVERIFY(answer.has("distance_off"));
    QVERIFY2(std::abs(answer.distanceThatFits - distance) < 0.01,
             qPrintable(QString::number(answer.distanceThatFits)));
    QVERIFY(holds(answer.parameters[0], scene.stiffness));
}

void TestIdentify::yieldingRock_isNeverNarrowAndWrongWhenForcedBilinear() {
    for (std::uint64_t seed = 2; seed <= 4; ++seed) {
        GaugeScene scene = sceneOf("corner", seed);
        scene.question.law = LawChoice::bilinear;
        const RecordAnswer answer = answerOf(scene.question);
        const IdentifiedParameter& stiffness = answer.parameters[0];
        QVERIFY(stiffness.verdict != ParameterVerdict::identified || holds(stiffness, scene.stiffness));
    }
}

void TestIdentify::cutRecord_showsNoGamma() {
    PlainScene scene;
    scene.noise = 0.003;
    scene.stiffness = 60e6;
    IdentifyQuestion question = scene.question();
    question.end = 120e-6;
    const RecordAnswer answer = answerOf(question);
    QVERIFY(!answer.refusal);
    QCOMPARE(answer.parameters[1].verdict, ParameterVerdict::notSeen);
    QCOMPARE(answer.parameters[1].reason, std::string("no_unloading"));
    QVERIFY(holds(answer.parameters[0], scene.stiffness));
}

void TestIdentify::posteriorDraws_areValidLaws() {
    PlainScene scene;
    scene.noise = 0.01;
    scene.gap = 0;
    scene.gamma = 0.9;
    const IdentifyFindings findings = runIdentify(scene.question());
    const PosteriorDraws draws = posteriorDraws(findings, 200, 1);
    QVERIFY(!draws.rows.empty());
    for (const std::vector<double>& row : draws.rows)
        for (std::size_t i = 0; i < draws.keys.size(); ++i) {
            QVERIFY(row[i] >= 0);
            if (draws.keys[i] == "bit_rock.gamma") QVERIFY(row[i] > 0 && row[i] <= 1);
        }
}

void TestIdentify::knownSizeBehindTheGauge_isRefused() {
    IdentifyQuestion question = sceneOf("string", 2).question;
    question.known.push_back({"string.adapter.diameter", 1e-3});
    QVERIFY(!identifyProblems(question).empty());
    question.known = {{"string.bit_head.diameter", 1e-3}};
    QVERIFY(identifyProblems(question).empty());
    question.known = {{"string.bit_head.diameter", 1.0}};
    QVERIFY(!identifyProblems(question).empty());
}

void TestIdentify::waveBehindTheSpecimen_isPredicted() {
    PlainScene scene;
    scene.gap = 0;
    IdentifyQuestion question = scene.question();
    GaugeRecord& record = question.records[0];
    std::vector<double>& p = record.gauges[0].force;
    // Against a bar the specimen gives way to both sides: half of the force that a rock twice as stiff shows.
    const auto f = [](double t) {
        return t > 0 && t < 220e-6 ? 200e3 * std::pow(std::sin(std::numbers::pi * t / 220e-6), 2) : 0.0;
    };
    const double trip = 2 * scene.rig.ahead / scene.rig.speed(), distance = 0.9;
    const double later = trip / 2 - distance / scene.rig.speed();  // of b against the wave behind
    record.behind.assign(p.size(), 0);
    const auto timeOf = [&](std::size_t i) { return static_cast<double>(i) * scene.step - 200e-6; };
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double t = timeOf(i), g = f(t - trip), doubled = p[i] - f(t) + g;
        const double at = (t - later + 200e-6) / scene.step + 0.5;
        if (t >= trip && at >= 0) record.behind[static_cast<std::size_t>(at)] = doubled / 2;
        if (t >= trip) p[i] = f(t) + doubled / 2 - g;
    }
    question.barBehind = true;
    question.checkDistance = distance;
    question.known.push_back({"zero", 0.001});  // a zero line that is free moves the force by 1 to 2 %
    const RecordAnswer answer = answerOf(question);
    QVERIFY(!answer.refusal);
    QVERIFY(std::abs(answer.parameters[0].value / (scene.stiffness / 2) - 1) < 0.01);
    QVERIFY(answer.check.has_value());
    // places of samples: a step of 1 µs on a rise of 100 µs
    QVERIFY2(answer.check->error < 0.01, qPrintable(QString::number(answer.check->error)));
    QVERIFY(std::abs(answer.check->shift) < 1.5e-6);
    QVERIFY(std::abs(answer.check->gain - 1) < 0.01);
    for (double& sample : record.behind) sample *= 1.2;
    const RecordAnswer louder = answerOf(question);
    QVERIFY(louder.check->error > 0.05);
    QVERIFY(std::abs(louder.check->gain / answer.check->gain - 1.2) < 1e-6);
    QVERIFY(louder.check->scaledError < 0.01);
    question.checkDistance = distance + 0.05;  // 10 µs later
    const RecordAnswer moved = answerOf(question);
    QVERIFY(std::abs(moved.check->shift + 0.05 / scene.rig.speed()) < 1.5e-6);
}

void TestIdentify::sharpFronts_leaveTheZeroLinesAlone() {
    // Fronts of one sample from cylindrical pistons: their error used to bend the zero lines.
    for (const std::uint64_t seed : {402, 411}) {
        const GaugeScene scene = sceneOf("string", seed);
        const RecordAnswer answer = answerOf(scene.question);
        QVERIFY(answer.model == ModelVerdict::accepted);
        QVERIFY(!answer.has("zero_line"));
        QVERIFY(holds(answer.parameters[0], scene.stiffness));
        QVERIFY(holds(answer.parameters[1], scene.gamma));
    }
}

void TestIdentify::bitInItsCrater_isNotNarrowAndWrong() {
    for (std::uint64_t seed = 301; seed <= 303; ++seed) {
        const GaugeScene scene = sceneOf("preloaded", seed);
        const RecordAnswer answer = answerOf(scene.question);
        if (answer.refusal || answer.model == ModelVerdict::rejected) continue;
        QVERIFY(holds(answer.parameters[0], scene.stiffness));
        QVERIFY(holds(answer.parameters[1], scene.gamma));
        QVERIFY(answer.has("law_tried"));
    }
}

QTEST_GUILESS_MAIN(TestIdentify)
#include "tst_identify.moc"
