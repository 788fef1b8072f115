// SPDX-License-Identifier: GPL-3.0-or-later
// `drillwave signal` and --signal: what scripts rely on.
#include <QTest>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <algorithm>

#include "tests/support/files.h"
#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QString field(const char* name) {
    return QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/field/%1").arg(QLatin1String(name));
}

QJsonObject object(const Finished& finished) {
    return QJsonDocument::fromJson(finished.out).object();
}

}  // namespace

class TestSignal : public QObject {
    Q_OBJECT

  private slots:
    void exitCodesSayWhetherAQuestionIsOpen_data();
    void exitCodesSayWhetherAQuestionIsOpen();
    void jsonHasTheKeysOfTheManual();
    void severalRecordsAreOneSeries();
    void writtenSignalsReadBack();
    void recordersKeepTheirOptions();
    void everyStudyTakesABlowFromARecord();
    void reportsStateTheQualityOfARecord();
    void openQuestionsStopAScenario();
    void tablesOfSpreadsheetsAreSolvedAlike();
};

void TestSignal::exitCodesSayWhetherAQuestionIsOpen_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("code");
    QTest::newRow("read") << QStringList{field("24_blow.csv")} << 0;
    QTest::newRow("unit open") << QStringList{field("01_unit_words.csv")} << 5;
    QTest::newRow("rate estimated") << QStringList{field("02_times_three_digits.csv")} << 5;
    QTest::newRow("rows refused") << QStringList{field("10_overload_9e37.csv")} << 3;
    QTest::newRow("rows skipped") << QStringList{field("10_overload_9e37.csv"), "--rows", "skip"} << 0;
    QTest::newRow("wrong unit") << QStringList{field("24_blow.csv"), "--unit", "stone"} << 2;
    QTest::newRow("wrong column") << QStringList{field("24_blow.csv"), "--signal-column", "none"} << 5;
    QTest::newRow("no table") << QStringList{QStringLiteral(DRILLWAVE_SOURCE_DIR "/LICENSE")} << 3;
    QTest::newRow("not there") << QStringList{"not-there.csv"} << 3;
    QTest::newRow("series") << QStringList{field("24_blow.csv"), field("01_unit_words.csv")} << 5;
}

void TestSignal::exitCodesSayWhetherAQuestionIsOpen() {
    QFETCH(QStringList, words);
    QFETCH(int, code);
    const Finished finished = run(QStringList{"signal"} + words);
    QVERIFY2(finished.exitCode == code, finished.error.constData());
    QCOMPARE(run(QStringList{"signal", "--json"} + words).exitCode, code);
}

void TestSignal::jsonHasTheKeysOfTheManual() {
    const QJsonObject read = object(run({"signal", field("24_blow.csv"), "--json"}));
    QCOMPARE(
        read.keys().join(QLatin1Char(' ')),
        QStringLiteral("columns file format impulse_Ns peak peak_unit questions range remarks samples signal "
                       "skipped_rows start_s step_s time"));
    QCOMPARE(read["signal"].toObject()["unit"].toString(), QStringLiteral("kN"));
    QVERIFY(std::abs(read["impulse_Ns"].toDouble() - 31.83) < 0.02);
    const QJsonObject open = object(run({"signal", field("02_times_three_digits.csv"), "--json"}));
    QVERIFY(open["impulse_Ns"].isNull());
    QCOMPARE(open["time"].toObject()["rate_hz"].toDouble(), 5e6);
    QCOMPARE(open["time"].toObject()["from"].toString(), QStringLiteral("estimated"));
    QCOMPARE(open["questions"].toArray(), QJsonArray{"rate"});
    // An assumption is a question, too.
    const QJsonObject assumed = object(run({"signal", field("13_index_first.csv"), "--json"}));
    QCOMPARE(assumed["time"].toObject()["from"].toString(), QStringLiteral("assumed"));
    QCOMPARE(assumed["questions"].toArray(), (QJsonArray{"time_unit", "unit"}));
    QVERIFY(assumed["start_s"].isNull());
}

void TestSignal::severalRecordsAreOneSeries() {
    const QStringList files{field("24_blow.csv"), field("11_clipped.csv"), field("10_overload_9e37.csv")};
    const Finished text = run(QStringList{"signal"} + files);
    QCOMPARE(text.out.count('\n'), 4);
    QVERIFY(text.out.contains("clipped"));
    const Finished json = run(QStringList{"signal", "--json"} + files);
    const QJsonArray array = QJsonDocument::fromJson(json.out).array();
    QCOMPARE(array.size(), 3);
    QCOMPARE(array[1].toObject()["remarks"].toArray(), QJsonArray{"clipped"});
    QVERIFY(array[2].toObject()["problem"].toString().contains(QStringLiteral("line 212")));
    QCOMPARE(json.exitCode, 3);
}

void TestSignal::writtenSignalsReadBack() {
    QTemporaryDir folder;
    for (const QStringList& signs : {QStringList{}, QStringList{"--decimal-comma"}}) {
        const QString file = folder.filePath(signs.isEmpty() ? "point.csv" : "comma.csv");
        QCOMPARE(run(QStringList{"signal", field("07_minus_2212.csv"), "-o", file} + signs).exitCode, 0);
        const QJsonObject again = object(run({"signal", file, "--json"}));
        QCOMPARE(again["questions"].toArray().size(), 0);
        QVERIFY(std::abs(again["impulse_Ns"].toDouble() - 31.8264) < 1e-4);
    }
    QFile comma(folder.filePath("comma.csv"));
    QVERIFY(comma.open(QIODevice::ReadOnly));
    QCOMPARE(comma.readLine(), QByteArray("time [us];force [kN]\n"));
    QVERIFY(!comma.readAll().contains('.'));
    // Nothing is written while a question is open.
    const QString none = folder.filePath("none.csv");
    QCOMPARE(run({"signal", field("01_unit_words.csv"), "-o", none}).exitCode, 5);
    QVERIFY(!QFile::exists(none));
}

void TestSignal::recordersKeepTheirOptions() {
    QTemporaryDir home;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", home.path());
    const QStringList keep{"signal",  field("01_unit_words.csv"), "--scale",
                           "100kN/V", "--save-recorder",          "rig \"A\""};
    QCOMPARE(run(keep, environment).exitCode, 0);
    QVERIFY(QFile::exists(home.filePath("drillwave/recorders.yaml")));
    const QStringList use{"signal", field("01_slash_voltage.csv"), "--recorder", "rig \"A\"", "--json"};
    const Finished used = run(use, environment);
    QCOMPARE(used.exitCode, 0);
    QVERIFY(std::abs(object(used)["impulse_Ns"].toDouble() - 31.83) < 0.02);
    // An option goes before the recorder.
    QCOMPARE(object(run(use + QStringList{"--scale", "50kN/V"}, environment))["peak"].toDouble(),
             object(used)["peak"].toDouble() / 2);
    QCOMPARE(run({"signal", field("24_blow.csv"), "--recorder", "rig B"}, environment).exitCode, 2);
}

void TestSignal::everyStudyTakesABlowFromARecord() {
    const QStringList record{"--signal", field("24_blow.csv")};
    const QString rod = example("t38_medium_rock"), string = example("t38_string");
    const Finished blow = run(QStringList{"run", rod, "--json"} + record);
    QVERIFY2(blow.exitCode == 0, blow.error.constData());
    QVERIFY2(blow.error.contains("impulse and e to 1e-4"), blow.error.constData());
    const Finished whole = run(QStringList{"run", rod, "--json", "--all-samples"} + record);
    const double change = object(blow)["cor"].toDouble() - object(whole)["cor"].toDouble();
    QVERIFY2(std::abs(change) < 1e-4, QByteArray::number(change).constData());
    QCOMPARE(run(QStringList{"sweep", rod, "--vary", "bit_rock.gamma=0.1,0.2"} + record).exitCode, 0);
    QCOMPARE(run(QStringList{"gap", rod} + record).exitCode, 0);
    // The hammer of a string makes room.
    const Finished ofString = run(QStringList{"run", string, "--json"} + record);
    QVERIFY2(ofString.exitCode == 0, ofString.error.constData());
}

void TestSignal::reportsStateTheQualityOfARecord() {
    const QStringList report{"report", example("t38_medium_rock"), "--no-plots", "-o", "-"};
    const QByteArray clipped = output(report + QStringList{"--signal", field("11_clipped.csv")});
    QVERIFY(clipped.contains("<b>Record:</b> "));
    QVERIFY(clipped.contains("11_clipped.csv: 98 equal samples at the largest value, 180: clipped?"));
    QVERIFY(!output(report + QStringList{"--signal", field("24_blow.csv")}).contains("<b>Record:</b>"));
    QVERIFY(!output(report).contains("<b>Record:</b>"));

    // A blow in a file of its own, and a trapezoid that was set by hand.
    const QTemporaryDir folder;
    const auto reportOf = [&](const QByteArray& name, const QByteArray& table) {
        write(folder.filePath(name + ".csv"), table);
        const QString scenario = folder.filePath(name + ".yaml");
        write(scenario,
              "drillwave: 1\nrod: {length: 3 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: "
              "7850 kg/m^3}\npulse: {shape: table, file: " +
                  name + ".csv}\nbit_rock: {stiffness: 105 MN/m, gamma: 0.1}\n");
        return output({"report", scenario, "--no-plots", "-o", "-"});
    };
    QByteArray flat = "time [us],force [kN]\n";
    for (int i = 0; i <= 260; ++i) {
        const double blow = std::min({2.0 * (i - 60), 180.0, 2.0 * (260 - i)});
        const double noise = 0.1 * (i * 7 % 5);
        flat += QByteArray::number(i) + "," +
                QByteArray::number(blow < 180 ? std::max(blow, 0.0) + noise : 180) + "\n";
    }
    QVERIFY(reportOf("flat", flat).contains("<b>Record:</b> flat.csv: 21 equal samples"));
    QVERIFY(!reportOf("trapezoid", "time [us],force [kN]\n0,0\n20,180\n120,180\n140,0\n")
                 .contains("<b>Record:</b>"));
}

void TestSignal::openQuestionsStopAScenario() {
    const QString rod = example("t38_medium_rock");
    const Finished open = run({"run", rod, "--signal", field("01_unit_words.csv")});
    QCOMPARE(open.exitCode, 5);
    QVERIFY2(open.error.contains("give --unit"), open.error.constData());
    QCOMPARE(run({"run", rod, "--signal", field("01_unit_words.csv"), "--scale", "100kN/V"}).exitCode, 0);
    QCOMPARE(run({"run", rod, "--rate", "5MHz"}).exitCode, 2);
}

void TestSignal::tablesOfSpreadsheetsAreSolvedAlike() {
    const QString rod = example("t38_medium_rock");
    const QByteArray german = output({"table", rod, field("20_table_german.csv")});
    QCOMPARE(german, output({"table", rod, field("19_table_empty_rows.csv")}));
    QVERIFY(german.startsWith("rod.length [m],bit_rock.gamma,cor\n3.66,0.1,"));
}

QTEST_GUILESS_MAIN(TestSignal)
#include "tst_signal.moc"
