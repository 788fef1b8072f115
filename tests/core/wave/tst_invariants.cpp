// SPDX-License-Identifier: GPL-3.0-or-later
// Conditions on every scene, checked over thousands of random ones.
#include <QTest>

#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestInvariants : public QObject {
    Q_OBJECT

  private slots:
    void momentumAndEnergyBalance_data() {
        QTest::addColumn<bool>("extreme");
        QTest::newRow("engineering domain") << false;
        QTest::newRow("extreme domain") << true;
    }
    void momentumAndEnergyBalance() {
        QFETCH(bool, extreme);
        RandomScenes scenes(extreme ? extremeDomain : engineeringDomain, 11);
        // of soft rock pieces of wave are joined: their impulse is kept, their energy to this share of the
        // work
        const double share = extreme ? 4e-10 : 1e-11;
        scenes.forEachSolved(2000, Detail::ledger, [share](const Scene& scene, const Impact& impact) {
            // the impulse is summed from F, the momentum from the waves that are left: independent sums
            QVERIFY2(std::abs(1 - impact.impulse - impact.finalMomentum) <= 1e-11, describe(scene).c_str());
            // the work on the rock is that of the law at the peak force, the energy that of the waves left
            const double energy = impact.hammerWork - impact.rockWork - impact.finalEnergy;
            // a hammer that pushes the rod against the rock does next to no work: the sums round at 1e-15 of
            // F0²t0/Z
            const double tolerance = share * impact.hammerWork + 1e-14;
            QVERIFY2(std::abs(energy) <= tolerance, describe(scene).c_str());
            QVERIFY(impact.cor > -1e-12);
            QVERIFY(impact.finalMomentum <= 1e-12);
        });
    }

    void theRockNeverPulls() {
        RandomScenes scenes(engineeringDomain, 12);
        scenes.forEachSolved(300, Detail::histories, [](const Scene& scene, const Impact& impact) {
            for (const auto& piece : impact.force.pieces())
                for (int k = 0; k <= 8; ++k)
                    QVERIFY2(impact.force.value(piece, piece.length * k / 8) >= -1e-14,
                             describe(scene).c_str());
        });
    }

    void eventsFollowTheContactLaw() {
        RandomScenes scenes(engineeringDomain, 13);
        scenes.forEachSolved(400, Detail::ledger, [](const Scene& scene, const Impact& impact) {
            QVERIFY(!impact.events.empty());
            QCOMPARE(impact.events.front().kind, ContactEvent::contact);
            double last = 0;
            bool apart = true;
            for (const ImpactEvent& event : impact.events) {
                QVERIFY2(event.time >= last, describe(scene).c_str());
                last = event.time;
                QVERIFY2((event.kind == ContactEvent::contact) == apart, describe(scene).c_str());
                apart = event.kind == ContactEvent::separation;
            }
            QVERIFY(impact.events.front().time == impact.firstContactTime);
        });
    }

    void unloadingEventsNeedAnInelasticRock() {
        const Impact elastic = solve({PulseShape::rectangular, {0.5, 1, 10, 0.3}}, Detail::ledger);
        for (const ImpactEvent& event : elastic.events)
            QVERIFY(event.kind == ContactEvent::contact || event.kind == ContactEvent::separation);
        const Impact inelastic = solve({PulseShape::rectangular, {0.5, 0.1, 10, 0.3}}, Detail::ledger);
        int unloadings = 0;
        for (const ImpactEvent& event : inelastic.events) unloadings += event.kind == ContactEvent::unloading;
        QVERIFY(unloadings >= 1);
    }
};

QTEST_GUILESS_MAIN(TestInvariants)
#include "tst_invariants.moc"
