// SPDX-License-Identifier: GPL-3.0-or-later
// Names that people read in one line, and what is printed of bytes that are no text.
#include <QTest>

#include "core/text/decimal_text.h"
#include "core/text/name_text.h"

using namespace drillwave;

class TestNameText : public QObject {
    Q_OBJECT

  private slots:
    void aNameIsOneLineWithALetter_data();
    void aNameIsOneLineWithALetter();
    void whatIsNoTextIsPrintedAsItsNumber_data();
    void whatIsNoTextIsPrintedAsItsNumber();
};

void TestNameText::aNameIsOneLineWithALetter_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* name, const char* problem) {
        QTest::newRow(name) << QByteArray(name) << problem;
    };
    for (const char* good : {"rod", "T38", "coupling ⌀39 mm", "a.b", "Stange", "Übergang", "штанга", "钎杆",
                             "ロッド", "repeat", "9/16 in", "µ"})
        row(good, "");
    for (const char* bad : {"", " ", "12", "3-4", "…", "⌀39", "39 × 14.5", "😀"})
        row(bad, "must have a letter");
    for (const char* bad : {"two\nlines", "rod\r"}) row(bad, "must be one line");
    for (const char* bad : {"rod\t", "rod\x7F", "rod\xC2\x85", "rod\xE2\x80\xA8", "\xEF\xBB\xBFrod"})
        row(bad, "must have no control characters");
    for (const char* bad : {"rod\u202E", "\u2066rod\u2069", "rod\u200F"})
        row(bad, "must have no characters that change the reading direction");
    row("rod\xE9", "must be UTF-8");
}

void TestNameText::aNameIsOneLineWithALetter() {
    QFETCH(QByteArray, name);
    QFETCH(QString, problem);
    QCOMPARE(QString::fromStdString(nameProblem(name.toStdString()).text()), problem);
}

void TestNameText::whatIsNoTextIsPrintedAsItsNumber_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("printed");
    const auto row = [](const char* text, const char* printed) {
        QTest::newRow(printed) << QByteArray(text) << QByteArray(printed);
    };
    row("string.r\xE9"
        "d.length",
        "string.r\\xE9d.length");
    row("caf\xC3", "caf\\xC3");
    row("\xFF\xFE", "\\xFF\\xFE");
    row("Größe ⌀ 😀", "Größe ⌀ 😀");
    row("a\u202E"
        "b",
        "a\\u202Eb");
    row("a\x1B[2Jb", "a\\x1B[2Jb");
    row("a\xC2\x9B"
        "2Jb",
        "a\\u009B2Jb");
}

void TestNameText::whatIsNoTextIsPrintedAsItsNumber() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, printed);
    QCOMPARE(QByteArray::fromStdString(printable(text.toStdString())), printed);
    QVERIFY(QByteArray::fromStdString(shortened(text.toStdString())).isValidUtf8());
    QCOMPARE(QByteArray::fromStdString(printableLines("\n\t" + text.toStdString())), "\n\t" + printed);
    QCOMPARE(QByteArray::fromStdString(printableLine("\r\n\t" + text.toStdString())), "   " + printed);
}

QTEST_APPLESS_MAIN(TestNameText)
#include "tst_name_text.moc"
