// SPDX-License-Identifier: GPL-3.0-or-later
// The bilinear law as the paper draws it, Fig. 1: lines, corners, memory and work.
#include <QTest>

#include <random>

#include "core/contact/contact_law.h"

using namespace drillwave;

namespace {

struct Rock {
    double beta, gamma;
};

/// Soft to stiff, elastic to nearly without spring.
const Rock rocks[] = {{0.5, 1}, {0.5, 0.1}, {1e-3, 0.3}, {2e4, 1e-6}, {3, 1 - 1e-9}};

bool isClose(double a, double b, double scale) {
    return std::abs(a - b) <= 1e-14 * scale;  // a few roundings
}

}  // namespace

class TestBilinearLaw : public QObject {
    Q_OBJECT

  private slots:
    void untouchedRockIsASpring() {
        for (const Rock& rock : rocks) {
            const ContactLaw<> law(rock.beta, rock.gamma);
            QCOMPARE(law.lineAtContact(), ContactLine::primary);
            QVERIFY(isClose(law.force(0.7), 0.7 * rock.beta, rock.beta));
            QVERIFY(isClose(law.penetration(0.7), 0.7 / rock.beta, 1 / rock.beta));
            QCOMPARE(law.force(-0.1), 0.0);  // no pull
            QCOMPARE(law.residualPenetration(), 0.0);
        }
    }

    void linesMeetAtTheirCorners() {
        for (const Rock& rock : rocks) {
            ContactLaw<> law(rock.beta, rock.gamma);
            law.remember(1.5);
            const double largest = law.largestPenetration(), residual = law.residualPenetration();
            QVERIFY(isClose(largest, 1.5 / rock.beta, largest));
            QVERIFY(std::abs(residual - (1 - rock.gamma) * largest) <= 1e-14 * largest);
            // from both sides, over ways on which neither line changes by more than 1e-9 of the force
            for (const double side : {-1e-9, 1e-9}) {
                const double way = side * rock.gamma * largest;
                QVERIFY(std::abs(law.force(largest + way) - 1.5) < 3e-9);
                QVERIFY(law.force(residual + way) < 3e-9);
            }
            QVERIFY(isClose(law.penetration(0), residual, largest));
            QVERIFY(isClose(law.penetration(1.5), largest, largest));
            QVERIFY(isClose(law.penetration(2), 2 / rock.beta, largest));  // on along the primary line
        }
    }

    void forceAndPenetrationAreInverse() {
        for (const Rock& rock : rocks) {
            ContactLaw<> law(rock.beta, rock.gamma);
            law.remember(1);
            for (const double force : {0.0, 1e-6, 0.3, 0.999, 1.0, 1.001, 4.0})
                // one rounding of U is β/γ of F
                QVERIFY(std::abs(law.force(law.penetration(force)) - force) <= 1e-15 * (1 + 4 / rock.gamma));
        }
    }

    /// Loaded to 1, unloaded with the slope of the elastic line, and back up to it.
    void slopesAreThoseOfTheLines() {
        for (const Rock& rock : rocks) {
            ContactLaw<> law(rock.beta, rock.gamma);
            law.remember(1);
            QVERIFY(isClose(law.slope(ContactLine::primary), rock.beta, rock.beta));
            QVERIFY(isClose(law.slope(ContactLine::elastic), rock.beta / rock.gamma, rock.beta / rock.gamma));
            const double way = law.elasticWay(0.5);
            QVERIFY(std::abs(law.penetration(1) - law.penetration(0.5) - way) <= 1e-14 / rock.beta);
            QVERIFY(std::abs(law.residualPenetration() + law.elasticWay(1) - law.largestPenetration()) <=
                    1e-14 / rock.beta);
        }
    }

    void onlyTheLargestForceIsRemembered() {
        ContactLaw<> law(0.5, 0.1);
        law.remember(2);
        law.remember(1);
        QCOMPARE(law.largestForce(), 2.0);
        QCOMPARE(law.lineAtContact(), ContactLine::elastic);  // at the bottom of the crater
        QVERIFY(law.isOneWay(ContactLine::primary) && !law.isOneWay(ContactLine::elastic));
    }

    /// ∫F dU over a path of many turns and separations, trapezium by trapezium on the force of (T5) with
    /// Um = the largest U so far, is what the law says of its end.
    void theWorkLedgerCloses() {
        for (const Rock& rock : rocks) {
            std::mt19937_64 random(7);
            std::uniform_real_distribution<double> forces(0, 1);
            ContactLaw<> law(rock.beta, rock.gamma);
            double U = 0, F = 0, work = 0, dissipatedBefore = 0;
            for (int turn = 0; turn < 200; ++turn) {
                // down, now and then to nothing, and up, now and then beyond the largest force
                const double low = turn % 5 == 0 ? 0 : F * forces(random);
                const double high = low + forces(random) * 0.02 * (turn + 1);
                for (const double target : {low, std::min(high, std::max(law.largestForce(), low)), high}) {
                    law.remember(target);
                    const double to = law.penetration(target);
                    work += (F + target) / 2 * (to - U);
                    U = to;
                    F = target;
                }
                const double scale = law.largestForce() * law.largestPenetration();
                // rounding of U, at most 200 times
                QVERIFY2(std::abs(work - law.worked(F)) < 1e-13 * scale, qPrintable(QString::number(turn)));
                QVERIFY(isClose(law.worked(0), law.kept(), scale));
                QVERIFY(law.kept() >= dissipatedBefore);  // the rock gives back what its spring holds only
                dissipatedBefore = law.kept();
            }
            const double loading = law.largestForce() * law.largestPenetration() / 2;
            QVERIFY(
                isClose(law.givenBack(law.largestForce()), rock.gamma * loading, loading));  // γ's meaning
            QVERIFY(isClose(law.worked(law.largestForce()), loading, loading));
        }
    }

    void elasticRockHasNoMemory() {
        ContactLaw<> law(0.5, 1);
        const ContactLaw<> fresh = law;
        law.remember(3);
        QVERIFY(law.isElastic());
        QCOMPARE(law.lineAtContact(), ContactLine::primary);
        QVERIFY(!law.isOneWay(ContactLine::primary));
        QCOMPARE(law.kept(), 0.0);
        for (const double U : {-1.0, 0.0, 0.3, 6.0, 7.0}) QVERIFY(isClose(law.force(U), fresh.force(U), 3.5));
        for (const double F : {0.0, 0.1, 3.0, 4.0})
            QVERIFY(isClose(law.penetration(F), fresh.penetration(F), 8));
    }

    /// Forces that differ in newtons need not as multiples of a scale: the second of two such corners counts.
    void cornersAtOneForceAreOne() {
        const ContactLaw<> one({.beta = 0.5, .gamma = 0.1, .corners = {{1, 0.25}, {2, 2}}});
        const ContactLaw<> two({.beta = 0.5, .gamma = 0.1, .corners = {{1, 0.5}, {1, 0.25}, {2, 2}}});
        for (const double force : {0.5, 1.0, 1.5, 2.5}) {
            QCOMPARE(two.penetration(force), one.penetration(force));
            ContactLaw<> once = one, twice = two;
            once.rememberAcross(force);
            twice.rememberAcross(force);
            QCOMPARE(twice.kept(), once.kept());
            QCOMPARE(twice.force(6), once.force(6));
        }
    }

    /// γ → 1: forces, penetrations and work differ from those of elastic rock by no more than 1 − γ.
    void nearlyElasticRockIsNearlyElastic() {
        ContactLaw<> elastic(0.5, 1);
        elastic.remember(1);
        for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12}) {
            ContactLaw<> law(0.5, 1 - distance);
            law.remember(1);
            const double most = 3 * distance + 1e-15;  // Fm, Um = 2 and slopes of order one
            for (const double U : {-1.0, 0.0, 0.5, 1.0, 1.9, 2.0, 3.0})
                QVERIFY(std::abs(law.force(U) - elastic.force(U)) <= most);
            for (const double F : {0.0, 0.5, 1.0})
                QVERIFY(std::abs(law.penetration(F) - elastic.penetration(F)) <= most);
            QVERIFY(std::abs(law.worked(0.5) - elastic.worked(0.5)) <= most);
        }
    }

    void limitedLinesKeepTheMemory() {
        ContactLaw<> law(2, 0.01);
        law.remember(1);
        const ContactLaw<> limited = law.limitedTo(50);
        QCOMPARE(limited.slopes().primary, 2.0);
        QCOMPARE(limited.slopes().elastic, 50.0);
        QCOMPARE(limited.largestForce(), 1.0);
        QVERIFY(!limited.isElastic());
    }
};

QTEST_GUILESS_MAIN(TestBilinearLaw)
#include "tst_contact_law.moc"
