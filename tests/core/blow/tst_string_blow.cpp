// SPDX-License-Identifier: GPL-3.0-or-later
// A blow on a drill string in the terms of every other blow.
#include <QTest>

#include "core/blow/blow.h"
#include "core/blow/blow_waves.h"
#include "core/blow/outputs.h"
#include "core/model/form_conversion.h"
#include "core/model/parameter.h"
#include "core/report/alert_words.h"
#include "core/wave/field/bit_history.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

Blow solved(const Scenario& scenario) {
    return solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
}

double output(const Blow& blow, std::string_view name) {
    return findOutput(name)->value({blow.summary, blow.scenario}).value_or(NAN);
}

double efficiencyWith(std::string_view key, double value) {
    Scenario scenario = test::losslessString();
    findParameter(key)->assign(scenario, value);
    return solved(scenario).summary.energy.rockWork;
}

}  // namespace

class TestStringBlow : public QObject {
    Q_OBJECT

  private slots:
    void t38StringHasThePublishedEfficiency() {
        const Blow blow = solved(test::losslessString());
        QVERIFY(blow.isSolved());
        QVERIFY(std::abs(blow.summary.energy.rockWork - 0.501587377477) < 1e-11);
        QVERIFY(blow.summary.efficiencyError < 1e-9);
        QCOMPARE(blow.impact.outcome, Outcome::rebounded);
        QCOMPARE(blow.impact.contacts, 4);
    }

    void efficiencyFollowsRodsAndCouplings() {
        const double ofRods[] = {0.640, 0.559, 0.502, 0.487, 0.482};
        for (int rods = 1; rods <= 5; ++rods)
            QVERIFY(std::abs(efficiencyWith("string.repeat", rods) - ofRods[rods - 1]) < 6e-4);
        const std::pair<double, double> ofCouplings[] = {{0.039, 0.747}, {0.048, 0.607}, {0.065, 0.478}};
        for (const auto& [diameter, efficiency] : ofCouplings)
            QVERIFY(std::abs(efficiencyWith("string.coupling.diameter", diameter) - efficiency) < 6e-4);
    }

    /// Losses take momentum from the string for as long as it is followed: that is no less rebound.
    void requiredFeedWithLossesIsTheImpulseOnTheRockTimesFrequency() {
        for (const double loss : {0.0, 0.05}) {
            std::optional<double> cor;
            for (const double frequency : {100.0, 60.0, 30.0, 10.0}) {
                Scenario scenario = test::losslessString();
                for (const char* key : {"string.coupling.loss", "string.rod.loss"})
                    findParameter(key)->assign(scenario, loss);
                scenario.drill.blowFrequency = frequency;
                const Blow blow = solved(scenario);
                const double onRock = output(blow, "impulse") * blow.scales.impulse;
                QVERIFY(std::abs(output(blow, "thrust") / frequency - onRock) < 1e-9 * onRock);
                QVERIFY(!cor || std::abs(output(blow, "cor") - *cor) < 1e-9);
                cor = output(blow, "cor");
            }
        }
    }

    /// A bit that may come back after the next blow: quick and sure runs end at the same time.
    void whatIsNotOverIsToldAtTheNextBlow() {
        Scenario scenario = test::losslessString();
        findParameter("string.rod.length")->assign(scenario, 10);
        MethodSolver solver;
        const Blow sure = solved(scenario);
        const Blow quick =
            solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted, solver, NetworkAccuracy::quick);
        for (const Blow* blow : {&sure, &quick}) {
            QVERIFY(blow->isSolved());
            QCOMPARE(blow->impact.outcome, Outcome::nextBlow);
            QVERIFY(std::abs(output(*blow, "end_time") * blow->scales.time - 1.0 / 60) < 1e-15);
        }
        const double error = std::abs(output(quick, "cor") - output(sure, "cor"));
        QVERIFY(error <= output(quick, "cor_error") + output(sure, "cor_error"));
        QVERIFY2(output(quick, "cor_error") < 1e-3, QByteArray::number(output(quick, "cor_error")));
    }

    void historiesAtTheBitAreThoseOfTheBlow() {
        const Blow blow = solveBlow(test::losslessString(), {}, Detail::histories);
        QVERIFY(blow.impact.hasHistories() && blow.impact.waves);
        const double end = blow.summary.endTime;
        double peak = 0;
        for (const ImpactEvent& event : blow.impact.events) {
            const double force = impactForce(blow.impact, event.time);
            peak = std::max(peak, force);
            if (event.kind == ContactEvent::contact || event.kind == ContactEvent::separation)
                QVERIFY(std::abs(force) < 2e-3);  // a kink within a cell
        }
        QVERIFY(std::abs(peak - blow.summary.peakForce) < 2e-3);
        // the impulse is in units of that of the hammer: p0 of F0 t0
        const double hammer = blow.scales.impulse / (blow.scales.force * blow.scales.time);
        QVERIFY(std::abs(impactImpulse(blow.impact, end) / hammer - blow.summary.impulse) < 1e-7);
        QVERIFY(!solved(test::losslessString()).impact.hasHistories());
    }

    void placesAreCountedAlongTheString() {
        const DrillString drill = test::losslessString().drillString;
        QCOMPARE(stringPlace(drill, 0), (StringPlace{2, 0}));
        const std::size_t last = allSections(drill).size() - 1;
        QCOMPARE(stringPlace(drill, 1).section, last);
        QVERIFY(std::abs(stringPlace(drill, 1).share - 1) < 1e-12);
        // Below the shank is the hammer, of 300 and 250 mm.
        QCOMPARE(stringPlace(drill, hammerRear(drill)), (StringPlace{0, 0}));
        QCOMPARE(stringPlace(drill, -1), (StringPlace{0, 0}));
        const double inFront = shareOfString(drill, {1, 0.25});
        QVERIFY(std::abs(inFront * 12.13 + 0.75 * 0.25) < 1e-12);
        QCOMPARE(stringPlace(drill, inFront).section, std::size_t{1});
        QVERIFY(std::abs(stringPlace(drill, inFront).share - 0.25) < 1e-9);
        const StringPlace middle = middleOfLongest(drill);
        QCOMPARE(allSections(drill)[middle.section]->name, std::string("rod"));
        const StringPlace again = stringPlace(drill, shareOfString(drill, middle));
        QCOMPARE(again.section, middle.section);
        QVERIFY(std::abs(again.share - 0.5) < 1e-12);
    }

    void itsHistoryIsThatOfTheBlow() {
        const Blow blow = solveBlow(test::losslessString(), {}, Detail::histories);
        const StringHistory history(blow.impact, blow.problem, middleOfLongest(blow.scenario.drillString));
        const std::vector<RodState> rows = history.sampled();
        QVERIFY(rows.size() > 1000);
        QVERIFY(std::ranges::is_sorted(rows, {}, &RodState::time));
        QCOMPARE(rows.front().time, 0.0);
        QCOMPARE(rows.back().time, history.end());  // of one of the two runs of a blow
        QVERIFY(history.end() > blow.summary.separationTime);
        QVERIFY(std::abs(rows.back().impulse - blow.summary.impulse) < 1e-7);
        QVERIFY(std::abs(rows.back().momentum - blow.summary.stringMomentum) < 1e-7);
        double deepest = 0;
        for (const RodState& now : rows) {
            deepest = std::max(deepest, now.penetration);
            QVERIFY(std::abs(now.positiveWave + now.negativeWave - now.normalForce) < 1e-12);
        }
        QVERIFY(std::abs(deepest - blow.summary.maxPenetration) < 1e-4 * deepest);
        // the first wave of the hammer arrives after its way through adapter, coupling and half a rod
        const auto first =
            std::ranges::find_if(rows, [](const RodState& now) { return now.normalForce < -1e-6; });
        const std::vector<UniformSection>& sections = blow.problem.sections;
        const double way = sections[2].transitTime + sections[3].transitTime + sections[4].transitTime / 2;
        QVERIFY(std::abs(first->time - way) < 1e-9);
    }

    void everyShareOfTheEnergyIsThere() {
        const Blow blow = solved(test::losslessString());
        const double sum = output(blow, "efficiency") + output(blow, "rebound_energy") +
                           output(blow, "residual_wave_energy") + output(blow, "hammer_rebound_energy") +
                           output(blow, "hammer_wave_energy") + output(blow, "joint_loss") +
                           output(blow, "rod_loss");
        QVERIFY(std::abs(sum - 1) < 1e-12);
    }

    /// For a hammer of whole millimetres that strikes once, the string has the results of the rod.
    void aRodAsAStringHasItsStressesInTheBlowAndAfter() {
        Scenario rod;
        for (const Example& example : builtInExamples())
            if (example.name == "t38_medium_rock") rod = parseScenario(example.text, "t38").scenario;
        const double speed = std::sqrt(rod.rod.youngsModulus / rod.rod.density);
        rod.pulse.duration = 2 * 0.52 / speed;
        const Blow ofRod = solveBlow(rod, {}, Detail::histories);
        const Blow ofString = solved(stringOf(rod).scenario);
        for (const char* name :
             {"peak_compression", "peak_tension", "peak_compression_after", "peak_tension_after"}) {
            const double expected = output(ofRod, name), found = output(ofString, name);
            QVERIFY2(std::abs(found - expected) < 1e-3 * expected,
                     QString("%1: %2, not %3").arg(name).arg(found).arg(expected).toUtf8());
        }
        QVERIFY(output(ofString, "peak_tension_after") > 1.2 * output(ofString, "peak_tension"));
    }

    void whatIsNotFollowedAfterTheBlowHasNoStresses() {
        Scenario scenario = test::losslessString();
        scenario.drillString.endTime = 8e-3;  // the last separation is at 7.49 ms, a transit takes 2.35 ms
        const Blow blow = solved(scenario);
        QVERIFY(output(blow, "peak_tension") > 0);
        QVERIFY(std::isnan(output(blow, "peak_tension_after")));
    }

    void velocityIsOnlyAScale() {
        Scenario scenario = test::losslessString();
        const Blow slow = solved(scenario);
        scenario.drillString.hammer.velocity *= 2;
        const Blow fast = solved(scenario);
        QVERIFY(std::abs(slow.summary.energy.rockWork - fast.summary.energy.rockWork) < 1e-13);
        const double slowest = sectionStresses(slow.scenario, slow.impact)[2].tension.stress;
        const double fastest = sectionStresses(fast.scenario, fast.impact)[2].tension.stress;
        QVERIFY(std::abs(fastest / slowest - 2) < 1e-12);
    }

    void sectionsBeyondTheirStrengthAreToldOnce() {
        Scenario scenario = test::losslessString();
        for (StringPart& part : scenario.drillString.parts)
            for (Section& section : part.sections)
                if (section.name == "rod") section.yieldStrength = 300e6, section.fatigueStrength = 400e6;
        const Blow blow = solved(scenario);
        int told = 0;
        for (const Alert& alert : blow.alerts) {
            if (alert.code == AlertCode::stressAboveFatigue) QFAIL("362 MPa are less than 400 MPa");
            if (alert.code != AlertCode::stressAboveYield) continue;
            ++told;
            QCOMPARE(alert.argument("section").value, 9.0);  // the last rod, behind two sections of hammer
            QVERIFY(alertText(alert).find("362.2 MPa") != std::string::npos);
        }
        QCOMPARE(told, 1);
    }

    void stressesThatWereLeftOutAreRemarkedOn() {
        Blow blow = solved(test::losslessString());
        const auto remarks = [&blow] {
            return std::ranges::count(stringAlerts(blow.scenario, blow.impact), AlertCode::stressesLeftOut,
                                      &Alert::code);
        };
        QCOMPARE(remarks(), 0);
        blow.impact.sections.clear();
        blow.impact.leftOutForces = true;
        QCOMPARE(remarks(), 1);
    }

    void lengthsThatShareNoCellAreRemarkedOn() {
        Scenario scenario = test::losslessString();
        scenario.drillString.hammer.sections[0].length = 0.3 * M_SQRT2 / 1.4;
        const auto remark = [](const Blow& blow) {
            const auto found = std::ranges::find(blow.alerts, AlertCode::lengthsRounded, &Alert::code);
            return found == blow.alerts.end() ? Alert{} : *found;
        };
        const Alert ofEfficiency = remark(solved(scenario));
        QVERIFY(ofEfficiency.has("efficiency_error") && !ofEfficiency.has("shared_cell"));

        // elastic rock keeps nothing, whatever the lengths are: what is off is the rebound
        findParameter("bit_rock.gamma")->assign(scenario, 1);
        const Blow elastic = solved(scenario);
        const Alert ofRebound = remark(elastic);
        QVERIFY(ofRebound.has("cor_error") && !ofRebound.has("efficiency_error"));
        QCOMPARE(ofRebound.argument("cor_error").value, elastic.summary.corError);
    }

    void aCellThatIsTooMuchWorkIsNotCalledMissing() {
        const Scenario scenario = test::losslessString();
        NetworkSolver solver;
        const Problem problem = problemOf(scenario);
        const Impact whole = solver.solve(problem, {});
        QCOMPARE(whole.sharedCell, 0.0);
        NetworkSettings settings;
        settings.mostCells = whole.pieces / 10;
        const Impact rounded = solver.solve(problem, settings);
        QVERIFY(rounded.outcome != Outcome::notSolved);
        QVERIFY(rounded.rounding > 0 && rounded.sharedCell > 0);
        const std::vector<Alert> alerts = stringAlerts(scenario, rounded);
        const auto found = std::ranges::find(alerts, AlertCode::lengthsRounded, &Alert::code);
        QVERIFY(found != alerts.end() && found->has("shared_cell"));
    }
};

QTEST_GUILESS_MAIN(TestStringBlow)
#include "tests/support/lossless_string.h"
#include "tst_string_blow.moc"
