// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people type them, whatever the comma.
#include <QTest>

#include "ui/text/typed_text.h"

using namespace drillwave;

class TestTypedText : public QObject {
    Q_OBJECT

  private slots:
    void numbersAreReadAsTheUserMeansThem_data();
    void numbersAreReadAsTheUserMeansThem();
    void ambiguousNumbersAreRefused_data();
    void ambiguousNumbersAreRefused();
    void numbersAreShownWithTheLocalesDecimalSign();
    void unitsAreShownAsTheyArePrinted();
};

void TestTypedText::numbersAreReadAsTheUserMeansThem_data() {
    QTest::addColumn<QString>("locale");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("plain");
    QTest::newRow("C: point") << "C"
                              << "3.2 m"
                              << "3.2 m";
    QTest::newRow("C: comma") << "C"
                              << "3,2 m"
                              << "3.2 m";
    QTest::newRow("C: no blank before the unit") << "C"
                                                 << "1.5in"
                                                 << "1.5 in";
    QTest::newRow("C: exponent") << "C"
                                 << "1e-3 m"
                                 << "1e-3 m";
    QTest::newRow("C: unit that begins with e is no exponent") << "C"
                                                               << "3 em"
                                                               << "3 em";
    QTest::newRow("C: blank groups") << "C"
                                     << "7 850 kg/m^3"
                                     << "7850 kg/m^3";
    QTest::newRow("C: comma groups and point") << "C"
                                               << "1,234.5"
                                               << "1234.5";
    QTest::newRow("C: several comma groups") << "C"
                                             << "1,234,567"
                                             << "1234567";
    QTest::newRow("C: zero before the comma") << "C"
                                              << "0,125"
                                              << "0.125";
    QTest::newRow("C: four digits before the comma") << "C"
                                                     << "1234,567"
                                                     << "1234.567";
    QTest::newRow("de: comma") << "de_DE"
                               << "3,2 m"
                               << "3.2 m";
    QTest::newRow("de: comma and three digits") << "de_DE"
                                                << "1,500"
                                                << "1.500";
    QTest::newRow("de: point") << "de_DE"
                               << "3.2 m"
                               << "3.2 m";
    QTest::newRow("de: point groups and comma") << "de_DE"
                                                << "1.234,5"
                                                << "1234.5";
    QTest::newRow("de_CH: apostrophe groups") << "de_CH"
                                              << "1’234.5"
                                              << "1234.5";
    QTest::newRow("sv: minus sign and no-break blank")
        << "sv_SE" << QStringLiteral("−1\u00a0234,5") << "-1234.5";
    QTest::newRow("C: point groups and comma") << "C"
                                               << "1.234,5"
                                               << "1234.5";
    QTest::newRow("de: comma groups and point") << "de_DE"
                                                << "1,234.5"
                                                << "1234.5";
    QTest::newRow("sv: comma") << "sv_SE"
                               << "3,2"
                               << "3.2";
    QTest::newRow("sv: point") << "sv_SE"
                               << "3.2"
                               << "3.2";
    QTest::newRow("sv: point groups and comma") << "sv_SE"
                                                << "1.234,5"
                                                << "1234.5";
    QTest::newRow("sv: thin blank and exponent")
        << "sv_SE" << QStringLiteral("−1\u202f234e−3 m") << "-1234e-3 m";
    QTest::newRow("pasted with its line break") << "C"
                                                << "38 mm\r\n"
                                                << "38 mm";
    QTest::newRow("pasted with marks nobody sees")
        << "C" << QStringLiteral("\ufeff38\u00a0mm\u200b") << "38 mm";
    QTest::newRow("not a number") << "C"
                                  << "abc"
                                  << "abc";
    QTest::newRow("empty") << "C"
                           << "  "
                           << "";
}

void TestTypedText::numbersAreReadAsTheUserMeansThem() {
    QFETCH(QString, locale);
    QFETCH(QString, typed);
    QFETCH(QString, plain);
    const PlainText read = plainText(typed, QLocale(locale));
    QCOMPARE(read.problem, QString());
    QCOMPARE(read.text, plain);
}

void TestTypedText::ambiguousNumbersAreRefused_data() {
    QTest::addColumn<QString>("locale");
    QTest::addColumn<QString>("typed");
    QTest::newRow("C: one or a thousand") << "C"
                                          << "1,500";
    QTest::newRow("de: one or a thousand") << "de_DE"
                                           << "7.850 kg/m^3";
    QTest::newRow("two points and a comma in wrong groups") << "C"
                                                            << "1.2.3,4";
    QTest::newRow("blank inside a number") << "C"
                                           << "3 8 mm";
    QTest::newRow("two cells of a column") << "C"
                                           << "1\n234";
    QTest::newRow("sv: one or a thousand") << "sv_SE"
                                           << "7.850";
    QTest::newRow("two decimal commas") << "de_DE"
                                        << "1,2,3";
}

void TestTypedText::ambiguousNumbersAreRefused() {
    QFETCH(QString, locale);
    QFETCH(QString, typed);
    QVERIFY(!plainText(typed, QLocale(locale)).problem.isEmpty());
}

void TestTypedText::numbersAreShownWithTheLocalesDecimalSign() {
    QCOMPARE(localText(QStringLiteral("3.66"), QLocale(QStringLiteral("de_DE"))), QStringLiteral("3,66"));
    QCOMPARE(localText(QStringLiteral("3.66"), QLocale::c()), QStringLiteral("3.66"));
}

void TestTypedText::unitsAreShownAsTheyArePrinted() {
    QCOMPARE(shownUnitName("us"), QStringLiteral("µs"));
    QCOMPARE(shownUnitName("kg/m^3"), QStringLiteral("kg/m³"));
    QCOMPARE(shownUnitName("mm"), QStringLiteral("mm"));
    QCOMPARE(shownUnitName("deg"), QStringLiteral("°"));
}

QTEST_MAIN(TestTypedText)
#include "tst_typed_text.moc"
