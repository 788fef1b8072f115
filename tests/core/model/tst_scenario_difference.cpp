// SPDX-License-Identifier: GPL-3.0-or-later
// In which parameters scenarios differ: in what they say, not in what follows from it.
#include <QTest>

#include "core/model/assignments.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario.h"

using namespace drillwave;

namespace {

QStringList keys(const std::vector<const Scenario*>& scenarios) {
    QStringList keys;
    for (const KeptParameter& parameter : differingParameters(scenarios))
        keys << QString::fromUtf8(parameter->key.data(), qsizetype(parameter->key.size()));
    return keys;
}

}  // namespace

class TestScenarioDifference : public QObject {
    Q_OBJECT

  private slots:
    void theSameScenarioDiffersInNothing();
    void onlyWhatIsGivenDiffers();
    void anOptionalValueDiffersFromNone();
    void oneOfManyIsEnough();
    void groupsDifferWhereTheyAreGiven();
    void lawsDifferInEveryNumber_data();
    void lawsDifferInEveryNumber();
    void aNumberOfTwoFormsIsListedOnce();
    void theMaterialOfRodAndStringIsOneNumber();
};

void TestScenarioDifference::theSameScenarioDiffersInNothing() {
    const Scenario scenario;
    QCOMPARE(keys({&scenario, &scenario}), QStringList());
}

// β and τ follow from the stiffness and the length.
void TestScenarioDifference::onlyWhatIsGivenDiffers() {
    const Scenario a;
    Scenario b;
    b.bitRock.stiffness = 3e8;
    b.rod.length = 4;
    QCOMPARE(keys({&a, &b}), QStringList({"rod.length", "bit_rock.stiffness"}));
}

void TestScenarioDifference::anOptionalValueDiffersFromNone() {
    const Scenario a;
    Scenario b;
    b.drill.thrust = 8e3;
    QCOMPARE(keys({&a, &b}), QStringList("drill.thrust"));
    QVERIFY(!valueIn(a, *findParameter("drill.thrust")));
    QCOMPARE(valueIn(b, *findParameter("drill.thrust")), 8e3);
}

void TestScenarioDifference::oneOfManyIsEnough() {
    const Scenario a;
    Scenario b;
    b.bitRock.gap = 1e-3;
    QCOMPARE(keys({&a, &a, &b}), QStringList("bit_rock.gap"));
}

void TestScenarioDifference::groupsDifferWhereTheyAreGiven() {
    const Scenario a = test::dimensionless(PulseShape::rectangular, {.beta = 0.5});
    const Scenario b = test::dimensionless(PulseShape::rectangular, {.beta = 0.6});
    QCOMPARE(keys({&a, &b}), QStringList("beta"));
}

void TestScenarioDifference::lawsDifferInEveryNumber_data() {
    QTest::addColumn<ScenarioForm>("form");
    QTest::newRow("with units") << ScenarioForm::dimensional;
    QTest::newRow("dimensionless") << ScenarioForm::dimensionless;
}

void TestScenarioDifference::lawsDifferInEveryNumber() {
    QFETCH(ScenarioForm, form);
    Scenario a;
    a.form = form;
    a.bitRock.law = RockLaw::power;
    Scenario b = a;
    b.bitRock.exponent = 1.5;
    b.bitRock.referencePenetration *= 2;
    QCOMPARE(keys({&a, &b}), QStringList({"bit_rock.exponent", "bit_rock.reference_penetration"}));
    a.bitRock.law = b.bitRock.law = RockLaw::corners;
    a.bitRock.corners = {{1, 0.5}};
    b.bitRock.corners = {{2, 0.5}, {3, 0.2}};
    QCOMPARE(keys({&a, &b}),
             QStringList({"bit_rock.corner.1.force", "bit_rock.corner.2.force", "bit_rock.corner.2.slope"}));
}

void TestScenarioDifference::aNumberOfTwoFormsIsListedOnce() {
    Scenario a;
    a.bitRock.law = RockLaw::power;
    Scenario b = a;
    b.form = ScenarioForm::dimensionless;
    const QStringList both = keys({&a, &b});
    QCOMPARE(both.count(QStringLiteral("bit_rock.reference_penetration")), 1);
    QCOMPARE(QSet<QString>(both.begin(), both.end()).size(), both.size());
}

void TestScenarioDifference::theMaterialOfRodAndStringIsOneNumber() {
    const Scenario rod = parseScenario(findExample("t38_medium_rock")->text, "").scenario;
    Scenario string = parseScenario(findExample("t38_string")->text, "").scenario;
    QCOMPARE(valueIn(string, *findParameter("rod.density")), std::optional(7850.0));
    for (const char* key :
         {"rod.youngs_modulus", "material.youngs_modulus", "rod.density", "material.density"})
        QVERIFY2(!keys({&rod, &string}).contains(QLatin1String(key)), key);
    string.drillString.material.density = 7800;
    QVERIFY(keys({&rod, &string}).contains(QStringLiteral("rod.density")));
    QVERIFY(!keys({&rod, &string}).contains(QStringLiteral("material.density")));
}

QTEST_GUILESS_MAIN(TestScenarioDifference)
#include "tst_scenario_difference.moc"
