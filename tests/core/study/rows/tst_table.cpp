// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of cases: cells set parameters, everything is checked before anything is solved.
#include <QTest>

#include <algorithm>
#include <sstream>

#include "core/report/row_csv.h"
#include "core/study/rows/table.h"
#include "core/study/rows/table_header.h"
#include "core/text/csv.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/scenario.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

Table tableOf(const Scenario& base, const char* outputs = "cor") {
    return {.base = base,
            .source = "cases.csv",
            .columns = chooseOutputs(outputs, OutputUnits::dimensionless).columns,
            .shard = {}};
}

TableCheck checkOf(const Table& table, const std::string& cases, int jobs = 2) {
    std::istringstream in(cases);
    return checkTable(table, in, jobs, {});
}

std::string csvOf(const Table& table, const std::string& cases, int jobs = 2, RowCounts* counts = nullptr) {
    std::istringstream in(cases);
    const std::uint64_t rows = checkTable(table, in, jobs, {}).rows;
    in.clear();
    in.seekg(0);
    std::string csv;
    RowCsv sink([&](std::string_view text) {
        csv += text;
        return true;
    });
    const RowCounts found = runTable(table, in, rows, jobs, {}, sink, [](const RowCounts&) {});
    if (counts) *counts = found;
    return csv;
}

double corOf(const Scenario& scenario) {
    return ExactSolver().solve(problemOf(scenario)).cor;
}

std::vector<double> lastColumn(const std::string& csv) {
    std::istringstream in(csv);
    CsvReader reader(in);
    CsvRecord record;
    reader.next(record);
    std::vector<double> values;
    while (reader.next(record)) values.push_back(*parseNumber(record.cells.back()));
    return values;
}

/// 3000 rows of all kinds, more than a chunk.
std::string manyCases() {
    std::string cases = "name,pulse.shape,beta,delta\n";
    const char* shapes[] = {"rectangular", "half_sine", "rigid_body"};
    for (int i = 0; i < 3000; ++i)
        cases += "\"case, " + std::to_string(i) + "\"," + shapes[i % 3] + ",0." + std::to_string(1 + i % 9) +
                 "," + std::to_string(i % 4) + "\n";
    return cases;
}

}  // namespace

class TestTable : public QObject {
    Q_OBJECT

  private slots:
    void cellsSetTheParametersOfTheirColumn();
    void groupsAreSetAfterWhatTheyDependOn();
    void anEmptyCellLeavesTheValueOfTheBase();
    void otherColumnsArePassedThroughUntouched();
    void theBytesDoNotDependOnTheNumberOfThreads();
    void shardsPutTogetherAreTheWhole();
    void unknownColumnsAreWarnedOfAndOutputsAreNot();
    void badTablesAreRefusedWithTheirPlace_data();
    void badTablesAreRefusedWithTheirPlace();
    void twoCellsOfOneSectionAreRefused();
    void onlyTheFirstTwentyProblemsAreListed();
    void aRowThatBecameInvalidIsEmptyAndCounted();
};

void TestTable::cellsSetTheParametersOfTheirColumn() {
    const Scenario base;
    Scenario first = base;
    first.rod.length = 4.27;
    first.rod.diameter = 0.045;
    first.pulse.shape = PulseShape::halfSine;
    Scenario second = base;
    second.rod.length = 3.05;
    second.rod.diameter = 0.032;
    second.pulse.shape = PulseShape::triangular;
    const std::string csv = csvOf(tableOf(base),
                                  "rod.diameter [mm],rod.length,pulse.shape\n"
                                  "45,4.27 m,half_sine\n"
                                  "32 mm,3050 mm,triangular\n");
    QCOMPARE(lastColumn(csv), (std::vector<double>{corOf(first), corOf(second)}));
}

void TestTable::groupsAreSetAfterWhatTheyDependOn() {
    // β moves the stiffness for the impedance of the rod in the same row, wherever its column is.
    const std::string csv = csvOf(tableOf(Scenario()), "beta,rod.diameter [mm]\n0.7,32\n0.7,45\n");
    const std::vector<double> cor = lastColumn(csv);
    // The groups are the same to rounding, so e is the same to the accuracy of the solver.
    QVERIFY(std::abs(cor[0] - cor[1]) < 1e-12);
}

void TestTable::anEmptyCellLeavesTheValueOfTheBase() {
    const Scenario base = dimensionless();
    Scenario other = base;
    other.groups.gamma = 0.1;
    QCOMPARE(lastColumn(csvOf(tableOf(base), "gamma,n\n,1\n0.1,2\n")),
             (std::vector<double>{corOf(base), corOf(other)}));
}

void TestTable::otherColumnsArePassedThroughUntouched() {
    const std::string csv =
        csvOf(tableOf(dimensionless()),
              "\xEF\xBB\xBF# a comment\r\nnote,beta,cor\r\n\"say \"\"hi\"\", twice\",0.50,printed\r\n");
    const std::string expected = "note,beta,cor,cor\n\"say \"\"hi\"\", twice\",0.50,printed,";
    QCOMPARE(QString::fromStdString(csv.substr(0, expected.size())), QString::fromStdString(expected));
}

void TestTable::theBytesDoNotDependOnTheNumberOfThreads() {
    const Table table = tableOf(dimensionless(), "cor,peak_force");
    const std::string alone = csvOf(table, manyCases(), 1);
    QCOMPARE(std::ranges::count(alone, '\n'), 3001);
    for (const int jobs : {2, 5}) QVERIFY(csvOf(table, manyCases(), jobs) == alone);
}

void TestTable::shardsPutTogetherAreTheWhole() {
    Table table = tableOf(dimensionless());
    const std::string whole = csvOf(table, manyCases());
    std::string parts;
    for (std::uint64_t index = 1; index <= 7; ++index) {
        table.shard = {index, 7};
        parts += csvOf(table, manyCases());
    }
    QVERIFY(parts == whole);
}

void TestTable::unknownColumnsAreWarnedOfAndOutputsAreNot() {
    const TableCheck check =
        checkOf(tableOf(dimensionless()), "beta,impulse,peak_force [N],gama,site,cor\n1,,,0.5,A,\n");
    QVERIFY(check.problems.empty());
    QCOMPARE(check.warnings.size(), std::size_t{3});
    QCOMPARE(QString::fromStdString(check.warnings[0].text()),
             QString("cases.csv:1:4: `gama` is not a parameter and only passed through; did you mean "
                     "`gamma`?"));
    QVERIFY(QString::fromStdString(check.warnings[1].text()).contains("`site`"));
    // The output of that name is appended: there will be two.
    QVERIFY(QString::fromStdString(check.warnings[2].text())
                .startsWith("cases.csv:1:6: `cor` is passed through"));
}

void TestTable::badTablesAreRefusedWithTheirPlace_data() {
    QTest::addColumn<QByteArray>("cases");
    QTest::addColumn<QString>("problem");
    QTest::newRow("empty file") << QByteArray("") << "cases.csv: is empty";
    QTest::newRow("out of range") << QByteArray("n,gamma\n1,0.5\n2,1.3\n")
                                  << "cases.csv:3:2: gamma = 1.3 (must be in (0, 1])";
    QTest::newRow("no number") << QByteArray("beta\nabc\n") << "cases.csv:2:1: beta = abc (is not a number";
    QTest::newRow("no unit") << QByteArray("rod.length\n3\n") << "cases.csv:2:1: rod.length = 3 (has no unit";
    QTest::newRow("unit of another quantity")
        << QByteArray("rod.length\n3 kg\n") << "cases.csv:2:1: rod.length = 3 kg (unit";
    QTest::newRow("unknown unit of a column")
        << QByteArray("rod.length [kg]\n3\n") << "cases.csv:1:1: rod.length: unit `kg`";
    QTest::newRow("unit of a group") << QByteArray("beta [m]\n3\n") << "cases.csv:1:1: beta has no unit";
    QTest::newRow("a parameter twice")
        << QByteArray("beta,tau,beta\n1,2,3\n") << "cases.csv:1:3: sets beta, which column 1 also sets";
    QTest::newRow("too few cells") << QByteArray("beta,tau\n1,2\n1\n")
                                   << "cases.csv:3: has 1 cells, the header has 2";
    QTest::newRow("too many cells") << QByteArray("beta,tau\n1,2,3\n")
                                    << "cases.csv:2: has 3 cells, the header has 2";
    QTest::newRow("open quote") << QByteArray("beta,tau\n1,\"2\n") << "cases.csv:2: a quote is not closed";
    QTest::newRow("a row as a whole")
        << QByteArray("rod.bore [mm],rod.diameter [mm]\n10,30\n40,30\n")
        << "cases.csv:3: rod.bore = 40 mm (must be less than the diameter of 30 mm)";
    // Every row would be the base beside the numbers of the user.
    QTest::newRow("no parameter") << QByteArray("site,depth\nA,3\n")
                                  << "cases.csv:1: no column is a parameter";
    QTest::newRow("upper case") << QByteArray("n,Beta\n1,2\n")
                                << "cases.csv:1:2: `Beta` is not a parameter; write `beta`,";
    QTest::newRow("an underscore for the dot, beside a parameter")
        << QByteArray("beta,rod_length [m]\n1,2\n")
        << "cases.csv:1:2: `rod_length` is not a parameter; write `rod.length`,";
    QTest::newRow("a dot for the underscore")
        << QByteArray("beta,drill.blow.frequency\n1,2\n") << "cases.csv:1:2: `drill.blow.frequency` is not";
    QTest::newRow("a shape") << QByteArray("Pulse Shape\nhalf_sine\n")
                             << "cases.csv:1:1: `Pulse Shape` is not a parameter; write `pulse.shape`,";
    QTest::newRow("a unit in parentheses")
        << QByteArray("rod.length (m)\n3\n")
        << "cases.csv:1:1: `rod.length (m)` is not a parameter; write `rod.length`, with its unit in square";
    QTest::newRow("NUL in a note") << QByteArray("beta,note\n1,a\0b\n", 16)
                                   << "cases.csv:2: holds a NUL byte";
    QTest::newRow("another unit than the header's")
        << QByteArray("rod.length [m]\n4 m\n3 ft\n")
        << "cases.csv:3:1: rod.length = 3 ft (is in ft, the column in m";
    QTest::newRow("one thing set twice") << QByteArray("rod.length [m],tau\n4,\n,5\n3,5\n")
                                         << "cases.csv:4:2: tau and rod.length set the same thing";
    QTest::newRow("a key misspelt beside a good one")
        << QByteArray("rod.lenght [m],beta\n1,2\n")
        << "cases.csv:1:1: `rod.lenght` is not a parameter; did you mean `rod.length`? A column";
    QTest::newRow("a key of a section misspelt") << QByteArray("beta,string.rod.lenght [mm]\n1,2\n")
                                                 << "cases.csv:1:2: `string.rod.lenght` is not a parameter; "
                                                    "did you mean `string.rod.length`? A column";
    QTest::newRow("a place with a nought") << QByteArray("beta,string.03.length [mm]\n1,2\n")
                                           << "cases.csv:1:2: `string.03.length` is not a parameter; write a "
                                              "known key, or another name than "
                                              "`string.…`";
    for (const char* name : {"pulse.x", "hammer.x", "bit_rock.x", "drill.x", "material.x", "rod."})
        QTest::newRow(name) << QByteArray("beta,") + name + "\n1,2\n"
                            << QString("cases.csv:1:2: `%1` is not a parameter; ").arg(name);
    QTest::newRow("without meaning") << QByteArray("pulse.rise\n0.2\n")
                                     << "cases.csv:2:1: pulse.rise = 0.2 (only for a trapezoid";
}

void TestTable::badTablesAreRefusedWithTheirPlace() {
    QFETCH(QByteArray, cases);
    QFETCH(QString, problem);
    const TableCheck check = checkOf(tableOf(Scenario()), cases.toStdString());
    QCOMPARE(check.problems.size(), std::size_t{1});
    QVERIFY2(QString::fromStdString(check.problems[0].text()).startsWith(problem),
             check.problems[0].text().c_str());
}

// Both rows would be solved with the value of the place, and show the other beside it.
void TestTable::twoCellsOfOneSectionAreRefused() {
    const Scenario base = parseScenario(findExample("t38_string")->text, "").scenario;
    const auto problemOf = [&](const std::string& cases) {
        const TableCheck check = checkOf(tableOf(base), cases);
        return check.problems.empty() ? QString() : QString::fromStdString(check.problems.front().text());
    };
    QVERIFY(problemOf("string.3.length [mm],string.5.length [mm]\n3000,2000\n")
                .startsWith(
                    "cases.csv:2:2: string.5.length and string.3.length are the same section of a repeat"));
    QVERIFY(
        problemOf("string.rod.length [mm],string.3.length [mm]\n3000,2000\n")
            .startsWith("cases.csv:2:2: string.3.length and string.rod.length set one section: section 3"));
    QCOMPARE(problemOf("string.3.length [mm],string.5.length [mm]\n3000,\n,2000\n"), QString());
    QCOMPARE(problemOf("string.3.length [mm],string.4.length [mm]\n3000,200\n"), QString());
}

void TestTable::onlyTheFirstTwentyProblemsAreListed() {
    std::string cases = "gamma\n";
    for (int i = 0; i < 2000; ++i) cases += i % 2 ? "7\n" : "0.5\n";
    const TableCheck check = checkOf(tableOf(dimensionless()), cases, 4);
    QCOMPARE(check.problems.size(), std::size_t{20});
    for (int i = 0; i < 20; ++i)
        QVERIFY(QString::fromStdString(check.problems[static_cast<std::size_t>(i)].text())
                    .startsWith(QString("cases.csv:%1:1:").arg(3 + 2 * i)));
}

void TestTable::aRowThatBecameInvalidIsEmptyAndCounted() {
    // The file changes between the check and the run.
    const Table table = tableOf(dimensionless(), "cor,impulse");
    std::istringstream in("gamma\n1\n7\n");
    std::string csv;
    RowCsv sink([&](std::string_view text) {
        csv += text;
        return true;
    });
    const RowCounts counts = runTable(table, in, 2, 2, {}, sink, [](const RowCounts&) {});
    QCOMPARE(counts.failed, std::uint64_t{1});
    QVERIFY(QString::fromStdString(csv).endsWith("\n7,,\n"));
}

QTEST_GUILESS_MAIN(TestTable)
#include "tst_table.moc"
