// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal text: the point is moved in the digits, so that nothing is rounded twice.
#include <QTest>

#include <bit>
#include <cmath>
#include <random>

#include "core/text/decimal_text.h"

using namespace drillwave;

class TestDecimalText : public QObject {
    Q_OBJECT

  private slots:
    void numbersEndWhereTheUnitBegins_data();
    void numbersEndWhereTheUnitBegins();
    void shiftedTextIsTheNearestDouble();
    void shiftingThereAndBackIsExact();
    void longTextIsCutBetweenCharacters();
};

void TestDecimalText::numbersEndWhereTheUnitBegins_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("length");
    QTest::newRow("unit") << "38mm" << 2;
    QTest::newRow("exponent") << "1.5e-3m" << 6;
    QTest::newRow("a unit that begins with e") << "3e" << 1;
    QTest::newRow("an exponent without digits") << "3e+m" << 1;
    QTest::newRow("no digits before the point") << "-.5" << 3;
    QTest::newRow("no digits behind the point") << "5." << 2;
    QTest::newRow("point alone") << "." << 0;
    QTest::newRow("sign alone") << "+m" << 0;
    QTest::newRow("word") << "inf" << 0;
    QTest::newRow("empty") << "" << 0;
}

void TestDecimalText::numbersEndWhereTheUnitBegins() {
    QFETCH(QString, text);
    QFETCH(int, length);
    QCOMPARE(static_cast<int>(numberLength(text.toStdString())), length);
}

// The literal is rounded once by the compiler.
void TestDecimalText::shiftedTextIsTheNearestDouble() {
    QCOMPARE(*scaledNumber("38", -3), 0.038);
    QCOMPARE(*scaledNumber("0.1", -3), 0.0001);
    QCOMPARE(*scaledNumber("210", 9), 210e9);
    QCOMPARE(*scaledNumber("+1.5E+2", -6), 1.5e-4);
    QVERIFY(!scaledNumber("1e308", 3));
    QVERIFY(!scaledNumber("1e-323", -3));
    QVERIFY(!scaledNumber("1e2147483647", 3));
}

void TestDecimalText::shiftingThereAndBackIsExact() {
    std::mt19937_64 random(11);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        for (const int exponent : {-9, -6, -3, 0, 3, 9})
            QCOMPARE(*scaledNumber(shiftedNumber(value, exponent), -exponent), value);
    }
    QCOMPARE(QString::fromStdString(shiftedNumber(0.038, 3)), QString("38"));
    QCOMPARE(QString::fromStdString(shiftedNumber(-0.00015, 0)), QString("-0.00015"));
    QCOMPARE(QString::fromStdString(shiftedNumber(1.25e20, 0)), QString("1.25e20"));
}

void TestDecimalText::longTextIsCutBetweenCharacters() {
    QCOMPARE(QString::fromStdString(shortened("short\n")), QString("short "));
    const QString umlauts(100, QChar(0xFC));
    const QString cut = QString::fromStdString(shortened(umlauts.toStdString()));
    QVERIFY(cut.endsWith(QChar(0x2026)));
    QVERIFY(umlauts.startsWith(cut.chopped(1)));
    QVERIFY(cut.size() >= 20 && cut.size() <= 41);
}

QTEST_APPLESS_MAIN(TestDecimalText)
#include "tst_decimal_text.moc"
