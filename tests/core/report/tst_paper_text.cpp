// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of any length in the room that paper has for them.
#include <QTest>

#include "core/report/paper_text.h"

using namespace drillwave;

class TestPaperText : public QObject {
    Q_OBJECT

  private slots:
    void whatFitsStaysAsItIs();
    void longLinesAreBrokenAndCounted();
    void noCharacterIsCutInTwo();
    void cellsEndWithAnEllipsisAndMayBeBroken();
};

void TestPaperText::whatFitsStaysAsItIs() {
    for (const std::string text : {"", "\n", "a", "a\nb\n", "a\n\nb", "12345\n12345\n12345\n"}) {
        const PaperLines paper = linesOnPaper(text, 3, 5);
        QCOMPARE(paper.text, text);
        QVERIFY(paper.isWhole);
    }
    QCOMPARE(cellOnPaper("3.66 m", 6), std::string("3.66 m"));
}

void TestPaperText::longLinesAreBrokenAndCounted() {
    const PaperLines paper = linesOnPaper("1234567890123\nb\n", 3, 5);
    QCOMPARE(paper.text, std::string("12345\n67890\n123\n"));
    QVERIFY(!paper.isWhole);
    QCOMPARE(linesOnPaper("a\nb\nc\nd", 3, 5).text, std::string("a\nb\nc\n"));
    QCOMPARE(linesOnPaper("123456", 1, 5).text, std::string("12345\n"));
    QVERIFY(!linesOnPaper("123456", 1, 5).isWhole);
}

void TestPaperText::noCharacterIsCutInTwo() {
    QCOMPARE(linesOnPaper("µµµµ", 2, 2).text, std::string("µµ\nµµ"));
    // Only half as many wide ones have room.
    QCOMPARE(linesOnPaper("測測測", 2, 4).text, std::string("測測\n測"));
    QCOMPARE(cellOnPaper("測測測", 4), std::string("測測…"));
}

void TestPaperText::cellsEndWithAnEllipsisAndMayBeBroken() {
    QCOMPARE(cellOnPaper("by drilling", 2), std::string("by…"));
    const std::string word(100, 'W');
    const std::string cell = cellOnPaper(word, 100);
    QCOMPARE(QString::fromStdString(cell).remove(QChar(0x200b)), QString::fromStdString(word));
    for (const QString& part : QString::fromStdString(cell).split(QChar(0x200b))) QVERIFY(part.size() <= 32);
}

QTEST_GUILESS_MAIN(TestPaperText)
#include "tst_paper_text.moc"
