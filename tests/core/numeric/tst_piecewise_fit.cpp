// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth pieces of functions with kinks, jumps and holes: where they end, how well they fit, what they cost.
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/numeric/fit_features.h"
#include "core/numeric/piecewise_fit.h"

using namespace drillwave;

namespace {

/// A function of one value, with an order that tells its kinks.
FitFunction of(std::function<double(double)> function, std::function<int(double)> order) {
    return [=](double x) {
        FitSample sample;
        sample.values[0] = function(x);
        sample.order = static_cast<std::uint64_t>(order(x));
        sample.solved = true;
        return sample;
    };
}

FitFunction of(std::function<double(double)> function) {
    return of(std::move(function), [](double) { return 0; });
}

double value(const PiecewiseFit& fit, double x) {
    return pieceAt(fit.pieces, x).outputs.front()(x);
}

constexpr double third = 1.0 / 3;

double angle(double x) {
    return std::sin(5 * x) + 2 * std::abs(x - third);
}

}  // namespace

class TestPiecewiseFit : public QObject {
    Q_OBJECT

  private slots:
    void aSmoothFunctionIsOnePieceACell();
    void aKinkThatTheOrderTellsIsBracketed();
    void aKinkThatNothingTellsIsHalvedTowards();
    void aJumpStaysWithinItsSliver();
    void whereValuesEndIsBracketed();
    void aFunctionThatNeverGetsSmoothCostsWhatIsPermitted();
    void whatCostsMuchIsLookedAtLess();
    void failuresEndTheWork();
    void aConstantIsOneSample();
    void extremesAndCrossingsOfASineAreWhereTheyAre();
    void aPlateauIsEverywhere();
};

void TestPiecewiseFit::aSmoothFunctionIsOnePieceACell() {
    const double cuts[] = {0, 0.5, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of([](double x) { return std::exp(x); }));
    QCOMPARE(fit.pieces.size(), 2u);
    QVERIFY(fit.borders.empty());
    // three cell ends, 15 nodes inside each cell and two checks
    QCOMPARE(fit.solves, 3u + 2 * (15 + 2));
    for (double x = 0; x <= 1; x += 0.01) QVERIFY(std::abs(value(fit, x) - std::exp(x)) < 1e-14);
}

void TestPiecewiseFit::aKinkThatTheOrderTellsIsBracketed() {
    const double cuts[] = {0, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of(angle, [](double x) { return x < third ? 0 : 1; }));
    QCOMPARE(fit.borders.size(), 1u);
    QVERIFY(std::abs(fit.borders.front() - third) < 1e-12);
    for (double x = 0; x <= 1; x += 0.0123) QVERIFY(std::abs(value(fit, x) - angle(x)) < 1e-10);
    const auto sides = sidesAt(fit.pieces, 0, fit.borders.front(), fit.borders.front());
    QVERIFY(sides && isAngle(sides->first, sides->second, 1));
    // slopes of the formula, whose pieces are off by no more than 1e-10
    QVERIFY(std::abs(sides->second.slope - sides->first.slope - 4) < 1e-6);
}

void TestPiecewiseFit::aKinkThatNothingTellsIsHalvedTowards() {
    const double cuts[] = {0, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of(angle));
    QVERIFY(fit.borders.empty());
    for (double x = 0; x <= 1; x += 0.0123) QVERIFY(std::abs(value(fit, x) - angle(x)) < 1e-10);
    double narrowest = 1, place = 0;
    for (const FitPiece& piece : fit.pieces)
        if (piece.end - piece.start < narrowest) {
            narrowest = piece.end - piece.start;
            place = piece.start;
        }
    // 1e-10 of the value is what a straight line over the angle may be off by, at a slope of 2
    QVERIFY2(narrowest < 1e-8 && std::abs(place - third) < 1e-8, QByteArray::number(narrowest));
}

void TestPiecewiseFit::aJumpStaysWithinItsSliver() {
    const auto step = [](double x) { return x < third ? 1.0 : 2.0; };
    const double cuts[] = {0, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of(step));
    int unresolved = 0;
    for (const FitPiece& piece : fit.pieces) {
        if (piece.resolved) continue;
        ++unresolved;
        QVERIFY(piece.end - piece.start <= 1e-11 && piece.error[0] >= 1);
    }
    QVERIFY(unresolved >= 1);
    QCOMPARE(value(fit, third - 1e-9), 1.0);
    QCOMPARE(value(fit, third + 1e-9), 2.0);
}

void TestPiecewiseFit::whereValuesEndIsBracketed() {
    const FitFunction hole = [](double x) {
        FitSample sample;
        sample.values[0] = x * x;
        sample.solved = x < 0.37 || x > 0.81;
        return sample;
    };
    const double cuts[] = {0, 1};
    FitSettings settings;
    settings.ends = FitSettings::Ends::bracketed;
    settings.failuresOfCell = 200;
    const PiecewiseFit fit = fitPiecewise(settings, cuts, hole);
    double from = 1, to = 0;
    for (const FitPiece& piece : fit.pieces) {
        if (piece.solved) continue;
        from = std::min(from, piece.start);
        to = std::max(to, piece.end);
    }
    QVERIFY(std::abs(from - 0.37) < 2e-11 && std::abs(to - 0.81) < 2e-11);
    QVERIFY(std::abs(fit.unsolved - 0.44) < 1e-10);
    QVERIFY(std::abs(value(fit, 0.9) - 0.81) < 1e-14);
}

void TestPiecewiseFit::aFunctionThatNeverGetsSmoothCostsWhatIsPermitted() {
    // a Weierstrass function: continuous, without a slope anywhere
    const auto rough = [](double x) {
        double sum = 0;
        for (int k = 0; k < 30; ++k) sum += std::pow(0.7, k) * std::cos(std::pow(7, k) * x);
        return sum;
    };
    const double cuts[] = {0, 1};
    FitSettings settings;
    settings.solvesOfCell = 500;
    const PiecewiseFit fit = fitPiecewise(settings, cuts, of(rough));
    // a piece that is begun is finished, and so are those it is a half of: some 17 blows at each halving
    QVERIFY2(fit.solves < 500 + 17 * 40, QByteArray::number(fit.solves));
    QCOMPARE(fit.pieces.back().end, 1.0);
    QVERIFY(std::ranges::any_of(fit.pieces, [](const FitPiece& piece) { return !piece.resolved; }));
}

// The number of samples says little where each costs what a thousand others do.
void TestPiecewiseFit::whatCostsMuchIsLookedAtLess() {
    const double cuts[] = {0, 1};
    const auto dear = [](double x) {
        FitSample sample{.x = x, .solved = true, .effort = 1000};
        sample.values[0] = std::sin(300 * x);
        sample.order = static_cast<std::uint64_t>(50 * x);
        return sample;
    };
    FitSettings settings;
    settings.mostEffort = 30'000;
    const PiecewiseFit fit = fitPiecewise(settings, cuts, dear);
    // and what has been begun: the nodes of one interval
    QVERIFY2(fit.solves >= 30 && fit.solves <= 30 + 17, QByteArray::number(fit.solves));
    QCOMPARE(fit.unsolved, 0.0);
    const auto isLeft = [](const FitPiece& piece) { return !piece.resolved; };
    QVERIFY(std::ranges::any_of(fit.pieces, isLeft));
    // A piece that was not examined does not count as known, even where its ends agree.
    settings.mostEffort = 2'000;
    const auto same = [](double x) {
        return FitSample{.x = x, .values = {1}, .solved = true, .effort = 1000};
    };
    QVERIFY(std::ranges::all_of(fitPiecewise(settings, cuts, same).pieces, isLeft));
}

void TestPiecewiseFit::failuresEndTheWork() {
    int taken = 0;
    const FitFunction never = [&](double) {
        ++taken;
        return FitSample{};
    };
    const double cuts[] = {0, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, never);
    QVERIFY2(taken <= 40, QByteArray::number(taken));
    QVERIFY(std::abs(fit.unsolved - 1) < 1e-12);
}

void TestPiecewiseFit::aConstantIsOneSample() {
    const PiecewiseFit fit = fitConstant({}, 2, 3, of([](double) { return 7.0; }));
    QCOMPARE(fit.solves, 1u);
    QCOMPARE(fit.pieces.size(), 1u);
    QCOMPARE(value(fit, 2.5), 7.0);
}

void TestPiecewiseFit::extremesAndCrossingsOfASineAreWhereTheyAre() {
    using std::numbers::pi;
    const double cuts[] = {0, 2, 4, 6, 8, 10};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of([](double x) { return std::sin(x); }));
    const std::vector<MonotoneSegment> segments = segmentsOf(fit.pieces, 0);
    const std::vector<LocalExtreme> extremes = localExtremesOf(segments);
    QCOMPARE(extremes.size(), 3u);
    for (std::size_t i = 0; i < extremes.size(); ++i) {
        const LocalExtreme& extreme = extremes[i];
        QCOMPARE(extreme.which, i % 2 == 0 ? Extreme::largest : Extreme::least);
        QVERIFY(std::abs(extreme.place.value - pi * (0.5 + double(i))) <= extreme.place.error);
        QVERIFY(std::abs(std::abs(extreme.value.value) - 1) <= extreme.value.error);
        QVERIFY(extreme.value.error < 1e-10);
    }
    const std::vector<FitCrossing> crossings = crossingsOf(segments, 0.5);
    QCOMPARE(crossings.size(), 4u);
    const double expected[] = {pi / 6, 5 * pi / 6, 13 * pi / 6, 17 * pi / 6};
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        QVERIFY(std::abs(crossings[i].place.value - expected[i]) <= crossings[i].place.error);
        QCOMPARE(crossings[i].rising, i % 2 == 0);
    }
    QVERIFY(crossingsOf(segments, 1).empty());  // touched, not passed
}

void TestPiecewiseFit::aPlateauIsEverywhere() {
    const double cuts[] = {0, 1};
    const PiecewiseFit fit = fitPiecewise({}, cuts, of([](double) { return 3.0; }));
    const std::vector<MonotoneSegment> segments = segmentsOf(fit.pieces, 0);
    QVERIFY(extremeOf(segments, Extreme::largest).everywhere);
    QVERIFY(localExtremesOf(segments).empty());
}

QTEST_GUILESS_MAIN(TestPiecewiseFit)
#include "tst_piecewise_fit.moc"
