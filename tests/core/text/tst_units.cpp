// SPDX-License-Identifier: GPL-3.0-or-later
// Units: typed text into SI to the last bit, and back.
#include <QTest>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>

#include "core/text/handy_text.h"
#include "core/text/units.h"

using namespace drillwave;

namespace {

constexpr Quantity quantities[] = {
    Quantity::ratio,     Quantity::length,     Quantity::area,  Quantity::stress,    Quantity::density,
    Quantity::time,      Quantity::impulse,    Quantity::force, Quantity::stiffness, Quantity::velocity,
    Quantity::frequency, Quantity::energy,     Quantity::power, Quantity::mass,      Quantity::angle,
    Quantity::share,     Quantity::attenuation};

/// Any finite double, all magnitudes alike.
double anyDouble(std::mt19937_64& random) {
    double value = 0;
    do value = std::bit_cast<double>(random());
    while (!std::isfinite(value));
    return value;
}

std::string reason(std::string_view text, Quantity quantity) {
    return parseQuantity(text, quantity).problem.text();
}

}  // namespace

class TestUnits : public QObject {
    Q_OBJECT

  private slots:
    void peopleReadTheUnitThatNeedsTheFewestZeros() {
        QCOMPARE(inHandyUnit(71700, Quantity::force), "71.7 kN");
        QCOMPARE(inHandyUnit(0.0032, Quantity::length), "3.2 mm");
        QCOMPARE(inHandyUnit(2e-9, Quantity::length), "0.002 um");
        QCOMPARE(inHandyUnit(3.46e-4, Quantity::length, 2), "350 um");
        QCOMPARE(inHandyUnit(-3.46e-4, Quantity::length, 2), "-350 um");
        QCOMPARE(inHandyUnit(9.99e-4, Quantity::length, 2), "1000 um");
        QCOMPARE(inHandyUnit(12.34, Quantity::impulse, 1), "10 N s");
        QCOMPARE(inHandyUnit(0, Quantity::length), "0 m");
        QCOMPARE(inHandyUnit(0, Quantity::time), "0 s");
        QCOMPARE(inHandyUnit(0, Quantity::force), "0 N");
        QCOMPARE(inHandyUnit(0.25, Quantity::ratio), "0.25");
    }

    void typedTextIsTheNearestDoubleOfItsSiValue_data();
    void typedTextIsTheNearestDoubleOfItsSiValue();
    void factorsAgreeWithTheDefinitionOfTheUnits_data();
    void factorsAgreeWithTheDefinitionOfTheUnits();
    void spellingsOfOneUnitAreTheSameUnit_data();
    void spellingsOfOneUnitAreTheSameUnit();
    void unitNamesAreCaseSensitive();
    void theSiUnitIsTheFirstOfItsQuantity();
    void everyUnitIsFoundByItsNameAndListed();
    void wrongTextIsRefusedWithTheReason_data();
    void wrongTextIsRefusedWithTheReason();
    void aBareNumberIsTakenInTheDefaultUnitWhereThatIsAllowed();
    void numbersOutsideDoublePrecisionAreRefused();
    void numbersReadBackAsTheSameDouble();
    void quantitiesReadBackAsTheSameDoubleInEveryUnit();
    void quantitiesAreWrittenShort_data();
    void quantitiesAreWrittenShort();
    void theUsersLocaleChangesNothing();
};

void TestUnits::typedTextIsTheNearestDoubleOfItsSiValue_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<double>("si");
    QTest::newRow("38 mm") << "38 mm" << Quantity::length << 0.038;
    QTest::newRow("14.5 mm") << "14.5 mm" << Quantity::length << 0.0145;
    QTest::newRow("0.1 mm") << "0.1 mm" << Quantity::length << 0.0001;
    QTest::newRow("1.5in, no blank") << "1.5in" << Quantity::length << 0.0381;
    QTest::newRow("12 ft") << "12 ft" << Quantity::length << 3.6576;
    QTest::newRow("+3.66 m") << "+3.66 m" << Quantity::length << 3.66;
    QTest::newRow("blanks around") << "  3.66   m " << Quantity::length << 3.66;
    QTest::newRow(".5 m") << ".5 m" << Quantity::length << 0.5;
    QTest::newRow("5. m") << "5. m" << Quantity::length << 5.0;
    QTest::newRow("1e3 mm") << "1e3 mm" << Quantity::length << 1.0;
    QTest::newRow("1134 mm^2") << "1134 mm^2" << Quantity::area << 0.001134;
    QTest::newRow("210 GPa") << "210 GPa" << Quantity::stress << 210e9;
    QTest::newRow("7850 kg/m^3") << "7850 kg/m^3" << Quantity::density << 7850.0;
    QTest::newRow("7.85 g/cm^3") << "7.85 g/cm^3" << Quantity::density << 7850.0;
    QTest::newRow("200 us") << "200 us" << Quantity::time << 200e-6;
    QTest::newRow("51 N s") << "51 N s" << Quantity::impulse << 51.0;
    QTest::newRow("255 kN") << "255 kN" << Quantity::force << 255e3;
    QTest::newRow("105 MN/m") << "105 MN/m" << Quantity::stiffness << 105e6;
    QTest::newRow("105 kN/mm") << "105 kN/mm" << Quantity::stiffness << 105e6;
    QTest::newRow("3600 bpm") << "3600 bpm" << Quantity::frequency << 60.0;
    QTest::newRow("36 km/h") << "36 km/h" << Quantity::velocity << 10.0;
    QTest::newRow("ratio") << "0.1" << Quantity::ratio << 0.1;
}

void TestUnits::typedTextIsTheNearestDoubleOfItsSiValue() {
    QFETCH(QString, text);
    QFETCH(Quantity, quantity);
    QFETCH(double, si);
    const TypedQuantity typed = parseQuantity(text.toStdString(), quantity);
    QCOMPARE(QString::fromStdString(typed.problem.text()), QString());
    QVERIFY(typed.unit != nullptr);
    // No tolerance: the decimal point is moved in the text, and the definitions of inch and foot are
    // integers.
    QVERIFY2(typed.si == si, qPrintable(QString::number(typed.si, 'g', 17)));
}

void TestUnits::factorsAgreeWithTheDefinitionOfTheUnits_data() {
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("factor");
    const double pound = 0.45359237;  // kg, international yard and pound agreement
    const double gravity = 9.80665;   // m/s², standard gravity
    QTest::newRow("psi") << Quantity::stress << "psi" << pound * gravity / (0.0254 * 0.0254);
    QTest::newRow("ksi") << Quantity::stress << "ksi" << 1000 * pound * gravity / (0.0254 * 0.0254);
    QTest::newRow("lbf") << Quantity::force << "lbf" << pound * gravity;
    QTest::newRow("kgf") << Quantity::force << "kgf" << gravity;
    QTest::newRow("lbf s") << Quantity::impulse << "lbf s" << pound * gravity;
    QTest::newRow("lb/ft^3") << Quantity::density << "lb/ft^3" << pound / (0.3048 * 0.3048 * 0.3048);
    QTest::newRow("lbf/in") << Quantity::stiffness << "lbf/in" << pound * gravity / 0.0254;
    QTest::newRow("ft lbf") << Quantity::energy << "ft lbf" << 0.3048 * pound * gravity;
    QTest::newRow("kip") << Quantity::force << "kip" << 1000 * pound * gravity;
    QTest::newRow("kip/in") << Quantity::stiffness << "kip/in" << 1000 * pound * gravity / 0.0254;
    QTest::newRow("Mpsi") << Quantity::stress << "Mpsi" << 1e6 * pound * gravity / (0.0254 * 0.0254);
    QTest::newRow("hp") << Quantity::power << "hp" << 550 * 0.3048 * pound * gravity;
    QTest::newRow("ft/min") << Quantity::velocity << "ft/min" << 0.3048 / 60;
    QTest::newRow("in/min") << Quantity::velocity << "in/min" << 0.0254 / 60;
    QTest::newRow("in^2") << Quantity::area << "in^2" << 0.0254 * 0.0254;
    QTest::newRow("hp") << Quantity::power << "hp" << 550 * 0.3048 * pound * gravity;
    QTest::newRow("lb") << Quantity::mass << "lb" << pound;
    QTest::newRow("%") << Quantity::share << "%" << 0.01;
    QTest::newRow("1/km") << Quantity::attenuation << "1/km" << 0.001;
    QTest::newRow("1/ft") << Quantity::attenuation << "1/ft" << 1 / 0.3048;
    QTest::newRow("rad") << Quantity::angle << "rad" << 180 / std::acos(-1.0);
    QTest::newRow("m/min") << Quantity::velocity << "m/min" << 1.0 / 60;
    QTest::newRow("ft/min") << Quantity::velocity << "ft/min" << 0.3048 / 60;
    QTest::newRow("rpm") << Quantity::frequency << "rpm" << 1.0 / 60;
    QTest::newRow("km/h") << Quantity::velocity << "km/h" << 1.0 / 3.6;
    QTest::newRow("bar") << Quantity::stress << "bar" << 1e5;
}

void TestUnits::factorsAgreeWithTheDefinitionOfTheUnits() {
    QFETCH(Quantity, quantity);
    QFETCH(QString, unit);
    QFETCH(double, factor);
    const Unit* found = findUnit(quantity, unit.toStdString());
    QVERIFY(found != nullptr);
    // A few roundings in the products above.
    QVERIFY(std::abs(found->factor() / factor - 1) < 1e-15);
    QVERIFY(std::abs(found->fromSi(found->toSi(3.0)) / 3.0 - 1) < 1e-15);
}

void TestUnits::spellingsOfOneUnitAreTheSameUnit_data() {
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("name");
    QTest::newRow("micro sign") << Quantity::time << "\u00b5s"
                                << "us";
    QTest::newRow("Greek mu") << Quantity::length << "\u03bcm"
                              << "um";
    QTest::newRow("superscript 2") << Quantity::area << "mm\u00b2"
                                   << "mm^2";
    QTest::newRow("plain 2") << Quantity::area << "cm2"
                             << "cm^2";
    QTest::newRow("superscript 3") << Quantity::density << "kg/m\u00b3"
                                   << "kg/m^3";
    QTest::newRow("N*s") << Quantity::impulse << "N*s"
                         << "N s";
    QTest::newRow("N·s") << Quantity::impulse << "N\u00b7s"
                         << "N s";
    QTest::newRow("Ns") << Quantity::impulse << "Ns"
                        << "N s";
    QTest::newRow("N * s") << Quantity::impulse << "N * s"
                           << "N s";
    QTest::newRow("inch") << Quantity::length << "inch"
                          << "in";
    QTest::newRow("1/s") << Quantity::frequency << "1/s"
                         << "Hz";
}

void TestUnits::spellingsOfOneUnitAreTheSameUnit() {
    QFETCH(Quantity, quantity);
    QFETCH(QString, written);
    QFETCH(QString, name);
    const Unit* unit = findUnit(quantity, written.toStdString());
    QVERIFY(unit != nullptr);
    QCOMPARE(unit, findUnit(quantity, name.toStdString()));
}

void TestUnits::unitNamesAreCaseSensitive() {
    QVERIFY(findUnit(Quantity::stress, "MPa") != nullptr);
    QVERIFY(findUnit(Quantity::stress, "mPa") == nullptr);
    QVERIFY(findUnit(Quantity::length, "MM") == nullptr);
    QVERIFY(findUnit(Quantity::length, std::string(1 << 20, 'm')) == nullptr);
}

void TestUnits::theSiUnitIsTheFirstOfItsQuantity() {
    for (const Quantity quantity : quantities) QCOMPARE(unitsOf(quantity).front().factor(), 1.0);
}

void TestUnits::everyUnitIsFoundByItsNameAndListed() {
    for (const Quantity quantity : quantities) {
        for (const Unit& unit : unitsOf(quantity)) {
            QCOMPARE(findUnit(quantity, unit.name), &unit);
            QVERIFY(unitList(quantity).find(unit.name) != std::string::npos);
        }
    }
}

void TestUnits::wrongTextIsRefusedWithTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("reason");
    QTest::newRow("empty") << "" << Quantity::length << "empty";
    QTest::newRow("blank") << "  " << Quantity::length << "empty";
    QTest::newRow("words") << "about 3 m" << Quantity::length << "not a number";
    QTest::newRow("no unit") << "38" << Quantity::length << "m, mm, cm, km, um, in, ft";
    QTest::newRow("zero, no unit") << "0" << Quantity::length << "has no unit";
    QTest::newRow("no share") << "2 mm" << Quantity::share << "allowed units: %";
    QTest::newRow("wrong quantity") << "38 kN" << Quantity::length << "`kN` is not known here";
    QTest::newRow("decimal comma") << "3,2 m" << Quantity::length << "decimal comma";
    QTest::newRow("two numbers") << "3 4 m" << Quantity::length << "`4 m` is not known";
    QTest::newRow("nan") << "nan" << Quantity::length << "finite";
    QTest::newRow("YAML nan") << ".NaN m" << Quantity::length << "finite";
    QTest::newRow("infinity") << "-inf" << Quantity::ratio << "finite";
    QTest::newRow("hexadecimal") << "0x10" << Quantity::ratio << "plain number";
    QTest::newRow("unit on a ratio") << "0.1 m" << Quantity::ratio << "plain number";
    QTest::newRow("percent") << "10 %" << Quantity::ratio << "plain number";
    QTest::newRow("sign alone") << "- m" << Quantity::length << "not a number";
    QTest::newRow("point alone") << ". m" << Quantity::length << "not a number";
    QTest::newRow("overflow") << "1e999 m" << Quantity::length << "too large";
    QTest::newRow("overflow by its unit") << "1e308 km" << Quantity::length << "too large";
    QTest::newRow("overflow by a factor") << "1e308 lbf" << Quantity::force << "too large";
}

void TestUnits::wrongTextIsRefusedWithTheReason() {
    QFETCH(QString, text);
    QFETCH(Quantity, quantity);
    QFETCH(QString, reason);
    const TypedQuantity typed = parseQuantity(text.toStdString(), quantity);
    QVERIFY(!typed.valid());
    QVERIFY2(typed.problem.text().find(reason.toStdString()) != std::string::npos,
             typed.problem.text().c_str());
}

void TestUnits::aBareNumberIsTakenInTheDefaultUnitWhereThatIsAllowed() {
    const Unit* mm = findUnit(Quantity::length, "mm");
    QCOMPARE(parseQuantity("38", Quantity::length, BareNumber::inDefaultUnit, mm).si, 0.038);
    QCOMPARE(parseQuantity("1.5 in", Quantity::length, BareNumber::inDefaultUnit, mm).si, 0.0381);
    QVERIFY(reason("38", Quantity::length) ==
            parseQuantity("38", Quantity::length, BareNumber::inDefaultUnit, nullptr).problem.text());
    const std::string refused = parseQuantity("38", Quantity::length, BareNumber::refused, mm).problem.text();
    QVERIFY2(refused.find("`38 mm`") != std::string::npos, refused.c_str());
}

void TestUnits::numbersOutsideDoublePrecisionAreRefused() {
    QVERIFY(!parseNumber("1e400"));
    QVERIFY(!parseNumber("1e-400"));
    QVERIFY(!parseNumber("1e99999999999999999999"));
    QVERIFY(!parseNumber("1 2"));
    QVERIFY(!parseNumber("1,5"));
    QVERIFY(!parseNumber(""));
    QVERIFY(!parseNumber("--1"));
    QCOMPARE(*parseNumber(" -1.5e-3 "), -0.0015);
    // As many digits as anybody types: still the nearest double.
    QCOMPARE(*parseNumber("0.1" + std::string(10000, '0') + "1"), 0.1);
}

void TestUnits::numbersReadBackAsTheSameDouble() {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double value = anyDouble(random);
        const std::optional<double> read = parseNumber(formatNumber(value));
        QVERIFY2(read && *read == value, formatNumber(value).c_str());
    }
    QCOMPARE(QString::fromStdString(formatNumber(0.1)), QString("0.1"));
}

void TestUnits::quantitiesReadBackAsTheSameDoubleInEveryUnit() {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-12, 12);
    for (const Quantity quantity : quantities) {
        for (const Unit& unit : unitsOf(quantity)) {
            for (int i = 0; i < 2000; ++i) {
                const double value = i % 4 == 0 ? anyDouble(random) : std::pow(10.0, exponent(random));
                const std::string text = formatQuantity(value, quantity, unit);
                const TypedQuantity typed = parseQuantity(text, quantity);
                QVERIFY2(typed.valid() && typed.si == value, text.c_str());
            }
        }
    }
}

void TestUnits::quantitiesAreWrittenShort_data() {
    QTest::addColumn<double>("si");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    QTest::newRow("38 mm") << 0.038 << Quantity::length << "mm"
                           << "38 mm";
    QTest::newRow("0.0381 m in inches") << 0.0381 << Quantity::length << "in"
                                        << "1.5 in";
    QTest::newRow("210 GPa") << 210e9 << Quantity::stress << "GPa"
                             << "210 GPa";
    QTest::newRow("200 us") << 200e-6 << Quantity::time << "us"
                            << "200 us";
    QTest::newRow("zero") << 0.0 << Quantity::length << "mm"
                          << "0 mm";
    QTest::newRow("negative") << -0.0005 << Quantity::length << "mm"
                              << "-0.5 mm";
    QTest::newRow("ratio") << 0.1 << Quantity::ratio << ""
                           << "0.1";
    QTest::newRow("small ratio") << 1e-9 << Quantity::ratio << ""
                                 << "1e-9";
    QTest::newRow("60 Hz in blows per minute") << 60.0 << Quantity::frequency << "bpm"
                                               << "3600 bpm";
    QTest::newRow("10 m/s in km/h") << 10.0 << Quantity::velocity << "km/h"
                                    << "36 km/h";
}

void TestUnits::quantitiesAreWrittenShort() {
    QFETCH(double, si);
    QFETCH(Quantity, quantity);
    QFETCH(QString, unit);
    QFETCH(QString, text);
    const Unit* found = findUnit(quantity, unit.toStdString());
    QVERIFY(found != nullptr);
    QCOMPARE(QString::fromStdString(formatQuantity(si, quantity, *found)), text);
}

void TestUnits::theUsersLocaleChangesNothing() {
    struct CommaPoint : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
    // Where a German locale is installed the C library follows it too.
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    const double typed = parseQuantity("1234.5 mm", Quantity::length).si;
    const std::string written = formatQuantity(1.2345, Quantity::length, *findUnit(Quantity::length, "mm"));
    std::setlocale(LC_ALL, "C");
    std::locale::global(before);
    QCOMPARE(typed, 1.2345);
    QCOMPARE(QString::fromStdString(written), QString("1234.5 mm"));
}

QTEST_APPLESS_MAIN(TestUnits)
#include "tst_units.moc"
