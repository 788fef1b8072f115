// SPDX-License-Identifier: GPL-3.0-or-later
// Presets along an axis and in a map.
#include <QTest>

#include "core/model/preset_places.h"
#include "core/model/scales.h"

using namespace drillwave;

namespace {

Preset rock(const char* name, double stiffness, double gamma) {
    return {.kind = PresetKind::rock,
            .name = name,
            .shape = {},
            .shapeSource = {},
            .law = RockLaw::bilinear,
            .corners = {},
            .lawSource = {},
            .values = {{&*findParameter("bit_rock.stiffness"), stiffness, "assumed"},
                       {&*findParameter("bit_rock.gamma"), gamma, "assumed"}}};
}

const std::vector<Preset> rocks{rock("hard", 5e8, 0.2), rock("soft", 5e7, 0.1), rock("weak", 5e7, 0.3)};

}  // namespace

class TestPresetPlaces : public QObject {
    Q_OBJECT

  private slots:
    void theyAscendAndShareAPlace();
    void aGroupHasThePlaceOfWhatItMoves();
    void otherParametersHaveNone();
    void inAMapTheyArePointsOfBoth();
    void withoutUnitsThereAreNone();
    void onAnotherLoadingCurveTheyAreOtherRocks();
};

void TestPresetPlaces::theyAscendAndShareAPlace() {
    const auto places = presetPlaces(rocks, *findParameter("bit_rock.stiffness"), Scenario());
    QCOMPARE(places.size(), std::size_t{2});
    QCOMPARE(places[0].name.text(), "soft, weak");
    QCOMPARE(places[0].si, 5e7);
    QCOMPARE(places[1], (PresetPlace{Message::ofTable("hard"), 5e8}));

    std::vector<Preset> many(4, rocks.front());
    for (std::size_t i = 0; i < many.size(); ++i) many[i].name = std::string(1, static_cast<char>('a' + i));
    const auto one = presetPlaces(many, *findParameter("bit_rock.stiffness"), Scenario());
    QCOMPARE(one.size(), std::size_t{1});
    QCOMPARE(one[0].name.text(), "a, b, …");
}

void TestPresetPlaces::aGroupHasThePlaceOfWhatItMoves() {
    const Scenario scenario;
    const auto places = presetPlaces(rocks, *findParameter("beta"), scenario);
    QCOMPARE(places.size(), std::size_t{2});
    QCOMPARE(places[1].si, 5e8 / scalesOf(scenario).stiffness);
}

void TestPresetPlaces::otherParametersHaveNone() {
    QVERIFY(presetPlaces(rocks, *findParameter("rod.length"), Scenario()).empty());
    QVERIFY(presetPoints(rocks, *findParameter("rod.length"), *findParameter("bit_rock.gamma"), Scenario())
                .empty());
}

void TestPresetPlaces::inAMapTheyArePointsOfBoth() {
    const auto points = presetPoints(rocks, *findParameter("bit_rock.gamma"),
                                     *findParameter("bit_rock.stiffness"), Scenario());
    QCOMPARE(points.size(), std::size_t{3});
    QCOMPARE(points[2], (PresetPoint{Message::ofTable("weak"), 0.3, 5e7}));
}

void TestPresetPlaces::withoutUnitsThereAreNone() {
    Scenario scenario;
    scenario.form = ScenarioForm::dimensionless;
    QVERIFY(presetPlaces(rocks, *findParameter("beta"), scenario).empty());
}

void TestPresetPlaces::onAnotherLoadingCurveTheyAreOtherRocks() {
    Scenario scenario;
    scenario.bitRock.law = RockLaw::corners;
    scenario.bitRock.corners = {{9e4, 0.35}};
    QVERIFY(presetPlaces(rocks, *findParameter("bit_rock.stiffness"), scenario).empty());
    std::vector<Preset> layered = rocks;
    layered[0].law = RockLaw::corners;
    layered[0].corners = scenario.bitRock.corners;
    QCOMPARE(presetPlaces(layered, *findParameter("bit_rock.stiffness"), scenario).size(), std::size_t{1});
}

QTEST_GUILESS_MAIN(TestPresetPlaces)
#include "tst_preset_places.moc"
