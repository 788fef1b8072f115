// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <sstream>

#include "core/signal/detected_table.h"
#include "core/signal/samples.h"
#include "core/signal/text_lines.h"

using namespace drillwave;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream in(text);
    return firstLines(in, 200);
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
    std::string text = mark ? (little ? "\xFF\xFE" : "\xFE\xFF") : "";
    for (const char c : ascii) text += little ? std::string{c, '\0'} : std::string{'\0', c};
    return text;
}

}  // namespace

class TestDetectedTable : public QObject {
    Q_OBJECT

  private slots:
    void separatorAndDecimalSignAreFound_data();
    void separatorAndDecimalSignAreFound();
    void theHeaderNamesColumnsAndUnits_data();
    void theHeaderNamesColumnsAndUnits();
    void linesBeforeTheSamplesArePassedOver();
    void samplesThatAreLeftOutDoNotHideTheHeader_data();
    void samplesThatAreLeftOutDoNotHideTheHeader();
    void aTableWithoutNumbersHasNoSamples();
    void aColumnThatGrowsIsNotCutAtItsDecimalComma();
    void columnsAreGuessedByUnitAndName();
    void onlyStatedUnitsAreTaken_data();
    void onlyStatedUnitsAreTaken();
    void aSingleColumnIsEvenlySpaced();
    void linesAreReadInAnyEncoding_data();
    void linesAreReadInAnyEncoding();
    void aLineTooLongIsRefused();
    void binaryJunkIsRefused();
};

void TestDetectedTable::separatorAndDecimalSignAreFound_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<char>("separator");
    QTest::addColumn<bool>("comma");
    QTest::addColumn<int>("columns");
    QTest::addRow("comma") << QByteArray("time,force\n0,1\n0.5,2\n1,1.5\n") << ',' << false << 2;
    QTest::addRow("tab") << QByteArray("t\tF\n0.0\t1.5\n0.1\t2.5\n") << '\t' << false << 2;
    QTest::addRow("semicolon, decimal comma") << QByteArray("t;F\n0,0;1,5\n0,1;2,5\n") << ';' << true << 2;
    QTest::addRow("semicolon, decimal point") << QByteArray("t;F\n0.0;1.5\n0.1;2.5\n") << ';' << false << 2;
    QTest::addRow("semicolon, whole numbers") << QByteArray("0;1\n1;2\n2;0\n") << ';' << false << 2;
    QTest::addRow("tab, decimal comma") << QByteArray("0,0\t1,5\n0,1\t2,5\n") << '\t' << true << 2;
    QTest::addRow("blanks") << QByteArray("  0.0   1.5\n  0.1   2.5\n") << ' ' << false << 2;
    QTest::addRow("blanks, decimal comma") << QByteArray("0,0 1,5\n0,1 2,5\n") << ' ' << true << 2;
    QTest::addRow("comma and blank") << QByteArray("0, 1.5\n0.1, 2.5\n") << ',' << false << 2;
    QTest::addRow("quoted decimal commas")
        << QByteArray("\"0,0\",\"1,5\"\n\"0,1\",\"2,5\"\n") << ',' << true << 2;
    QTest::addRow("quoted, semicolon")
        << QByteArray("\"0,0\";\"1,5\"\n\"0,1\";\"2,5\"\n") << ';' << true << 2;
    QTest::addRow("words in a column") << QByteArray("0;a;1,5\n1;b;2,5\n2;c;3,5\n") << ';' << true << 3;
    QTest::addRow("date and time of day")
        << QByteArray("Date,Time,F [kN]\n2021-03-04,12:00:00.1,-1.5\n2021-03-04,12:00:00.2,2.5\n") << ','
        << false << 3;
    QTest::addRow("NaN and empty cells")
        << QByteArray("0;1,5;\n1;NaN;\n2;2,5;\n3;3,5;\n") << ';' << true << 2;
    QTest::addRow("old Mac line ends") << QByteArray("t;F\r0,0;1,5\r0,1;2,5\r") << ';' << true << 2;
}

void TestDetectedTable::separatorAndDecimalSignAreFound() {
    QFETCH(QByteArray, text);
    QFETCH(char, separator);
    QFETCH(bool, comma);
    QFETCH(int, columns);
    const DetectedTable table = detectTable(linesOf(text.toStdString()));
    QVERIFY(table.hasSamples());
    QCOMPARE(table.format.separator, separator);
    QCOMPARE(table.format.decimal == DecimalSign::comma, comma);
    QCOMPARE(static_cast<int>(table.columns.size()), columns);
}

void TestDetectedTable::theHeaderNamesColumnsAndUnits_data() {
    QTest::addColumn<QByteArray>("header");
    QTest::addRow("brackets") << QByteArray("time [us],force [kN]\n");
    QTest::addRow("parentheses") << QByteArray("time (us),force (kN)\n");
    QTest::addRow("slash") << QByteArray("time / us,force / kN\n");
    QTest::addRow("slash without blanks") << QByteArray("time/us,force/kN\n");
    QTest::addRow("blank") << QByteArray("time us,force kN\n");
    QTest::addRow("underscore") << QByteArray("time_us,force_kN\n");
    QTest::addRow("two lines") << QByteArray("time,force\nus,kN\n");
    QTest::addRow("two lines with brackets") << QByteArray("time,force\n[us],[kN]\n");
    QTest::addRow("quoted") << QByteArray("\"time [us]\",\"force [kN]\"\n");
    QTest::addRow("after a title") << QByteArray("Run 5 on Monday,3\n\ntime [us],force [kN]\n");
    QTest::addRow("in a comment") << QByteArray("# time [us],force [kN]\n");
}

void TestDetectedTable::theHeaderNamesColumnsAndUnits() {
    QFETCH(QByteArray, header);
    const DetectedTable table = detectTable(linesOf(header.toStdString() + "0,1.5\n10,2.5\n20,0.5\n"));
    QCOMPARE(table.columns.size(), std::size_t{2});
    QCOMPARE(table.columns[0], (TableColumn{"time", "us", true}));
    QCOMPARE(table.columns[1], (TableColumn{"force", "kN", true}));
    QCOMPARE(static_cast<int>(table.firstLine), static_cast<int>(header.count('\n')) + 1);
}

void TestDetectedTable::linesBeforeTheSamplesArePassedOver() {
    std::string text = "Recorder X 200\nDate;12.03.2024\nChannels;2\n\nt;a;b\ns;microstrain;microstrain\n";
    for (int i = 0; i < 20; ++i) text += std::to_string(i) + ",5;-1,25;3\n";
    const DetectedTable table = detectTable(linesOf(text));
    QCOMPARE(table.firstLine, std::size_t{7});
    QCOMPARE(table.columns[1], (TableColumn{"a", "microstrain", true}));
}

void TestDetectedTable::samplesThatAreLeftOutDoNotHideTheHeader_data() {
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<int>("headerLines");
    QTest::addRow("one line") << QByteArray("t [us];a [kN]\n") << 1;
    QTest::addRow("two lines") << QByteArray("t;a\nus;kN\n") << 2;
    QTest::addRow("a blank line and a comment below") << QByteArray("t [us];a [kN]\n\n# begins\n") << 3;
    QTest::addRow("in a comment") << QByteArray("Recorder;7\n# t [us];a [kN]\n") << 2;
}

void TestDetectedTable::samplesThatAreLeftOutDoNotHideTheHeader() {
    QFETCH(QByteArray, header);
    QFETCH(int, headerLines);
    const std::vector<std::string> lines =
        linesOf(header.toStdString() + "0;1.5\n10;NaN\n\n# pause\n20;2.5\n30;0.5\n");
    const RowFormat format{';', DecimalSign::point};
    for (const int leftOut : {0, 1, 4, 5}) {
        const DetectedTable table =
            tableFrom(lines, format, static_cast<std::size_t>(headerLines + leftOut + 1));
        QCOMPARE(table.columns, (std::vector<TableColumn>{{"t", "us", true}, {"a", "kN", true}}));
    }
    // Text between the samples is no header of those below it.
    const DetectedTable single = tableFrom(linesOf("F [kN]\n1\n# pause\n2\n3\n"), {',', {}}, 4);
    QCOMPARE(single.columns, (std::vector<TableColumn>{{"F", "kN", true}}));
}

void TestDetectedTable::aTableWithoutNumbersHasNoSamples() {
    QVERIFY(!detectTable(linesOf("not a number\nin sight\n")).hasSamples());
    QVERIFY(!detectTable(linesOf("")).hasSamples());
}

void TestDetectedTable::aColumnThatGrowsIsNotCutAtItsDecimalComma() {
    const DetectedTable named = detectTable(linesOf("force\n0,5\n0,7\n0,9\n"));
    QCOMPARE(named.columns.size(), std::size_t{1});
    const DetectedTable nameless = detectTable(linesOf("0,5\n0,7\n0,9\n"));
    QCOMPARE(nameless.columns.size(), std::size_t{1});
    QCOMPARE(nameless.format.decimal, DecimalSign::comma);
    // And a table of two columns stays one, even where its times are wrong.
    QCOMPARE(detectTable(linesOf("t,F\n0,5\n1,7\n0.5,9\n")).columns.size(), std::size_t{2});
    QCOMPARE(detectTable(linesOf("0,5\n1,7\n2,9\n")).columns.size(), std::size_t{2});
}

void TestDetectedTable::columnsAreGuessedByUnitAndName() {
    const DetectedTable table =
        detectTable(linesOf("n;t [ms];temperature [K];gauge 1 [µm/m]\n1;0,1;300;-5\n2;0,2;301;-6\n"));
    const SampleGuess guess = guessedSource(table);
    QCOMPARE(guess.source.timeColumn, std::optional<std::size_t>(1));
    QCOMPARE(guess.source.timeUnit, 1e-3);
    QCOMPARE(guess.source.valueColumn, std::size_t{3});
    QVERIFY(guess.unit && guess.unit->kind == SignalKind::strain);
    QCOMPARE(guess.unit->unit.factor, 1e-6);
}

void TestDetectedTable::onlyStatedUnitsAreTaken_data() {
    QTest::addColumn<std::string>("time");
    QTest::addColumn<double>("timeUnit");  // 0: not known
    QTest::addColumn<std::string>("force");
    QTest::addColumn<double>("forceUnit");
    QTest::addRow("none") << std::string("Time") << 0.0 << std::string("Load") << 0.0;
    QTest::addRow("known") << std::string("Time [msec]") << 1e-3 << std::string("Load [daN]") << 10.0;
    QTest::addRow("micro") << std::string("Time [µsec]") << 1e-6 << std::string("F kN") << 1e3;
    QTest::addRow("not known") << std::string("Time [ticks]") << 0.0 << std::string("Load [counts]") << 0.0;
    QTest::addRow("a name of words") << std::string("Time") << 0.0 << std::string("Load min") << 0.0;
    QTest::addRow("slash") << std::string("t/ms") << 1e-3 << std::string("gauge 1/µm/m") << 1e-6;
    QTest::addRow("underscores") << std::string("t_us") << 1e-6 << std::string("gauge_1_kN") << 1e3;
    QTest::addRow("rates") << std::string("feed/ms") << 0.0 << std::string("v_s") << 0.0;
    QTest::addRow("no header") << std::string("0") << 0.0 << std::string("0") << 0.0;
    QTest::addRow("strain by name") << std::string("t us") << 1e-6 << std::string("axial strain") << 0.0;
    QTest::addRow("words") << std::string("t in Mikrosekunden") << 1e-6 << std::string("F/Kilonewton") << 1e3;
    QTest::addRow("inside") << std::string("Time [ms] rel.") << 1e-3 << std::string("F [kN] (filtered)")
                            << 1e3;
    QTest::addRow("volts") << std::string("Time/s") << 1.0 << std::string("CH1/voltage") << 1.0;
    QTest::addRow("tonnes") << std::string("Tid, ms") << 1e-3 << std::string("Kraft [tf]") << 9806.65;
}

void TestDetectedTable::onlyStatedUnitsAreTaken() {
    QFETCH(std::string, time);
    QFETCH(double, timeUnit);
    QFETCH(std::string, force);
    QFETCH(double, forceUnit);
    const DetectedTable table = detectTable(linesOf(time + ";" + force + "\n0;1.5\n2;2.5\n4;0.5\n"));
    QCOMPARE(guessedSource(table).source.timeColumn, std::optional<std::size_t>(0));
    QCOMPARE(statedTimeUnit(table.columns[0]).value_or(0), timeUnit);
    const std::optional<NamedSignalUnit> unit = statedUnit(table.columns[1]);
    QCOMPARE(unit ? unit->unit.factor : 0, forceUnit);
    QCOMPARE(guessedSource(table).unit, unit);
}

void TestDetectedTable::aSingleColumnIsEvenlySpaced() {
    const SampleGuess guess = guessedSource(detectTable(linesOf("F [kN]\n1.5\n2.5\n0.5\n")));
    QVERIFY(!guess.source.timeColumn);
    QCOMPARE(guess.source.valueColumn, std::size_t{0});
    QVERIFY(guess.unit.has_value());
    QCOMPARE(guess.unit->unit.factor, 1e3);
}

void TestDetectedTable::linesAreReadInAnyEncoding_data() {
    QTest::addColumn<std::string>("bytes");
    const std::string text = "a;b\r\n1;2\r\n3;4";
    QTest::addRow("UTF-8") << text;
    QTest::addRow("UTF-8 with mark") << "\xEF\xBB\xBF" + text;
    QTest::addRow("UTF-16 little endian") << utf16(text, true, true);
    QTest::addRow("UTF-16 big endian") << utf16(text, false, true);
    QTest::addRow("UTF-16 little endian without mark") << utf16(text, true, false);
    QTest::addRow("UTF-16 big endian without mark") << utf16(text, false, false);
}

void TestDetectedTable::linesAreReadInAnyEncoding() {
    QFETCH(std::string, bytes);
    QCOMPARE(linesOf(bytes), (std::vector<std::string>{"a;b", "1;2", "3;4"}));
}

void TestDetectedTable::aLineTooLongIsRefused() {
    std::istringstream in("1;2\n" + std::string(20'000'000, '1') + "\n");
    TextLines text(in);
    std::string_view line;
    QVERIFY(text.next(line));
    QVERIFY(!text.next(line));
    QCOMPARE(text.number(), std::size_t{2});
    QVERIFY(!text.problem().empty());
}

void TestDetectedTable::binaryJunkIsRefused() {
    std::istringstream in(std::string("ab\0\0\1\2\n", 7));
    TextLines text(in);
    std::string_view line;
    QVERIFY(!text.next(line));
    QVERIFY(text.problem().find("NUL") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestDetectedTable)
#include "tst_detected_table.moc"
