// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of text, as all reports for people show their numbers.
#include <QTest>

#include "core/report/report_text.h"

using namespace drillwave;

class TestReportText : public QObject {
    Q_OBJECT

  private slots:
    void numbersStandUnderEachOther();
    void cellsMayBeAlignedToTheLeft();
    void columnsAreCharacters();
    void aParagraphIsAsWideAsItsCharacters();
    void aRemarkWidensNoColumn();
    void linesHaveNoBlanksAtTheirEnd();
    void aTitleTakesOneLine();
};

void TestReportText::numbersStandUnderEachOther() {
    TextGrid grid;
    grid.add({"", "e", "force"});
    grid.add({"smallest", "0.25", "7 kN"});
    grid.add({"mean", "1", "120 kN"});
    QCOMPARE(grid.text(), std::string("               e   force\n"
                                      "  smallest  0.25    7 kN\n"
                                      "  mean         1  120 kN\n"));
}

void TestReportText::cellsMayBeAlignedToTheLeft() {
    TextGrid grid(CellAlignment::left);
    grid.add({"restitution", "0.25"});
    grid.add({"force", "1.5 F0", "7 kN"});
    grid.add({"time", "12 t0", "120 us"});
    QCOMPARE(grid.text(), std::string("  restitution  0.25\n"
                                      "  force        1.5 F0  7 kN\n"
                                      "  time         12 t0   120 us\n"));
}

// An umlaut has two bytes.
void TestReportText::columnsAreCharacters() {
    TextGrid grid;
    grid.add({"Größe", "e", "Stöße"});
    grid.add({"kleinste", "0,25", "7"});
    QCOMPARE(grid.text(), std::string("  Größe        e  Stöße\n"
                                      "  kleinste  0,25      7\n"));
}

void TestReportText::aParagraphIsAsWideAsItsCharacters() {
    const std::string letters(96, 'x');
    QCOMPARE(paragraph(letters + " ü y"), "  " + letters + " ü\n  y\n");
    QCOMPARE(paragraph(letters + "ü ü y"), "  " + letters + "ü\n  ü y\n");
}

void TestReportText::aRemarkWidensNoColumn() {
    TextGrid grid;
    grid.add({"a remark that is longer than anything else"});
    grid.add({"lattice", "not solved: it needs more pieces"});
    grid.add({"exact", "1", "2"});
    QCOMPARE(grid.text(), std::string("  a remark that is longer than anything else\n"
                                      "  lattice  not solved: it needs more pieces\n"
                                      "  exact    1  2\n"));
}

void TestReportText::linesHaveNoBlanksAtTheirEnd() {
    TextGrid grid(CellAlignment::left);
    grid.add({"long label", "", ""});
    grid.add({""});
    grid.add({"a", "b", "c"});
    QCOMPARE(grid.text(), std::string("  long label\n\n  a           b  c\n"));
}

// A title may hold anything; a terminal takes orders from control characters.
void TestReportText::aTitleTakesOneLine() {
    Scenario scenario;
    scenario.title = "two\nlines\x1b[2J";
    QVERIFY(headingOf(scenario).starts_with("two lines\\x1B[2J\n  beta "));
    scenario.title.clear();
    QVERIFY(headingOf(scenario).starts_with("  beta "));
}

QTEST_GUILESS_MAIN(TestReportText)
#include "tst_report_text.moc"
