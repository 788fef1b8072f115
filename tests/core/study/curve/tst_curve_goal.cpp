// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of a parameter give an output: all of them, solved for, and nothing where there is none.
#include <QTest>

#include <cmath>

#include "core/numeric/piecewise_fit.h"
#include "core/report/goal_report.h"
#include "core/study/curve/curve.h"
#include "core/study/curve/goal_brackets.h"
#include "core/study/curve/sampled_curve.h"
#include "core/study/rows/case_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario.h"

using namespace drillwave;

namespace {

using Kind = GoalPlace::Kind;

Scenario dimensionless(const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = PulseShape::rectangular;
    scenario.groups = groups;
    return scenario;
}

Scenario example(const char* name) {
    return parseScenario(findExample(name)->text, name).scenario;
}

CurveQuestion question(const Scenario& base, const char* along, const char* output, double goal) {
    return {.base = base,
            .along = parseRange(along).axis,
            .family = {},
            .columns = chooseOutputs(output, OutputUnits::dimensionless).columns,
            .levels = {},
            .goal = goal};
}

CurveQuestion sampled(const Scenario& base, const char* along, const char* output, double goal) {
    CurveQuestion asked = question(base, "beta=1:2", output, goal);
    asked.along = parseAxis(along).axis;
    return asked;
}

const GoalAnswer& answerOf(const CurveStudy& study) {
    if (study.lines.size() != 1 || !study.lines.front().goal) qFatal("one answer expected");
    return *study.lines.front().goal;
}

GoalAnswer answerTo(const CurveQuestion& asked) {
    return answerOf(studyCurve(asked, 2));
}

/// Returns the result of another solver for the scenario with that value.
double solvedBy(Method method, const CurveQuestion& asked, double x) {
    Scenario scenario = asked.base;
    if (!asked.along.assign(scenario, x).isEmpty()) qFatal("no such value");
    MethodChoice choice;
    choice.method = method;
    CaseSolver solver(asked.columns, choice, asked.workLimit);
    solver.setPulse(scenario);
    double value = 0;
    if (!solver.solve(scenario, {&value, 1}, {}).isEmpty()) qFatal("not solved");
    return value;
}

FitPiece line(double start, double end, double first, double last, double error = 1e-10) {
    FitPiece piece;
    piece.start = start;
    piece.end = end;
    const double ends[] = {first, last};
    piece.outputs.emplace_back(start, end, ends);
    piece.error = {error};
    return piece;
}

}  // namespace

class TestCurveGoal : public QObject {
    Q_OBJECT

  private slots:
    void aCurveIsAtAGoalOnceForEachTimeItComesThere();
    void aCurveThatStaysAtAGoalIsThereOnce();
    void whatLiesBehindAStretchWithoutAnswerIsNotJoined();
    void everyValueThatGivesTheGoalIsFound();
    void theClosedFormAgrees();
    void theLargestValueIsTouched();
    void theEndOfTheRangeCounts();
    void beyondWhatThereIsTheNearestIsTold();
    void goalIsNotFoundAtJump();
    void everyLineOfAFamilyHasItsOwn();
    void goalsAreInTheUnitOfTheColumn();
    void ofErrorsNoPlaceIsClaimed();
    void manyBlowsAreLeftBetweenPoints();
    void pointsOfAStringAreClosedIn();
    void betweenWholeNumbersThereIsNothing();
    void threadsChangeNothing();
    void aStopEndsTheWork();
};

void TestCurveGoal::aCurveIsAtAGoalOnceForEachTimeItComesThere() {
    const std::vector<FitPiece> pieces{line(0, 0.25, 0, 1), line(0.25, 0.5, 1, 0), line(0.5, 1, 0, 0.5)};
    const std::vector<MonotoneSegment> segments = segmentsOf(pieces, 0);
    const std::vector<GoalBracket> half = goalBrackets(segments, 0.25);
    QCOMPARE(half.size(), 3u);
    const double places[] = {0.0625, 0.4375, 0.75};
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(std::abs(half[i].share.value - places[i]) <= half[i].share.error);
        QVERIFY(half[i].share.error < 1e-9 && half[i].isPassed());
    }
    QVERIFY(half[0].before < 0 && half[1].before > 0);
    const std::vector<GoalBracket> top = goalBrackets(segments, 1);
    QCOMPARE(top.size(), 1u);
    QVERIFY(top[0].before == -1 && top[0].after == -1 && std::abs(top[0].share.value - 0.25) < 1e-9);
    const std::vector<GoalBracket> last = goalBrackets(segments, 0.5);
    QCOMPARE(last.size(), 3u);
    QVERIFY(last[2].before == -1 && last[2].after == 0 && last[2].share.value == 1);
    QVERIFY(goalBrackets(segments, 2).empty());
    QCOMPARE(nearestTo(segments, 2).value.value, 1.0);
    QCOMPARE(nearestTo(segments, 2).share.value, 0.25);
}

void TestCurveGoal::aCurveThatStaysAtAGoalIsThereOnce() {
    const std::vector<FitPiece> pieces{line(0, 0.2, 0, 1), line(0.2, 0.6, 1, 1), line(0.6, 1, 1, 2)};
    const std::vector<GoalBracket> found = goalBrackets(segmentsOf(pieces, 0), 1);
    QCOMPARE(found.size(), 1u);
    QVERIFY(found[0].isPassed());
    QVERIFY(std::abs(found[0].share.value - 0.4) < 1e-8 && std::abs(found[0].share.error - 0.2) < 1e-8);
    const std::vector<FitPiece> all{line(0, 1, 1, 1)};
    const std::vector<GoalBracket> everywhere = goalBrackets(segmentsOf(all, 0), 1);
    QCOMPARE(everywhere.size(), 1u);
    QVERIFY(everywhere[0].before == 0 && everywhere[0].after == 0);
}

void TestCurveGoal::whatLiesBehindAStretchWithoutAnswerIsNotJoined() {
    FitPiece none = line(0.4, 0.6, 0, 0);
    none.solved = false;
    const std::vector<FitPiece> pieces{line(0, 0.4, 0, 1), none, line(0.6, 1, 3, 4)};
    QVERIFY(goalBrackets(segmentsOf(pieces, 0), 2).empty());
    // Side by side it leaps.
    const std::vector<FitPiece> beside{line(0, 0.5, 0, 1), line(0.5, 1, 3, 4)};
    const std::vector<GoalBracket> leap = goalBrackets(segmentsOf(beside, 0), 2);
    QCOMPARE(leap.size(), 1u);
    QVERIFY(leap[0].isPassed() && leap[0].valueFrom == 1 && leap[0].valueTo == 3);
}

// theory §7: half a unit of the last digit that is given there.
void TestCurveGoal::everyValueThatGivesTheGoalIsFound() {
    const CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "delta=0:1.2", "cor", 1);
    const GoalAnswer answer = answerTo(asked);
    QCOMPARE(answer.places.size(), 2u);
    QVERIFY(answer.isComplete && answer.isReached() && !answer.nearest);
    QVERIFY(std::abs(answer.places[0].x.value - 0.326877) < 5e-7 && !answer.places[0].rising);
    QVERIFY(std::abs(answer.places[1].x.value - 0.778532) < 5e-7 && answer.places[1].rising);
    for (const GoalPlace& place : answer.places) {
        QCOMPARE(place.kind, Kind::crossing);
        QVERIFY(place.x.error > 0 && place.x.error < 1e-9);
        // slopes of e over δ are about 1
        QVERIFY(std::abs(solvedBy(Method::exact, asked, place.x.value) - 1) < 1e-11);
        QVERIFY(std::abs(place.value.value - 1) < 1e-11);
    }
}

// The paper's analytical solution, which is another solver, says the same of each place.
void TestCurveGoal::theClosedFormAgrees() {
    const CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=1:10", "cor", 1.1);
    const GoalAnswer answer = answerTo(asked);
    QCOMPARE(answer.places.size(), 1u);
    // its own bound is 2e-15 there
    QVERIFY(std::abs(solvedBy(Method::closedForm, asked, answer.places[0].x.value) - 1.1) < 1e-11);
}

void TestCurveGoal::theLargestValueIsTouched() {
    CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=0.1:10:log", "cor", 1);
    const CurveStudy study = studyCurve(asked, 1);
    const CurveFeature largest = *study.lines[0].outputs[0].extreme(CurveFeature::Kind::maximum);
    asked.goal = largest.value.value;
    const GoalAnswer top = answerTo(asked);
    QCOMPARE(top.places.size(), 1u);
    QCOMPARE(top.places[0].kind, Kind::touch);
    QVERIFY(std::abs(top.places[0].x.value - largest.x.value) < largest.x.error + top.places[0].x.error);
    QVERIFY(top.places[0].x.error < 1e-4);  // a maximum is known to the root of what its value is
    // A little less is given on both sides of it.
    asked.goal = largest.value.value - 1e-6;
    const GoalAnswer below = answerTo(asked);
    QCOMPARE(below.places.size(), 2u);
    QVERIFY(below.places[0].x.value < largest.x.value && below.places[1].x.value > largest.x.value);
    asked.goal = largest.value.value + 1e-6;
    QVERIFY(!answerTo(asked).isReached());
}

void TestCurveGoal::theEndOfTheRangeCounts() {
    CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=0.5:5", "cor", 1);
    asked.goal = solvedBy(Method::exact, asked, 0.5);
    const GoalAnswer answer = answerTo(asked);
    QVERIFY(!answer.places.empty());
    QCOMPARE(answer.places.front().kind, Kind::end);
    QCOMPARE(answer.places.front().x.value, 0.5);
    QVERIFY(answer.places.front().x.error < 1e-8);
}

void TestCurveGoal::beyondWhatThereIsTheNearestIsTold() {
    const CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=0.1:10:log", "cor", 2);
    const CurveStudy study = studyCurve(asked, 1);
    const GoalAnswer& answer = answerOf(study);
    QVERIFY(answer.places.empty() && answer.isComplete && !answer.isReached() && !study.isReached());
    QVERIFY(answer.nearest);
    // theory §7
    QVERIFY(std::abs(answer.nearest->value.value - 1.4140683) < 5e-8);
    QVERIFY(std::abs(answer.nearest->x.value - 0.29983) < 5e-6);
    const std::vector<Message> problems = goalProblems(study);
    QCOMPARE(problems.size(), 1u);
    QCOMPARE(problems[0].text(),
             std::string("no beta from 0.1 to 10 gives cor = 2: the nearest is 1.4140683, at "
                         "0.29982658"));
}

// As in aSeparationTimeJumps() of the curve: another contact, a round trip later.
void TestCurveGoal::goalIsNotFoundAtJump() {
    CurveQuestion asked = question(dimensionless({0.5, 0.01, 10, 0}), "beta=0.3:1", "separation_time", 0);
    const CurveStudy study = studyCurve(asked, 1);
    CurveFeature jump;
    for (const CurveFeature& feature : study.lines[0].outputs[0].features)
        if (feature.kind == CurveFeature::Kind::jump) jump = feature;
    QVERIFY(std::abs(jump.valueAfter - jump.value.value) > 19);
    asked.goal = (jump.value.value + jump.valueAfter) / 2;
    const GoalAnswer answer = answerTo(asked);
    QCOMPARE(answer.places.size(), 1u);
    const GoalPlace& place = answer.places[0];
    QCOMPARE(place.kind, Kind::jump);
    QVERIFY(std::abs(place.x.value - jump.x.value) <= place.x.error + jump.x.error);
    QVERIFY(std::abs(place.value.value - jump.value.value) < 1e-6);
    QVERIFY(std::abs(place.valueAfter - jump.valueAfter) < 1e-6);
    QVERIFY(!answer.isReached() && answer.nearest && answer.isComplete);
    const double off = std::abs(answer.nearest->value.value - *asked.goal);
    QVERIFY(std::abs(off - std::abs(jump.valueAfter - jump.value.value) / 2) < 1e-6);
    QVERIFY(goalProblems(studyCurve(asked, 1))[0].text().find("jumps over") != std::string::npos);
}

void TestCurveGoal::everyLineOfAFamilyHasItsOwn() {
    CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=0.1:10:log", "cor", 1.1);
    asked.family = parseAxis("gamma=0.01,1").axis;
    const CurveStudy study = studyCurve(asked, 2);
    QVERIFY(!study.lines[0].goal->isReached());  // rock that gives nothing back
    QVERIFY(study.lines[1].goal->isReached());
    QVERIFY(!study.isReached());
    const std::vector<Message> problems = goalProblems(study);
    QCOMPARE(problems.size(), 1u);
    QVERIFY(problems[0].text().starts_with("gamma = 0.01: no beta from 0.1 to 10 gives cor = 1.1"));
    QVERIFY(goalCsv(study).starts_with("goal,kind,direction,gamma,beta,place_error,cor,value_error,"));
}

void TestCurveGoal::goalsAreInTheUnitOfTheColumn() {
    CurveQuestion asked = question(Scenario{}, "bit_rock.stiffness=20MN/m:500MN/m:log", "peak_force", 0.9);
    const GoalAnswer plain = answerTo(asked);
    QVERIFY(plain.isReached());
    asked.columns = chooseOutputs("peak_force", OutputUnits::si).columns;
    asked.goal = 0.9 * scalesOf(asked.base).force;
    const GoalAnswer si = answerTo(asked);
    QCOMPARE(si.places.size(), plain.places.size());
    for (std::size_t i = 0; i < si.places.size(); ++i)
        QVERIFY(std::abs(si.places[i].x.value - plain.places[i].x.value) <
                2 * (si.places[i].x.error + plain.places[i].x.error));
}

// They are as large as what is known of them.
void TestCurveGoal::ofErrorsNoPlaceIsClaimed() {
    CurveQuestion asked = question(dimensionless({0.5, 0.1, 10, 0}), "beta=0.1:10:log", "cor_error", 0);
    const CurveStudy study = studyCurve(asked, 1);
    const CurveOutput& output = study.lines[0].outputs[0];
    asked.goal = (output.extreme(CurveFeature::Kind::minimum)->value.value +
                  output.extreme(CurveFeature::Kind::maximum)->value.value) /
                 2;
    const CurveStudy sought = studyCurve(asked, 1);
    const GoalAnswer& answer = answerOf(sought);
    QVERIFY(!answer.places.empty() && !answer.isComplete);
    for (const GoalPlace& place : answer.places) QVERIFY(place.kind != Kind::crossing);
    QVERIFY(goalText(asked, sought.lines[0]).find("There may be others") != std::string::npos);
}

// Takes few points, each of which is a march.
void TestCurveGoal::manyBlowsAreLeftBetweenPoints() {
    Scenario base = example("t38_medium_rock");
    base.drill.blows = 40;
    base.drill.settle = 10;
    CurveQuestion asked = sampled(base, "drill.thrust=4kN:8kN:3", "drill_penetration", 0);
    const CurveStudy points = sampleCurve(asked, 2);
    const std::vector<double>& values = points.lines[0].values[0];
    QVERIFY(values[0] != values[2]);
    asked.goal = values[0] / 2 + values[2] / 2;
    const GoalAnswer answer = answerOf(sampleCurve(asked, 2));
    QVERIFY(!answer.places.empty() && !answer.isComplete);
    for (const GoalPlace& place : answer.places) QCOMPARE(place.kind, Kind::between);
}

void TestCurveGoal::pointsOfAStringAreClosedIn() {
    CurveQuestion asked =
        sampled(example("t38_string"), "string.coupling.diameter=45mm:65mm:9", "efficiency", 0);
    const CurveLine points = sampleCurve(asked, 2).lines.front();
    asked.goal = points.values[0][3] / 2 + points.values[0][4] / 2;
    const CurveStudy study = sampleCurve(asked, 2);
    const GoalAnswer& answer = answerOf(study);
    QVERIFY(answer.isReached() && !answer.isComplete);
    const auto found = std::ranges::find_if(answer.places, [&](const GoalPlace& place) {
        return place.x.value > points.points[3] && place.x.value < points.points[4];
    });
    QVERIFY(found != answer.places.end());
    QCOMPARE(found->kind, Kind::crossing);
    QVERIFY(found->x.error < 1e-6 * found->x.value);
    const double there = solvedBy(Method::exact, asked, found->x.value);
    QVERIFY(std::abs(there - *asked.goal) < 1e-8);
    QVERIFY(study.solves > 9 && study.solves < 60);
}

void TestCurveGoal::betweenWholeNumbersThereIsNothing() {
    CurveQuestion asked = sampled(example("t38_string"), "string.repeat=1:4:4", "efficiency", 0);
    const std::vector<double> values = sampleCurve(asked, 1).lines[0].values[0];
    asked.goal = values[1] / 2 + values[2] / 2;
    const GoalAnswer answer = answerOf(sampleCurve(asked, 1));
    QCOMPARE(answer.places.size(), 1u);
    QCOMPARE(answer.places[0].kind, Kind::jump);
    QVERIFY(!answer.isReached() && answer.nearest);
    QVERIFY(answer.nearest->x.value == 2 || answer.nearest->x.value == 3);
    asked.goal = values[1];
    const GoalAnswer met = answerOf(sampleCurve(asked, 1));
    QVERIFY(met.isReached());
    QCOMPARE(met.places[0].x.value, 2.0);
}

void TestCurveGoal::threadsChangeNothing() {
    CurveQuestion asked = question(dimensionless({0.5, 0.3, 2, 0.3}), "beta=0.05:10:log", "cor", 0.5);
    asked.family = parseAxis("gamma=0.1,0.3,1").axis;
    const CurveStudy one = studyCurve(asked, 1);
    QVERIFY(goalCsv(one).size() > 200);
    for (const int jobs : {2, 5}) {
        const CurveStudy many = studyCurve(asked, jobs);
        QCOMPARE(goalCsv(many), goalCsv(one));
        QCOMPARE(many.solves, one.solves);
    }
}

void TestCurveGoal::aStopEndsTheWork() {
    std::stop_source stop;
    stop.request_stop();
    const CurveQuestion asked = question(dimensionless({0.5, 1, 10, 0}), "beta=0.1:10:log", "cor", 1);
    const CurveStudy study = studyCurve(asked, 2, stop.get_token());
    QVERIFY(study.stopped && study.lines.empty() && !study.isReached());
}

QTEST_GUILESS_MAIN(TestCurveGoal)
#include "tst_curve_goal.moc"
