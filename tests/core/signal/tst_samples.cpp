// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/signal/samples.h"
#include "tests/support/tries.h"

using namespace drillwave;

namespace {

Samples readText(const std::string& text, const SampleSource& source) {
    std::istringstream in(text);
    return readSamples(in, source);
}

SampleSource timesAndValues(char separator = ',') {
    SampleSource source;
    source.format.separator = separator;
    source.timeColumn = 0;
    source.valueColumn = 1;
    return source;
}

/// Rows "i,sin" made as they are read: a file of any length without one.
class RowStream : public std::streambuf {
  public:
    explicit RowStream(long rows) : m_rows(rows) {}
    long rowsMade() const { return m_row; }

  protected:
    int_type underflow() override {
        if (m_row == m_rows) return traits_type::eof();
        m_text.clear();
        for (int i = 0; i < 1000 && m_row < m_rows; ++i, ++m_row)
            m_text += std::to_string(m_row) + ";0," + std::to_string(m_row % 10) + "\n";
        setg(m_text.data(), m_text.data(), m_text.data() + m_text.size());
        return traits_type::to_int_type(m_text.front());
    }

  private:
    long m_rows;
    long m_row = 0;
    std::string m_text;
};

}  // namespace

class TestSamples : public QObject {
    Q_OBJECT

  private slots:
    void timesAndValuesAreReadInTheirUnits();
    void samplesWithoutTimesAreEvenlySpaced();
    void twoGaugesGiveTheirMean();
    void whatCannotBeReadIsRefusedWithItsLine_data();
    void whatCannotBeReadIsRefusedWithItsLine();
    void timesAreToldAsTheyArePrinted();
    void twoValuesAtOneTimeAreAJump();
    void rowsWithoutANumberAreSkippedAndCounted();
    void skippedRowsKeepTheirPlaceInTime();
    void commentsAndBlankLinesAreNoRows();
    void tenMillionSamplesAreReadOnceAndMoreAreRefused();
    void readingEndsSoonWhenItIsStopped();
    void nulBytesAtTheEndEndTheTable();
    void overloadsAreNoValues();
    void rateFollowsFromCoarseTimes();
    void stampsAreSecondsSinceTheFirst();
};

void TestSamples::timesAndValuesAreReadInTheirUnits() {
    SampleSource source = timesAndValues(';');
    source.format.decimal = DecimalSign::comma;
    source.firstLine = 3;
    source.timeUnit = 1e-3;
    source.valueColumn = 2;
    const Samples samples = readText("t;x;F\nms;;kN\n-0,5;9;1,25\n0,5;\"9\";\"-2,5\"\n", source);
    QCOMPARE(samples.problem, std::string());
    QCOMPARE(samples.time, (std::vector<double>{-0.5e-3, 0.5e-3}));
    QCOMPARE(samples.value, (std::vector<double>{1.25, -2.5}));
}

void TestSamples::samplesWithoutTimesAreEvenlySpaced() {
    SampleSource source;
    source.interval = 0.25;
    const Samples samples = readText("1\n2\n4\n", source);
    QCOMPARE(samples.time, (std::vector<double>{0, 0.25, 0.5}));
    QCOMPARE(samples.value, (std::vector<double>{1, 2, 4}));
}

void TestSamples::twoGaugesGiveTheirMean() {
    SampleSource source = timesAndValues();
    source.secondGauge = 2;
    QCOMPARE(readText("0,1,3\n1,-2,6\n", source).value, (std::vector<double>{2, 2}));
}

void TestSamples::whatCannotBeReadIsRefusedWithItsLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QByteArray>("words");
    QTest::addRow("word") << QByteArray("0,1\n1,2\n2,x\n") << 3 << QByteArray("`x` is not a number");
    QTest::addRow("NaN") << QByteArray("0,1\n1,NaN\n2,3\n") << 2 << QByteArray("holds no value");
    QTest::addRow("empty cell") << QByteArray("0,1\n,2\n") << 2 << QByteArray("column 1 holds no value");
    QTest::addRow("missing cell") << QByteArray("0,1\n1\n") << 2 << QByteArray("column 2 is missing");
    QTest::addRow("time goes back") << QByteArray("0,1\n2,2\n\n1,3\n") << 4 << QByteArray("not later");
    QTest::addRow("time stands still") << QByteArray("0,1\n0,2\n0,3\n") << 1 << QByteArray("too coarse");
    QByteArray coarse;
    for (int i = 0; i < 50; ++i) coarse += QByteArray::number(i / 2) + ",1\n";
    QTest::addRow("coarse times") << coarse << 1 << QByteArray("too coarse");
    QTest::addRow("overflow") << QByteArray("0,1\n1,1e999\n") << 2 << QByteArray("not a number");
    QTest::addRow("one sample") << QByteArray("0,1\n") << 0 << QByteArray("fewer than two samples");
    QTest::addRow("none") << QByteArray("") << 0 << QByteArray("fewer than two samples");
    QTest::addRow("NUL") << QByteArray("0,1\n1,2\n\0\0\n3,4\n", 15) << 3 << QByteArray("NUL");
}

void TestSamples::whatCannotBeReadIsRefusedWithItsLine() {
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QByteArray, words);
    const Samples samples = readText(text.toStdString(), timesAndValues());
    QVERIFY2(samples.problem.find(words.toStdString()) != std::string::npos, samples.problem.c_str());
    QCOMPARE(static_cast<int>(samples.problemLine), line);
    QVERIFY(samples.time.empty() && samples.value.empty());
}

// 400 us are 0.00039999999999999996 s.
void TestSamples::timesAreToldAsTheyArePrinted() {
    SampleSource source = timesAndValues();
    source.timeUnit = 1e-6;
    const Samples samples = readText("0,1\n499.5,2\n400,3\n", source);
    QCOMPARE(QString::fromStdString(samples.problem).section(QStringLiteral(": take"), 0, 0),
             QStringLiteral("the time 400 us is not later than the one before it, 499.5 us"));
}

void TestSamples::twoValuesAtOneTimeAreAJump() {
    const Samples samples = readText("0,0\n1,0\n1,5\n2,5\n3,5\n4,5\n5,5\n6,5\n7,5\n8,5\n", timesAndValues());
    QCOMPARE(samples.problem, std::string());
    QCOMPARE(samples.jumps, std::size_t{1});
    QCOMPARE(samples.time[2], std::nextafter(1.0, 2.0));
    QCOMPARE(samples.value[2], 5.0);
}

void TestSamples::rowsWithoutANumberAreSkippedAndCounted() {
    SampleSource source = timesAndValues();
    source.wrongRows = WrongRows::skipped;
    const Samples samples = readText("0,1\n1,NaN\n2,\n3\n4,5\nend of record\n", source);
    QCOMPARE(samples.problem, std::string());
    QCOMPARE(samples.time, (std::vector<double>{0, 4}));
    QCOMPARE(samples.skipped, std::size_t{4});
    QCOMPARE(samples.firstSkipped, std::size_t{2});
    // Times in the wrong order are no gaps.
    QVERIFY(!readText("0,1\n5,1\n4,1\n", source).problem.empty());
}

void TestSamples::skippedRowsKeepTheirPlaceInTime() {
    SampleSource source;
    source.interval = 1;
    source.wrongRows = WrongRows::skipped;
    QCOMPARE(readText("1\nNaN\n3\n", source).time, (std::vector<double>{0, 2}));
}

void TestSamples::commentsAndBlankLinesAreNoRows() {
    SampleSource source;
    source.interval = 1;
    QCOMPARE(readText("1\n\n# pause\n2\n", source).time, (std::vector<double>{0, 1}));
}

void TestSamples::tenMillionSamplesAreReadOnceAndMoreAreRefused() {
    if (!test::isNightly()) QSKIP("reads twenty million samples; runs at night");
    SampleSource source = timesAndValues(';');
    source.format.decimal = DecimalSign::comma;
    std::uint64_t told = 0;
    RowStream rows(static_cast<long>(mostSamples) + 1);
    std::istream in(&rows);
    const Samples tooMany = readSamples(in, source, {}, [&](std::uint64_t bytes) { told = bytes; });
    QCOMPARE(tooMany.problemLine, mostSamples + 1);
    QVERIFY(tooMany.problem.find("more than 10000000 samples") != std::string::npos);
    QVERIFY(told > 10 * mostSamples);
    RowStream asMany(static_cast<long>(mostSamples));
    std::istream again(&asMany);
    const Samples samples = readSamples(again, source);
    QCOMPARE(samples.problem, std::string());
    QCOMPARE(samples.time.size(), mostSamples);
    QCOMPARE(samples.time.back(), static_cast<double>(mostSamples - 1));
    QCOMPARE(samples.value.back(), 0.9);
}

void TestSamples::readingEndsSoonWhenItIsStopped() {
    std::stop_source stop;
    RowStream rows(static_cast<long>(mostSamples));
    std::istream in(&rows);
    SampleSource source = timesAndValues(';');
    source.format.decimal = DecimalSign::comma;
    const Samples samples =
        readSamples(in, source, stop.get_token(), [&stop](std::uint64_t) { stop.request_stop(); });
    QCOMPARE(samples.problem, std::string("stopped"));
    QVERIFY(rows.rowsMade() < 100'000);
}

void TestSamples::nulBytesAtTheEndEndTheTable() {
    const Samples samples = readText(std::string("0,1\n1,2\n2,3\0\0\n\0\r\n\0", 18), timesAndValues());
    QCOMPARE(samples.problem, std::string());
    QCOMPARE(samples.value, (std::vector<double>{1, 2, 3}));
    QVERIFY(samples.hasNulTail);
}

void TestSamples::overloadsAreNoValues() {
    for (const char* word : {"9.9E37", "-9.91e+37", "OVL", "Inf", "1e38"}) {
        SampleSource source = timesAndValues();
        const std::string text = "0,1\n1," + std::string(word) + "\n2,3\n";
        const Samples refused = readText(text, source);
        QCOMPARE(refused.problemLine, std::size_t{2});
        QVERIFY2(refused.problem.find("overload") != std::string::npos, refused.problem.c_str());
        source.wrongRows = WrongRows::skipped;
        const Samples skipped = readText(text, source);
        QCOMPARE(skipped.overloads, std::size_t{1});
        QCOMPARE(skipped.skippedTime, 2.0);
    }
}

// 5 MHz with times of three digits: each occurs five or more times from 100 us on.
void TestSamples::rateFollowsFromCoarseTimes() {
    std::string text;
    for (int i = 0; i < 5000; ++i) {
        std::array<char, 32> time{};
        std::snprintf(time.data(), time.size(), "%.2E,1\n", -50e-6 + i * 0.2e-6);
        text += time.data();
    }
    const Samples samples = readText(text, timesAndValues());
    QVERIFY(samples.estimatedRate.has_value());
    QCOMPARE(*samples.estimatedRate, 5e6);
    QCOMPARE(samples.firstTime, -50e-6);
    QVERIFY(samples.problem.find("5 MHz (an estimate)") != std::string::npos);
}

void TestSamples::stampsAreSecondsSinceTheFirst() {
    const char* const texts[] = {"23:59:59.999999,1\n00:00:00.000001,2\n00:00:00.000003,3\n",
                                 "2024-02-28T23:59:59.999999Z,1\n2024-02-29T00:00:00.000001Z,2\n"
                                 "2024-02-29T00:00:00.000003Z,3\n",
                                 "31.12.2023 23:59:59.999999,1\n01.01.2024 00:00:00.000001,2\n"
                                 "01.01.2024 00:00:00.000003,3\n",
                                 "12/31/2023 11:59:59.999999 PM,1\n1/1/2024 12:00:00.000001 AM,2\n"
                                 "1/1/2024 12:00:00.000003 AM,3\n"};
    for (const char* text : texts) {
        const Samples samples = readText(text, timesAndValues());
        QCOMPARE(samples.problem, std::string());
        // Fractions of a second are kept to 1e-16.
        QVERIFY(std::abs(samples.time[1] - 2e-6) < 1e-15 && std::abs(samples.time[2] - 4e-6) < 1e-15);
    }
}

QTEST_APPLESS_MAIN(TestSamples)
#include "tst_samples.moc"
