// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of drill strings by points: the rows of a sweep, coarse points first.
#include <QTest>

#include "core/study/curve/sampled_curve.h"
#include "core/study/rows/sweep.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/sweep.h"

using namespace drillwave;

namespace {

Scenario exampleString() {
    return parseScenario(findExample("t38_string")->text, "t38_string").scenario;
}

CurveQuestion question(const char* along, const char* family = nullptr) {
    CurveQuestion asked;
    asked.base = exampleString();
    asked.along = parseAxis(along).axis;
    if (family) asked.family = parseAxis(family).axis;
    asked.columns = {{findOutput("efficiency")}, {findOutput("peak_force"), OutputUnits::si}};
    return asked;
}

/// The numbers of a sweep, row after row.
struct Rows : RowSink {
    bool begin(const RowHeader&) override { return true; }
    bool take(const RowBlock& block, std::string_view) override {
        for (std::size_t i = 0; i < block.size(); ++i) rows.emplace_back(block[i].begin(), block[i].end());
        return true;
    }
    std::vector<std::vector<double>> rows;
};

}  // namespace

class TestSampledCurve : public QObject {
    Q_OBJECT

  private slots:
    void theLinesAreTheRowsOfTheSweep();
    void wholeNumbersAreGoneAlong();
    void coarseLinesComeFirstAndHaveTheSamePoints();
    void extremesAreThoseOfThePoints();
    void constantOutputHasNoExtremum();
    void aRangeThatIsNoneIsRefused();
    void aStopEndsIt();
};

void TestSampledCurve::theLinesAreTheRowsOfTheSweep() {
    const CurveQuestion asked =
        question("bit_rock.stiffness=20 MN/m:400 MN/m:21:log", "hammer.velocity=8 m/s,11 m/s");
    QVERIFY(sampledProblemsOf(asked).empty());
    Rows swept;
    runSweep({.base = asked.base, .axes = asked.axes(), .columns = asked.columns, .shard = {}}, 1, {}, swept,
             [](const RowCounts&) {});
    for (const int jobs : {1, 3}) {
        const CurveStudy study = sampleCurve(asked, jobs);
        QCOMPARE(study.lines.size(), std::size_t{2});
        std::size_t row = 0;
        for (const CurveLine& line : study.lines) {
            QCOMPARE(line.points.size(), std::size_t{21});
            for (std::size_t i = 0; i < line.points.size(); ++i, ++row) {
                QCOMPARE(*line.family, swept.rows[row][0]);
                QCOMPARE(line.points[i], swept.rows[row][1]);
                QCOMPARE(line.values[0][i], swept.rows[row][2]);
                QCOMPARE(line.values[1][i], swept.rows[row][3]);
            }
        }
        QCOMPARE(row, swept.rows.size());
        QVERIFY(study.isComplete());
    }
}

void TestSampledCurve::wholeNumbersAreGoneAlong() {
    const CurveStudy study = sampleCurve(question("string.repeat=1:4:4"), 1);
    QCOMPARE(study.lines.front().points, (std::vector<double>{1, 2, 3, 4}));
    // Couplings reflect: each further rod costs.
    const std::vector<double>& efficiency = study.lines.front().values.front();
    for (std::size_t i = 1; i < efficiency.size(); ++i) QVERIFY(efficiency[i] < efficiency[i - 1]);
}

void TestSampledCurve::coarseLinesComeFirstAndHaveTheSamePoints() {
    const CurveQuestion asked = question("hammer.1.diameter=40 mm:60 mm:33");
    std::vector<CurveStudy> previews;
    std::size_t told = 0, of = 0;
    SampledProgress progress;
    progress.show = [&](CurveStudy soFar) { previews.push_back(std::move(soFar)); };
    progress.tell = [&](std::size_t done, std::size_t all) {
        QVERIFY(done > told);
        told = done;
        of = all;
    };
    const CurveStudy study = sampleCurve(asked, 2, {}, progress);
    QCOMPARE(told, std::size_t{33});
    QCOMPARE(of, std::size_t{33});
    QCOMPARE(previews.size(), std::size_t{3});
    const CurveLine& whole = study.lines.front();
    std::size_t stride = 8;
    for (const CurveStudy& preview : previews) {
        const CurveLine& line = preview.lines.front();
        QCOMPARE(line.points.size(), 32 / stride + 1);
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            QCOMPARE(line.points[i], whole.points[i * stride]);
            QCOMPARE(line.values[0][i], whole.values[0][i * stride]);
        }
        stride /= 2;
    }
}

void TestSampledCurve::extremesAreThoseOfThePoints() {
    const CurveStudy study = sampleCurve(question("bit_rock.stiffness=20 MN/m:800 MN/m:40:log"), 2);
    const CurveLine& line = study.lines.front();
    const std::vector<double>& values = line.values.front();
    const CurveFeature* largest = line.outputs.front().extreme(CurveFeature::Kind::maximum);
    QVERIFY(largest);
    QCOMPARE(largest->shape, CurveFeature::Shape::grid);
    QCOMPARE(largest->value.value, *std::ranges::max_element(values));
    const auto at = std::size_t(std::ranges::max_element(values) - values.begin());
    QCOMPARE(largest->x.value, line.points[at]);
    // Between points it is straight.
    const double middle =
        line.range.at((line.range.shareOf(line.points[at - 1]) + line.range.shareOf(line.points[at])) / 2);
    QVERIFY(std::abs(*line.value(middle, 0) - (values[at - 1] + values[at]) / 2) < 1e-12);
    const CurveFeature* least = line.outputs.front().extreme(CurveFeature::Kind::minimum);
    QCOMPARE(least->shape, CurveFeature::Shape::end);  // soft rock
}

// No ratio depends on the velocity of impact (strings §9).
void TestSampledCurve::constantOutputHasNoExtremum() {
    const CurveStudy study = sampleCurve(question("hammer.velocity=5 m/s:15 m/s:5"), 1);
    const CurveOutput& efficiency = study.lines.front().outputs.front();
    QCOMPARE(efficiency.extreme(CurveFeature::Kind::maximum)->shape, CurveFeature::Shape::everywhere);
    const CurveOutput& force = study.lines.front().outputs.back();
    QCOMPARE(force.extreme(CurveFeature::Kind::maximum)->shape, CurveFeature::Shape::end);
}

void TestSampledCurve::aRangeThatIsNoneIsRefused() {
    QVERIFY(!sampledProblemsOf(question("bit_rock.stiffness=400 MN/m:20 MN/m:5")).empty());
    QVERIFY(!sampledProblemsOf(question("bit_rock.stiffness=20 MN/m,40 MN/m")).empty());
    // A bore of 14.5 mm does not fit.
    QVERIFY(!sampledProblemsOf(question("string.coupling.diameter=10 mm:14 mm:5")).empty());
    QVERIFY(!sampledProblemsOf(question("string.cupling.diameter=30 mm:56 mm:5")).empty());
}

void TestSampledCurve::aStopEndsIt() {
    std::stop_source stop;
    SampledProgress progress;
    progress.tell = [&](std::size_t done, std::size_t) {
        if (done == 3) stop.request_stop();
    };
    const CurveStudy study =
        sampleCurve(question("hammer.1.diameter=40 mm:60 mm:33"), 1, stop.get_token(), progress);
    QVERIFY(study.stopped);
    QVERIFY(study.lines.empty());
}

QTEST_APPLESS_MAIN(TestSampledCurve)
#include "tst_sampled_curve.moc"
