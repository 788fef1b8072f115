// SPDX-License-Identifier: GPL-3.0-or-later
// CSV, RFC 4180: read record by record in bounded memory, and written so that it reads back.
#include <QTest>

#include <random>
#include <sstream>

#include "core/text/csv.h"

using namespace drillwave;

namespace {

using Records = QList<QStringList>;

/// Every record of the text, its cells, and the problems found on the way.
struct Contents {
    Records records;
    QList<int> lines;
    QStringList problems;
};

Contents contentsOf(const std::string& text, std::size_t limit = 1 << 20) {
    std::istringstream in(text);
    CsvReader reader(in, limit);
    Contents contents;
    CsvRecord record;
    while (reader.next(record)) {
        QStringList cells;
        for (const std::string& cell : record.cells) cells << QString::fromStdString(cell);
        contents.records << cells;
        contents.lines << reader.line();
        if (!record.problem.isEmpty()) contents.problems << QString::fromStdString(record.problem.text());
    }
    return contents;
}

}  // namespace

class TestCsv : public QObject {
    Q_OBJECT

  private slots:
    void recordsAreSplitIntoCells_data();
    void recordsAreSplitIntoCells();
    void linesAreCountedThroughQuotesAndComments();
    void malformedRecordsAreReported_data();
    void malformedRecordsAreReported();
    void aRecordIsNeverKeptBeyondItsLimit();
    void cellsReadBackAsTheyWereWritten();
    void skippedRecordsAreThoseThatAreRead();
};

void TestCsv::recordsAreSplitIntoCells_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<Records>("records");
    QTest::newRow("plain") << "a,b\n1,2\n" << Records{{"a", "b"}, {"1", "2"}};
    QTest::newRow("no last line end") << "a,b\n1,2" << Records{{"a", "b"}, {"1", "2"}};
    QTest::newRow("Windows line ends") << "a,b\r\n1,2\r\n" << Records{{"a", "b"}, {"1", "2"}};
    QTest::newRow("old Macintosh line ends") << "a,b\r1,2\r" << Records{{"a", "b"}, {"1", "2"}};
    QTest::newRow("empty cells") << ",a,\n" << Records{{"", "a", ""}};
    QTest::newRow("blank lines") << "\n\na\n\n1\n" << Records{{"a"}, {"1"}};
    QTest::newRow("a quoted empty cell is a record") << "a\n\"\"\n" << Records{{"a"}, {""}};
    QTest::newRow("quotes") << "\"a,b\",\"say \"\"x\"\"\"\n" << Records{{"a,b", "say \"x\""}};
    QTest::newRow("line end in quotes") << "\"a\nb\",c\n" << Records{{"a\nb", "c"}};
    QTest::newRow("comments before the header") << "# x\n# y\na\n#1\n" << Records{{"a"}, {"#1"}};
    QTest::newRow("byte order mark") << QString("\ufeffa,b\n1,2\n") << Records{{"a", "b"}, {"1", "2"}};
    QTest::newRow("byte order mark and comment") << QString("\ufeff# x\na\n") << Records{{"a"}};
    QTest::newRow("quote inside a cell") << "a\"b,c\n" << Records{{"a\"b", "c"}};
    QTest::newRow("nothing") << "" << Records{};
    QTest::newRow("only a comment") << "# x" << Records{};
}

void TestCsv::recordsAreSplitIntoCells() {
    QFETCH(QString, text);
    QFETCH(Records, records);
    const Contents contents = contentsOf(text.toStdString());
    QCOMPARE(contents.records, records);
    QCOMPARE(contents.problems, QStringList());
}

void TestCsv::linesAreCountedThroughQuotesAndComments() {
    const Contents contents = contentsOf("# one\n\na,b\r\n\"x\ny\",1\n2,3\n");
    QCOMPARE(contents.lines, QList<int>({3, 4, 6}));
}

void TestCsv::malformedRecordsAreReported_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("problem");
    QTest::newRow("open quote") << "a\n\"1,2\n3,4\n"
                                << "not closed";
    QTest::newRow("text behind a quote") << "\"a\"b,c\n"
                                         << "closing quote";
    QTest::newRow("long record") << QString(300, 'x') + "\n"
                                 << "too long";
    QTest::newRow("many cells") << QString(300, ',') + "\n"
                                << "too many cells";
}

void TestCsv::malformedRecordsAreReported() {
    QFETCH(QString, text);
    QFETCH(QString, problem);
    const Contents contents = contentsOf(text.toStdString(), 200);
    QCOMPARE(contents.problems.size(), 1);
    QVERIFY2(contents.problems.front().contains(problem), qPrintable(contents.problems.front()));
}

void TestCsv::aRecordIsNeverKeptBeyondItsLimit() {
    const std::string text = "a\n" + std::string(5'000'000, 'x') + "\n1\n\"" + std::string(5'000'000, '\n');
    std::istringstream in(text);
    CsvReader reader(in, 1000);
    CsvRecord record;
    std::size_t records = 0;
    while (reader.next(record)) {
        ++records;
        std::size_t bytes = 0;
        for (const std::string& cell : record.cells) bytes += cell.size();
        QVERIFY(bytes <= 1000);
    }
    QCOMPARE(records, std::size_t{4});
}

void TestCsv::cellsReadBackAsTheyWereWritten() {
    std::mt19937 random(5);
    const std::string alphabet = "a1 ,\"\n\r#\xc3\xa9;";
    std::uniform_int_distribution<std::size_t> character(0, alphabet.size() - 1);
    std::uniform_int_distribution<int> length(0, 8);
    for (int i = 0; i < 5000; ++i) {
        // The leading cell keeps the record from being blank or a comment.
        QStringList cells{"x"};
        std::string text = "x";
        for (int cell = 0; cell < 3; ++cell) {
            std::string value;
            for (int n = length(random); n > 0; --n) value += alphabet[character(random)];
            text += "," + csvCell(value);
            cells << QString::fromStdString(value);
        }
        const Contents contents = contentsOf(text + "\n");
        QCOMPARE(contents.problems, QStringList());
        QCOMPARE(contents.records, Records{cells});
    }
}

void TestCsv::skippedRecordsAreThoseThatAreRead() {
    constexpr std::string_view pieces[] = {"a",    "1.5", ",",    ",",        "\n",
                                           "\r\n", "\r",  "\"",   "\"\"",     "\"b,c\"",
                                           "#",    " ",   "\n\n", "\"d\ne\"", "\xEF\xBB\xBF"};
    std::mt19937 random(55);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string text;
        for (std::size_t n = random() % 20; n > 0; --n) text += pieces[random() % std::size(pieces)];
        std::istringstream all(text), skipped(text);
        CsvReader reader(all), skipping(skipped);
        CsvRecord record, other;
        std::vector<CsvRecord> records;
        std::vector<int> lines;
        for (; reader.next(record); lines.push_back(reader.line())) records.push_back(record);
        const std::uint64_t some = records.empty() ? 0 : random() % records.size();
        QCOMPARE(skipping.skip(some), some);
        for (std::size_t i = some; i < records.size(); ++i) {
            QVERIFY2(skipping.next(other), text.c_str());
            QVERIFY2(other.cells == records[i].cells && skipping.line() == lines[i], text.c_str());
        }
        std::istringstream again(text);
        QCOMPARE(CsvReader(again).skip(UINT64_MAX), std::uint64_t{records.size()});
    }
}

QTEST_APPLESS_MAIN(TestCsv)
#include "tst_csv.moc"
