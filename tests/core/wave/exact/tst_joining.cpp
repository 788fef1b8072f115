// SPDX-License-Identifier: GPL-3.0-or-later
// Joined wave pieces on soft rock: what they save, and that the stated error covers what they cost.
#include <QTest>
#include <numeric>

#include "core/wave/exact/contact_march.h"
#include "core/wave/exact/series_basis.h"
#include "core/wave/exact/series_joiner.h"
#include "tests/support/scenes.h"
#include "tests/support/series.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Soft scenes of every shape with β from `leastBeta` up and γ in a range.
class SoftScenes {
  public:
    SoftScenes(double leastBeta, double leastGamma, double mostGamma, unsigned seed)
        : m_leastBeta(leastBeta), m_leastGamma(leastGamma), m_mostGamma(mostGamma), m_random(seed) {}

    Scene next() {
        static constexpr PulseShape shapes[] = {PulseShape::rectangular, PulseShape::triangular,
                                                PulseShape::halfSine,    PulseShape::trapezoid,
                                                PulseShape::exponential, PulseShape::piston};
        Scene scene;
        scene.shape = shapes[m_random() % 6];
        scene.impedanceRatio = logarithmic(0.2, 5);
        Groups& g = scene.groups;
        g.beta = logarithmic(m_leastBeta, 30 * m_leastBeta);
        g.gamma = logarithmic(m_leastGamma, m_mostGamma);
        g.tau = logarithmic(0.1, 30);
        g.delta = m_random() % 2 == 0 ? 0 : 2 * fraction();
        return scene;
    }

  private:
    double fraction() { return static_cast<double>(m_random() >> 11) * 0x1p-53; }
    double logarithmic(double low, double high) { return low * std::pow(high / low, fraction()); }

    double m_leastBeta, m_leastGamma, m_mostGamma;
    std::mt19937_64 m_random;
};

int blowsToTry() {
    return tries("DRILLWAVE_SOFT_BLOWS", 10, 40);
}

}  // namespace

class TestJoining : public QObject {
    Q_OBJECT

  private slots:
    void aJoinedPieceKeepsFourMoments() {
        const Problem soft = problemOf(Scene{PulseShape::rectangular, {1e-7, 0.3, 1, 0}});
        SeriesJoiner<double> joiner;
        joiner.begin(JoiningBudget(soft), soft.law.beta / soft.law.gamma);
        const WavePiece<double> first = series(0.4, {1, 0.2}), second = series(0.1, {1.2, 0.05 + 4e-9});
        WavePiece<double> joined = first;
        double error = 0;
        QVERIFY(joiner.join(joined, second, error));
        QCOMPARE(joined.length, 0.5);
        QVERIFY(joined.displaced > 1e-10);
        QVERIFY(std::abs(joined.value(0.5) - second.value(0.1)) > 1e-10);  // something was changed
        for (int power = 0; power < keptMoments; ++power) {
            // ∫ f xʲ by Gauss' rule of four points, exact up to the seventh power
            const auto moment = [power](const PowerSeries<double>& f, double start) {
                double sum = 0;
                for (const auto& [place, weight] : {std::pair(0.8611363115940526, 0.3478548451374538 / 2),
                                                    std::pair(-0.8611363115940526, 0.3478548451374538 / 2),
                                                    std::pair(0.3399810435848563, 0.6521451548625461 / 2),
                                                    std::pair(-0.3399810435848563, 0.6521451548625461 / 2)}) {
                    const double x = f.length * (1 + place) / 2;
                    sum += weight * f.length * f.value(x) * std::pow(start + x, power);
                }
                return sum;
            };
            const double both = moment(first, 0) + moment(second, first.length);
            QVERIFY(std::abs(moment(joined, 0) - both) < 1e-15);
        }
    }

    void aJumpIsNotJoined() {
        const Problem soft = problemOf(Scene{PulseShape::rectangular, {1e-7, 0.3, 1, 0}});
        SeriesJoiner<double> joiner;
        joiner.begin(JoiningBudget(soft), soft.law.beta / soft.law.gamma);
        WavePiece<double> last = series(0.4, {1});
        double error = 0;
        QVERIFY(!joiner.join(last, series(0.1, {0.9}), error));
        QVERIFY(!joiner.join(last, series(0.1, {0.9, 0.1}), error));
        QCOMPARE(last.length, 0.4);
        QCOMPARE(error, 0.0);
    }

    void whatIsCutOutOfAJoinedPieceIsDisplacedFromItsStart() {
        WavePiece<double> piece = series(1, {1, 1});
        piece.displaced = 1e-9;
        QCOMPARE(piece.displacedAtStart, 0.0);
        piece.dropFront(0.5);
        QCOMPARE(piece.displacedAtStart, 1e-9);
    }

    void moderateRockKeepsEveryDigit() {
        for (const double gamma : {1.0, 0.3, 0.05}) {
            const JoiningBudget budget(problemOf(Scene{PulseShape::halfSine, {0.01, gamma, 0.3, 0}}));
            QVERIFY(budget.mostDisplaced < 1e-15);
            QVERIFY(budget.mostDeviation < 1e-9);
        }
    }

    void theStatedErrorCoversWhatJoiningChanges_data() {
        QTest::addColumn<double>("leastBeta");
        QTest::addColumn<double>("leastGamma");
        QTest::addColumn<double>("mostGamma");
        QTest::newRow("large gamma") << 3e-7 << 0.1 << 1.0;
        QTest::newRow("medium gamma") << 1e-6 << 3e-3 << 0.1;
        QTest::newRow("small gamma") << 3e-6 << 1e-4 << 3e-3;
        QTest::newRow("smallest gamma") << 3e-6 << 1e-6 << 1e-4;
    }
    void theStatedErrorCoversWhatJoiningChanges() {
        QFETCH(double, leastBeta);
        QFETCH(double, leastGamma);
        QFETCH(double, mostGamma);
        // In long double a joint may change 1/2048 of what it may in double.
        const auto extended = std::make_unique<ContactMarch<SeriesBasis<long double>>>();
        SoftScenes scenes(leastBeta, leastGamma, mostGamma, 17);
        int compared = 0, outside = 0, changed = 0;
        for (int i = 0; i < blowsToTry(); ++i) {
            const Scene scene = scenes.next();
            const Impact impact = solve(scene);
            QCOMPARE(impact.outcome, Outcome::rebounded);
            QVERIFY2(impact.corError <= 1e-9, describe(scene).c_str());
            if (impact.pieces > 600'000 && blowsToTry() < 100) continue;  // many seconds in long double
            Impact exact;
            extended->solve(problemOf(scene), Detail::cor, exact);
            if (exact.outcome != Outcome::rebounded) continue;
            const double change = std::abs(impact.cor - exact.cor);
            ++compared;
            changed += change > 1e-14;
            if (change > impact.corError) {
                ++outside;
                qInfo("%s: e errs by %.2g, stated %.2g", describe(scene).c_str(), change, impact.corError);
            }
        }
        qInfo("%d of %d outside, %d changed by more than rounding", outside, compared, changed);
        QVERIFY(outside <= compared / 100);
        QVERIFY(compared >= blowsToTry() * 2 / 3);
        QVERIFY(changed >= std::max(2, compared / 20));  // else nothing has been tried
    }

    void workOnSoftRockIsBounded_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("tau");
        QTest::addColumn<long>("most");
        const auto row = [](const char* name, PulseShape shape, double beta, double gamma, double tau,
                            long most) { QTest::newRow(name) << int(shape) << beta << gamma << tau << most; };
        row("triangular, gamma 7.7e-5", PulseShape::triangular, 1.5e-7, 7.7e-5, 5.8, 12'000'000);
        row("trapezoid, gamma 4.4e-4", PulseShape::trapezoid, 1.5e-7, 4.4e-4, 7.1, 2'000'000);
        row("half sine, gamma 1.4e-5", PulseShape::halfSine, 1.5e-7, 1.4e-5, 1.2, 14'000'000);
        row("rectangular, gamma 2e-4", PulseShape::rectangular, 1.5e-7, 2e-4, 1.8, 5'000'000);
        row("triangular, gamma 0.335", PulseShape::triangular, 1.5e-7, 0.335, 0.64, 200'000);
        row("exponential, gamma 0.65", PulseShape::exponential, 1.5e-7, 0.65, 0.1, 300'000);
    }
    void workOnSoftRockIsBounded() {
        QFETCH(int, shape);
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, tau);
        QFETCH(long, most);
        const Scene scene{PulseShape(shape), {beta, gamma, tau, 0.3}};
        const Impact impact = solve(scene);
        QCOMPARE(impact.outcome, Outcome::rebounded);
        QVERIFY2(impact.pieces <= most, std::to_string(impact.pieces).c_str());
        QVERIFY2(impact.corError <= 1e-9, formatNumber(impact.corError).c_str());
    }
};

QTEST_GUILESS_MAIN(TestJoining)
#include "tst_joining.moc"
