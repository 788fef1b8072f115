// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <sstream>

#include "core/signal/case_records.h"

using namespace drillwave;

namespace {

struct Contents {
    std::vector<std::vector<std::string>> records;
    std::vector<int> lines;
    std::string problem;
};

Contents contentsOf(const std::string& text) {
    std::istringstream in(text);
    CaseRecords reader(in);
    Contents contents;
    for (CsvRecord record; reader.next(record);) {
        contents.records.push_back(record.cells);
        contents.lines.push_back(reader.line());
        if (!record.problem.isEmpty() && contents.problem.empty()) contents.problem = record.problem.text();
    }
    return contents;
}

}  // namespace

class TestCaseRecords : public QObject {
    Q_OBJECT

  private slots:
    void everySpreadsheetGivesTheSameCells_data();
    void everySpreadsheetGivesTheSameCells();
    void cellsWithoutNumbersStay();
    void emptyRowsEndTheTable();
    void emptyRowsBetweenCasesAreRefused();
    void skippedRecordsAreThoseThatAreRead();
};

void TestCaseRecords::everySpreadsheetGivesTheSameCells_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addRow("English") << QByteArray("rod.length [m],bit_rock.gamma\n3.66,0.1\n-4.27,0.2\n");
    QTest::addRow("German") << QByteArray("rod.length [m];bit_rock.gamma\r\n3,66;0,1\r\n-4,27;0,2\r\n");
    QTest::addRow("Swedish") << QByteArray("rod.length [m];bit_rock.gamma\n3,66;0,1\n\u22124,27;0,2\n");
    QTest::addRow("tabs") << QByteArray("rod.length [m]\tbit_rock.gamma\n3,66\t0,1\n-4,27\t0,2\n");
    QTest::addRow("CR CR LF") << QByteArray(
        "rod.length [m],bit_rock.gamma\r\r\n3.66,0.1\r\r\n-4.27,0.2\r\r\n");
    QTest::addRow("CR") << QByteArray("rod.length [m];bit_rock.gamma\r3,66;0,1\r-4,27;0,2\r");
    QTest::addRow("sep=") << QByteArray("sep=;\nrod.length [m];bit_rock.gamma\n3,66;0,1\n-4,27;0,2\n");
    QTest::addRow("quoted commas") << QByteArray(
        "rod.length [m],bit_rock.gamma\n\"3,66\",\"0,1\"\n\"-4,27\",\"0,2\"\n");
    QTest::addRow("NUL tail") << QByteArray("rod.length [m],bit_rock.gamma\n3.66,0.1\n-4.27,0.2\n\0\0\0", 52);
    QByteArray wide("\xFF\xFE");
    for (const char c : QByteArray("rod.length [m]\tbit_rock.gamma\r\n3,66\t0,1\r\n-4,27\t0,2\r\n")) {
        wide += c;
        wide += '\0';
    }
    QTest::addRow("UTF-16") << wide;
}

void TestCaseRecords::everySpreadsheetGivesTheSameCells() {
    QFETCH(QByteArray, text);
    const Contents contents = contentsOf(text.toStdString());
    const std::vector<std::vector<std::string>> expected{
        {"rod.length [m]", "bit_rock.gamma"}, {"3.66", "0.1"}, {"-4.27", "0.2"}};
    QCOMPARE(contents.problem, std::string());
    QCOMPARE(contents.records, expected);
}

void TestCaseRecords::cellsWithoutNumbersStay() {
    const Contents contents = contentsOf("name;rod.length\nA, 3rd hole;3,66 m\n1,2,3;4,27 m\n");
    QCOMPARE(contents.records[1], (std::vector<std::string>{"A, 3rd hole", "3.66 m"}));
    QCOMPARE(contents.records[2], (std::vector<std::string>{"1,2,3", "4.27 m"}));
    // With points a comma belongs to a word.
    QCOMPARE(contentsOf("a,b\n1.5,\"x, 1,5\"\n").records[1], (std::vector<std::string>{"1.5", "x, 1,5"}));
}

void TestCaseRecords::emptyRowsEndTheTable() {
    const Contents contents = contentsOf("a,b\r\n1,2\r\n3,4\r\n,\r\n , \r\n\r\n,\r\n");
    QCOMPARE(contents.records.size(), std::size_t{3});
    QCOMPARE(contents.problem, std::string());
}

void TestCaseRecords::emptyRowsBetweenCasesAreRefused() {
    const Contents contents = contentsOf("a,b\n1,2\n,\n,\n3,4\n");
    QCOMPARE(contents.lines, (std::vector<int>{1, 2, 3, 5}));
    QVERIFY(contents.problem.find("without values") != std::string::npos);
}

void TestCaseRecords::skippedRecordsAreThoseThatAreRead() {
    const std::string texts[] = {"a;b\n1,5;2\n;\n3;4\n\n5;\n;\n", "a,b\n1,2\n\"\",\"\"\n3,4\n",
                                 std::string("a,b\n1,2\n3\0,4\n5,6\n", 16)};
    for (const std::string& text : texts) {
        const Contents all = contentsOf(text);
        for (std::size_t some = 0; some <= all.records.size(); ++some) {
            std::istringstream in(text);
            CaseRecords reader(in);
            QCOMPARE(reader.skip(some), std::uint64_t{some});
            CsvRecord record;
            QCOMPARE(reader.next(record), some < all.records.size());
            if (some < all.records.size()) QCOMPARE(record.cells, all.records[some]);
        }
    }
}

QTEST_APPLESS_MAIN(TestCaseRecords)
#include "tst_case_records.moc"
