// SPDX-License-Identifier: GPL-3.0-or-later
// The feed force: its formula, its cases from this blow to the worst, and what the installed one means.
#include <QTest>

#include <array>
#include <cmath>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
#include "core/blow/outputs.h"
#include "core/model/scales.h"
#include "core/study/thrust/thrust_curve.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/study/thrust/thrust_study.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

/// The paper's Fig. 8 in steel: β = 0.5, γ = 0.1 unless set, τ = 10, no gap, 50 blows a second of 40 N s.
Scenario drill(double gamma = 0.1) {
    Scenario scenario;
    scenario.pulse.impulse = 40;
    scenario.drill.blowFrequency = 50;
    scenario.bitRock.gamma = gamma;
    const RodProperties rod = propertiesOf(scenario.rod);
    scenario.rod.length = 10 * scenario.pulse.duration * rod.waveSpeed;
    scenario.bitRock.stiffness = 0.5 * rod.impedance / scenario.pulse.duration;
    return scenario;
}

/// Without an installed feed force, 60 blows a second.
Scenario t38String() {
    Scenario scenario = test::losslessString();
    scenario.drill.thrust.reset();
    return scenario;
}

}  // namespace

class TestThrust : public QObject {
    Q_OBJECT

  private slots:
    void thrustIsFrequencyTimesImpulse();
    void whereThereIsNoThrustTheReasonSaysWhatToDo();
    void theCasesAreThoseOfTheTheory();
    void theMarginOfAHeavyBlowIsLeftOut();
    void anElasticRockNeedsMoreThanARigidOne();
    void marginsAndFrequencyLimitFollowFromTheInstalledThrust();
    void theStateIsByTheLargestOfTheFour();
    void theMarginIsThatOfTheLargestNeed();
    void weightAlongTheHoleCountsInEveryMargin();
    void theShareHeldIsTheShareOfGapsThatNeedLess();
    void aMarginOnItsOwnIsThatOfTheStudy();
    void whatIsSharedBetweenCasesChangesNothing();
    void alongAParameterEveryPointIsAStudyOfItsOwn();
    void pointsDoNotDependOnTheNumberOfThreads();
    void aPointWithoutAnAnswerSaysWhy();
    void aStopLeavesTheFinishedPoints();
    void theReferenceCaseHasOneRebound();
    void aStringNeedsWhatTheRockGivesBack();
    void aStringThatIsARodNeedsWhatTheRodNeeds();
    void theGapsOfAStringAreNotTold();
    void alongAParameterOfAStringEveryPointIsABlow();
    void aStringThatStillMovesToTheRockNeedsWhatItsHammerHandsOn();
    void aConeNeedsWhatItsBlowNeeds();
    void aStopEndsTheStudy();
};

void TestThrust::thrustIsFrequencyTimesImpulse() {
    QCOMPARE(*thrustNeeded(drill(), 0.4), 50 * 40 * 1.4);
    // A piston brings its own impulse, all of its momentum where impedances match.
    Scenario piston = drill();
    piston.pulse.shape = PulseShape::piston;
    piston.pulse.piston.diameter = piston.rod.diameter;
    const double mass =
        piston.rod.density * M_PI / 4 * std::pow(piston.rod.diameter, 2) * piston.pulse.piston.length;
    QVERIFY(std::abs(*thrustNeeded(piston, 0) / (50 * mass * piston.pulse.piston.velocity) - 1) < 1e-12);
}

void TestThrust::whereThereIsNoThrustTheReasonSaysWhatToDo() {
    Scenario scenario = drill();
    QVERIFY(thrustProblem(scenario).isEmpty());
    scenario.drill.blowFrequency.reset();
    QVERIFY(!thrustNeeded(scenario, 0.4));
    QVERIFY(thrustProblem(scenario).text().find("drill.blow_frequency") != std::string::npos);
    scenario = drill();
    scenario.form = ScenarioForm::dimensionless;
    QVERIFY(!thrustNeeded(scenario, 0.4));
    QVERIFY(thrustProblem(scenario).text().find("physical units") != std::string::npos);
}

// theory §7, at these groups: e = 0.4067107 at no gap; the elastic worst is e = 1.4010825.
void TestThrust::theCasesAreThoseOfTheTheory() {
    const ThrustStudy study = studyThrust(drill());
    QCOMPARE(study.reason.text(), std::string());
    QVERIFY(std::abs(study.need(ThrustCase::scenario).cor.value - 0.40671074387478970) < 1e-12);
    QCOMPARE(study.need(ThrustCase::rigidRock).cor.value, 1.0);
    QVERIFY(std::abs(study.need(ThrustCase::elasticWorst).cor.value - 1.4010824845070556) < 1e-10);
    const GapCurve curve = gapCurve(problemOf(drill()), Detail::cor);
    QCOMPARE(study.need(ThrustCase::gapQuantile).cor.value,
             gapStatistics(curve).of(GapOutput::cor).uniform.quantiles[2].value);
    for (const ThrustNeed& need : study.feed.needs) {
        QCOMPARE(need.thrust, 50 * 40 * (1 + need.cor.value));
        QCOMPARE(need.thrustUndamped, 50 * 40 * (1 + 2 * need.cor.value));
    }
}

// The paper, section 6: with e = 1.4 some 20 % more thrust than for rigid rock.
void TestThrust::anElasticRockNeedsMoreThanARigidOne() {
    const ThrustStudy study = studyThrust(drill());
    const double ratio =
        study.need(ThrustCase::elasticWorst).thrust / study.need(ThrustCase::rigidRock).thrust;
    QVERIFY(std::abs(ratio - 1.2) < 0.005);
    QCOMPARE(&study.largestNeed(), &study.need(ThrustCase::elasticWorst));
}

void TestThrust::marginsAndFrequencyLimitFollowFromTheInstalledThrust() {
    Scenario scenario = drill();
    QVERIFY(!studyThrust(scenario).need(ThrustCase::rigidRock).margin);
    QVERIFY(!studyThrust(scenario).shareFull);
    scenario.drill.thrust = 5000;
    const ThrustStudy study = studyThrust(scenario);
    QCOMPARE(*study.need(ThrustCase::rigidRock).margin, 0.25);  // 4000 N needed
    QCOMPARE(*study.need(ThrustCase::rigidRock).frequencyLimit, 62.5);
    // At the limit the installed feed force is just what is needed.
    scenario.drill.blowFrequency = *study.need(ThrustCase::elasticWorst).frequencyLimit;
    QVERIFY(std::abs(*studyThrust(scenario).need(ThrustCase::elasticWorst).margin) < 1e-12);
}

// Required: 2813 N here, 2892 N by 95 % of gaps, 4000 N on rigid, 4802 N on the worst rock.
void TestThrust::theStateIsByTheLargestOfTheFour() {
    Scenario scenario = drill();
    const auto stateAt = [&](double thrust) {
        scenario.drill.thrust = thrust;
        return *studyThrust(scenario).feed.state();
    };
    QCOMPARE(stateAt(1900), FeedState::pushedBack);
    QCOMPARE(stateAt(2800), FeedState::belowRequired);
    QCOMPARE(stateAt(4200), FeedState::requiredAtThisGap);
    QCOMPARE(stateAt(4900), FeedState::requiredMet);
    QCOMPARE(stateAt(7700), FeedState::returnMet);  // 2000 (1 + 2 · 1.401) = 7604 N
}

void TestThrust::theMarginIsThatOfTheLargestNeed() {
    Scenario scenario = drill();
    QVERIFY(!studyThrust(scenario).margin());
    scenario.drill.thrust = 4200;
    const ThrustStudy study = studyThrust(scenario);
    QCOMPARE(*study.margin(), 4200 / study.need(ThrustCase::elasticWorst).thrust - 1);
    QVERIFY(*study.margin() < 0);
}

void TestThrust::weightAlongTheHoleCountsInEveryMargin() {
    Scenario scenario = drill();
    scenario.drill.thrust = 3000;
    scenario.drill.machineMass = 200;
    const ThrustStudy level = studyThrust(scenario);
    scenario.drill.inclination = 90;
    const ThrustStudy down = studyThrust(scenario);
    const double weight = (200 + propertiesOf(scenario.rod).mass) * 9.80665;
    for (const ThrustCase which : thrustCases) {
        QCOMPARE(*level.need(which).margin, 3000 / level.need(which).thrust - 1);
        QCOMPARE(*down.need(which).margin, (3000 + weight) / down.need(which).thrust - 1);
        QVERIFY(std::abs(*down.need(which).frequencyLimit / (50 * (3000 + weight) / down.need(which).thrust) -
                         1) < 1e-14);
    }
    QCOMPARE(level.feed.state(), FeedState::requiredAtThisGap);
    QCOMPARE(down.feed.state(), FeedState::requiredMet);
    QVERIFY(down.shareFull >= level.shareFull);
    // Up, a machine as heavy as that is not lifted at any frequency.
    scenario.drill.inclination = -90;
    scenario.drill.machineMass = 1000;
    QCOMPARE(*studyThrust(scenario).need(ThrustCase::rigidRock).frequencyLimit, 0.0);
    QCOMPARE(studyThrust(scenario).feed.state(), FeedState::pushedBack);
}

void TestThrust::aMarginOnItsOwnIsThatOfTheStudy() {
    Scenario scenario = drill(0.3);
    const auto margin = [&] {
        const Problem problem = problemOf(scenario);
        const Impact impact = ExactSolver().solve(problem, Detail::cor);
        return ThrustMargins().of(scenario, problem, {impact.cor, impact.corError}, {});
    };
    QVERIFY(!margin());
    scenario.drill.thrust = 4200;
    QCOMPARE(*margin(), *studyThrust(scenario).margin());
    scenario.drill.blowFrequency.reset();
    QVERIFY(!margin());
}

// A finder that has seen other rocks, rods and blows answers as a new one does.
void TestThrust::whatIsSharedBetweenCasesChangesNothing() {
    GapReboundFinder finder;
    const auto problemWith = [](double gamma, PulseShape shape, double gap) {
        Scenario scenario = drill(gamma);
        scenario.pulse.shape = shape;
        scenario.bitRock.gap = gap;
        return problemOf(scenario);
    };
    for (const Problem& problem :
         {problemWith(0.1, PulseShape::rectangular, 0), problemWith(0.3, PulseShape::rectangular, 0),
          problemWith(0.1, PulseShape::rectangular, 1e-3), problemWith(0.1, PulseShape::halfSine, 0),
          problemWith(0.3, PulseShape::rectangular, 0)}) {
        const GapRebounds shared = finder.of(problem, {}), own = GapReboundFinder().of(problem, {});
        QCOMPARE(shared.quantile.cor.value, own.quantile.cor.value);
        QCOMPARE(shared.worst.cor.value, own.worst.cor.value);
    }
}

void TestThrust::alongAParameterEveryPointIsAStudyOfItsOwn() {
    Scenario scenario = drill();
    scenario.drill.thrust = 4200;
    for (const char* key : {"drill.blow_frequency", "gamma", "drill.thrust"}) {
        const Parameter& parameter = *findParameter(key);
        const double here = *parameter.value(scenario);
        const std::vector<double> values{here / 2, here, here * 1.5};
        const ThrustCurve curve = thrustAlong(scenario, parameter, values, 1);
        QCOMPARE(curve.points.size(), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            Scenario one = scenario;
            parameter.assign(one, values[i]);
            const ThrustStudy study = studyThrust(one);
            QCOMPARE(curve.points[i].value, values[i]);
            QCOMPARE(curve.points[i].feed, study.feed);
            for (const ThrustCase which : thrustCases) {
                QCOMPARE(curve.points[i].need(which).thrust, study.need(which).thrust);
                QCOMPARE(curve.points[i].need(which).margin, study.need(which).margin);
            }
        }
    }
}

void TestThrust::pointsDoNotDependOnTheNumberOfThreads() {
    std::vector<double> values;
    for (int i = 1; i <= 12; ++i) values.push_back(i / 12.0);
    const Parameter& gamma = *findParameter("bit_rock.gamma");
    const ThrustCurve one = thrustAlong(drill(), gamma, values, 1),
                      four = thrustAlong(drill(), gamma, values, 4);
    QCOMPARE(four.points.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const ThrustCase which : thrustCases)
            QCOMPARE(one.points[i].need(which).thrust, four.points[i].need(which).thrust);
}

void TestThrust::aPointWithoutAnAnswerSaysWhy() {
    const std::vector<double> values{-1, 0.038};
    const ThrustCurve curve = thrustAlong(drill(), *findParameter("rod.diameter"), values, 2);
    QCOMPARE(curve.points.size(), std::size_t{2});
    QVERIFY(curve.points[0].reason.text().find("greater than 0") != std::string::npos);
    QVERIFY(curve.points[1].reason.isEmpty());
}

void TestThrust::aStopLeavesTheFinishedPoints() {
    std::stop_source stop;
    const std::vector<double> values(50, 0.5);
    const ThrustCurve curve = thrustAlong(drill(), *findParameter("bit_rock.gamma"), values, 1,
                                          stop.get_token(), [&](const ThrustCurve& soFar) {
                                              if (soFar.points.size() == 3) stop.request_stop();
                                          });
    QVERIFY(curve.stopped);
    QVERIFY(curve.points.size() >= 3 && curve.points.size() < values.size());
    for (const ThrustPoint& point : curve.points) QVERIFY(point.reason.isEmpty());
}

void TestThrust::theShareHeldIsTheShareOfGapsThatNeedLess() {
    Scenario scenario = drill(1);
    // Just enough for rigid rock: held at gaps with e ≤ 1 (theory §7).
    scenario.drill.thrust = *thrustNeeded(scenario, 1);
    QVERIFY(std::abs(*studyThrust(scenario).shareFull - (1 - 0.548346)) < 5.1e-7);
    scenario.drill.thrust = *thrustNeeded(scenario, 0.84);
    QCOMPARE(*studyThrust(scenario).shareFull, 0.0);
    scenario.drill.thrust = *thrustNeeded(scenario, 1.41);
    QCOMPARE(*studyThrust(scenario).shareFull, 1.0);
}

void TestThrust::theReferenceCaseHasOneRebound() {
    Scenario scenario = drill();
    scenario.pulse.shape = PulseShape::rigidBody;
    const ThrustStudy study = studyThrust(scenario);
    QCOMPARE(study.need(ThrustCase::gapQuantile).cor.value, study.need(ThrustCase::scenario).cor.value);
}

void TestThrust::aStopEndsTheStudy() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(studyThrust(drill(), stop.get_token()).stopped);
}

// A file of results is not to wait for minutes.
void TestThrust::theMarginOfAHeavyBlowIsLeftOut() {
    Scenario scenario;
    scenario.drill.blowFrequency = 60;
    scenario.drill.thrust = 8000;
    Blow light = solveBlow(scenario, {}, Detail::summary);
    addThrustMargin(light);
    QVERIFY(light.thrustMargin());
    scenario.bitRock.stiffness /= 1e8;
    scenario.bitRock.gamma = 0.01;
    Blow heavy = solveBlow(scenario, {}, Detail::summary);
    QVERIFY(heavy.isSolved());
    addThrustMargin(heavy);
    QVERIFY(!heavy.thrustMargin());
    QCOMPARE(studyThrust(scenario, {}, {}, mostPiecesInPassing).reason.text(), std::string(tooManyPieces));
}

// Nothing else pushes a string without losses: what the hammer hands on and the rebound come from the rock.
void TestThrust::aStringNeedsWhatTheRockGivesBack() {
    Scenario scenario = t38String();
    const Blow blow = solveBlow(scenario, {}, Detail::ledger);
    const Impact& impact = blow.impact;
    const double perUnit = pulseImpulse(scenario) / impact.hammerImpulse, frequency = 60;
    const ThrustStudy study = studyThrust(scenario);
    QCOMPARE(study.reason.text(), std::string());
    const ThrustNeed& here = study.need(ThrustCase::scenario);
    QVERIFY(std::abs(here.thrust / (frequency * perUnit * impact.impulse) - 1) < 1e-9);
    // Momentum of the hammer before less after.
    const double handedOn = impact.hammerImpulse - impact.hammerMomentum;
    QVERIFY(std::abs(study.feed.balance / (frequency * perUnit * handedOn) - 1) < 1e-9);
    QVERIFY(std::abs(here.thrustUndamped + study.feed.balance - 2 * here.thrust) < 1e-6);
    QVERIFY(std::abs(study.need(ThrustCase::rigidRock).thrust / study.feed.balance - 2) < 1e-12);
    // One judgement for command, result panel and alerts.
    QCOMPARE(study.feed, *blow.feed);
    QCOMPARE(*findOutput("thrust")->value({blow.summary, scenario}), here.thrust);
    scenario.drill.thrust = 1.25 * here.thrust;
    QVERIFY(std::abs(*studyThrust(scenario).need(ThrustCase::scenario).margin - 0.25) < 1e-9);
    scenario.drill.thrust = 0.9 * study.feed.balance;
    QCOMPARE(studyThrust(scenario).feed.state(), FeedState::pushedBack);
}

// strings §10: one rod, a hammer of its section, withdrawn after its push.
void TestThrust::aStringThatIsARodNeedsWhatTheRodNeeds() {
    Scenario rod = drill();
    rod.drill.thrust = 3000;
    const RodProperties properties = propertiesOf(rod.rod);
    Section section;
    section.length = rod.rod.length;
    section.diameter = rod.rod.diameter;
    section.bore = rod.rod.bore;
    Scenario string = rod;
    string.form = ScenarioForm::string;
    string.drillString.material = {rod.rod.youngsModulus, rod.rod.density};
    string.drillString.parts = {{.sections = {section}}};
    section.length = rod.pulse.duration / 2 * properties.waveSpeed;
    string.drillString.hammer.sections = {section};
    string.drillString.hammer.velocity = 40 / (section.length * rod.rod.density * properties.area);
    string.drillString.hammer.restrike = false;
    const ThrustStudy of = studyThrust(string), than = studyThrust(rod);
    for (const ThrustCase which : {ThrustCase::scenario, ThrustCase::rigidRock}) {
        const ThrustNeed &a = of.need(which), &b = than.need(which);
        QVERIFY(std::abs(a.cor.value - b.cor.value) < 1e-9);
        QVERIFY(std::abs(a.thrust / b.thrust - 1) < 1e-9);
        QVERIFY(std::abs(a.thrustUndamped / b.thrustUndamped - 1) < 1e-9);
        QVERIFY(std::abs(*a.margin - *b.margin) < 1e-9);
        QCOMPARE(a.gapAtBlow->motion.kind, b.gapAtBlow->motion.kind);
        QVERIFY(std::abs(a.gapAtBlow->gap - b.gapAtBlow->gap) < 1e-9 * (1 + b.gapAtBlow->gap));
        QVERIFY(std::abs(a.gapAtBlow->inD0 - b.gapAtBlow->inD0) < 1e-7 * (1 + b.gapAtBlow->inD0));
    }
    QVERIFY(than.need(ThrustCase::scenario).gapAtBlow->gap > 0);  // so that the last two say something
}

void TestThrust::theGapsOfAStringAreNotTold() {
    Scenario scenario = t38String();
    scenario.drill.thrust = 10e3;
    const ThrustStudy study = studyThrust(scenario);
    QVERIFY(study.need(ThrustCase::scenario).known && study.need(ThrustCase::rigidRock).known);
    QVERIFY(!study.need(ThrustCase::gapQuantile).known && !study.need(ThrustCase::elasticWorst).known);
    QCOMPARE(&study.largestNeed(), &study.need(ThrustCase::rigidRock));
    QVERIFY(!study.margin());
    QVERIFY(!study.shareFull);
}

void TestThrust::alongAParameterOfAStringEveryPointIsABlow() {
    const Scenario scenario = t38String();
    const Parameter& stiffness = *findParameter("bit_rock.stiffness");
    const std::vector<double> values{5e7, 1e8, 2e8};
    const ThrustCurve curve = thrustAlong(scenario, stiffness, values, 2);
    QCOMPARE(curve.points.size(), values.size());
    for (const ThrustPoint& point : curve.points) {
        QCOMPARE(point.reason.text(), std::string());
        Scenario alone = scenario;
        stiffness.assign(alone, point.value);
        const ThrustStudy study = studyThrust(alone);
        QVERIFY(std::abs(point.need(ThrustCase::scenario).thrust / study.need(ThrustCase::scenario).thrust -
                         1) < 1e-6);  // quick and sure
        QCOMPARE(point.feed.state(), study.feed.state());
    }
    QVERIFY(curve.points[2].need(ThrustCase::scenario).thrust >
            curve.points[0].need(ThrustCase::scenario).thrust);
}

// What has not come back yet will not ask for less than nothing.
void TestThrust::aStringThatStillMovesToTheRockNeedsWhatItsHammerHandsOn() {
    const Scenario scenario = t38String();
    const double handedOn = 60 * pulseImpulse(scenario) * 1.1;
    QCOMPARE(*thrustNeeded(scenario, -0.2, 1.1), handedOn);
    const FeedEstimate feed = *feedEstimate(scenario, {-0.2, 0}, 1.1);
    QCOMPARE(feed.need(ThrustCase::scenario).thrust, feed.balance);
}

// A section that is not uniform was one uniform piece to the study, and many to the blow.
void TestThrust::aConeNeedsWhatItsBlowNeeds() {
    Scenario scenario = t38String();
    Section& adapter = scenario.drillString.parts.front().sections.front();
    adapter.endDiameter = 2 * adapter.diameter;
    const Blow blow = solveBlow(scenario, {}, Detail::ledger);
    QVERIFY(blow.isSolved());
    const Impact piece = NetworkSolver().solve(problemOf(scenario), {});
    QVERIFY(std::abs(piece.cor - blow.summary.cor) > 100 * blow.summary.corError);
    const ThrustNeed need = studyThrust(scenario).need(ThrustCase::scenario);
    QVERIFY(std::abs(need.cor.value - blow.summary.cor) <= blow.summary.corError + need.cor.error);
    const std::array values{*scenario.drill.blowFrequency};
    const ThrustCurve curve = thrustAlong(scenario, *findParameter("drill.blow_frequency"), values, 1);
    QVERIFY(std::abs(curve.points[0].need(ThrustCase::scenario).thrust / need.thrust - 1) < 1e-3);  // quick
}

QTEST_GUILESS_MAIN(TestThrust)
#include "tests/support/lossless_string.h"
#include "tst_thrust.moc"
