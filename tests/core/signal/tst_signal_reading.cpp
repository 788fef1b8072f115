// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "core/signal/signal_option.h"
#include "core/signal/signal_reading.h"

using namespace drillwave;

namespace {

SignalReading readText(const std::string& text, const SignalOptions& options = {}) {
    std::istringstream in(text);
    return readSignal(in, options);
}

SignalReading readFieldFile(const QString& name, const SignalOptions& options = {}) {
    std::ifstream in((QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/field/") + name).toStdString(),
                     std::ios::binary);
    return readSignal(in, options);
}

/// Options as words: "--unit kN --rows skip" without the dashes.
SignalOptions optionsOf(const QString& words) {
    SignalOptions options;
    const QStringList list = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (qsizetype i = 0; i + 1 < list.size(); i += 2) {
        const SignalOption* option = findSignalOption(list[i].toStdString());
        if (!option || !option->set(options, list[i + 1].toStdString()).isEmpty()) qFatal("wrong option");
    }
    return options;
}

bool hasRemark(const SignalReading& reading, const std::string& code) {
    return std::ranges::find(reading.remarks, code, &SignalRemark::code) != reading.remarks.end();
}

QString questionsOf(const SignalReading& reading) {
    QStringList list;
    for (const std::string& question : reading.questions) list << QString::fromStdString(question);
    return list.join(QLatin1Char(' '));
}

/// A half sine of 250 kN and 200 us with white noise, at 1 MHz: "time [us],force [kN]".
struct Record {
    double offset = 0;    // [kN]
    double drift = 0;     // [kN/ms]
    double step = 0;      // [kN]
    double noise = 0.5;   // [kN]
    double jitter = 0;    // [us]
    double second = 0;    // [us] after the first blow
    double bending = -1;  // share, a second column
    int samples = 1000;
    int from = -200;  // [us]

    std::string text() const {
        std::string rows = bending >= 0 ? "time [us],A [kN],B [kN]\n" : "time [us],force [kN]\n";
        unsigned state = 1;
        const auto random = [&state] {
            state = state * 1664525u + 1013904223u;
            return state / 4294967296.0 - 0.5;
        };
        for (int i = 0; i < samples; ++i) {
            const double t = from + i;
            const auto blow = [&](double begin) {
                const double phase = (t - begin) / 200;
                return phase > 0 && phase < 1 ? 250 * std::sin(std::numbers::pi * phase) : 0.0;
            };
            double force = blow(100) + (second > 0 ? blow(100 + second) : 0.0);
            const double pure = force;
            force += offset + drift * i / 1000 + noise * 2 * random();
            if (step > 0) force = step * std::round(force / step);
            rows += std::to_string(t + jitter * 2 * random());
            if (bending >= 0)
                rows += "," + std::to_string(force + bending * pure) + "," +
                        std::to_string(force - bending * pure);
            else
                rows += "," + std::to_string(force);
            rows += "\n";
        }
        return rows;
    }
};

}  // namespace

class TestSignalReading : public QObject {
    Q_OBJECT

  private slots:
    void settingsOfARecorderSetTheSameOptions() {
        for (const char* words :
             {"separator tab decimal comma first-line 3 encoding latin-1 time t signal-column A+B time-unit "
              "us",
              "unit V scale 50kN/V rows skip", "unit mV gain 100 excitation 5V bridge 2.6 gauge-factor 2.1",
              "unit microstrain area 1134mm^2 modulus 206GPa rate 5MHz", "unit m/s scale 18000", ""}) {
            const SignalOptions options = optionsOf(words);
            SignalOptions again;
            for (const auto& [name, value] : recorderSettings(options))
                QVERIFY2(findSignalOption(name)->set(again, value).isEmpty(), name.c_str());
            QVERIFY2(again == options, words);
        }
        QVERIFY(recorderSettings(optionsOf("zero 1us:2us from 3us to 4us")).empty());  // of one record
    }
    void fieldFilesAreReadOrAskedAbout_data();
    void fieldFilesAreReadOrAskedAbout();
    void fieldFilesAreRefusedWithTheirLine_data();
    void fieldFilesAreRefusedWithTheirLine();
    void fortyChannelsHaveTheirNamesAndUnits();
    void nothingIsAssumedInSilence_data();
    void nothingIsAssumedInSilence();
    void ratesAreReadFromTheLinesAbove_data();
    void ratesAreReadFromTheLinesAbove();
    void voltsBecomeForces_data();
    void voltsBecomeForces();
    void groupsOfThousandsAreReadWhereTheDecimalSignIsKnown_data();
    void groupsOfThousandsAreReadWhereTheDecimalSignIsKnown();
    void qualityIsStated_data();
    void qualityIsStated();
    void filesThatAreNoTablesAreNamed_data();
    void filesThatAreNoTablesAreNamed();
    void optionsGoBeforeWhatTheTableSays();
};

void TestSignalReading::fieldFilesAreReadOrAskedAbout_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("questions");
    QTest::addColumn<double>("impulse");  // [N s]; NaN while a question is open
    QTest::addColumn<QString>("remark");
    const double open = std::nan("");
    const auto add = [](const char* file, const char* options, const char* questions, double impulse,
                        const char* remark = "") {
        QTest::addRow("%s %s", file, options)
            << QString(options) << QString(questions) << impulse << QString(remark);
    };
    add("01_slash_voltage.csv", "", "unit", open);
    add("01_slash_voltage.csv", "scale 100kN/V", "", 31.83);
    add("01_slash_voltage.csv", "unit kN scale 100", "", 31.83);
    add("01_unit_words.csv", "", "unit", open);
    add("02_times_three_digits.csv", "", "rate", open, "times_repeat");
    add("02_times_three_digits.csv", "rate 5MHz", "", 31.83);
    add("03_rate_in_header.csv", "", "", 31.83);
    add("04_time_of_day.csv", "", "", 63.66);
    add("05_na_first_column.csv", "rows skip", "rate", open, "skipped_rows");
    add("05_na_first_column.csv", "rows skip rate 1MHz", "", 33.01, "gap_at_peak");
    add("05_na_at_the_peak.csv", "rows skip", "", 23.51, "gap_at_peak");
    add("06_unit_inside.csv", "", "", 31.83);
    add("07_minus_2212.csv", "", "", 31.83);
    add("08_cr_cr_lf.csv", "", "", 31.83);
    add("09_thousands_quoted.csv", "", "", 31.83);
    add("10_overload_9e37.csv", "rows skip", "", 29.02, "overload");
    add("11_clipped.csv", "", "", 27.32, "clipped");
    add("12_metadata_beside.csv", "", "unit", open);
    add("12_metadata_beside.csv", "unit kN scale 100", "", 31.83);
    add("13_index_first.csv", "", "time_unit unit", open);
    add("13_index_first.csv", "time-unit s unit N", "", 31.83);
    add("14_nul_tail.csv", "", "", 31.83, "nul_tail");
    add("14_rows.csv", "", "", 31.83, "rows");
    add("23_blow_as_exported.csv", "", "", 30);
    add("24_blow.csv", "", "", 31.83);
    // Where rows of the blow are skipped the impulse is that of the straight lines across them.
}

void TestSignalReading::fieldFilesAreReadOrAskedAbout() {
    QFETCH(QString, options);
    QFETCH(QString, questions);
    QFETCH(double, impulse);
    QFETCH(QString, remark);
    const QString file = QString(QTest::currentDataTag()).section(QLatin1Char(' '), 0, 0);
    const SignalReading reading = readFieldFile(file, optionsOf(options));
    QCOMPARE(QString::fromStdString(reading.problem.text()), QString());
    QCOMPARE(questionsOf(reading), questions);
    QVERIFY(remark.isEmpty() || hasRemark(reading, remark.toStdString()));
    if (std::isnan(impulse)) return;
    // The ripple of 0.5 kN that is cut off with the rest of the record, and rows that are left out.
    QVERIFY2(std::abs(reading.blow.impulse - impulse) < 2e-3 * impulse,
             std::to_string(reading.blow.impulse).c_str());
}

void TestSignalReading::fieldFilesAreRefusedWithTheirLine_data() {
    QTest::addColumn<QString>("words");
    QTest::addRow("05_na_first_column.csv") << "line 122: column 1 holds no value (`#N/A`)";
    QTest::addRow("05_na_at_the_peak.csv") << "line 192: column 1 holds no value (`#N/A`)";
    QTest::addRow("10_overload_9e37.csv")
        << "line 212: column 2 holds `9.99999999E+37`, which stands for an overload";
}

void TestSignalReading::fieldFilesAreRefusedWithTheirLine() {
    QFETCH(QString, words);
    const SignalReading reading = readFieldFile(QTest::currentDataTag());
    QVERIFY2(QString::fromStdString(reading.problem.text()).startsWith(words),
             reading.problem.text().c_str());
}

void TestSignalReading::fortyChannelsHaveTheirNamesAndUnits() {
    const SignalReading reading = readFieldFile(QStringLiteral("17_forty_channels.csv"));
    const std::vector<TableColumn>& columns = reading.table.columns;
    QCOMPARE(columns.size(), std::size_t{41});
    QCOMPARE(columns[0].unit, std::string("us"));
    for (std::size_t i = 1; i < columns.size(); ++i) {
        QCOMPARE(columns[i].unit, std::string("um/m"));
        QVERIFY(columns[i].name.starts_with("Dehnung "));
    }
    QCOMPARE(questionsOf(reading), QStringLiteral("column area modulus"));
}

void TestSignalReading::nothingIsAssumedInSilence_data() {
    QTest::addColumn<QString>("header");
    QTest::addColumn<QString>("questions");
    QTest::addRow("names alone") << "time,force"
                                 << "time_unit unit";
    QTest::addRow("unknown units") << "time [ticks],force [counts]"
                                   << "time_unit unit";
    QTest::addRow("strain without a bar") << "time [us],strain [microstrain]"
                                          << "area modulus";
    QTest::addRow("bridge") << "time [us],CH1 [mV/V]"
                            << "bridge gauge_factor area modulus";
    QTest::addRow("stress") << "time [us],stress [MPa]"
                            << "area";
    QTest::addRow("velocity") << "time [us],v [m/s]"
                              << "impedance";
    QTest::addRow("volts") << "time [us],CH1 [V]"
                           << "unit";
    QTest::addRow("known") << "Zeit [µs],Kraft [kN]"
                           << "";
    QTest::addRow("units in a line of their own") << "t,F\n[us],[kN]"
                                                  << "";
    QTest::addRow("units above the names") << "us,kN\nt,F"
                                           << "";
    QTest::addRow("words below the names") << "t,F\nMikrosekunden,Kilonewton"
                                           << "";
    QTest::addRow("units alone") << "us,kN"
                                 << "";
    QTest::addRow("three lines") << "Time,Channel A\n(us),(kN)\n"
                                 << "";
}

void TestSignalReading::nothingIsAssumedInSilence() {
    QFETCH(QString, header);
    QFETCH(QString, questions);
    const SignalReading reading = readText(header.toStdString() + "\n0,0\n50,300.5\n200,0\n");
    QCOMPARE(QString::fromStdString(reading.problem.text()), QString());
    QCOMPARE(questionsOf(reading), questions);
}

void TestSignalReading::ratesAreReadFromTheLinesAbove_data() {
    QTest::addColumn<double>("rate");  // 0: none is stated with a unit
    for (const char* line : {"# sampling rate: 5 MHz", "Sampling Rate [kHz];5000", "Abtastrate: 5000 kHz",
                             "sample interval,2e-07,s", "\"Sample Interval\";0,2;\"us\"", "% fs = 5e6 Hz",
                             "dt = 0.2 us", "Samplingsfrekvens: 5 MHz", "Sample rate: 5 MS/s",
                             "XINCREMENT,200,ns", "# Sample Rate (Hz): 5 000 000",
                             "Abtastintervall [µs]: 0,2", "Recorder 7, sampling rate 5 MHz, 16 bit"})
        QTest::addRow("%s", line) << 5e6;
    QTest::addRow("sampling rate: 5000000") << 0.0;
    QTest::addRow("Range: 5 MHz") << 0.0;
    QTest::addRow("blows at 40 Hz") << 0.0;
}

void TestSignalReading::ratesAreReadFromTheLinesAbove() {
    QFETCH(double, rate);
    const std::string line = QTest::currentDataTag();
    const SignalReading reading = readText(line + "\nforce [kN]\n0\n1.5\n300.5\n200\n0\n");
    QCOMPARE(reading.questions.empty(), rate > 0);
    if (rate > 0) QVERIFY(reading.rate && std::abs(*reading.rate / rate - 1) < 1e-12);
}

void TestSignalReading::voltsBecomeForces_data() {
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("options");
    QTest::addColumn<double>("force");  // [N] of one number
    const double area = 1e-3, modulus = 200e9;
    const QString bar = QStringLiteral(" area 1000mm^2 modulus 200GPa");
    QTest::addRow("calibration") << "V"
                                 << "scale 50kN/V" << 50e3;
    QTest::addRow("calibration in mV") << "mV"
                                       << "scale 50kN/V" << 50.0;
    // ε = 4 U/(g V k B)
    QTest::addRow("full bridge") << "V"
                                 << "gain 1000 excitation 10 bridge 4 gauge-factor 2" + bar
                                 << area * modulus * 4 / (1000 * 10 * 2.0 * 4);
    QTest::addRow("Poisson bridge") << "mV"
                                    << "gain 100 excitation 5V bridge 2.6 gauge-factor 2.1" + bar
                                    << area * modulus * 4e-3 / (100 * 5 * 2.1 * 2.6);
    QTest::addRow("bridge") << "mV/V"
                            << "bridge 1 gauge-factor 2" + bar << area * modulus * 4e-3 / 2;
    QTest::addRow("strain") << "µm/m" << bar << area * modulus * 1e-6;
    QTest::addRow("strain, corrected") << "µm/m"
                                       << "scale 1.13" + bar << 1.13 * area * modulus * 1e-6;
    QTest::addRow("stress") << "MPa"
                            << "area 1000mm^2" << area * 1e6;
    QTest::addRow("velocity") << "m/s"
                              << "scale 18kN·s/m" << 18e3;
    QTest::addRow("tonnes") << "tf"
                            << "" << 9806.65;
}

void TestSignalReading::voltsBecomeForces() {
    QFETCH(QString, unit);
    QFETCH(QString, options);
    QFETCH(double, force);
    const SignalReading reading = readText(
        "t [us],CH1 [" + unit.toStdString() + "]\n0,0\n1,0\n2,0\n100,1\n200,0\n", optionsOf(options));
    QCOMPARE(questionsOf(reading), QString());
    QVERIFY2(std::abs(reading.forcePerNumber / force - 1) < 1e-12,
             std::to_string(reading.forcePerNumber).c_str());
}

void TestSignalReading::groupsOfThousandsAreReadWhereTheDecimalSignIsKnown_data() {
    QTest::addColumn<QString>("rows");
    QTest::addColumn<QString>("questions");
    QTest::addRow("English") << "0;0.5\n1;1,234.5\n2;12,345\n"
                             << "";
    QTest::addRow("German") << "0;0,5\n1;1.234,5\n2;12.345\n"
                            << "";
    QTest::addRow("Swiss") << "0;0.5\n1;1'234.5\n2;12'345\n"
                           << "";
    QTest::addRow("Swedish") << "0;0,5\n1;1\u00a0234,5\n2;12\u202f345\n"
                             << "";
    QTest::addRow("open") << "1;2,500\n2;1,234\n3;12,345\n"
                          << "decimal";
}

void TestSignalReading::groupsOfThousandsAreReadWhereTheDecimalSignIsKnown() {
    QFETCH(QString, rows);
    QFETCH(QString, questions);
    const SignalReading reading = readText("t [us];F [N]\n" + rows.toStdString());
    QCOMPARE(QString::fromStdString(reading.problem.text()), QString());
    QCOMPARE(questionsOf(reading), questions);
    if (questions.isEmpty()) QCOMPARE(reading.samples.value, (std::vector<double>{0.5, 1234.5, 12345}));
}

void TestSignalReading::qualityIsStated_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("remarks");
    const auto add = [](const char* name, const Record& record, const char* remarks) {
        QTest::addRow("%s", name) << QString::fromStdString(record.text()) << QString(remarks);
    };
    add("a good record", {}, "");
    add("a computed record", {.noise = 0}, "");
    add("offset", {.offset = 10}, "offset");
    add("drift", {.drift = 20}, "drift");
    add("steps of 8 bits", {.step = 2, .noise = 0.1}, "quantised");
    add("steps below the noise", {.step = 0.1}, "");
    add("jitter", {.jitter = 0.1}, "jitter");
    add("two blows", {.second = 2000, .samples = 4000}, "several_blows");
    add("a reflection", {.second = 400, .samples = 4000}, "");
}

void TestSignalReading::qualityIsStated() {
    QFETCH(QString, text);
    QFETCH(QString, remarks);
    const SignalReading reading = readText(text.toStdString());
    QStringList codes;
    for (const SignalRemark& remark : reading.remarks) codes << QString::fromStdString(remark.code);
    QCOMPARE(codes.join(QLatin1Char(' ')), remarks);
    // Opposite gauges, rms of half the difference over 5 % of the peak.
    for (const double bending : {0.02, 0.3}) {
        SignalOptions options;
        options.signalColumn = "A+B";
        const SignalReading pair = readText(Record{.bending = bending}.text(), options);
        QCOMPARE(hasRemark(pair, "opposite_gauges"), bending > 0.2);
    }
}

void TestSignalReading::filesThatAreNoTablesAreNamed_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    QTest::addRow("zip") << QByteArray("PK\3\4\0\0\0\0abc", 11) << "zip archive";
    QTest::addRow("xlsx") << QByteArray("PK\3\4\0\0[Content_Types].xml", 25) << "Excel workbook (.xlsx)";
    QTest::addRow("gzip") << QByteArray("\x1F\x8B\x08\0\0", 5) << "gzip";
    QTest::addRow("xls") << QByteArray("\xD0\xCF\x11\xE0\xA1\xB1") << "old Excel workbook";
    QTest::addRow("MATLAB") << QByteArray("MATLAB 5.0 MAT-file") << "MATLAB";
    QTest::addRow("empty") << QByteArray() << "empty";
    QTest::addRow("words") << QByteArray("nothing to be\nseen here\n") << "no line of numbers";
    QTest::addRow("binary") << QByteArray("ab\0\1\2\n", 6) << "NUL byte";
}

void TestSignalReading::filesThatAreNoTablesAreNamed() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    const SignalReading reading = readText(bytes.toStdString());
    QVERIFY2(QString::fromStdString(reading.problem.text()).contains(words), reading.problem.text().c_str());
}

void TestSignalReading::optionsGoBeforeWhatTheTableSays() {
    const std::string text = "t [us];F [kN];G [kN]\n0;0;1,5\n100;-300;2\n200;0;3\n";
    QCOMPARE(questionsOf(readText(text)), QStringLiteral("column"));
    const SignalReading second =
        readText(text, optionsOf(QStringLiteral("signal-column G time-unit ms unit N")));
    QCOMPARE(second.source.valueColumn, std::size_t{2});
    QCOMPARE(second.samples.time.back(), 0.2);
    QCOMPARE(second.timeFrom, FactSource::option);
    // The mean of the trapezoids: 1.5, 2, 3 N over 2 × 100 ms.
    QVERIFY(std::abs(second.blow.impulse - 0.425) < 1e-12);
    const SignalReading wrong = readText(text, optionsOf(QStringLiteral("signal-column H")));
    QVERIFY(wrong.isWrongOption);
    QVERIFY(wrong.problem.text().find("there is no column `H`") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestSignalReading)
#include "tst_signal_reading.moc"
