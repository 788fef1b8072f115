// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates of the required feed force: forces and states as they are defined, whatever e, weight and
// frequency.
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/blow/feed_estimate.h"
#include "core/blow/result_alerts.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"

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

constexpr ReboundsOverGaps someGaps{{0.5, 0}, {1.5, 0}};

std::string stateOf(const std::optional<FeedEstimate>& feed) {
    return feed && feed->state() ? std::string(name(*feed->state())) : std::string("none");
}

}  // namespace

class TestFeedEstimate : public QObject {
    Q_OBJECT

  private slots:
    void forcesAreThoseOfTheTheory() {
        const FeedEstimate feed = *feedEstimate(drill({}), {0.4, 0}, 1, someGaps);
        QCOMPARE(feed.balance, 2000.0);
        QCOMPARE(feed.need(ThrustCase::scenario).thrust, 2800.0);
        QCOMPARE(feed.need(ThrustCase::scenario).thrustUndamped, 3600.0);
        QCOMPARE(feed.need(ThrustCase::gapQuantile).thrust, 3000.0);
        QCOMPARE(feed.need(ThrustCase::rigidRock).thrust, 4000.0);
        QCOMPARE(feed.need(ThrustCase::elasticWorst).thrust, 5000.0);
        QCOMPARE(feed.largestCase(), ThrustCase::elasticWorst);
        QVERIFY(feed.isOfAllGaps() && !feed.state() && !feed.margin());
    }

    void eachRangeHasItsState_data() {
        QTest::addColumn<double>("thrust");
        QTest::addColumn<bool>("ofAllGaps");
        QTest::addColumn<QByteArray>("state");
        QTest::addColumn<bool>("isWarned");
        const auto row = [](double thrust, bool ofAllGaps, const char* state, bool isWarned) {
            QTest::addRow("%g N, %s", thrust, ofAllGaps ? "all gaps" : "this blow and rigid rock")
                << thrust << ofAllGaps << QByteArray(state) << isWarned;
        };
        for (const bool ofAllGaps : {false, true}) {
            row(0, ofAllGaps, "pushed_back", true);
            row(1999, ofAllGaps, "pushed_back", true);
            row(2000, ofAllGaps, "below_required", true);
            row(2799, ofAllGaps, "below_required", true);
            row(2800, ofAllGaps, "required_at_this_gap", false);
            row(3999, ofAllGaps, "required_at_this_gap", false);
        }
        row(4000, false, "required_met", false);
        row(4000, true, "required_at_this_gap", false);
        row(5999, false, "required_met", false);
        row(6000, false, "return_met", false);
        row(5000, true, "required_met", false);
        row(7999, true, "required_met", false);
        row(8000, true, "return_met", false);
    }

    void eachRangeHasItsState() {
        QFETCH(double, thrust);
        QFETCH(bool, ofAllGaps);
        QFETCH(QByteArray, state);
        QFETCH(bool, isWarned);
        const std::optional<FeedEstimate> feed =
            feedEstimate(drill(thrust), {0.4, 0}, 1, ofAllGaps ? std::optional(someGaps) : std::nullopt);
        QCOMPARE(stateOf(feed), state.toStdString());
        QCOMPARE(feed->isTooLittle(), isWarned);
    }

    void theAlertIsThatOfTheState() {
        for (const double thrust : {0.0, 1999.0, 2500.0, 2799.0, 2800.0, 4000.0}) {
            ImpactSummary summary;
            summary.cor = 0.4;
            const std::vector<Alert> alerts = resultAlerts(drill(thrust), summary);
            const bool isWarned =
                std::ranges::find(alerts, AlertCode::thrustBelowNeeded, &Alert::code) != alerts.end();
            QCOMPARE(isWarned, feedEstimate(drill(thrust), {0.4, 0})->isTooLittle());
        }
    }

    void aStringThatStillMovesToTheRockCountsAsNoRebound() {
        const FeedEstimate feed = *feedEstimate(drill(2500), {-0.2, 0}, 1.1);
        QCOMPARE(feed.balance, 2200.0);
        QCOMPARE(feed.need(ThrustCase::scenario).thrust, 2200.0);
        QCOMPARE(feed.need(ThrustCase::scenario).thrustUndamped, 2200.0);
    }

    void theWeightAlongTheHoleCounts() {
        Scenario scenario = drill(2500);
        scenario.drill.inclination = 90;
        scenario.drill.machineMass = 100;
        const FeedEstimate feed = *feedEstimate(scenario, {0.4, 0});
        const double weight = (100 + chainProperties(scenario).mass) * 9.80665;
        QVERIFY(std::abs(feed.weight - weight) < 1e-9);
        QVERIFY(std::abs(*feed.effective() - 2500 - weight) < 1e-9);
        QVERIFY(std::abs(feed.thrustFor(4000) - (4000 - weight)) < 1e-9);
        QVERIFY(std::abs(feed.frequencyFor(4000) - 50 * (2500 + weight) / 4000) < 1e-9);
    }

    void noEstimateAppliesWhileWavesAreStillOnTheirWay() {
        Scenario scenario = drill(1e5);
        const double unity = 50 * *roundTripsBetweenBlows(drill(1e5));  // Hz at which n_b is 1
        scenario.drill.blowFrequency = 1.01 * unity;
        QCOMPARE(stateOf(feedEstimate(scenario, {0.4, 0})), std::string("not_applicable"));
        scenario.drill.blowFrequency = 0.99 * unity;
        QVERIFY(stateOf(feedEstimate(scenario, {0.4, 0})) != "not_applicable");
    }

    // At the paper's thrust the bit hangs off the rock; in metres and in d0 it is the same gap.
    void theGapAtTheBlowIsOneInMetresAndInD0() {
        const Scenario scenario = drill(2800);
        const GapAtBlow found = *gapAtBlow(scenario, 0.4);
        QCOMPARE(found.feed, 1.4);
        QCOMPARE(found.motion.kind, UndampedMotion::Kind::bouncing);
        QVERIFY(std::abs(found.gap / (found.inD0 * scalesOf(scenario).penetration) - 1) < 1e-14);
        const double v0 = 40 / propertiesOf(scenario.rod).mass;
        QVERIFY(std::abs(found.gap / (0.192 * v0 / 50) - 1) < 1e-12);  // V = 1, a = 0.2, y = 0.2 − 0.008
    }

    void nothingIsEstimatedWithoutUnitsOrFrequency() {
        Scenario scenario = drill(2500);
        scenario.drill.blowFrequency.reset();
        QVERIFY(!feedEstimate(scenario, {0.4, 0}));
        QVERIFY(!gapAtBlow(drill({}), 0.4));
    }
};

QTEST_GUILESS_MAIN(TestFeedEstimate)
#include "tst_feed_estimate.moc"
