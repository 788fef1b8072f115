// SPDX-License-Identifier: GPL-3.0-or-later
// Keys set together: the shape before what depends on it, groups after what they move, rivals found.
#include <QTest>

#include <algorithm>

#include "core/model/assignments.h"
#include "core/model/parameter_text.h"

using namespace drillwave;

class TestAssignments : public QObject {
    Q_OBJECT

  private slots:
    void theShapeIsFirstAndTheGroupsAreLast();
    void equalKeysKeepTheirOrder();
    void whatSetsNothingIsNumberedButNotSet();
    void anyOrderOfTheKeysGivesTheSameScenario();
    void rivalsAreTheSameEitherWayRound_data();
    void rivalsAreTheSameEitherWayRound();
    void settingOneRivalUndoesTheOther();
    void onlyHammerAndRodMoveThePulse();
};

void TestAssignments::theShapeIsFirstAndTheGroupsAreLast() {
    const Assignments assignments({"delta", "pulse.rise", "rod.length", "pulse.shape", "beta"});
    QCOMPARE(assignments.order(), (std::vector<std::size_t>{3, 2, 1, 4, 0}));
}

void TestAssignments::equalKeysKeepTheirOrder() {
    // Unknown keys, whose problems are listed in the order in which they were typed.
    const Assignments assignments({"beta", "nonsense", "title", ""});
    QCOMPARE(assignments.order(), (std::vector<std::size_t>{1, 2, 3, 0}));
}

void TestAssignments::whatSetsNothingIsNumberedButNotSet() {
    Assignments assignments;
    assignments.skip();
    assignments.add("tau");
    assignments.skip();
    assignments.add("rod.length");
    QCOMPARE(assignments.order(), (std::vector<std::size_t>{3, 1}));
    const std::optional<RivalPair> pair = assignments.rivals();
    QVERIFY(pair && pair->one == 1 && pair->other == 3);
    QCOMPARE(pair->problem.text(), std::string("set the same thing"));
    QVERIFY(!assignments.rivals([](std::size_t i) { return i != 3; }));
    QVERIFY(!assignments.movesPulse(0));
}

void TestAssignments::anyOrderOfTheKeysGivesTheSameScenario() {
    std::vector<std::pair<std::string_view, std::string_view>> settings{
        {"pulse.shape", "trapezoid"}, {"pulse.rise", "0.1"}, {"pulse.duration", "300 us"},
        {"rod.diameter", "45 mm"},    {"beta", "0.7"},       {"delta", "0.3"}};
    std::ranges::sort(settings);
    std::optional<Scenario> first;
    do {
        Assignments assignments;
        for (const auto& setting : settings) assignments.add(setting.first);
        Scenario scenario;
        for (const std::size_t i : assignments.order())
            QCOMPARE(assignText(scenario, settings[i].first, settings[i].second), Message());
        if (!first) first = scenario;
        QVERIFY(scenario == *first);
    } while (std::ranges::next_permutation(settings).found);
}

void TestAssignments::rivalsAreTheSameEitherWayRound_data() {
    QTest::addColumn<QByteArray>("one");
    QTest::addColumn<QByteArray>("other");
    QTest::addColumn<bool>("rivals");
    const auto add = [](const char* one, const char* other, bool rivals) {
        QTest::addRow("%s, %s", one, other) << QByteArray(one) << QByteArray(other) << rivals;
    };
    add("beta", "beta", true);
    add("nonsense", "nonsense", true);
    add("beta", "bit_rock.stiffness", true);
    add("gamma", "bit_rock.gamma", true);
    add("delta", "bit_rock.gap", true);
    add("tau", "rod.length", true);
    add("rod.area", "rod.diameter", true);
    add("rod.area", "rod.bore", true);
    add("pulse.impulse", "pulse.force", true);
    add("rod.bore", "rod.diameter", false);
    add("pulse.force", "pulse.duration", false);
    add("beta", "nonsense", false);
    add("pulse.force", "", false);
    add("beta", "rod.length", false);
}

void TestAssignments::rivalsAreTheSameEitherWayRound() {
    QFETCH(QByteArray, one);
    QFETCH(QByteArray, other);
    QFETCH(bool, rivals);
    QCOMPARE(areRivals(one.constData(), other.constData()), rivals);
    QCOMPARE(areRivals(other.constData(), one.constData()), rivals);
}

void TestAssignments::settingOneRivalUndoesTheOther() {
    // The table's own words, proved by what assigning does.
    int pairs = 0;
    for (const Parameter& parameter : parameters()) {
        const KeptParameter rival = findParameter(parameter.rules.rival);
        if (!rival) continue;
        ++pairs;
        Scenario scenario;
        rival->assign(scenario, 0.37);
        Scenario both = scenario;
        if (parameter.applies(both)) parameter.assign(both, 0.23);
        const bool undone = !rival->applies(both) || rival->value(both) != 0.37;
        QVERIFY2(undone || !parameter.applies(scenario), qPrintable(QString::fromUtf8(parameter.key.data())));
    }
    QCOMPARE(pairs, 7);
}

void TestAssignments::onlyHammerAndRodMoveThePulse() {
    const Assignments moving({"pulse.shape", "pulse.rise", "rod.density"});
    for (const std::size_t i : {0U, 1U, 2U}) QVERIFY(moving.movesPulse(i));
    const Assignments still({"beta", "tau", "bit_rock.gap", "drill.thrust"});
    for (const std::size_t i : {0U, 1U, 2U, 3U}) QVERIFY(!still.movesPulse(i));
    QVERIFY(moving.movePulse());
    QVERIFY(!still.movePulse());
    QVERIFY(!Assignments().movePulse());
}

QTEST_GUILESS_MAIN(TestAssignments)
#include "tst_assignments.moc"
