// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for people: as many digits as they need.
#include <QTest>
#include <limits>

#include "core/text/handy_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

using namespace drillwave;

class TestNumberText : public QObject {
    Q_OBJECT

  private slots:
    void numbersAreWrittenForPeople_data();
    void numbersAreWrittenForPeople();
    void boundsAreRoundedUp_data();
    void boundsAreRoundedUp();
    void theLocaleGivesTheComma();
    void noLocaleGroupsDigits();
    void signsStandForWhatTerminalsLack();
};

void TestNumberText::numbersAreWrittenForPeople_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("digits");
    QTest::addColumn<QString>("text");
    QTest::newRow("a COR") << 0.40671234 << 4 << QStringLiteral("0.4067");
    QTest::newRow("negative, with a real minus") << -0.40671234 << 4 << QStringLiteral("−0.4067");
    QTest::newRow("nothing") << 0.0 << 4 << QStringLiteral("0");
    QTest::newRow("no trailing zeros") << 200.0 << 4 << QStringLiteral("200");
    QTest::newRow("more digits before the point") << 12345.6 << 4 << QStringLiteral("12346");
    QTest::newRow("rounded up to one digit more") << 9999.7 << 4 << QStringLiteral("10000");
    QTest::newRow("three digits of thousands") << 2666.4 << 3 << QStringLiteral("2666");
    QTest::newRow("large") << 1.23456e9 << 4 << QStringLiteral("1.235·10⁹");
    QTest::newRow("small") << -1.23456e-12 << 4 << QStringLiteral("−1.235·10⁻¹²");
    QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min() << 2
                              << QStringLiteral("4.9·10⁻³²⁴");
}

void TestNumberText::numbersAreWrittenForPeople() {
    QFETCH(const double, value);
    QFETCH(const int, digits);
    QTEST(numberText(value, digits, QLocale::c()), "text");
}

void TestNumberText::boundsAreRoundedUp_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("digits");
    QTest::addColumn<QString>("text");
    QTest::newRow("just above") << 1.2301 << 3 << QStringLiteral("1.24");
    QTest::newRow("already round") << 0.3 << 1 << QStringLiteral("0.3");
    QTest::newRow("already round, three digits") << 1.1 << 3 << QStringLiteral("1.1");
    QTest::newRow("one digit more") << 99.91 << 3 << QStringLiteral("100");
    QTest::newRow("large") << 1234.0 << 2 << QStringLiteral("1300");
    QTest::newRow("small") << 3.21e-7 << 2 << QStringLiteral("3.3·10⁻⁷");
    QTest::newRow("nothing") << 0.0 << 3 << QStringLiteral("0");
}

void TestNumberText::boundsAreRoundedUp() {
    QFETCH(const double, value);
    QFETCH(const int, digits);
    QTEST(numberText(roundedTo(value, digits, Rounding::up), digits, QLocale::c()), "text");
    QCOMPARE(boundText(3.2e-15, QLocale::c()), QStringLiteral("4·10⁻¹⁵"));
}

void TestNumberText::theLocaleGivesTheComma() {
    const QLocale german(QLocale::German);
    QCOMPARE(numberText(0.5, 3, german), QStringLiteral("0,5"));
    QCOMPARE(numberText(1.5e-9, 2, german), QStringLiteral("1,5·10⁻⁹"));
    QCOMPARE(numberText(12345.0, 3, german), QStringLiteral("12345"));
}

void TestNumberText::noLocaleGroupsDigits() {
    for (const char* name : {"en_US", "de_DE", "sv_SE"}) {
        const QLocale locale(QString::fromLatin1(name));
        QVERIFY(locale.toString(12345) != QStringLiteral("12345"));
        QCOMPARE(withoutGroups(locale).toString(12345), QStringLiteral("12345"));
    }
}

void TestNumberText::signsStandForWhatTerminalsLack() {
    QCOMPARE(withSigns(QStringLiteral("phi = 2 +- 1, f I0 (1 + e), d0")),
             QStringLiteral("φ = 2 ± 1, f I₀ (1 + e), d₀"));
    QCOMPARE(withSigns(QStringLiteral("T0, 10, graphic")), QStringLiteral("T0, 10, graphic"));
    QCOMPARE(translated(Message("gap %1 +- %2", {std::string("d0"), std::string("1")})),
             QStringLiteral("gap d0 ± 1"));  // names stay
}

QTEST_GUILESS_MAIN(TestNumberText)
#include "tst_number_text.moc"
