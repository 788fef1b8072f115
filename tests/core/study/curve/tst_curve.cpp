// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs along a parameter: what the solver says at every point, features where they are, in bounded work.
#include <QTest>

#include <cmath>
#include <random>

#include "core/model/parameter_text.h"
#include "core/report/curve_report.h"
#include "core/study/curve/curve.h"
#include "core/study/curve/curve_sampler.h"
#include "core/text/units.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario.h"
#include "tests/support/tries.h"

using namespace drillwave;

namespace {

using Kind = CurveFeature::Kind;
using Shape = CurveFeature::Shape;

Scenario dimensionless(PulseShape shape, const Groups& groups) {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    scenario.pulse.shape = shape;
    scenario.groups = groups;
    return scenario;
}

CurveQuestion question(const Scenario& base, const char* along, const char* outputs = "cor") {
    return {.base = base,
            .along = parseRange(along).axis,
            .family = {},
            .columns = chooseOutputs(outputs, OutputUnits::dimensionless).columns,
            .levels = {}};
}

CurveQuestion question(PulseShape shape, const Groups& groups, const char* along,
                       const char* outputs = "cor") {
    return question(dimensionless(shape, groups), along, outputs);
}

const CurveLine& onlyLine(const CurveStudy& study) {
    if (study.lines.size() != 1) qFatal("one line expected");
    return study.lines.front();
}

std::vector<CurveFeature> ofKind(const CurveOutput& output, Kind kind) {
    std::vector<CurveFeature> found;
    for (const CurveFeature& feature : output.features)
        if (feature.kind == kind) found.push_back(feature);
    return found;
}

bool isNear(double value, double expected, double tolerance) {
    return std::abs(value - expected) <= tolerance;
}

}  // namespace

class TestCurve : public QObject {
    Q_OBJECT

  private slots:
    void theLargestReboundOfAnElasticSpringNeedsNoGrid();
    void theReferenceCaseHasItsLeastRebound();
    void theGapHasACuspAtAWholeNumberAndPassesOne();
    void valuesAreWhatTheSolverSays_data();
    void valuesAreWhatTheSolverSays();
    void randomScenesAreWhatTheSolverSays();
    void aPeakForceTurnsWhereTheGreatestPeakChanges();
    void aSeparationTimeJumps();
    void aLevelThatIsJumpedOverIsNotCrossed_data();
    void aLevelThatIsJumpedOverIsNotCrossed();
    void crossingsHaveTheirLevelAndNoJumpIsMissed();
    void aLogarithmicRangeFindsTheSameFeatures();
    void aLineOfAFamilyIsTheCurveOfItsValue();
    void aFamilyOfShapesIsALineEach();
    void extremesAreAmongThePoints();
    void oneTurnHasOneExtreme();
    void otherOutputsChangeNothing();
    void threadsChangeNothing();
    void siIsTheScaledNumber();
    void errorsAreKnownByPointsAlone();
    void whatIsRoughIsKnownByPointsAlone();
    void curvesOfStringsTakeBoundedWork();
    void whereThereIsNoAnswerIsToldWithTheReason();
    void workIsCountedAndBounded();
    void blowsOfManyPiecesTakeBoundedWork();
    void aStopEndsTheWork();
    void whatCannotBeFollowedIsRefused_data();
    void whatCannotBeFollowedIsRefused();
    void aRangeBeyondWhatCanBeHasAStretchWithoutAnswer();
    void anAxisThatNoTextSaidIsRefusedAlike_data();
    void anAxisThatNoTextSaidIsRefusedAlike();
};

// theory §7: half a unit of the last digit that is given there.
void TestCurve::theLargestReboundOfAnElasticSpringNeedsNoGrid() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rectangular, {0.5, 1, 10, 0}, "beta=0.1:10:log"), 1);
    const CurveFeature* largest = onlyLine(study).outputs[0].extreme(Kind::maximum);
    QVERIFY(largest);
    QVERIFY(isNear(largest->value.value, 1.4140683, 5e-8));
    QVERIFY(isNear(largest->x.value, 0.29983, 5e-6));
    QCOMPARE(largest->shape, Shape::smooth);
    QVERIFY(largest->value.error < 1e-10 && largest->x.error < 1e-5);
    QVERIFY(study.isComplete());
}

void TestCurve::theReferenceCaseHasItsLeastRebound() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rigidBody, {0.5, 1, 0.5, 0}, "beta=0.1:10:log"), 1);
    const CurveFeature* least = onlyLine(study).outputs[0].extreme(Kind::minimum);
    QVERIFY(isNear(least->value.value, 0.9710054, 5e-8));
    QVERIFY(isNear(least->x.value, 2.57847, 5e-6));
}

void TestCurve::theGapHasACuspAtAWholeNumberAndPassesOne() {
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 1, 10, 0}, "delta=0:1.2");
    asked.levels = {1};
    const CurveStudy study = studyCurve(asked, 2);
    const CurveOutput& output = onlyLine(study).outputs[0];
    const std::vector<CurveFeature> crossings = ofKind(output, Kind::crossing);
    QCOMPARE(crossings.size(), 2u);
    QVERIFY(isNear(crossings[0].x.value, 0.326877, 5e-7) && !crossings[0].rising);
    QVERIFY(isNear(crossings[1].x.value, 0.778532, 5e-7) && crossings[1].rising);
    const std::vector<CurveFeature> maxima = ofKind(output, Kind::maximum);
    QCOMPARE(maxima.size(), 2u);
    QVERIFY(maxima[0].ofAll && maxima[0].shape == Shape::end && maxima[0].x.value == 0);
    QVERIFY(isNear(maxima[1].x.value, 1, 1e-11) && maxima[1].shape == Shape::cusp);
    QVERIFY(maxima[1].slopeBefore > 2 && maxima[1].slopeAfter < -1);
    QVERIFY(isNear(maxima[1].value.value, maxima[0].value.value, 1e-10));  // one period further
    QCOMPARE(ofKind(output, Kind::minimum).size(), 1u);
}

void TestCurve::valuesAreWhatTheSolverSays_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<QString>("groups");
    QTest::addColumn<QString>("along");
    QTest::addColumn<QString>("outputs");
    const auto add = [](const char* name, PulseShape shape, const char* groups, const char* along,
                        const char* outputs) {
        QTest::newRow(name) << static_cast<int>(shape) << groups << along << outputs;
    };
    add("stiffness", PulseShape::rectangular, "0.5 0.1 10 0", "beta=0.01:100:log",
        "cor,peak_force,efficiency,max_penetration");
    add("times", PulseShape::halfSine, "0.5 0.3 3 0.4", "beta=0.05:20:log",
        "separation_time,contact_duration,first_contact_time");
    add("gamma", PulseShape::triangular, "0.5 0.3 3 0.4", "gamma=0.001:1", "cor,residual_penetration");
    add("a short rod", PulseShape::rectangular, "0.5 0.5 10 0.2", "tau=0.1:2", "cor");
    add("a long rod", PulseShape::exponential, "0.5 0.5 10 0.2", "tau=5:500:log", "cor,residual_wave_energy");
    add("many gaps", PulseShape::rectangular, "0.5 1 10 0", "delta=0:9.3", "cor,peak_force");
    add("a huge gap", PulseShape::rectangular, "0.5 0.1 10 0", "delta=1000:1002", "cor");
    add("stresses", PulseShape::rectangular, "0.5 0.3 2 0", "beta=0.5:2", "peak_compression,peak_tension");
    add("a staircase", PulseShape::piston, "0.5 0.1 5 0", "delta=0:1", "cor");
    add("the reference case", PulseShape::rigidBody, "0.5 0.1 5 0", "beta=0.01:10:log", "cor,efficiency");
}

void TestCurve::valuesAreWhatTheSolverSays() {
    QFETCH(int, shape);
    QFETCH(QString, groups);
    QFETCH(QString, along);
    QFETCH(QString, outputs);
    const QStringList numbers = groups.split(' ');
    const CurveQuestion asked =
        question(static_cast<PulseShape>(shape),
                 {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble(), numbers[3].toDouble()},
                 along.toUtf8(), outputs.toUtf8());
    const CurveStudy study = studyCurve(asked, 2);
    const CurveLine& line = onlyLine(study);
    QVERIFY(study.isComplete());
    const std::vector<SweepAxis> axes = asked.axes();
    CurveSampler sampler(asked, axes, 0, {});
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::size_t i = 0; i < line.outputs.size(); ++i) {
        const std::vector<FitPiece>& pieces = line.outputs[i].pieces;
        QCOMPARE(pieces.front().start, 0.0);
        QCOMPARE(pieces.back().end, 1.0);
        for (int n = 0; n < 300; ++n) {
            // anywhere; and close to the ends of pieces, which is where kinks are
            const FitPiece& piece = pieces[static_cast<std::size_t>(uniform(random) * double(pieces.size()))];
            const double off = std::pow(10, -8 * uniform(random)) * (piece.end - piece.start);
            const double share = n % 3 == 0   ? uniform(random)
                                 : n % 3 == 1 ? piece.start + off
                                              : piece.end - off;
            const double x = line.range.at(share);
            const double exact = sampler(share, i).values[0];
            // x is known to its last digits, which the slope may multiply
            const double slope = std::abs(pieceAt(pieces, share).outputs[0].slope(share));
            const double margin = 3 * *line.error(x, i) + 1e-14 * std::abs(exact) + 1e-15 * slope;
            QVERIFY2(std::abs(*line.value(x, i) - exact) <= margin,
                     qPrintable(QString("output %1 at %2: off by %3, stated %4")
                                    .arg(i)
                                    .arg(x, 0, 'g', 17)
                                    .arg(std::abs(*line.value(x, i) - exact))
                                    .arg(*line.error(x, i))));
        }
    }
}

void TestCurve::randomScenesAreWhatTheSolverSays() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine,
                                 PulseShape::trapezoid};
    int smooth = 0;
    for (int scene = 0; scene < 12; ++scene) {
        const auto between = [&](double low, double high) {
            return low * std::pow(high / low, uniform(random));
        };
        const Groups groups{between(0.05, 50), between(0.02, 1), between(0.5, 50), uniform(random)};
        const double low = between(0.05, 5);
        const std::string along = "beta=" + formatNumber(low) + ":" + formatNumber(low * 5) + ":log";
        const CurveQuestion asked = question(shapes[scene % 4], groups, along.c_str());
        const CurveStudy study = studyCurve(asked, 2);
        const CurveLine& line = onlyLine(study);
        const std::vector<SweepAxis> axes = asked.axes();
        CurveSampler sampler(asked, axes, 0, {});
        for (int n = 0; n < 100; ++n) {
            const double share = uniform(random), x = line.range.at(share);
            const FitSample exact = sampler(share, 0);
            QCOMPARE(line.value(x, 0).has_value(), exact.solved);
            QVERIFY2(isNear(*line.value(x, 0), exact.values[0], 3 * *line.error(x, 0) + 1e-14),
                     qPrintable(QString::fromStdString(along) + QString(" %1").arg(x, 0, 'g', 17)));
            smooth += *line.error(x, 0) < 1e-9;
        }
    }
    QVERIFY2(smooth > 1100, QByteArray::number(smooth));  // of 1200: what is rough is rare
}

/// Two peaks are of one size there: nothing else happens at the bit.
void TestCurve::aPeakForceTurnsWhereTheGreatestPeakChanges() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rectangular, {0.5, 1, 3, 0}, "beta=0.05:5:log", "peak_force"), 1);
    const std::vector<CurveFeature> kinks = ofKind(onlyLine(study).outputs[0], Kind::kink);
    QVERIFY(!kinks.empty());
    for (const CurveFeature& kink : kinks) {
        QVERIFY(kink.x.error < 1e-5);
        QVERIFY(std::abs(kink.slopeAfter - kink.slopeBefore) > 1e-3);
    }
}

void TestCurve::aSeparationTimeJumps() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rectangular, {0.5, 0.01, 10, 0}, "beta=0.3:1", "separation_time"), 1);
    const std::vector<CurveFeature> jumps = ofKind(onlyLine(study).outputs[0], Kind::jump);
    QCOMPARE(jumps.size(), 1u);
    // another contact: a round trip, 2τ, later
    QVERIFY(isNear(std::abs(jumps[0].valueAfter - jumps[0].value.value), 19.1, 0.1));
    QVERIFY(jumps[0].x.error < 1e-9);
}

void TestCurve::aLevelThatIsJumpedOverIsNotCrossed_data() {
    QTest::addColumn<Scenario>("base");
    QTest::addColumn<QString>("output");
    QTest::addColumn<double>("level");
    QTest::addColumn<int>("crossings");
    QTest::addColumn<double>("place");
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("after");
    Scenario exponential =
        dimensionless(PulseShape::exponential, {1.1184125049355267, 0.1, 12.072905508634229, 0});
    QTest::newRow("another contact is the last one") << exponential << "separation_time" << 46.903227806877574
                                                     << 0 << 0.753593266933606 << 38.177227 << 60.746054;
    Scenario corners =
        dimensionless(PulseShape::rectangular, {13.901282013813239, 0.1, 2.292600912172583, 0});
    for (const auto& [key, text] :
         {std::pair("bit_rock.law", "corners"), std::pair("bit_rock.corner.1.force", "0.5811"),
          std::pair("bit_rock.corner.1.slope", "1.031")})
        QVERIFY(assignText(corners, key, text).isEmpty());
    QTest::newRow("a contact ends") << corners << "contact_duration" << 5.173400239902858 << 1 << 1.0
                                    << 8.2270642 << 4.6418624;
}

/// The jump is a feature with both values; the level between them is none.
void TestCurve::aLevelThatIsJumpedOverIsNotCrossed() {
    QFETCH(Scenario, base);
    QFETCH(QString, output);
    QFETCH(double, level);
    QFETCH(int, crossings);
    QFETCH(double, place);
    QFETCH(double, before);
    QFETCH(double, after);
    CurveQuestion asked = question(base, "delta=0:1.3", qPrintable(output));
    asked.levels = {level};
    const CurveStudy study = studyCurve(asked, 1);
    const CurveOutput& line = onlyLine(study).outputs[0];
    const std::vector<CurveFeature> jumps = ofKind(line, Kind::jump);
    QCOMPARE(jumps.size(), 1u);
    QVERIFY(isNear(jumps[0].x.value, place, 1e-9));
    QVERIFY(isNear(jumps[0].value.value, before, 1e-5) && isNear(jumps[0].valueAfter, after, 1e-5));
    const std::vector<CurveFeature> crossed = ofKind(line, Kind::crossing);
    QCOMPARE(static_cast<int>(crossed.size()), crossings);
    for (const CurveFeature& crossing : crossed) QVERIFY(isNear(crossing.x.value, 0.99951175, 1e-7));
}

/// Times jump where contacts come and go: every crossing is solved again, and every step between samples is
/// looked for among the jumps.
void TestCurve::crossingsHaveTheirLevelAndNoJumpIsMissed() {
    std::mt19937_64 random(53);
    std::uniform_real_distribution<double> uniform(0, 1);
    const PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine,
                                 PulseShape::exponential};
    const int scenes = test::tries("DRILLWAVE_CURVE_JUMPS", 12, 200);
    int jumpsFound = 0, crossingsFound = 0;
    for (int scene = 0; scene < scenes; ++scene) {
        const auto between = [&](double low, double high) {
            return low * std::pow(high / low, uniform(random));
        };
        const Groups groups{between(0.3, 30), 0.1, between(1, 20), 0};
        CurveQuestion asked = question(shapes[scene % 4], groups, "delta=0:1.3",
                                       scene % 2 ? "separation_time" : "contact_duration");
        const std::vector<SweepAxis> axes = asked.axes();
        CurveSampler sampler(asked, axes, 0, {});
        constexpr int samples = 600;
        std::vector<double> values;
        for (int n = 0; n <= samples; ++n) {
            const FitSample sample = sampler(static_cast<double>(n) / samples, 0);
            values.push_back(sample.solved ? sample.values[0] : NAN);
        }
        const auto [least, most] = std::ranges::minmax(values);
        asked.levels = {least + (most - least) * between(0.1, 0.9)};
        const CurveStudy study = studyCurve(asked, 2);
        const CurveOutput& line = onlyLine(study).outputs[0];
        const std::vector<CurveFeature> jumps = ofKind(line, Kind::jump);
        for (const CurveFeature& crossing : ofKind(line, Kind::crossing)) {
            ++crossingsFound;
            const double share = asked.range().shareOf(crossing.x.value);
            const double off = std::abs(sampler(share, 0).values[0] - asked.levels[0]);
            QVERIFY2(
                off < 1e-5 * most || crossing.shape == Shape::grid,
                qPrintable(
                    QStringLiteral("scene %1 at %2: off by %3").arg(scene).arg(crossing.x.value).arg(off)));
        }
        // a step beside which nothing rises like it
        for (int n = 2; n + 1 < samples; ++n) {
            const double step = std::abs(values[n + 1] - values[n]);
            const double beside = std::max(std::abs(values[n] - values[n - 1]),
                                           n + 2 <= samples ? std::abs(values[n + 2] - values[n + 1]) : 0);
            if (!(step > 0.05 * most && step > 50 * beside)) continue;
            // halved until it is steep beyond doubt, or smooth
            double low = double(n) / samples, high = double(n + 1) / samples;
            for (int i = 0; i < 30; ++i) {
                const double middle = (low + high) / 2, value = sampler(middle, 0).values[0];
                const bool isLow = std::abs(value - values[n]) < std::abs(value - values[n + 1]);
                (isLow ? low : high) = middle;
            }
            const double left = sampler(low, 0).values[0], right = sampler(high, 0).values[0];
            if (std::abs(right - left) < 0.02 * most) continue;
            ++jumpsFound;
            QVERIFY2(
                std::ranges::any_of(jumps,
                                    [&](const CurveFeature& jump) {
                                        return std::abs(jump.x.value - asked.range().at(low)) < 1e-4;
                                    }),
                qPrintable(QStringLiteral("scene %1: no jump at %2").arg(scene).arg(asked.range().at(low))));
        }
    }
    qInfo("%d jumps, %d crossings", jumpsFound, crossingsFound);
    QVERIFY(jumpsFound > scenes / 4 && crossingsFound > scenes / 2);
}

void TestCurve::aLogarithmicRangeFindsTheSameFeatures() {
    const Groups groups{0.5, 0.1, 10, 0};
    const CurveStudy linear = studyCurve(question(PulseShape::rectangular, groups, "beta=0.1:3"), 1);
    const CurveStudy logarithmic = studyCurve(question(PulseShape::rectangular, groups, "beta=0.1:3:log"), 1);
    QVERIFY(onlyLine(linear).points.front() == 0.1 && onlyLine(linear).points.back() == 3);
    QVERIFY(onlyLine(logarithmic).points.front() == 0.1 && onlyLine(logarithmic).points.back() == 3);
    for (const Kind kind : {Kind::minimum, Kind::maximum}) {
        const std::vector<CurveFeature> a = ofKind(onlyLine(linear).outputs[0], kind);
        const std::vector<CurveFeature> b = ofKind(onlyLine(logarithmic).outputs[0], kind);
        QVERIFY(!a.empty());
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QVERIFY(isNear(a[i].x.value, b[i].x.value, a[i].x.error + b[i].x.error));
            QVERIFY(isNear(a[i].value.value, b[i].value.value, a[i].value.error + b[i].value.error));
            QCOMPARE(a[i].shape, b[i].shape);
        }
    }
}

void TestCurve::aLineOfAFamilyIsTheCurveOfItsValue() {
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.1:10:log");
    asked.family = parseAxis("gamma=0.03,0.1,1").axis;
    const CurveStudy family = studyCurve(asked, 2);
    QCOMPARE(family.lines.size(), 3u);
    QCOMPARE(*family.lines[1].family, 0.1);
    const CurveStudy single =
        studyCurve(question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.1:10:log"), 1);
    QVERIFY(family.lines[1].outputs[0].features == onlyLine(single).outputs[0].features);
    QVERIFY(family.lines[1].points == onlyLine(single).points);
    QVERIFY(family.lines[1].values == onlyLine(single).values);
    QVERIFY(family.lines[0].values != family.lines[1].values);
}

void TestCurve::aFamilyOfShapesIsALineEach() {
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.1:1");
    asked.family = parseAxis("pulse.shape=half_sine,rectangular").axis;
    const CurveStudy study = studyCurve(asked, 1);
    QCOMPARE(study.lines.size(), 2u);
    const CurveStudy alone = studyCurve(question(PulseShape::halfSine, {0.5, 0.1, 10, 0}, "beta=0.1:1"), 1);
    QVERIFY(study.lines[0].values == onlyLine(alone).values);
}

void TestCurve::extremesAreAmongThePoints() {
    const CurveStudy study = studyCurve(
        question(PulseShape::rectangular, {0.5, 0.1, 3.5, 0}, "beta=0.05:5:log", "cor,efficiency"), 1);
    const CurveLine& line = onlyLine(study);
    int extremes = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        for (const CurveFeature& feature : line.outputs[i].features) {
            if (feature.kind != Kind::minimum && feature.kind != Kind::maximum) continue;
            const auto found = std::ranges::find(line.points, feature.x.value);
            QVERIFY(found != line.points.end());
            const double drawn = line.values[i][static_cast<std::size_t>(found - line.points.begin())];
            QVERIFY(std::abs(drawn - feature.value.value) <= feature.value.error + 1e-14);
            ++extremes;
        }
        const CurveFeature* least = line.outputs[i].extreme(Kind::minimum);
        QVERIFY(std::ranges::min(line.values[i]) >= least->value.value - least->value.error - 1e-14);
    }
    QVERIFY(extremes > 6);
    QVERIFY(std::ranges::is_sorted(line.points));
}

// A kink at which short pieces rise, fall and rise within 1e-7 of the range.
void TestCurve::oneTurnHasOneExtreme() {
    const CurveStudy study = studyCurve(
        question(PulseShape::halfSine, {0.9016, 0.1, 1.379, 0}, "delta=0:1.3", "contact_duration"), 1);
    int near = 0;
    for (const CurveFeature& feature : onlyLine(study).outputs[0].features)
        if (std::abs(feature.x.value - 0.986625) < 1e-4) {
            ++near;
            QVERIFY(feature.kind == Kind::maximum && feature.ofAll);
        }
    QCOMPARE(near, 1);
}

void TestCurve::otherOutputsChangeNothing() {
    const Groups groups{0.5, 0.1, 10, 0};
    const CurveStudy alone = studyCurve(question(PulseShape::rectangular, groups, "beta=0.1:10:log"), 1);
    const CurveStudy among = studyCurve(question(PulseShape::rectangular, groups, "beta=0.1:10:log",
                                                 "separation_time,cor,cor_error,peak_force"),
                                        1);
    QVERIFY(onlyLine(alone).outputs[0].features == onlyLine(among).outputs[1].features);
    for (const double x : onlyLine(alone).points)
        QCOMPARE(onlyLine(among).value(x, 1), onlyLine(alone).value(x, 0));
}

void TestCurve::threadsChangeNothing() {
    CurveQuestion asked =
        question(PulseShape::rectangular, {0.5, 0.1, 2, 0.3}, "beta=0.05:10:log", "cor,peak_force,cor_error");
    asked.family = parseAxis("gamma=0.1,1").axis;
    const CurveStudy one = studyCurve(asked, 1);
    for (const int jobs : {2, 5}) {
        const CurveStudy many = studyCurve(asked, jobs);
        QCOMPARE(curveCsv(many), curveCsv(one));
        QCOMPARE(many.solves, one.solves);
        for (std::size_t line = 0; line < one.lines.size(); ++line)
            for (std::size_t i = 0; i < asked.columns.size(); ++i)
                QVERIFY(many.lines[line].outputs[i].features == one.lines[line].outputs[i].features);
    }
}

void TestCurve::siIsTheScaledNumber() {
    CurveQuestion asked = question(Scenario{}, "bit_rock.stiffness=20MN/m:500MN/m:log", "peak_force");
    const CurveStudy dimensionlessStudy = studyCurve(asked, 1);
    asked.columns = chooseOutputs("peak_force", OutputUnits::si).columns;
    const CurveStudy si = studyCurve(asked, 1);
    const double scale = scalesOf(asked.base).force;
    for (const double x : {3e7, 1e8, 4e8})
        QVERIFY(isNear(*onlyLine(si).value(x, 0), *onlyLine(dimensionlessStudy).value(x, 0) * scale,
                       2e-10 * scale));
}

void TestCurve::errorsAreKnownByPointsAlone() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.1:10", "cor_error"), 1);
    const CurveLine& line = onlyLine(study);
    QCOMPARE(line.outputs[0].grid.size(), 1u);
    QCOMPARE(line.outputs[0].grid[0].start, 0.1);
    QCOMPARE(line.outputs[0].grid[0].end, 10.0);
    QVERIFY(line.points.size() >= 501);
    QVERIFY(study.solves <= line.points.size() + 64);  // and the ends of cells
    // at its points it is the number of the solver
    const CurveQuestion asked = study.question;
    const std::vector<SweepAxis> axes = asked.axes();
    CurveSampler sampler(asked, axes, 0, {});
    for (const std::size_t i : {0u, 17u, 250u})
        QVERIFY(isNear(line.values[0][i], sampler(line.range.shareOf(line.points[i]), 0).values[0], 1e-16));
}

/// Hammer and string touch faintly and often where couplings are thin: every contact more or less counts as a
/// kink, and a blow takes some milliseconds.
void TestCurve::curvesOfStringsTakeBoundedWork() {
    const Scenario base = parseScenario(findExample("t38_string")->text, "t38_string").scenario;
    CurveQuestion asked = question(base, "string.coupling.diameter=39mm:39.2mm", "efficiency");
    asked.workLimit = 20'000;  // blows of fewer cells are cut no more, and smoother
    const CurveStudy study = studyCurve(asked, 2);
    const CurveOutput& output = onlyLine(study).outputs[0];
    QVERIFY(!output.grid.empty() && output.unsolved.empty());
    QVERIFY2(study.solves < 16 * 200, QByteArray::number(double(study.solves)));  // 16 cells
    const std::vector<SweepAxis> axes = asked.axes();
    CurveSampler sampler(asked, axes, 0, {});
    const double largest = sampler(0.1, 0).values[0];
    const std::vector<CurveFeature> features = ofKind(output, Kind::maximum);
    const auto above = [&](const CurveFeature& feature) {
        return feature.value.value + feature.value.error >= largest;
    };
    QVERIFY(std::ranges::any_of(features, above));
}

/// Short rods in chattering contact, and contacts that change with every round trip.
void TestCurve::whatIsRoughIsKnownByPointsAlone() {
    const CurveStudy study =
        studyCurve(question(PulseShape::rectangular, {0.5, 0.3, 0.05, 0.4}, "beta=1e-4:1:log"), 2);
    const CurveOutput& output = onlyLine(study).outputs[0];
    QVERIFY(!output.grid.empty() && output.unsolved.empty());
    for (const CurveStretch& stretch : output.grid) {
        QVERIFY(stretch.reason.text().find("work") != std::string::npos);
        const auto inside = std::ranges::count_if(onlyLine(study).points, [&](double x) {
            return x >= stretch.start * (1 - 1e-12) && x <= stretch.end * (1 + 1e-12);
        });
        QVERIFY2(inside >= 17, QByteArray::number(int(inside)));
    }
    QVERIFY(
        std::ranges::all_of(onlyLine(study).values[0], [](double value) { return std::isfinite(value); }));
    // 2 000 blows a cell, the pieces that have been begun, and the points
    QVERIFY2(study.solves < 16 * 4'000, QByteArray::number(study.solves));
}

void TestCurve::whereThereIsNoAnswerIsToldWithTheReason() {
    // the closed form needs tau >= 0.5, and a contact that is over before the third wave arrives
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 1, 10, 0}, "tau=0.2:5");
    asked.method.method = Method::closedForm;
    const CurveStudy study = studyCurve(asked, 2);
    const CurveLine& line = onlyLine(study);
    const CurveOutput& output = line.outputs[0];
    QVERIFY(!study.isComplete());
    QCOMPARE(output.unsolved.size(), 1u);
    QVERIFY(output.unsolved[0].reason.text().find("tau >= 0.5") != std::string::npos);
    QCOMPARE(output.unsolved[0].start, 0.2);
    // bisection in the test: where it begins to hold
    double without = 0.5, with = 5;
    MethodSolver solver;
    while (with - without > 1e-13) {
        const double tau = (without + with) / 2;
        const Problem problem = problemOf(pulseForceOf(PulseShape::rectangular, 2), {0.5, 1, tau, 0});
        const bool holds = solver.solve(problem, Detail::cor, asked.method).outcome == Outcome::rebounded;
        (holds ? with : without) = tau;
    }
    QVERIFY(isNear(output.unsolved[0].end, with, 1e-10));
    QVERIFY(!line.value(with - 0.01, 0) && line.value(with + 0.01, 0));
    QVERIFY(std::isnan(line.values[0].front()) && std::isfinite(line.values[0].back()));
}

void TestCurve::workIsCountedAndBounded() {
    const CurveStudy smooth = studyCurve(question(PulseShape::rigidBody, {0.5, 1, 10, 0}, "beta=1:5"), 1);
    // 16 cells: two ends, 15 nodes between them and two checks
    QCOMPARE(smooth.solves, 16u * (2 + 15 + 2));
    const CurveStudy kinked =
        studyCurve(question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.1:10:log"), 1);
    QVERIFY2(kinked.solves < 3'000, QByteArray::number(kinked.solves));
    CurveQuestion hopeless = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=1:2");
    hopeless.workLimit = 1;
    const CurveStudy none = studyCurve(hopeless, 1);
    QVERIFY2(none.solves <= 16 * 10, QByteArray::number(none.solves));
    QVERIFY(onlyLine(none).outputs[0].features.empty());
    QCOMPARE(onlyLine(none).outputs[0].unsolved.size(), 1u);
}

// On a short rod in soft rock every blow is as much work as thousands of others, and still has an answer.
void TestCurve::blowsOfManyPiecesTakeBoundedWork() {
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "tau=1e-5:1e-2:log");
    asked.workLimit = 10'000;
    const CurveStudy study = studyCurve(asked, 2);
    const CurveOutput& output = onlyLine(study).outputs[0];
    QVERIFY(!output.grid.empty());
    // 16 cells, each with what has been begun when its work was spent
    const long ofCells = 16 * (5 + 20) * asked.workLimit;
    const auto points = static_cast<long>(onlyLine(study).points.size());
    const long most = ofCells + points * asked.workLimit / 6;
    QVERIFY2(study.effort > 0 && study.effort <= most, QByteArray::number(qlonglong(study.effort)));
    QVERIFY2(points <= 2'000, QByteArray::number(qlonglong(points)));
}

void TestCurve::aStopEndsTheWork() {
    std::stop_source stop;
    double told = 0;
    const CurveStudy study = studyCurve(question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "delta=0:8"), 1,
                                        stop.get_token(), [&](double done) {
                                            told = done;
                                            stop.request_stop();
                                        });
    QVERIFY(study.stopped && study.lines.empty());
    QVERIFY(told > 0 && told < 0.5);
}

void TestCurve::whatCannotBeFollowedIsRefused_data() {
    QTest::addColumn<QString>("along");
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("problem");
    QTest::newRow("a list") << "beta=1,2,3"
                            << ""
                            << "beta needs START:STOP or START:STOP:log";
    QTest::newRow("a count") << "beta=1:2:30"
                             << ""
                             << "`30` after the range of beta";
    QTest::newRow("a shape") << "pulse.shape=half_sine:table"
                             << ""
                             << "no numeric values";
    QTest::newRow("downwards") << "beta=2:1"
                               << ""
                               << "must end above its beginning";
    QTest::newRow("nothing") << "beta=1:1.00001"
                             << ""
                             << "too narrow";
    QTest::newRow("below 0") << "delta=0:1:log"
                             << ""
                             << "must begin and end above 0";
    QTest::newRow("out of range") << "gamma=0.5:1.5"
                                  << ""
                                  << "must be in (0, 1]";
    QTest::newRow("unknown") << "betta=1:2"
                             << ""
                             << "did you mean `beta`?";
    QTest::newRow("without meaning") << "rod.length=1m:2m"
                                     << ""
                                     << "does not apply here";
    QTest::newRow("one quantity twice") << "beta=1:2"
                                        << "beta=3,4"
                                        << "set the same thing";
    QTest::newRow("a large family") << "beta=1:2"
                                    << "gamma=0.01:1:51"
                                    << "at most 50 lines";
}

void TestCurve::whatCannotBeFollowedIsRefused() {
    QFETCH(QString, along);
    QFETCH(QString, family);
    QFETCH(QString, problem);
    const ParsedAxis parsed = parseRange(along.toStdString());
    std::vector<Message> problems{parsed.problem};
    if (parsed.problem.isEmpty()) {
        CurveQuestion asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, along.toUtf8());
        if (!family.isEmpty()) asked.family = parseAxis(family.toStdString()).axis;
        problems = problemsOf(asked);
    }
    QCOMPARE(problems.size(), 1u);
    QVERIFY2(problems[0].text().find(problem.toStdString()) != std::string::npos, problems[0].text().c_str());
}

void TestCurve::aRangeBeyondWhatCanBeHasAStretchWithoutAnswer() {
    CurveQuestion asked = question(Scenario(), "rod.bore=10mm:60mm");
    QVERIFY(problemsOf(asked).empty());
    const CurveStudy study = studyCurve(asked, 2);
    const CurveOutput& output = onlyLine(study).outputs.front();
    QCOMPARE(output.unsolved.size(), 1u);
    QVERIFY(isNear(output.unsolved.front().start, 0.038, 1e-6));
    QCOMPARE(output.unsolved.front().end, 0.06);
    QCOMPARE(output.unsolved.front().reason.text(),
             std::string("rod.bore must be less than the diameter of 38 mm"));
    QVERIFY(onlyLine(study).value(0.03, 0) && !onlyLine(study).value(0.05, 0));

    asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=0.5:1");
    asked.family = parseAxis("pulse.shape=rectangular,table").axis;
    QVERIFY(problemsOf(asked).empty());
    const CurveStudy family = studyCurve(asked, 2);
    QVERIFY(family.lines[0].outputs[0].unsolved.empty());
    QCOMPARE(family.lines[1].outputs[0].unsolved.size(), 1u);
    QVERIFY(family.lines[1].outputs[0].unsolved[0].reason.text().starts_with(
        "pulse.points needs at least two points"));
}

void TestCurve::anAxisThatNoTextSaidIsRefusedAlike_data() {
    QTest::addColumn<SweepAxis>("along");
    QTest::addColumn<QString>("problem");
    const auto add = [](const char* name, SweepAxis::Kind kind, double start, double stop,
                        const char* problem) {
        SweepAxis axis = parseRange("beta=1:2").axis;
        axis.kind = kind;
        axis.start = start;
        axis.stop = stop;
        QTest::newRow(name) << axis << problem;
    };
    using AxisKind = SweepAxis::Kind;
    add("downwards", AxisKind::linear, 2, 1, "must end above its beginning");
    add("downwards by ratios", AxisKind::logarithmic, 2, 1, "must end above its beginning");
    add("a point", AxisKind::linear, 1, 1, "must end above its beginning");
    add("no number", AxisKind::linear, std::nan(""), 1, "must end above its beginning");
    add("narrow", AxisKind::linear, 1, 1.00001, "too narrow");
    add("from 0 by ratios", AxisKind::logarithmic, 0, 1, "must begin and end above 0");
    QTest::newRow("a list") << parseAxis("beta=1,2").axis << "beta needs START:STOP";
    QTest::newRow("shapes") << parseAxis("pulse.shape=half_sine").axis << "no numeric values";
}

void TestCurve::anAxisThatNoTextSaidIsRefusedAlike() {
    QFETCH(SweepAxis, along);
    QFETCH(QString, problem);
    CurveQuestion asked = question(PulseShape::rectangular, {0.5, 0.1, 10, 0}, "beta=1:2");
    QVERIFY(problemsOf(asked).empty());
    asked.along = along;
    const std::vector<Message> problems = problemsOf(asked);
    QCOMPARE(problems.size(), 1u);
    QVERIFY2(problems[0].text().find(problem.toStdString()) != std::string::npos, problems[0].text().c_str());
}

QTEST_GUILESS_MAIN(TestCurve)
#include "tst_curve.moc"
