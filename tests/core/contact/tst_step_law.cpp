// SPDX-License-Identifier: GPL-3.0-or-later
// The bilinear law over steps of constant force: its work is that of the law, whatever corners a step passes.
#include <QTest>

#include <random>

#include "core/contact/step_law.h"

using namespace drillwave;

namespace {

/// The law of the paper, Fig. 1, as force over penetration with its memory, written independently.
struct Rock {
    double beta, gamma;
    double largest = 0;  ///< Um

    double residual() const { return (1 - gamma) * largest; }  ///< Ur
    double force(double U) const {
        if (U >= largest) return beta * U;
        return std::max(0.0, beta / gamma * (U - residual()));
    }
    /// ∫F dU from `from` to `to`, trapezium by trapezium between the corners.
    double work(double from, double to) const {
        std::vector<double> corners{from, to};
        for (const double corner : {residual(), largest})
            if ((corner - from) * (corner - to) < 0) corners.push_back(corner);
        std::ranges::sort(corners);
        if (from > to) std::ranges::reverse(corners);
        double sum = 0;
        for (std::size_t i = 1; i < corners.size(); ++i)
            sum += (force(corners[i]) + force(corners[i - 1])) / 2 * (corners[i] - corners[i - 1]);
        return sum;
    }
    void remember(double U) { largest = std::max(largest, U); }
};

}  // namespace

class TestStepLaw : public QObject {
    Q_OBJECT

  private slots:
    void theWorkOfAStepIsThatOfTheLaw_data() {
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("gamma");
        QTest::addColumn<double>("step");
        QTest::newRow("paper Fig. 4 (b)") << 0.5 << 0.1 << 0.01;
        QTest::newRow("elastic") << 0.5 << 1.0 << 0.01;
        QTest::newRow("steps that pass several corners") << 2.0 << 0.2 << 0.19;
        QTest::newRow("steep unloading") << 1.0 << 0.01 << 0.019;
        QTest::newRow("nearly elastic") << 3.0 << 0.999 << 0.1;
    }

    void theWorkOfAStepIsThatOfTheLaw() {
        QFETCH(double, beta);
        QFETCH(double, gamma);
        QFETCH(double, step);
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> between(-1, 1);
        StepLaw law(ContactLaw<>(beta, gamma), step, 0.1, 1e-19);
        Rock rock{beta, gamma};
        double U = -0.1;
        int corners = 0, several = 0;
        double wave = 0;
        for (int i = 0; i < 40000; ++i) {
            if (i % 7 == 0) wave = between(random) * (i % 14 == 0 ? 3 : 0.3);
            const double g = wave + 0.2 * between(random);
            const double force = law.advance(g);
            const double dU = (2 * g - force) * step;
            const double work = rock.work(U, U + dU);
            U += dU;
            rock.remember(U);
            QVERIFY(force >= 0);
            // rounding, gathered over the steps and amplified by the steepest slope
            const double tolerance = 1e-12 * (1 + beta / gamma);
            QVERIFY2(std::abs(force * dU - work) < tolerance * step, qPrintable(QString::number(i)));
            QVERIFY(std::abs(law.force() - rock.force(U)) < tolerance * (1 + std::abs(U)));
            const unsigned changes = law.changes();
            corners += changes != StepLaw::none;
            several += (changes & (changes - 1)) != 0;
            if (U < -0.3) {  // bring it back
                while (law.isApart()) {
                    const double back = law.advance(2);
                    const double way = (4 - back) * step;
                    QVERIFY(std::abs(back * way - rock.work(U, U + way)) < tolerance * step);
                    U += way;
                    rock.remember(U);
                    several += law.changes() == (StepLaw::contact | StepLaw::primaryLoading);
                }
            }
        }
        QVERIFY2(corners > 300, qPrintable(QString::number(corners)));
        if (step == 0.19) QVERIFY2(several > 10, qPrintable(QString::number(several)));
    }

    void aStepMayCloseTheGapAndReachThePrimaryLine() {
        // first contact up to F = 0.5, apart by 0.2, and back with a wave that is strong enough for both
        StepLaw law(ContactLaw<>(1, 0.5), 0.9, 0, 1e-19);
        law.advance(0.4);
        const double peak = law.peak();
        while (!law.isApart()) law.advance(-1);
        const double gap = law.gap();
        law.advance(5);
        QCOMPARE(law.changes(), unsigned(StepLaw::contact | StepLaw::primaryLoading));
        QVERIFY(law.force() > peak && law.peak() == law.force());
        QVERIFY(law.contactFraction() > 0 && law.contactFraction() < law.primaryFraction() &&
                law.primaryFraction() < 1);
        // the front end moves evenly: the fractions are those of the way; 0.5 peak is the elastic part γF/β
        const double way = law.primaryFraction() - law.contactFraction();
        QVERIFY(std::abs(law.contactFraction() / way - gap / (0.5 * peak)) < 1e-12);
    }

    void unloadingBeginsWhereTheWaveTurns() {
        StepLaw law(ContactLaw<>(0.5, 0.1), 0.01, 0, 1e-19);
        for (int i = 0; i < 100; ++i) law.advance(1);
        QCOMPARE(law.changes(), unsigned(StepLaw::none));
        const double peak = law.force();
        law.advance(0);
        QCOMPARE(law.changes(), unsigned(StepLaw::unloading));
        QCOMPARE(law.peak(), peak);
        // the force at the end of the step is on the line of slope β/γ through (Um, Fm)
        const double force = (law.force() + peak) / 2;
        QVERIFY(std::abs(law.force() - (peak - 0.5 / 0.1 * force * 0.01)) < 1e-15);
        law.advance(0);
        QCOMPARE(law.changes(), unsigned(StepLaw::none));
    }

    void aForceThatDecaysNeitherOvershootsNorSeparates() {
        // theory §6: aΔ = 2 is the limit, at which the force vanishes within one step
        for (const double step : {0.05, 1.0, 1.999}) {
            StepLaw law(ContactLaw<>(0.5, 0.5), step, 0, 1e-19);
            law.advance(1);
            double before = law.force();
            for (int i = 0; i < 10000 && law.force() > 0; ++i) {
                law.advance(0);
                QVERIFY(!law.isApart() && law.force() >= 0 && law.force() < before);
                before = law.force();
            }
            QCOMPARE(law.force(), 0.0);  // from the negligible force on
            QVERIFY(!law.isApart());
        }
    }

    void aSteadyWaveCausesNoEvents() {
        // F = 2g within rounding: neither loading nor unloading
        StepLaw law(ContactLaw<>(1e3, 0.5), 1e-3, 0, 1e-19);
        for (int i = 0; i < 200; ++i) law.advance(1);
        for (int i = 0; i < 10000; ++i) {
            law.advance(1 + 1e-16 * (i % 3 - 1));
            QCOMPARE(law.changes(), unsigned(StepLaw::none));
        }
        QVERIFY(std::abs(law.force() - 2) < 1e-14);
    }
};

QTEST_GUILESS_MAIN(TestStepLaw)
#include "tst_step_law.moc"
