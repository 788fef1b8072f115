// SPDX-License-Identifier: GPL-3.0-or-later
// Units of results and fields: readable prefixes, US units, and a unit for one kind of value.
#include <QTest>

#include "ui/text/number_text.h"
#include "ui/text/shown_units.h"

using namespace drillwave;

class TestShownUnits : public QObject {
    Q_OBJECT

  private slots:
    void everyKindHasItsUnitsInBothSystems();
    void everyParameterWithAUnitIsOfAKind();
    void prefixesSuitTheSize_data();
    void prefixesSuitTheSize();
    void fieldsHaveCustomaryUnits_data();
    void fieldsHaveCustomaryUnits();
    void aUnitOfOneKindLeavesTheOthers();
    void theFactorLeadsFromTheGroupsToTheUnit();
    void singleValuesAreReadWithAPrefixOfTheirOwn();
};

void TestShownUnits::everyKindHasItsUnitsInBothSystems() {
    for (const UnitKindRow& row : unitKinds()) {
        QCOMPARE(rowOf(row.kind).name, row.name);
        for (const auto& names : {row.si, row.us}) {
            double last = HUGE_VAL;
            for (const std::string_view name : names) {
                const Unit* unit = findUnit(row.quantity, name);
                QVERIFY2(unit, row.name);
                QVERIFY(unit->factor() < last);  // from the largest to the smallest
                last = unit->factor();
            }
            QVERIFY(last < HUGE_VAL);
        }
    }
}

void TestShownUnits::everyParameterWithAUnitIsOfAKind() {
    for (const Parameter& parameter : parameters()) {
        const std::optional<UnitKind> kind = kindOf(parameter);
        const bool isPlain = parameter.quantity == Quantity::ratio || parameter.quantity == Quantity::share;
        QCOMPARE(kind.has_value(), !isPlain);
        if (kind) QCOMPARE(rowOf(*kind).quantity, parameter.quantity);
        QCOMPARE(&customaryUnit(parameter, UnitSystem::si), &parameter.displayUnit());
    }
}

void TestShownUnits::prefixesSuitTheSize_data() {
    QTest::addColumn<UnitKind>("kind");
    QTest::addColumn<double>("size");
    QTest::addColumn<UnitSystem>("system");
    QTest::addColumn<QString>("unit");
    QTest::newRow("thrust") << UnitKind::force << 8e3 << UnitSystem::si << "kN";
    QTest::newRow("thrust, US") << UnitKind::force << 8e3 << UnitSystem::us << "lbf";
    QTest::newRow("force of the hammer, US") << UnitKind::force << 255e3 << UnitSystem::us << "kip";
    QTest::newRow("small force, US") << UnitKind::force << 800.0 << UnitSystem::us << "lbf";
    QTest::newRow("smaller than all") << UnitKind::force << 1e-9 << UnitSystem::si << "N";
    QTest::newRow("nothing") << UnitKind::force << 0.0 << UnitSystem::si << "N";
    QTest::newRow("power") << UnitKind::power << 19.8e3 << UnitSystem::si << "kW";
    QTest::newRow("power, US") << UnitKind::power << 19.8e3 << UnitSystem::us << "hp";
    QTest::newRow("dimensionless: SI where there is no number")
        << UnitKind::power << 19.8e3 << UnitSystem::dimensionless << "kW";
}

void TestShownUnits::prefixesSuitTheSize() {
    QFETCH(UnitKind, kind);
    QFETCH(double, size);
    QFETCH(UnitSystem, system);
    QTEST(QString::fromStdString(std::string(handyUnit(kind, size, system).name)), "unit");
}

void TestShownUnits::fieldsHaveCustomaryUnits_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("unit");
    QTest::newRow("rod") << "rod.length"
                         << "ft";
    QTest::newRow("diameter") << "rod.diameter"
                              << "in";
    QTest::newRow("attenuation of a section") << "string.1.attenuation"
                                              << "1/ft";
    QTest::newRow("modulus") << "rod.youngs_modulus"
                             << "Mpsi";
    QTest::newRow("strength") << "rod.yield_strength"
                              << "ksi";
    QTest::newRow("time") << "pulse.duration"
                          << "us";
    QTest::newRow("stiffness") << "bit_rock.stiffness"
                               << "kip/in";
    QTest::newRow("frequency") << "drill.blow_frequency"
                               << "bpm";
    QTest::newRow("hammer") << "pulse.force"
                            << "kip";
    QTest::newRow("thrust") << "drill.thrust"
                            << "lbf";
    QTest::newRow("group") << "beta"
                           << "";
}

void TestShownUnits::fieldsHaveCustomaryUnits() {
    QFETCH(QString, key);
    const KeptParameter parameter = findParameter(key.toStdString());
    QVERIFY(parameter);
    QTEST(QString::fromStdString(std::string(customaryUnit(*parameter, UnitSystem::us).name)), "unit");
}

void TestShownUnits::aUnitOfOneKindLeavesTheOthers() {
    const Scales scales = scalesOf(Scenario());
    const ShownUnits usual = shownUnits(UnitSystem::si, scales);
    const ShownUnits own =
        shownUnits(UnitSystem::si, scales, {{UnitKind::force, findUnit(Quantity::force, "lbf")}});
    QCOMPARE(own.force.unit, QString("lbf"));
    QCOMPARE(own.of(UnitKind::force, 1e9).unit, QString("lbf"));
    QCOMPARE(own.impulse, usual.impulse);
    QCOMPARE(own.stress, usual.stress);
    // Dimensionless values stay so.
    QVERIFY(shownUnits(UnitSystem::dimensionless, scales, own.chosen).force.dimensionless);
}

void TestShownUnits::theFactorLeadsFromTheGroupsToTheUnit() {
    const Scales scales = scalesOf(Scenario());
    // Pounds and inches by their definitions; a few roundings.
    const ShownUnits us = shownUnits(UnitSystem::us, scales);
    QCOMPARE(us.force.unit, QString("kip"));
    QVERIFY(std::abs(us.force.factor * 4448.2216152605 / scales.force - 1) < 1e-14);
    QCOMPARE(us.length.unit, QString("ft"));
    QVERIFY(std::abs(us.length.factor * 0.3048 / scales.length - 1) < 1e-14);
    QCOMPARE(us.time.unit, shownUnits(UnitSystem::si, scales).time.unit);
    QCOMPARE(us.time.factor, shownUnits(UnitSystem::si, scales).time.factor);
}

void TestShownUnits::singleValuesAreReadWithAPrefixOfTheirOwn() {
    const Scales scales = scalesOf(Scenario());
    const ShownUnits si = shownUnits(UnitSystem::si, scales);
    const auto text = [](double value, const ShownUnit& unit, double scale) {
        return quantityText(value / scale, unit, QLocale::c()).replace(QChar(QChar::Nbsp), ' ');
    };
    QCOMPARE(si.force.unit, QString("kN"));
    QCOMPARE(text(36.06, si.force, scales.force), QString("36.06 N"));
    QCOMPARE(text(-36.06, si.force, scales.force), QString("−36.06 N"));
    QCOMPARE(text(187.3e3, si.force, scales.force), QString("187.3 kN"));
    QCOMPARE(text(2.5e9, si.force, scales.force), QString("2.5 GN"));
    QCOMPARE(text(0, si.force, scales.force), QString("0 kN"));
    QCOMPARE(text(183.326, si.penetration, scales.penetration), QString("183.3 m"));
    QCOMPARE(text(2.3e-6, si.penetration, scales.penetration), QString("2.3 µm"));
    QCOMPARE(text(350e-9, si.time, scales.time), QString("350 ns"));
    // A unit that was chosen stays, and what is dimensionless has no prefix.
    const ShownUnits own =
        shownUnits(UnitSystem::si, scales, {{UnitKind::force, findUnit(Quantity::force, "kN")}});
    QCOMPARE(text(36.06, own.force, scales.force), QString("0.03606 kN"));
    const ShownUnits plain = shownUnits(UnitSystem::dimensionless, scales);
    QCOMPARE(text(0.003, plain.force, 1), QString("0.003 F₀"));
}

QTEST_APPLESS_MAIN(TestShownUnits)
#include "tst_shown_units.moc"
