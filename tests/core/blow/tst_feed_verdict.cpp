// SPDX-License-Identifier: GPL-3.0-or-later
// The judgement on the feed: thresholds of theory §10, one set of words, and nothing claimed beyond it.
#include <QTest>

#include <cmath>

#include "core/blow/feed_verdict.h"
#include "core/blow/result_alerts.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/report/alert_words.h"
#include "core/report/feed_words.h"

using namespace drillwave;

namespace {

// 50 blows a second of 40 N s: f I0 = 2000 N.
Scenario drill(std::optional<double> thrust) {
    Scenario scenario;
    scenario.pulse.impulse = 40;
    scenario.drill.blowFrequency = 50;
    scenario.drill.thrust = thrust;
    return scenario;
}

QString textOf(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// The sentence to act on, by e = 0.4, and what it means at the rig.
std::string saidOf(const Scenario& scenario) {
    const FeedVerdict verdict = *judgeFeed(scenario, 0.4);
    return feedDecisionText(decideFeed(scenario, verdict)) + " " + std::string(feedAdvice(verdict.feed));
}

}  // namespace

class TestFeedVerdict : public QObject {
    Q_OBJECT

  private slots:
    void thresholdsAreThoseOfTheTheory() {
        const FeedVerdict verdict = *judgeFeed(drill({}), 0.4);
        QCOMPARE(verdict.feed, Feed::unknown);
        QCOMPARE(verdict.balance, 2000.0);
        QCOMPARE(verdict.fullRate, 2800.0);
        QCOMPARE(verdict.returned, 3600.0);
    }

    void eachRangeHasItsWord_data() {
        QTest::addColumn<double>("thrust");
        QTest::addColumn<QString>("code");
        QTest::addColumn<bool>("warned");
        QTest::newRow("no feed at all") << 0.0 << "pushed_back" << true;
        QTest::newRow("just below f I0") << 1999.0 << "pushed_back" << true;
        QTest::newRow("f I0") << 2000.0 << "penetration_lost" << true;
        QTest::newRow("just below f I0 (1+e)") << 2799.0 << "penetration_lost" << true;
        QTest::newRow("f I0 (1+e)") << 2800.0 << "full_rate" << false;
        QTest::newRow("just below f I0 (1+2e)") << 3599.0 << "full_rate" << false;
        QTest::newRow("f I0 (1+2e)") << 3600.0 << "back_in_time" << false;
        QTest::newRow("ten times as much") << 36000.0 << "back_in_time" << false;  // and at rest
    }

    void eachRangeHasItsWord() {
        QFETCH(double, thrust);
        QFETCH(QString, code);
        QFETCH(bool, warned);
        const FeedVerdict verdict = *judgeFeed(drill(thrust), 0.4);
        QCOMPARE(textOf(name(verdict.feed)), code);
        QVERIFY(!feedWord(verdict.feed).empty());
        // The alert says the very same as the sentence to act on.
        ImpactSummary summary;
        summary.cor = 0.4;
        const std::vector<Alert> alerts = resultAlerts(drill(thrust), summary);
        QCOMPARE(!alerts.empty(), warned);
        if (!warned) return;
        QCOMPARE(alerts[0].code, AlertCode::thrustBelowNeeded);
        QCOMPARE(alerts[0].level, AlertLevel::warning);
        QCOMPARE(alertText(alerts[0]), saidOf(drill(thrust)));
    }

    void aBitAtRestNeedsMoreThanOneThatIsBack() {
        // f I0 (1+e)/(1−e), e = 0.4; for e ≥ 1 there is none.
        QVERIFY(std::abs(judgeFeed(drill({}), 0.4)->resting / (2000 * 1.4 / 0.6) - 1) < 1e-15);
        QCOMPARE(judgeFeed(drill(4600), 0.4)->feed, Feed::backInTime);
        QCOMPARE(judgeFeed(drill(4700), 0.4)->feed, Feed::resting);
        QCOMPARE(judgeFeed(drill(1e6), 1.2)->feed, Feed::backInTime);
        QCOMPARE(name(Feed::resting), name(Feed::backInTime));  // for files
    }

    // A bit at f I0 (1+e) hangs off the rock between blows; what too much feed does is not computed.
    void nothingIsClaimedBeyondTheTheory() {
        for (const double thrust : {1000.0, 2500.0, 3000.0, 4000.0, 9000.0}) {
            const Feed feed = judgeFeed(drill(thrust), 0.4)->feed;
            const QString meaning = textOf(feedMeaning(feed, gapAtBlow(drill(thrust), 0.4)).text());
            QVERIFY(meaning.startsWith(textOf(feedAdvice(feed))));
            QVERIFY(!meaning.contains("hold", Qt::CaseInsensitive));
            QVERIFY(!meaning.contains("over-feed", Qt::CaseInsensitive));
            QCOMPARE(meaning.contains("outside the model"), thrust > 3600);
        }
        QVERIFY(textOf(feedAdvice(Feed::fullRate)).contains("leaves the rock between blows"));
    }

    // Straight down: all of the weight; 12° up: a part of it against the feed. Half of the mass is the rod's.
    void weightAlongTheHoleCountsWhereAnInclinationIsGiven() {
        Scenario scenario = drill(2900);
        const RodProperties rod = propertiesOf(scenario.rod);
        scenario.drill.machineMass = rod.mass;
        QCOMPARE(*judgeFeed(scenario, 0.4)->effective(), 2900.0);
        QVERIFY(!judgeFeed(scenario, 0.4)->force->weight);
        scenario.drill.inclination = 90;
        QCOMPARE(*judgeFeed(scenario, 0.4)->effective(), 2900 + 2 * rod.mass * 9.80665);
        scenario.drill.inclination = -12;
        const FeedVerdict verdict = *judgeFeed(scenario, 0.4);
        const double weight = -2 * rod.mass * 9.80665 * std::sin(12 * std::acos(-1.0) / 180);
        QVERIFY(std::abs(*verdict.force->weight / weight - 1) < 1e-14);
        QCOMPARE(verdict.feed, Feed::penetrationLost);  // 2900 − 132 N, 2800 needed
        QCOMPARE(*verdict.margin(), *verdict.effective() / 2800 - 1);
        const QString sentence = textOf(feedForceText(*verdict.force));
        QVERIFY2(sentence.startsWith("effective force of 2.7"), qPrintable(sentence));
        QVERIFY2(sentence.contains("(thrust 2.9 kN, less 1"), qPrintable(sentence));
        // The alert says the very same.
        ImpactSummary summary;
        summary.cor = 0.4;
        QCOMPARE(alertText(resultAlerts(scenario, summary).at(0)), saidOf(scenario));
        scenario.drill.machineMass.reset();
        QVERIFY(std::abs(*judgeFeed(scenario, 0.4)->force->weight / (weight / 2) - 1) < 1e-14);
    }

    // At the paper's thrust the bit hangs off the rock; in metres and in d0 it is the same gap.
    void theGapAtTheBlowIsToldInMetresAndInD0() {
        const Scenario scenario = drill(2800);
        const GapAtBlow found = *gapAtBlow(scenario, 0.4);
        QCOMPARE(found.feed, 1.4);
        QCOMPARE(found.motion.kind, UndampedMotion::Kind::bouncing);
        QVERIFY(std::abs(found.gap / (found.inD0 * scalesOf(scenario).penetration) - 1) < 1e-14);
        const double v0 = 40 / propertiesOf(scenario.rod).mass;
        QVERIFY(std::abs(found.gap / (0.192 * v0 / 50) - 1) < 1e-12);  // V = 1, a = 0.2, y = 0.2 − 0.008
        const auto saidAt = [](double thrust, double cor) {
            return textOf(
                feedMeaning(judgeFeed(drill(thrust), cor)->feed, gapAtBlow(drill(thrust), cor)).text());
        };
        QVERIFY(saidAt(2800, 0.4).contains("If nothing damps the rebound, the bit is "));
        QVERIFY(saidAt(2800, 0.4).contains(" off the rock when the hammer strikes"));
        QVERIFY(!saidAt(9000, 0.4).contains("off the rock"));
        // Back after a rest, and yet a steady bounce: φ = 2 is between 1.8 and 2.33.
        QVERIFY(gapAtBlow(drill(4000), 0.4)->gap > 0);
        QVERIFY(saidAt(4000, 0.4).contains("goes on bouncing if nothing damps the rebound. It is then "));
        QVERIFY(saidAt(3000, 1.2).contains("steady"));
        QVERIFY(!gapAtBlow(drill({}), 0.4));
    }

    void withoutAFrequencyThereIsNoVerdict() {
        Scenario scenario = drill(1000);
        scenario.drill.blowFrequency.reset();
        QVERIFY(!judgeFeed(scenario, 0.4));
    }
};

QTEST_GUILESS_MAIN(TestFeedVerdict)
#include "tst_feed_verdict.moc"
