// SPDX-License-Identifier: GPL-3.0-or-later
// Sums, feet and inches, and units in everyday spellings, as people type them into a field.
#include <QTest>

#include "ui/text/typed_quantity.h"

using namespace drillwave;

class TestTypedQuantity : public QObject {
    Q_OBJECT

  private slots:
    void arithmeticIsDoneBeforeTheUnit_data();
    void arithmeticIsDoneBeforeTheUnit();
    void theUnitIsTheLastThatWasTyped();
    void germansCalculateWithCommas();
    void whatCannotBeCalculatedIsRefusedWithAReason_data();
    void whatCannotBeCalculatedIsRefusedWithAReason();
    void capitalsNeverMakeMegaOfMilli();
    void theOneOfAReciprocalUnitBelongsToIt();
    void longOrDeepTextsAreRefused();
};

namespace {

TypedQuantity read(const QString& typed, Quantity quantity = Quantity::length, const char* unit = "mm",
                   const QLocale& locale = QLocale::c()) {
    return typedQuantity(typed, quantity, *findUnit(quantity, unit), locale);
}

}  // namespace

// Expected to the last digit: what a form shows is 6.1 m, not 6.1000000000000005 m.
void TestTypedQuantity::arithmeticIsDoneBeforeTheUnit_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("metres");
    QTest::newRow("a product") << "2*3.05 m" << 6.1;
    QTest::newRow("a fraction") << "1/2 in" << 0.0127;
    QTest::newRow("a mixed fraction") << "1 1/2 in" << 0.0381;
    QTest::newRow("feet") << "12'" << 3.6576;
    QTest::newRow("inches") << "144\"" << 3.6576;
    QTest::newRow("feet and inches") << "12' 6\"" << 3.81;
    QTest::newRow("feet and inches, close") << "5'6\"" << 1.6764;
    QTest::newRow("feet and a fraction of inches") << "1 ft 6 1/2 in" << 0.4699;
    QTest::newRow("feet and inches with a hyphen") << "12'-3\"" << 3.7338;
    QTest::newRow("feet and a fraction with a hyphen") << "12'-3 1/2\"" << 3.7465;
    QTest::newRow("feet less inches") << "12 ft - 3 in" << 3.5814;
    QTest::newRow("feet less inches, close") << "12 ft -3 in" << 3.5814;
    QTest::newRow("feet less inches by their marks") << "12' - 3\"" << 3.5814;
    QTest::newRow("feet less inches, blank before") << "12' -3\"" << 3.5814;
    QTest::newRow("feet and a minus sign") << QString::fromUtf8("12'−3\"") << 3.5814;
    QTest::newRow("a word") << "3.66 metres" << 3.66;
    QTest::newRow("one metre") << "1 meter" << 1.0;
    QTest::newRow("capitals") << "12 FT" << 3.6576;
    QTest::newRow("capitals with a prefix") << "38 MM" << 0.038;
    QTest::newRow("a sum") << "3 + 0.66 m" << 3.66;
    QTest::newRow("a sum of two units") << "12 ft + 3 in" << 3.7338;
    QTest::newRow("a difference without units") << "40-2" << 0.038;
    QTest::newRow("brackets") << "2*(3 + 0.05) m" << 6.1;
    QTest::newRow("a quotient") << "10/4 m" << 2.5;
    QTest::newRow("signs of typography") << QString::fromUtf8("2×3.05 m − 10 cm") << 6.0;
    QTest::newRow("exponents") << "2*1e-3 m" << 0.002;
    QTest::newRow("no arithmetic at all") << "38 mm" << 0.038;
}

void TestTypedQuantity::arithmeticIsDoneBeforeTheUnit() {
    QFETCH(const QString, typed);
    QFETCH(const double, metres);
    const TypedQuantity quantity = read(typed);
    QVERIFY2(quantity.valid(), quantity.problem.text().c_str());
    QVERIFY2(std::abs(quantity.si - metres) <= 2e-16 * metres, formatNumber(quantity.si).c_str());
}

void TestTypedQuantity::theUnitIsTheLastThatWasTyped() {
    QCOMPARE(read(QStringLiteral("1/2 in")).unit, findUnit(Quantity::length, "in"));
    QCOMPARE(read(QStringLiteral("12 ft + 3 in")).unit, findUnit(Quantity::length, "in"));
    QCOMPARE(read(QStringLiteral("40-2")).unit, findUnit(Quantity::length, "mm"));
    QCOMPARE(read(QStringLiteral("2*50 kN"), Quantity::force, "N").si, 1e5);
    QCOMPARE(read(QStringLiteral("1/3"), Quantity::ratio, "").si, 1.0 / 3);
    QCOMPARE(read(QStringLiteral("2*60 MN/m"), Quantity::stiffness, "MN/m").si, 1.2e8);
}

void TestTypedQuantity::germansCalculateWithCommas() {
    const QLocale german(QStringLiteral("de_DE"));
    QCOMPARE(read(QStringLiteral("2*3,05 m"), Quantity::length, "mm", german).si, 6.1);
    QVERIFY(!read(QStringLiteral("2*1,500 m")).valid());  // one and a half, or a thousand and a half
}

void TestTypedQuantity::whatCannotBeCalculatedIsRefusedWithAReason_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("reason");
    QTest::newRow("by zero") << "1/0 m"
                             << "zero";
    QTest::newRow("begins with a product") << "*3 m"
                                           << "no number";
    QTest::newRow("ends with a product") << "3*"
                                         << "no number";
    QTest::newRow("open bracket") << "2*(3 + 1 m"
                                  << "bracket";
    QTest::newRow("a length times a length") << "2 m*3 m"
                                             << "not known";
    QTest::newRow("another quantity in a sum") << "2 m + 3 kg"
                                               << "kg";
    QTest::newRow("beyond doubles") << "1e308*1e308 m"
                                    << "too large";
    QTest::newRow("a fraction of fractions") << "1/2 1/2 in"
                                             << "not one number";
    QTest::newRow("only a sign") << "1+-m"
                                 << "no number";
    QTest::newRow("no digits") << "a/b"
                               << "not a number";
    QTest::newRow("one number, wrong unit") << "3.66 kg"
                                            << "allowed units";
}

void TestTypedQuantity::whatCannotBeCalculatedIsRefusedWithAReason() {
    QFETCH(const QString, typed);
    QFETCH(const QString, reason);
    const TypedQuantity quantity = read(typed);
    QVERIFY(!quantity.valid());
    QVERIFY2(quantity.problem.text().find(reason.toStdString()) != std::string::npos,
             quantity.problem.text().c_str());
}

void TestTypedQuantity::capitalsNeverMakeMegaOfMilli() {
    QVERIFY(!read(QStringLiteral("105 mn/m"), Quantity::stiffness, "MN/m").valid());
    QVERIFY(!read(QStringLiteral("210 mpa"), Quantity::stress, "GPa").valid());
    QVERIFY(!read(QStringLiteral("5 mj"), Quantity::energy, "J").valid());
    QCOMPARE(read(QStringLiteral("255 KN"), Quantity::force, "N").si, 255e3);
}

void TestTypedQuantity::theOneOfAReciprocalUnitBelongsToIt() {
    QCOMPARE(read(QStringLiteral("0.002 1/m"), Quantity::attenuation, "1/m").si, 0.002);
    QCOMPARE(read(QStringLiteral("2 1/km"), Quantity::attenuation, "1/m").si, 0.002);
    QCOMPARE(read(QStringLiteral("0.002"), Quantity::attenuation, "1/m").si, 0.002);
    QCOMPARE(read(QStringLiteral("2*0.001 1/m"), Quantity::attenuation, "1/m").si, 0.002);
    QVERIFY(!read(QStringLiteral("x 1/m"), Quantity::attenuation, "1/m").valid());
}

void TestTypedQuantity::longOrDeepTextsAreRefused() {
    QVERIFY(!read(QStringLiteral("1+").repeated(5000) + QStringLiteral("1 m")).valid());
    QVERIFY(!read(QStringLiteral("(").repeated(40) + QStringLiteral("1") + QStringLiteral(")").repeated(40))
                 .valid());
    QCOMPARE(read(QStringLiteral("((1))")).si, 0.001);
}

QTEST_GUILESS_MAIN(TestTypedQuantity)
#include "tst_typed_quantity.moc"
