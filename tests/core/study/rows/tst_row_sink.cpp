// SPDX-License-Identifier: GPL-3.0-or-later
// Rows as numbers: every sink sees the same, in order, whatever the threads, and why a row has no outputs.
#include <QTest>

#include <bit>
#include <cmath>
#include <sstream>

#include "core/report/row_csv.h"
#include "core/study/rows/sweep_check.h"
#include "core/study/rows/table.h"
#include "core/text/csv.h"
#include "core/wave/exact/exact_solver.h"
#include "tests/support/scenario.h"
#include "tests/support/sweep.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

const Scenario blowInGroups = dimensionless(PulseShape::rectangular, {0.5, 0.1, 3, 0.2});

/// Keeps everything, as a page or a binding would.
struct ArraySink : RowSink {
    RowHeader header;
    std::vector<std::vector<double>> rows;
    std::vector<std::vector<std::string>> copied;
    std::vector<std::string> reasons;
    std::size_t largestBlock = 0;
    bool inOrder = true;
    std::uint64_t first = 0;

    bool begin(const RowHeader& all) override {
        header = all;
        return true;
    }
    bool take(const RowBlock& block, std::string_view prepared) override {
        inOrder = inOrder && block.first() == first + rows.size() && prepared.empty();
        largestBlock = std::max(largestBlock, block.size());
        for (std::size_t i = 0; i < block.size(); ++i) {
            rows.emplace_back(block[i].begin(), block[i].end());
            copied.emplace_back(block.copied(i).begin(), block.copied(i).end());
            reasons.push_back(block.reason(i).text());
        }
        return true;
    }
};

ArraySink arrayOf(const Sweep& sweep, int jobs, std::uint64_t first = 0) {
    ArraySink sink;
    sink.first = first;
    runSweep(sweep, jobs, {}, sink, [](const RowCounts&) {});
    return sink;
}

}  // namespace

class TestRowSink : public QObject {
    Q_OBJECT

  private slots:
    void theNumbersOfASweepAreThoseOfItsCases();
    void theRowsDoNotDependOnTheNumberOfThreads();
    void theCsvReadsBackAsTheNumbers();
    void aPartBeginsWithItsFirstRow();
    void aRowThatWasNotSolvedSaysWhy();
    void theCellsOfATableStandBesideTheNumbers();
    void whatIsPreparedComesBackWithItsRows();
    void aSinkThatRefusesTheHeaderGetsNoRows();
    void blocksStaySmallHoweverManyRowsThereAre();
};

void TestRowSink::theNumbersOfASweepAreThoseOfItsCases() {
    Scenario base;
    const ArraySink sink = arrayOf(
        sweepOf(base, {"pulse.shape=half_sine,rectangular", "rod.length=3m:6m:3"}, "cor,contact_duration"),
        2);
    QCOMPARE(sink.header.columns.size(), std::size_t{4});
    QCOMPARE(sink.header.columns[1].header, std::string("rod.length [m]"));
    QCOMPARE(sink.rows.size(), std::size_t{6});
    for (std::size_t i = 0; i < 6; ++i) {
        Scenario scenario = base;
        scenario.pulse.shape = i < 3 ? PulseShape::halfSine : PulseShape::rectangular;
        scenario.rod.length = 3 + 1.5 * static_cast<double>(i % 3);
        const std::vector<double>& row = sink.rows[i];
        QCOMPARE(row[0], static_cast<double>(scenario.pulse.shape));
        QCOMPARE(row[1], scenario.rod.length);
        QCOMPARE(row[2], ExactSolver().solve(problemOf(scenario)).cor);
        QVERIFY(row[3] > 0);
    }
}

void TestRowSink::theRowsDoNotDependOnTheNumberOfThreads() {
    const Sweep sweep = sweepOf(blowInGroups, {"beta=0.1:5:40:log", "delta=0:2:60"}, "cor,peak_force");
    const ArraySink one = arrayOf(sweep, 1);
    QCOMPARE(one.rows.size(), std::size_t{2400});
    for (const int jobs : {2, 7}) {
        const ArraySink many = arrayOf(sweep, jobs);
        QVERIFY(many.inOrder);
        QVERIFY(many.rows == one.rows);
    }
}

void TestRowSink::theCsvReadsBackAsTheNumbers() {
    // An axis in a unit that is no power of ten, one from 0 on with both signs of zero behind it, and a
    // shape.
    Scenario base;
    base.drill.blowFrequency = 60;
    base.drill.thrust = 8000;
    Sweep sweep = sweepOf(
        base, {"pulse.shape=half_sine,triangular", "rod.length=10ft:20ft:7", "bit_rock.gap=0mm,1.3mm"}, "cor",
        OutputUnits::si);
    sweep.columns = allOutputsOf(base, OutputUnits::si);
    QVERIFY(problemsOf(sweep).empty());
    std::string csv;
    RowCsv sink([&](std::string_view text) {
        csv += text;
        return true;
    });
    runSweep(sweep, 2, {}, sink, [](const RowCounts&) {});
    const ArraySink numbers = arrayOf(sweep, 1);
    std::istringstream in(csv);
    CsvReader reader(in);
    CsvRecord record;
    QVERIFY(reader.next(record));
    QCOMPARE(record.cells.size(), numbers.header.columns.size());
    std::size_t compared = 0;
    for (const std::vector<double>& row : numbers.rows) {
        QVERIFY(reader.next(record));
        for (std::size_t c = 0; c < row.size(); ++c) {
            const RowColumn& column = numbers.header.columns[c];
            const std::string& cell = record.cells[c];
            if (column.kind == RowColumn::Kind::word) {
                QCOMPARE(std::string_view(cell), column.words[static_cast<std::size_t>(row[c])]);
            } else if (column.kind == RowColumn::Kind::quantity) {
                const auto typed =
                    parseQuantity(cell, column.quantity, BareNumber::inDefaultUnit, column.unit);
                QCOMPARE(std::bit_cast<quint64>(typed.si), std::bit_cast<quint64>(row[c]));
            } else if (std::isfinite(row[c])) {
                QCOMPARE(std::bit_cast<quint64>(*parseNumber(cell)), std::bit_cast<quint64>(row[c]));
            } else {
                QVERIFY(cell.empty());
            }
            ++compared;
        }
    }
    QVERIFY(!reader.next(record));
    QCOMPARE(compared, 28 * numbers.header.columns.size());
}

void TestRowSink::aPartBeginsWithItsFirstRow() {
    Sweep sweep = sweepOf(blowInGroups, {"delta=0:1:1001"}, "cor");
    sweep.shard = {2, 3};
    const RowRange part = rowsOf(sweep.shard, 1001);
    const ArraySink sink = arrayOf(sweep, 2, part.begin);
    QVERIFY(sink.inOrder);
    QVERIFY(!sink.header.isFirstPart);
    QCOMPARE(sink.rows.size(), part.size());
    QCOMPARE(sink.rows.front()[0], static_cast<double>(part.begin) / 1000);
}

void TestRowSink::aRowThatWasNotSolvedSaysWhy() {
    // At β = 1e-300 the contact lasts for 1e150 round trips: beyond every limit of work.
    const ArraySink sink = arrayOf(sweepOf(blowInGroups, {"beta=1,1e-300,2"}, "cor,peak_force"), 1);
    QVERIFY(sink.reasons[0].empty() && sink.reasons[2].empty());
    QVERIFY2(sink.reasons[1].find("polynomial pieces") != std::string::npos, sink.reasons[1].c_str());
    QCOMPARE(sink.rows[1][0], 1e-300);
    QVERIFY(std::isnan(sink.rows[1][1]) && std::isnan(sink.rows[1][2]));
    QVERIFY(std::isfinite(sink.rows[2][2]));
}

void TestRowSink::theCellsOfATableStandBesideTheNumbers() {
    const Table table{.base = blowInGroups,
                      .source = "cases.csv",
                      .columns = chooseOutputs("cor", OutputUnits::dimensionless).columns,
                      .shard = {}};
    std::istringstream cases("name,beta\n\"a, b\",0.50\n,1e0\nc,\n");
    ArraySink sink;
    runTable(table, cases, 3, 2, {}, sink, [](const RowCounts&) {});
    QCOMPARE(sink.header.copied, (std::vector<std::string>{"name", "beta"}));
    QCOMPARE(sink.header.columns.size(), std::size_t{1});
    QCOMPARE(sink.copied[0], (std::vector<std::string>{"a, b", "0.50"}));
    QCOMPARE(sink.copied[1], (std::vector<std::string>{"", "1e0"}));
    QCOMPARE(sink.rows[0], sink.rows[2]);  // 0.50 is the value of the base
    QVERIFY(sink.rows[1] != sink.rows[0]);
    QVERIFY(sink.inOrder);
}

/// Says in advance which rows it was shown.
struct PreparingSink : RowSink {
    std::string text;
    bool begin(const RowHeader&) override { return true; }
    void prepare(const RowBlock& rows, std::string& prepared) const override {
        prepared += std::to_string(rows.first()) + "+" + std::to_string(rows.size()) + " ";
    }
    bool take(const RowBlock& rows, std::string_view prepared) override {
        text += std::to_string(rows.first()) + ":" + std::string(prepared);
        return true;
    }
};

void TestRowSink::whatIsPreparedComesBackWithItsRows() {
    PreparingSink sink;
    runSweep(sweepOf(blowInGroups, {"delta=0:1:1500"}, "cor"), 3, {}, sink, [](const RowCounts&) {});
    QCOMPARE(sink.text, std::string("0:0+512 512:512+512 1024:1024+476 "));
}

struct RefusingSink : RowSink {
    int rows = 0;
    bool begin(const RowHeader&) override { return false; }
    bool take(const RowBlock&, std::string_view) override { return ++rows > 0; }
};

void TestRowSink::aSinkThatRefusesTheHeaderGetsNoRows() {
    RefusingSink sink;
    const RowCounts counts =
        runSweep(sweepOf(blowInGroups, {"delta=0,1"}, "cor"), 2, {}, sink, [](const RowCounts&) {});
    QCOMPARE(counts.end, WorkEnd::stopped);
    QCOMPARE(counts.rows, std::uint64_t{0});
    QCOMPARE(sink.rows, 0);
}

void TestRowSink::blocksStaySmallHoweverManyRowsThereAre() {
    // Four blocks for each thread are all that exists at once.
    const ArraySink sink = arrayOf(sweepOf(blowInGroups, {"delta=0:1:20000"}, "cor"), 2);
    QCOMPARE(sink.rows.size(), std::size_t{20000});
    QVERIFY(sink.largestBlock <= 512);
}

QTEST_GUILESS_MAIN(TestRowSink)
#include "tst_row_sink.moc"
