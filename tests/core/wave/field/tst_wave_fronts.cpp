// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lines of an x–t diagram begin.
#include <QTest>

#include "core/wave/field/wave_fronts.h"
#include "tests/support/scenes.h"

using namespace drillwave;
using namespace drillwave::test;

class TestWaveFronts : public QObject {
    Q_OBJECT

  private slots:
    void aBlowHasAFrontWhereItBeginsJumpsAndEnds() {
        const auto fronts = [](PulseShape shape) { return pulseFronts(pulseForceOf(shape)); };
        for (const PulseShape shape :
             {PulseShape::rectangular, PulseShape::triangular, PulseShape::halfSine, PulseShape::trapezoid})
            QCOMPARE(fronts(shape), (std::vector<double>{0, 1}));
        QCOMPARE(fronts(PulseShape::exponential), std::vector<double>{0});
        QCOMPARE(fronts(PulseShape::rigidBody), std::vector<double>{0});
    }

    void aPistonsStaircaseHasAFrontAtEveryStepThatCanBeSeen() {
        // The same impedance: one step. Twice: steps of 1, 1/3, 1/9, … with jumps of 2/3 as much.
        QCOMPARE(pulseFronts(pulseForceOf(PulseShape::piston, 1)), (std::vector<double>{0, 1}));
        QCOMPARE(pulseFronts(pulseForceOf(PulseShape::piston, 2)), (std::vector<double>{0, 1, 2, 3, 4}));
        QVERIFY(pulseFronts(pulseForceOf(PulseShape::piston, 1000)).size() < 10);
    }

    void aTableHasNoJumpsButABeginningAndAnEnd() {
        Scenario scenario;
        scenario.form = ScenarioForm::dimensionless;
        scenario.pulse.shape = PulseShape::table;
        scenario.pulse.tablePoints = {{0, 0}, {1, 3}, {2, 3}, {3, 0}, {4, 0}};
        QCOMPARE(pulseFronts(pulseForceOf(scenario)), (std::vector<double>{0, 1}));
    }

    void contactsAreTheTimesFromTouchingToSeparation() {
        RandomScenes scenes(engineeringDomain, 3);
        scenes.forEachSolved(200, Detail::summary, [](const Scene& scene, const Impact& impact) {
            const auto contacts = contactIntervals(impact);
            QCOMPARE(static_cast<int>(contacts.size()), impact.contacts);
            double sum = 0;
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                QVERIFY(contacts[i].end >= contacts[i].begin);
                QVERIFY(i == 0 || contacts[i].begin >= contacts[i - 1].end);
                sum += contacts[i].end - contacts[i].begin;
            }
            QVERIFY2(std::abs(sum - impact.contactDuration) <= 1e-9 * impact.separationTime,
                     describe(scene).c_str());
            QCOMPARE(contacts.back().end, impact.separationTime);
        });
    }
};

QTEST_GUILESS_MAIN(TestWaveFronts)
#include "tst_wave_fronts.moc"
