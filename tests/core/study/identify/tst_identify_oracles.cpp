// SPDX-License-Identifier: GPL-3.0-or-later
// Identifications against a closed form, under changes that must not matter, and their intervals over many
// records (theory of identification §11, §13).
#include <QTest>

#include "core/study/identify/known_sizes.h"
#include "core/study/identify/law_search.h"
#include "core/study/identify/record_model.h"
#include "tests/core/study/identify/coverage_scenes.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr CoverageRock plainRock{150e6, 0.2, 1e-4};

/// k, γ and gap.
struct Answer {
    RecordAnswer record;
    double value(std::size_t i) const { return record.parameters[i].value; }
    double halfWidth(std::size_t i) const { return record.parameters[i].halfWidth; }
    /// Whether value `i` is `factor` times that of another answer, to 5 % of its half-width.
    bool isNear(const Answer& other, std::size_t i, double factor) const {
        const double change =
            i == 2 ? value(i) - factor * other.value(i) : std::log(value(i) / (factor * other.value(i)));
        return std::abs(change) < 0.05 * halfWidth(i);
    }
    QByteArray against(const Answer& other) const {
        QByteArray text;
        for (std::size_t i = 0; i < 3; ++i)
            text += QByteArray::number(value(i), 'g', 10) + " for " +
                    QByteArray::number(other.value(i), 'g', 10) + " ± " +
                    QByteArray::number(halfWidth(i), 'g', 3) + "; ";
        return text;
    }
};

Answer answerOf(const IdentifyQuestion& question) {
    return {runIdentify(question).records.front()};
}

std::vector<double>& forceOf(IdentifyQuestion& question) {
    return question.records[0].gauges[0].force;
}

}  // namespace

class TestIdentifyOracles : public QObject {
    Q_OBJECT

  private slots:
    void slopeOfTheModelIsThatOfTheClosedForm_data();
    void slopeOfTheModelIsThatOfTheClosedForm();
    void scaledRecordScalesForcesAndGap();
    void originOfTimeChangesNothing();
    void splitSectionChangesNothing();
    void wavesOfTheModelGiveItsLawBack_data();
    void wavesOfTheModelGiveItsLawBack();
    void whatTheZeroLinesAbsorbMovesTheAnswerLittle_data();
    void whatTheZeroLinesAbsorbMovesTheAnswerLittle();
    void whiteNoiseIsCovered();
};

/// sd(ln k) = σ √Δ √(β / (2 [1 − (1 + β) e^−β])) for γ = 1 without a gap, under a rectangle of F0 and t0.
void TestIdentifyOracles::slopeOfTheModelIsThatOfTheClosedForm_data() {
    QTest::addColumn<double>("beta");
    for (const double beta : {0.5, 1.0, 1.7933, 3.0, 5.0})
        QTest::newRow(qPrintable(QString::number(beta))) << beta;
}

void TestIdentifyOracles::slopeOfTheModelIsThatOfTheClosedForm() {
    QFETCH(double, beta);
    constexpr double force = 200e3, length = 200e-6, step = 0.25e-6;
    RodRig rig;
    rig.length = 14;
    rig.ahead = rig.stated = 3;  // a long window
    const double k = beta * rig.impedance() / length;
    const IncidentWave f = [](double t) { return t > 0 && t < length ? force : 0.0; };
    std::vector<double> record =
        rodRecord(rig, f, loadingRock([k](double u) { return k * u; }, k), 0, step, 100e-6, 5e-3);
    SceneRandom random(1);
    addNoise(record, "white", 1e-3 * force, step, random);  // a flat top would be a clipped one
    GaugeRecord made;
    for (std::size_t i = 0; i < record.size(); ++i) made.time.push_back(static_cast<double>(i) * step);
    made.gauges.push_back({"strain", rig.stated, std::move(record), {}});
    IdentifyQuestion question;
    question.scenario = rodScenario(rig);
    question.records.push_back(std::move(made));
    const Preparation prepared =
        prepareRecord(question.records[0], {*gaugePlace(question.scenario, rig.stated)}, question);
    QVERIFY2(!prepared.refusal, prepared.refusal ? prepared.refusal->code.c_str() : "");
    SizeTolerances sizes;
    RecordModel model(prepared.record, question, sizes, TrialLaw::bilinear);
    Eigen::VectorXd values = startValues(model);
    const auto at = [&](UnknownKind kind) -> double& {
        return values[static_cast<Eigen::Index>(model.find(kind))];
    };
    at(UnknownKind::gamma) = 0;
    at(UnknownKind::gap) = 0;
    constexpr double change = 1e-4;  // step of ln k
    at(UnknownKind::stiffness) = std::log(k) + change;
    model.solved(values);
    const std::vector<double> above = model.modelReturning();
    at(UnknownKind::stiffness) = std::log(k) - change;
    model.solved(values);
    const std::vector<double>& below = model.modelReturning();
    double sum = 0;
    for (std::size_t i = 0; i < above.size(); ++i)
        sum += std::pow((above[i] - below[i]) / (2 * change) / force, 2);
    const double found = 1 / std::sqrt(sum);
    const double expected =
        std::sqrt(prepared.record.step / length) * std::sqrt(beta / (2 * (1 - (1 + beta) * std::exp(-beta))));
    QVERIFY2(std::abs(found / expected - 1) < 0.02, qPrintable(QString::number(found / expected)));
}

void TestIdentifyOracles::scaledRecordScalesForcesAndGap() {
    IdentifyQuestion question = coverageScene("white", plainRock, 0.003, 5).question;
    const Answer one = answerOf(question);
    for (double& value : forceOf(question)) value *= 1.25;
    const Answer other = answerOf(question);
    QVERIFY2(other.isNear(one, 0, 1) && other.isNear(one, 1, 1) && other.isNear(one, 2, 1.25),
             other.against(one).constData());
}

void TestIdentifyOracles::originOfTimeChangesNothing() {
    IdentifyQuestion question = coverageScene("white", plainRock, 0.003, 6).question;
    const Answer one = answerOf(question);
    for (double& time : question.records[0].time) time += 0.125;
    const Answer other = answerOf(question);
    QVERIFY2(other.isNear(one, 0, 1) && other.isNear(one, 1, 1) && other.isNear(one, 2, 1),
             other.against(one).constData());
}

void TestIdentifyOracles::wavesOfTheModelGiveItsLawBack_data() {
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("gamma");
    QTest::addColumn<double>("gap");
    QTest::newRow("soft") << 60e6 << 0.05 << 0.0;
    QTest::newRow("medium") << 150e6 << 0.2 << 1e-4;
    QTest::newRow("hard, at a gap") << 400e6 << 0.4 << 3e-4;
}

/// The reflected wave of the record is replaced by that of the model, without noise; zero lines are held
/// (§13.1).
void TestIdentifyOracles::wavesOfTheModelGiveItsLawBack() {
    QFETCH(double, stiffness);
    QFETCH(double, gamma);
    QFETCH(double, gap);
    const IdentifyQuestion question = coverageScene("white", plainRock, 0.003, 7).question;
    const GaugeRecord& given = question.records[0];
    Preparation prepared =
        prepareRecord(given, {*gaugePlace(question.scenario, given.gauges[0].distance)}, question);
    QVERIFY(!prepared.refusal);
    const auto set = [](const RecordModel& model, Eigen::VectorXd& values, UnknownKind kind, double value) {
        values[static_cast<Eigen::Index>(model.find(kind))] = value;
    };
    RecordModel made(prepared.record, question, {}, TrialLaw::bilinear);
    made.setDispersion(0, false);
    Eigen::VectorXd truth = startValues(made);
    set(made, truth, UnknownKind::stiffness, std::log(stiffness));
    set(made, truth, UnknownKind::gamma, std::log(gamma));
    set(made, truth, UnknownKind::gap, gap);
    made.solved(truth);
    std::ranges::copy(made.modelReturning(), prepared.record.gauges[0].force.begin() +
                                                 static_cast<std::ptrdiff_t>(made.firstReturning()));
    RecordModel model(prepared.record, question, {}, TrialLaw::bilinear);
    model.setDispersion(0, false);
    for (Unknown& unknown : model.unknowns())
        if (unknown.kind == UnknownKind::shape) unknown.isHeld = true;
    Eigen::VectorXd values = startValues(model);
    set(model, values, UnknownKind::stiffness, std::log(1.3 * stiffness));
    set(model, values, UnknownKind::gamma, std::log(0.8 * gamma));
    set(model, values, UnknownKind::gap, gap + 2e-5);
    minimise(model, values, 200, {});
    const Eigen::VectorXd change = values - truth;
    const auto off = [&](UnknownKind kind) {
        return std::abs(change[static_cast<Eigen::Index>(model.find(kind))]);
    };
    QVERIFY2(off(UnknownKind::stiffness) < 1e-5, qPrintable(QString::number(off(UnknownKind::stiffness))));
    QVERIFY2(off(UnknownKind::gamma) < 1e-5, qPrintable(QString::number(off(UnknownKind::gamma))));
    QVERIFY2(off(UnknownKind::gap) < 1e-6, qPrintable(QString::number(off(UnknownKind::gap))));
    QVERIFY2(off(UnknownKind::lag) < 1e-8, qPrintable(QString::number(off(UnknownKind::lag))));
}

void TestIdentifyOracles::splitSectionChangesNothing() {
    GaugeScene scene = sceneOf("string", 2);
    const Answer one = answerOf(scene.question);
    // the head in two equal parts, of which neither holds the gauge
    std::vector<StringPart>& parts = scene.question.scenario.drillString.parts;
    StringPart& last = parts.back();
    Section half = last.sections[0];
    half.length /= 2;
    last.sections[0].length /= 2;
    half.name = "bit face";
    parts.push_back({1, false, {half}});
    const Answer other = answerOf(scene.question);
    QVERIFY(std::abs(other.value(0) / one.value(0) - 1) < 0.1 * one.halfWidth(0));
    QVERIFY(std::abs(other.value(1) / one.value(1) - 1) < 0.1 * one.halfWidth(1));
}

void TestIdentifyOracles::whatTheZeroLinesAbsorbMovesTheAnswerLittle_data() {
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("slope");  // in a millisecond
    QTest::addColumn<double>("droop");  // 1 ms over the time constant
    QTest::newRow("constant") << 0.005 << 0.0 << 0.0;
    QTest::newRow("slope") << 0.0 << 0.005 << 0.0;
    QTest::newRow("droop") << 0.0 << 0.0 << 0.05;
}

void TestIdentifyOracles::whatTheZeroLinesAbsorbMovesTheAnswerLittle() {
    QFETCH(double, offset);
    QFETCH(double, slope);
    QFETCH(double, droop);
    IdentifyQuestion question = coverageScene("white", plainRock, 0.005, 7).question;
    const Answer one = answerOf(question);
    double integral = 0;
    const double step = 1e-6;
    std::vector<double>& force = forceOf(question);
    for (std::size_t i = 0; i < force.size(); ++i) {
        integral += force[i] * step * droop / 1e-3;
        force[i] += 200e3 * (offset + slope * static_cast<double>(i) * step / 1e-3) - integral;
    }
    const Answer other = answerOf(question);
    QCOMPARE(other.record.model, ModelVerdict::accepted);
    for (std::size_t i : {0, 1})
        QVERIFY2(std::abs(std::log(other.value(i) / one.value(i))) < 0.1 * one.halfWidth(i),
                 qPrintable(QString::number(std::log(other.value(i) / one.value(i)) / one.halfWidth(i))));
}

void TestIdentifyOracles::whiteNoiseIsCovered() {
    const int seeds = tries("DRILLWAVE_COVERAGE_SEEDS", 1, 20);
    const CoverageTally tally = coverageOf("white", seeds, 1 + static_cast<std::uint64_t>(seed()));
    qInfo("%d records: k %d/%d gamma %d/%d gap %d/%d, bias %.2f %.2f %.2f, %d silent", tally.records,
          tally.held[0], tally.intervals[0], tally.held[1], tally.intervals[1], tally.held[2],
          tally.intervals[2], tally.bias(0), tally.bias(1), tally.bias(2), tally.silent);
    QVERIFY(tally.silent <= tally.records / 50);
    for (std::size_t i = 0; i < 3; ++i) {
        const double count = tally.intervals[i];
        QVERIFY(count > 0.6 * tally.records);
        // 90 % of many, three standard deviations less of few
        QVERIFY(tally.share(i) >= 0.9 - 3 * std::sqrt(0.09 / count) * (seeds < 10 ? 1 : 0));
        QVERIFY(std::abs(tally.bias(i)) < 0.5 + (seeds < 10 ? 3 / std::sqrt(count) : 0));
    }
}

QTEST_GUILESS_MAIN(TestIdentifyOracles)
#include "tst_identify_oracles.moc"
