// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of the remarks on a blow: one for every code, from nothing but its arguments.
#include <QTest>

#include <set>

#include "core/blow/result_alerts.h"
#include "core/model/alerts.h"
#include "core/report/alert_words.h"
#include "core/text/enum_names.h"

using namespace drillwave;

namespace {

QString textOf(const Alert& alert) {
    return QString::fromStdString(alertText(alert));
}

/// A remark and what is to be said.
struct Example {
    Alert alert;
    const char* sentence;
};

const std::vector<Example>& examples() {
    constexpr AlertLevel note = AlertLevel::information;
    constexpr AlertLevel warning = AlertLevel::warning;
    static const std::vector<Example> all{
        {{warning, AlertCode::implausibleValue, "rod.youngs_modulus", {{"value", 210, Quantity::stress}}},
         "The input Young's modulus E = 0.00021 MPa is outside its typical range, 60 GPa to 250 GPa."},
        {{warning, AlertCode::longPulse, "tau", {{"late_impulse", 0.1239}}},
         "When the first reflection returns to the hammer, 12.3 % of the impulse of the blow is still to "
         "come. A real hammer would feel the reflection, but here the hammer force is prescribed. To include "
         "this effect, use a drill string with a hammer."},
        {{note, AlertCode::defaultHammer, "pulse.impedance_ratio", {}},
         "No hammer data are given. The hammer is assumed to have the impedance of the rod and to give a "
         "rectangular blow. Enter the data of the piston."},
        {{note,
          AlertCode::defaultHammer,
          "pulse.length",
          {{"pulse.length", 0.5, Quantity::length},
           {"pulse.diameter", 0.038, Quantity::length},
           {"pulse.velocity", 10, Quantity::velocity}}},
         "The hammer is the default one (hammer length 500 mm, hammer diameter 38 mm, hammer velocity 10 "
         "m/s, the material of the rod). Give the data of the rock drill's piston."},
        {{note, AlertCode::pistonImpedance, "pulse.diameter", {{"ratio", 0.5}}},
         "The impedance of the hammer is below that of the rod. The hammer therefore bounces back after one "
         "force step, and the rod receives more than the momentum of the hammer."},
        {{note, AlertCode::pistonImpedance, "pulse.diameter", {{"ratio", 2}}},
         "The impedance of the hammer is above that of the rod: the force falls in ever smaller steps. "
         "Reflections that return to the hammer are neglected here."},
        {{note, AlertCode::gapWithoutEffect, "delta", {}},
         "The rod moves as a rigid body until it meets the rock. The gap between bit and rock therefore only "
         "shifts the time of contact and has no other effect."},
        {{warning,
          AlertCode::thrustBelowNeeded,
          "drill.thrust",
          {{"installed", 1500, Quantity::force},
           {"balance", 2000, Quantity::force},
           {"required", 2800, Quantity::force},
           {"frequency", 50, Quantity::frequency}}},
         "The feed force of 1.5 kN is less than the mean force of the blows, 2 kN: the machine is pushed "
         "back. For this blow, the feed force must be at least 2.8 kN at 50 Hz, or the blow frequency "
         "at most 26.7 Hz with the present feed force. Friction, rotation and buckling are not modelled."},
        {{note, AlertCode::superRebound, "", {{"cor", 1.25}}},
         "The rod rebounds with more momentum than it had before impact (e = 1.25). An estimate for rigid "
         "rock (e = 1) gives too small a feed force."},
        {{note, AlertCode::severalContacts, "", {{"contacts", 3}}},
         "The bit hits the rock 3 times in this blow: reflected waves push it against the rock again."},
        {{note,
          AlertCode::closedFormInvalid,
          "tau",
          {{"tau", 0.4}, {"closed_form_cor", 0.5}, {"difference", 0.125}}},
         "The closed-form solution for elastic rock does not apply, because the blow is longer than a round "
         "trip in the rod (tau = 0.4 < 0.5). Its coefficient of restitution, e = 0.5, has an error of "
         "0.125."},
        {{note,
          AlertCode::closedFormInvalid,
          "delta",
          {{"delta", 0.3}, {"closed_form_cor", 0.5}, {"difference", 0.125}}},
         "The closed-form solution for elastic rock does not apply, because the bit meets the rock in the "
         "middle of a wave (delta = 0.3 is not a whole number). Its coefficient of restitution, e = 0.5, has "
         "an error of 0.125."},
        {{note,
          AlertCode::closedFormInvalid,
          "bit_rock.law",
          {{"bit_rock.law", 2}, {"closed_form_cor", 0.5}, {"difference", 0.125}}},
         "The closed-form solution for elastic rock does not apply, because the loading curve of the rock is "
         "not a straight line. Its coefficient of restitution, e = 0.5, has an error of 0.125."},
        {{warning, AlertCode::implausibleValue, "bit_rock.corner.2.force", {{"value", 1e6, Quantity::force}}},
         "The input force of corner 2 = 1000 kN is outside its typical range, 5 kN to 500 kN."},
        {{warning, AlertCode::implausibleValue, "bit_rock.corner.2.force", {{"value", 9, Quantity::ratio}}},
         "The input force of corner 2 = 9 is outside its typical range, 0.05 to 2."},
        {{note,
          AlertCode::cornersWithoutEffect,
          "bit_rock.law",
          {{"peak_force", 80e3, Quantity::force}, {"corner_force", 90e3, Quantity::force}}},
         "The force on the rock reaches only 80 kN, below the first corner of the loading curve at 90 kN. "
         "The rock therefore acts as if its loading curve were one straight line."},
        {{note,
          AlertCode::closedFormInvalid,
          "beta",
          {{"beta", 0.02}, {"closed_form_cor", 0.5}, {"difference", 0.125}}},
         "The closed-form solution for elastic rock does not apply, because the bit is still on the rock "
         "when the next reflection arrives. Its coefficient of restitution, e = 0.5, has an error of 0.125."},
        {{warning, AlertCode::inputDecides, "", {{"contacts", 40}, {"cor_error", 2e-4}}},
         "The bit chatters on the rock (40 contacts). Tiny changes of the input then change the coefficient "
         "of restitution e, which can be known only to within 0.00021. A longer rod, a shorter blow or a "
         "softer rock reduces the chatter."},
        {{warning, AlertCode::reducedAccuracy, "", {{"cor_error", 2e-8}}},
         "The numerical error of the coefficient of restitution e may be as large as 2.1e-08."},
        {{warning,
          AlertCode::stressAboveYield,
          "rod.yield_strength",
          {{"compression", 360e6, Quantity::stress},
           {"place", 1.83, Quantity::length},
           {"time", 600e-6, Quantity::time},
           {"strength", 300e6, Quantity::stress}}},
         "The rod would yield: during the blow the stress reaches 360 MPa in compression, at 1.83 m from the "
         "hammer and 600 us after the start of the blow. Its yield strength is 300 MPa."},
        {{note,
          AlertCode::stressAboveFatigue,
          "rod.fatigue_strength",
          {{"tension", 160e6, Quantity::stress},
           {"place", 0.915, Quantity::length},
           {"time", 4e-3, Quantity::time},
           {"strength", 150e6, Quantity::stress}}},
         "Every blow loads the rod above its fatigue strength of 150 MPa, by residual waves that are not "
         "damped here. The stress reaches 160 MPa in tension, at 915 mm from the hammer and 4 ms after the "
         "start of the blow."},
        {{note, AlertCode::residualWaves, "drill.blow_frequency", {{"round_trips", 4.5}}},
         "The waves of a blow make only 4.5 round trips in the string before the next blow, and they still "
         "act on that blow (undamped). This may change the penetration by up to 10 %, depending on blow "
         "frequency and string length; to compute it, use `drill`."},
        {{note, AlertCode::residualWaves, "drill.blow_frequency", {{"round_trips", 2}, {"wave_loss", 0.1}}},
         "The waves of a blow make only 2 round trips in the string before the next blow, and they still act "
         "on that blow (81 % of the wave is left, with a loss of 10 % per round trip). This may change the "
         "penetration by up to 10 %, depending on blow frequency and string length; to compute it, use "
         "`drill`."},
        {{warning, AlertCode::residualWaves, "drill.blow_frequency", {{"round_trips", 4.06}, {"whole", 4}}},
         "The waves of a blow make only 4.06 round trips in the string before the next blow, and they still "
         "act on that blow (undamped). Because 4.06 is close to the whole number 4, they arrive at the same "
         "time as the next blow. This may change the penetration by up to 10 %; to compute it, use `drill`."},
        {{warning,
          AlertCode::stressAboveYield,
          "string.9.yield_strength",
          {{"tension", 362.2e6, Quantity::stress},
           {"place", 1.5, Quantity::length},
           {"time", 4e-3, Quantity::time},
           {"strength", 300e6, Quantity::stress},
           {"section", 9}},
          Message("3rd rod")},
         "3rd rod would yield: the stress in this section reaches 362.2 MPa in tension, at 1.5 m from its "
         "rear end and 4 ms after the start of the blow. Its yield strength is 300 MPa."},
        {{AlertLevel::information, AlertCode::wavesThinned, "", {{"difference", 2.5e-3}}},
         "This blow has too many waves to store them all. Plots of waves and forces therefore show a coarser "
         "model of the string. Its coefficient of restitution and efficiency differ by at most 0.0026."},
        {{warning,
          AlertCode::lengthsRounded,
          "",
          {{"time", 2e-7, Quantity::time}, {"efficiency_error", 1e-3}}},
         "The transit times of the sections share no time step: they were rounded by up to 0.2 us, and the "
         "efficiency may have an error of 0.0011. Enter all lengths in whole millimetres, with the same "
         "steel in all sections: the time step is then exact."},
        {{warning, AlertCode::lengthsRounded, "", {{"time", 2e-7, Quantity::time}, {"cor_error", 5e-3}}},
         "The transit times of the sections share no time step: they were rounded by up to 0.2 us, and force "
         "on the rock and rebound have errors: e by up to 0.0053. Enter all lengths in whole millimetres, "
         "with the same steel in all sections: the time step is then exact."},
        {{warning,
          AlertCode::lengthsRounded,
          "",
          {{"time", 2e-7, Quantity::time},
           {"efficiency_error", 1e-3},
           {"shared_cell", 4e-7, Quantity::time}}},
         "The transit times of the sections only share a time step of 0.4 us, which takes more work than is "
         "permitted: they were rounded by up to 0.2 us, and the efficiency may have an error of 0.0011. "
         "Round the section lengths to multiples of a common length, such as 50 mm. A longer time step then "
         "fits all sections exactly."},
        {{warning, AlertCode::blowNotOver, "", {{"time", 0.0167, Quantity::time}, {"forced", 1}}},
         "This blow is not over after 16.7 ms, when the next blow starts: the bit may hit the rock again. "
         "The values are for that moment and not final."},
        {{warning, AlertCode::blowNotOver, "", {{"time", 0.0167, Quantity::time}}},
         "This blow is not over after 16.7 ms, when the next blow starts: bit and rock, or hammer and "
         "string, may meet again. The values are for that moment and not final."},
        {{warning,
          AlertCode::pushedBack,
          "",
          {{"force", 3000, Quantity::force}, {"needed", 3060, Quantity::force}}},
         "The feed force of 3 kN is below the mean force of the blows, 3.06 kN, or too close to it. The gap "
         "between bit and rock therefore grows from blow to blow. Increase the feed force."},
        {{note, AlertCode::noWaveLoss, "", {}},
         "Nothing damps the waves, so their fronts never decay. Give a wave loss; 1 to 30 % per round trip "
         "is usual."},
        {{warning, AlertCode::restrikeInTheWay, "", {{"share", 0.1234}}},
         "After the piston has separated, the rebounding string hits it again, and the piston passes up to "
         "12.3 % of its momentum to the string. If the machine has drawn the piston back by then, switch off "
         "“may strike again” (restrike: false in the file)."},
        {{warning, AlertCode::shankOff, "", {{"offset", 0.006, Quantity::length}}},
         "At impact, the shank is up to 6 mm from its mean position in the machine. A real machine would "
         "then have another stroke and blow energy than assumed. If the damper has no spring, add one: a "
         "dashpot alone lets the shank drift."},
        {{note,
          AlertCode::frequencyRounded,
          "",
          {{"frequency", 60, Quantity::frequency}, {"used", 60.01, Quantity::frequency}}},
         "The blow frequency is rounded to 60.01 Hz, so that each blow falls on a time step."},
        {{warning, AlertCode::notSettled, "", {}},
         "The motion may not be steady yet: means of the first and second half of the blows differ by more "
         "than three times their error. Increase the number of blows, or of transient blows."},
        {{warning, AlertCode::coexistingMotions, "", {}},
         "Two steady motions are possible. The start or the time step decides which one is computed; a real "
         "drill may settle into either."},
        {{note, AlertCode::irregularMotion, "", {}},
         "The motion does not repeat from blow to blow: use the means, not the values of single blows."},
        {{warning, AlertCode::energyUnbalanced, "", {{"share", 0.0021}}},
         "The energy balance of all blows has an error of 0.21 %. The time step is too long for the short "
         "contacts between bit and rock. A shorter time step reduces the error in proportion."},
        {{note, AlertCode::damperAssumed, "", {}},
         "The data of the damper are assumed, because makers do not publish them. Try dashpots from 0.05 to "
         "0.5 times the impedance of the rod."},
        {{warning, AlertCode::stressesLeftOut, "", {}},
         "The largest stresses of the sections were not computed, because this would exceed the limit of "
         "computing work. No strength was checked. Try a shorter end time (end_time)."},
    };
    return all;
}

}  // namespace

class TestAlertWords : public QObject {
    Q_OBJECT

  private slots:
    void eachRemarkHasItsSentence_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < examples().size(); ++i) {
            const Alert& alert = examples()[i].alert;
            QTest::addRow("%s %zu", name(alert.code).data(), i) << int(i);
        }
    }

    void eachRemarkHasItsSentence() {
        QFETCH(int, index);
        const Example& example = examples()[std::size_t(index)];
        QCOMPARE(textOf(example.alert), QString(example.sentence));
    }

    // The names stand in files and are not to change.
    void theNamesAreThoseOfTheCodes() {
        QCOMPARE(name(AlertCode::implausibleValue), std::string_view("outside_plausible_range"));
        QCOMPARE(name(AlertCode::longPulse), std::string_view("pulse_longer_than_round_trip"));
        QCOMPARE(name(AlertCode::gapWithoutEffect), std::string_view("gap_without_effect"));
        QCOMPARE(name(AlertCode::thrustBelowNeeded), std::string_view("thrust_below_needed"));
        QCOMPARE(name(AlertCode::superRebound), std::string_view("super_rebound"));
        QCOMPARE(name(AlertCode::closedFormInvalid), std::string_view("closed_form_invalid"));
        QCOMPARE(name(AlertCode::reducedAccuracy), std::string_view("reduced_accuracy"));
        QCOMPARE(name(AlertCode::stressAboveYield), std::string_view("stress_above_yield"));
        QCOMPARE(name(AlertCode::stressAboveFatigue), std::string_view("stress_above_fatigue"));
        QCOMPARE(name(AlertCode::residualWaves), std::string_view("residual_waves"));
    }

    // A string as long as ten rods: 1.2 round trips between blows of 60 Hz; nearly one at 70 Hz.
    void wavesThatMeetTheNextBlowAreRemarkedOn() {
        const auto remarks = [](double frequency, double length) {
            Scenario scenario;
            scenario.drill.blowFrequency = frequency;
            scenario.rod.length = length;
            return alertsFor(scenario);
        };
        QVERIFY(remarks(60, 3.66).empty());
        const std::vector<Alert> some = remarks(60, 36.6);
        QCOMPARE(some.size(), std::size_t{1});
        QCOMPARE(some[0].code, AlertCode::residualWaves);
        QCOMPARE(some[0].level, AlertLevel::information);
        const std::vector<Alert> inStep = remarks(70, 36.6);
        QCOMPARE(inStep[0].level, AlertLevel::warning);
        QVERIFY(textOf(inStep[0]).contains("is close to the whole number 1,"));
        QVERIFY(textOf(some[0]).contains("undamped"));
        Scenario damped;
        damped.drill.blowFrequency = 60;
        damped.drill.waveLoss = 0.1;
        damped.rod.length = 36.6;
        const std::vector<Alert> withLoss = alertsFor(damped);
        QVERIFY(!textOf(withLoss[0]).contains("undamped"));
    }

    void noCodeIsLeftOut() {
        std::set<AlertCode> told;
        std::set<std::string_view> names;
        for (const Example& example : examples()) {
            told.insert(example.alert.code);
            names.insert(name(example.alert.code));
        }
        QCOMPARE(told.size(), valueCount<AlertCode>);
        QCOMPARE(names.size(), told.size());
        QCOMPARE(*told.rbegin(), allValues<AlertCode>.back());
        QVERIFY(!names.contains(std::string_view()));
    }

    // The arguments above are those that the model gives.
    void theRemarksOfTheModelHaveTheArgumentsOfTheirSentences() {
        Scenario scenario;
        scenario.rod.youngsModulus = 210;  // meant in GPa
        QCOMPARE(alertsFor(scenario).at(0), examples()[0].alert);
        scenario = {};
        scenario.pulse.impulse = 40;
        scenario.drill.blowFrequency = 50;
        scenario.drill.thrust = 1500;
        ImpactSummary summary;
        summary.cor = 0.4;
        const std::vector<Alert> alerts = resultAlerts(scenario, summary);
        QCOMPARE(alerts.size(), std::size_t{1});
        QCOMPARE(
            textOf(alerts[0]),
            QString("The feed force of 1.5 kN is less than the mean force of the blows, 2 kN: the "
                    "machine is pushed back. For this blow, the feed force must be at least 2.8 kN "
                    "at 50 Hz, or the blow frequency at most 26.7 Hz with the present feed force. Friction, "
                    "rotation and buckling are not modelled."));
    }
};

QTEST_APPLESS_MAIN(TestAlertWords)
#include "tst_alert_words.moc"
