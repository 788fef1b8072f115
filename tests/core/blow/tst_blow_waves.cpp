// SPDX-License-Identifier: GPL-3.0-or-later
// Rods and strings in one look at their waves.
#include <QTest>

#include "core/blow/blow_waves.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Blow solvedExample(std::string_view name) {
    const Example& example = *findExample(name);
    return solveBlow(parseScenario(example.text, std::string(name)).scenario, {}, Detail::histories);
}

}  // namespace

class TestBlowWaves : public QObject {
    Q_OBJECT

  private slots:
    void jointsAreWhereSectionsMeet() {
        const Blow blow = solvedExample("t38_string");
        const DrillString& drill = blow.scenario.drillString;
        const std::vector<double> joints = sectionJoints(drill);
        const std::vector<const Section*> sections = allSections(drill);
        QCOMPARE(joints.size(), sections.size() + 1);
        const std::size_t hammer = drill.hammer.sections.size();
        QCOMPARE(joints[hammer], 0.0);
        QCOMPARE(joints.back(), 1.0);
        for (std::size_t j = 0; j < sections.size(); ++j)
            QVERIFY(std::abs((joints[j + 1] - joints[j]) * blow.scales.length - sections[j]->length) < 1e-12);
        // as other pages count places
        for (const double share : {0.001, 0.3, 0.62, 0.999}) {
            const StringPlace place = stringPlace(drill, share);
            QVERIFY(joints[place.section] <= share && share <= joints[place.section + 1]);
        }
        QCOMPARE(BlowWaves(blow).rear(), joints.front());
    }

    void stringAndHistoryHaveTheSameForces() {
        const Blow blow = solvedExample("r32_string");
        const BlowWaves waves(blow);
        int compared = 0;
        for (const double x : {0.05, 0.4, 0.93}) {
            const StringHistory history(blow.impact, blow.problem, stringPlace(blow.scenario.drillString, x));
            for (double t = 0.013; t < waves.end(); t += 0.37, ++compared) {
                const RodState now = history.at(t);
                QVERIFY(std::abs(waves.value(WaveQuantity::force, x, t) - now.normalForce) < 1e-9);
                // velocities in F0/Z, of which v0 has two
                QVERIFY(std::abs(waves.value(WaveQuantity::velocity, x, t) - 2 * now.velocity) < 1e-9);
                QVERIFY(std::abs(waves.impactForce(t) - now.impactForce) < 1e-9);
            }
        }
        QVERIFY(compared > 200);
    }

    // One state of rods and strings: N is the sum of its waves and what pictures show, from the rear to the
    // bit.
    void theStateOfEitherIsWhatPicturesShow() {
        for (const char* name : {"t38_medium_rock", "t38_string"}) {
            const Blow blow = solvedExample(name);
            const BlowWaves waves(blow);
            const double rear = waves.rear(), last = std::min(waves.end(), 60.0);
            double largest = 0;
            for (const double share : {0.002, 0.3, 0.77, 0.999})
                for (double t = 0.017; t < last; t += 0.41) {
                    const double x = std::lerp(rear, 1.0, share);
                    const RodState now = waves.state(x, t);
                    QVERIFY(std::abs(now.normalForce - waves.value(WaveQuantity::force, x, t)) < 1e-9);
                    QVERIFY(std::abs(now.positiveWave + now.negativeWave - now.normalForce) < 1e-12);
                    QVERIFY(std::abs(now.impactForce - waves.impactForce(t)) < 1e-9);
                    largest = std::max(largest, now.faceForce);
                }
            QCOMPARE(largest > 0, blow.isOfString());
        }
    }

    void theBitIsWhereTheHistoryHasIt() {
        const Blow blow = solvedExample("t51_string");
        const BlowWaves waves(blow);
        const std::vector<ContactInterval> contacts = waves.contacts();
        QCOMPARE(static_cast<int>(contacts.size()), blow.summary.contacts);
        const StringHistory history(blow.impact, blow.problem, stringPlace(blow.scenario.drillString, 1));
        int touching = 0, apart = 0;
        for (double t = 0.1; t < waves.end(); t += 0.4) {
            const BitState bit = waves.bit(contacts, t);
            const RodState now = history.at(t);
            if (bit.touching) {
                QCOMPARE(bit.penetration, now.penetration);
                ++touching;
            } else {
                QVERIFY(bit.gap >= 0);
                QVERIFY(now.impactForce < 1e-9);
                ++apart;
            }
        }
        QVERIFY(touching > 10 && apart > 10);
    }

    void hammerAndStringTouchWhileTheyPush() {
        const Blow blow = solvedExample("r32_string");
        const BlowWaves waves(blow);
        const std::vector<ContactInterval> contacts = waves.faceContacts();
        QVERIFY(contacts.size() > 1);  // it is struck again
        QVERIFY(std::abs(contacts.front().begin) < 1e-9);
        const StringHistory history(blow.impact, blow.problem, stringPlace(blow.scenario.drillString, 0));
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            QVERIFY(history.at((contacts[i].begin + contacts[i].end) / 2).faceForce > 1e-6);
            if (i + 1 < contacts.size())
                QCOMPARE(history.at((contacts[i].end + contacts[i + 1].begin) / 2).faceForce, 0.0);
        }
        QVERIFY(BlowWaves(solvedExample("t38_medium_rock")).faceContacts().empty());
    }

    void whatIsInterestingEndsARoundTripAfterTheLastContact() {
        for (const char* name : {"r32_string", "t38_string", "t51_string", "t38_medium_rock"}) {
            const Blow blow = solvedExample(name);
            const BlowWaves waves(blow);
            const TimeSpan span = waves.interesting();
            QCOMPARE(span.begin, 0.0);
            QVERIFY(std::abs(span.end - blow.impact.separationTime - waves.roundTrip()) < 1e-9);
            QVERIFY(span.end <= waves.end());
        }
    }

    void aStringThatIsFollowedToAnEndIsShownToThere() {
        Scenario scenario = solvedExample("t38_string").scenario;
        for (const double milliseconds : {0.5, 4.0}) {  // before the bit is reached, and in the blow
            scenario.drillString.endTime = milliseconds * 1e-3;
            const Blow blow = solveBlow(scenario, {}, Detail::histories);
            const TimeSpan span = BlowWaves(blow).interesting();
            QCOMPARE(span.begin, 0.0);
            QVERIFY(std::abs(span.end * blow.scales.time - milliseconds * 1e-3) < 1e-9);
        }
    }

    // A blow that is cut off before the separation has no separation time, or that of an earlier contact.
    void aContactThatIsCutOffLastsToTheEnd() {
        Scenario scenario = test::losslessString();
        for (const auto& [milliseconds, contacts] : {std::pair(2.5, 1), std::pair(3.2, 2)}) {
            scenario.drillString.endTime = milliseconds * 1e-3;
            const Blow blow = solveBlow(scenario, {}, Detail::histories);
            const BlowWaves waves(blow);
            const std::vector<ContactInterval> touching = waves.contacts();
            QCOMPARE(static_cast<int>(touching.size()), contacts);
            QCOMPARE(touching.back().end, waves.end());
            QVERIFY(waves.bit(touching, 0.999 * waves.end()).touching);
            QVERIFY(waves.impactForce(0.999 * waves.end()) > 0.1);
            QCOMPARE(waves.interesting().end, waves.end());
        }
    }

    void ofARodEverythingIsAsBefore() {
        const Blow blow = solvedExample("t38_medium_rock");
        const BlowWaves waves(blow);
        QCOMPARE(waves.rear(), 0.0);
        QVERIFY(std::isinf(waves.end()));
        QVERIFY(waves.interesting() == interestingTime(blow.impact, blow.problem.force()));
        const RasterGrid grid{0, 1, 20, 0, 30, 20};
        QVERIFY(waves.raster(WaveQuantity::force, grid).values ==
                waveRaster(blow.impact, WaveQuantity::force, grid).values);
        QCOMPARE(waves.fronts(), pulseFronts(blow.problem.force()));
    }
};

QTEST_GUILESS_MAIN(TestBlowWaves)
#include "tests/support/lossless_string.h"
#include "tst_blow_waves.moc"
