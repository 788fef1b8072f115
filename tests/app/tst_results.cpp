// SPDX-License-Identifier: GPL-3.0-or-later
// Every file says what it is, and can be worked on with.
#include <QTest>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QJsonObject withoutTime(QJsonObject report) {
    report.remove("run_time");
    return report;
}

QByteArray withByteOrderMark(const QByteArray& bytes) {
    return "\xEF\xBB\xBF" + bytes;
}

}  // namespace

class TestResults : public QObject {
    Q_OBJECT

  private slots:
    void jsonHoldsScenarioAndUnits();
    void everyFileOfARunRunsAgainToTheSameDigits_data();
    void everyFileOfARunRunsAgainToTheSameDigits();
    void remarksDoNotPileUp();
    void aLatticeResultRunsAgainAsLattice_data();
    void aLatticeResultRunsAgainAsLattice();
    void commandsThatSolveExactlySaySoOfALatticeResult();
    void aNewerProgramIsToldOf();
    void byteOrderMarksAreRead();
    void rowsHaveTheirRecordBesideThem();
    void filesOfAStringNameTheMethodThatItHas();
    void theCommandOfARecordGivesTheSameRows();
    void aRecordDoesNotDependOnThreads();
    void recordsFollowTheRulesOfOverwriting();
    void noRecordIsLeftWithoutItsRows();
    void theFolderFollowsTheUnitsOfTheScenario();
    void theGapIsWrittenInSi();
    void studiesHoldTheirScenario_data();
    void studiesHoldTheirScenario();
    void allOutputsAreAllThereAre();
    void aLongTableOfPointsStaysInItsFile();
    void aTitleIsSet();
    void sharesThatAreRoundingAreZero();
    void theErrorOfTheLatticeIsToldOnce();
    void pdfIsDatedBySourceDateEpoch();
};

void TestResults::jsonHoldsScenarioAndUnits() {
    const QJsonObject report = json({"run", example("t38_medium_rock"), "--set", "pulse.shape=half_sine"});
    QVERIFY(report["scenario"].toString().contains("shape: half_sine"));
    const QJsonObject units = report["units"].toObject();
    QCOMPARE(units.keys(), report["si"].toObject().keys());
    const QList<QPair<const char*, const char*>> known{{"peak_force", "N"}, {"max_penetration", "m"},
                                                       {"impulse", "N s"},  {"separation_time", "s"},
                                                       {"cor", "1"},        {"thrust", "N"}};
    for (const auto& [name, unit] : known) QCOMPARE(units[name].toString(), QString(unit));
    const QJsonObject groups = json({"run", example("paper_fig4b")});
    QVERIFY(groups["scenario"].toString().contains("gamma: 0.1"));
    QVERIFY(!groups.contains("units"));
}

void TestResults::everyFileOfARunRunsAgainToTheSameDigits_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"scenario.yaml", "summary.json", "histories.csv", "events.csv"})
        QTest::newRow(file) << file;
}

void TestResults::everyFileOfARunRunsAgainToTheSameDigits() {
    QFETCH(QString, file);
    const QTemporaryDir folder;
    const QStringList words{"run",   example("t38_medium_rock"), "--set", "beta=0.7",
                            "--set", "pulse.shape=triangular",   "--set", "title=\"ü: # \\ {\""};
    QCOMPARE(run(words + QStringList{"-o", folder.path()}).exitCode, 0);
    QCOMPARE(withoutTime(json({"run", folder.filePath(file)})), withoutTime(json(words)));
    QCOMPARE(run({"validate", folder.filePath(file)}).exitCode, 0);
}

// A header of a header would say two things of one file.
void TestResults::remarksDoNotPileUp() {
    const QTemporaryDir folder;
    QString from = example("paper_fig4b");
    for (const char* out : {"one", "two", "three"}) {
        const QString to = folder.filePath(out);
        QCOMPARE(run({"run", from, "-o", to}).exitCode, 0);
        from = to + (QLatin1String(out) == QLatin1String("one") ? "/histories.csv" : "/scenario.yaml");
    }
    for (const char* file : {"scenario.yaml", "histories.csv", "events.csv"}) {
        const QByteArray first = read(folder.filePath("one/") + file);
        QCOMPARE(first.count("Written by Drillwave"), 1);
        QVERIFY2(read(folder.filePath("two/") + file) == first, file);
        QVERIFY2(read(folder.filePath("three/") + file) == first, file);
    }
}

void TestResults::aLatticeResultRunsAgainAsLattice_data() {
    everyFileOfARunRunsAgainToTheSameDigits_data();
}

void TestResults::aLatticeResultRunsAgainAsLattice() {
    QFETCH(QString, file);
    const QTemporaryDir folder;
    const QStringList words{"run", example("paper_fig4b"), "--method", "lattice", "--segments", "100"};
    QCOMPARE(run(words + QStringList{"-o", folder.path()}).exitCode, 0);
    const QString path = folder.filePath(file);
    QCOMPARE(withoutTime(json({"run", path})), withoutTime(json(words)));
    QCOMPARE(json({"run", path, "--method", "exact"})["method"].toString(), QString("exact"));
    QCOMPARE(json({"run", path, "--segments", "200"})["segments"].toInt(), 200);
    QCOMPARE(run({"sweep", path, "--vary", "beta=1,2"}).out,
             run({"sweep", example("paper_fig4b"), "--vary", "beta=1,2", "--method", "lattice", "--segments",
                  "100"})
                 .out);
}

void TestResults::commandsThatSolveExactlySaySoOfALatticeResult() {
    const QTemporaryDir folder;
    QCOMPARE(run({"run", example("paper_fig4a"), "--method", "closed_form", "-o", folder.path()}).exitCode,
             0);
    const Finished gap = run({"gap", folder.filePath("summary.json")});
    QCOMPARE(gap.exitCode, 0);
    QCOMPARE(gap.error.count('\n'), 1);
    QVERIFY2(gap.error.contains("was solved by method closed_form; this command solves exactly"), gap.error);
}

void TestResults::aNewerProgramIsToldOf() {
    const QTemporaryDir folder;
    QCOMPARE(run({"run", example("paper_fig4b"), "-o", folder.path()}).exitCode, 0);
    const QByteArray version = run({"version"}).out.mid(qstrlen("drillwave ")).trimmed();
    for (const char* file : {"scenario.yaml", "summary.json", "histories.csv"}) {
        const QString path = folder.filePath(file);
        QCOMPARE(run({"run", path}).error, QByteArray());
        write(path, read(path).replace(version, "9.9.9"));
        const Finished finished = run({"run", path});
        QCOMPARE(finished.exitCode, 0);
        QCOMPARE(finished.error.count('\n'), 1);
        QVERIFY2(finished.error.contains("written by Drillwave 9.9.9, newer than this " + version),
                 finished.error);
    }
}

// A spreadsheet that saves "CSV UTF-8" puts one in front.
void TestResults::byteOrderMarksAreRead() {
    const QTemporaryDir folder;
    QCOMPARE(run({"run", example("paper_fig4b"), "-o", folder.path()}).exitCode, 0);
    const QJsonObject before = withoutTime(json({"run", example("paper_fig4b")}));
    for (const char* file : {"scenario.yaml", "summary.json", "histories.csv"}) {
        const QString path = folder.filePath(file);
        write(path, withByteOrderMark(read(path)));
        QCOMPARE(withoutTime(json({"run", path})), before);
    }
}

void TestResults::rowsHaveTheirRecordBesideThem() {
    const QTemporaryDir folder;
    const QString map = folder.filePath("map.csv");
    QCOMPARE(run({"sweep", example("t38_medium_rock"), "--vary", "rod.length=3m:6m:4", "--vary",
                  "pulse.shape=rectangular,half_sine", "--outputs", "cor,peak_force", "--si", "--set",
                  "bit_rock.gamma=0.37", "-o", map})
                 .exitCode,
             0);
    const QByteArray record = read(map + ".yaml");
    for (const char* part :
         {"drillwave_result: 1\n", "\nversion: ", "\nmethod: exact\n", "\nrows: 8\n", "rod.length [m]",
          "3m:6m:4", "count: 2", "peak_force [N]", "    gamma: 0.37\n", "bit_rock.gamma=0.37"})
        QVERIFY2(record.contains(part), part);
    const QJsonObject again = json({"run", map + ".yaml"});
    QCOMPARE(again["dimensionless"],
             json({"run", example("t38_medium_rock"), "--set", "bit_rock.gamma=0.37"})["dimensionless"]);
    QCOMPARE(run({"validate", map + ".yaml"}).exitCode, 0);

    write(folder.filePath("cases.csv"), "beta\n0.3\n0.4\n0.5\n");
    const QString rows = folder.filePath("rows.csv");
    QCOMPARE(run({"table", example("paper_fig4b"), folder.filePath("cases.csv"), "--method", "lattice",
                  "--segments", "100", "-o", rows})
                 .exitCode,
             0);
    for (const char* part : {"\nmethod: lattice\nsegments: 100\n", "\nrows: 3\n", "cases.csv\n"})
        QVERIFY2(read(rows + ".yaml").contains(part), part);
    QCOMPARE(json({"run", rows + ".yaml"})["segments"].toInt(), 100);

    // Standard output and devices have none.
    QCOMPARE(run({"sweep", example("paper_fig4b"), "--vary", "beta=1,2", "-o", "/dev/null"}).exitCode, 0);
    QVERIFY(!QFile::exists("/dev/null.yaml"));
}

void TestResults::filesOfAStringNameTheMethodThatItHas() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("out"), rows = folder.filePath("rows.csv");
    QCOMPARE(run({"run", example("r32_string"), "-o", out}).exitCode, 0);
    const QJsonObject before = withoutTime(json({"run", example("r32_string")}));
    for (const char* file : {"/scenario.yaml", "/histories.csv", "/events.csv"}) {
        const QByteArray text = read(out + file);
        QVERIFY2(text.contains("# Solved by method polynomial_cells.\n"), file);
        QCOMPARE(withoutTime(json({"run", out + file})), before);
    }
    QCOMPARE(run({"sweep", example("r32_string"), "--vary", "bit_rock.gamma=0.1,0.2", "--outputs",
                  "efficiency", "-o", rows})
                 .exitCode,
             0);
    QVERIFY(!read(rows + ".yaml").contains("method"));  // there is no choice
    QCOMPARE(withoutTime(json({"run", rows + ".yaml"})), before);
}

void TestResults::theCommandOfARecordGivesTheSameRows() {
    const QTemporaryDir folder;
    const QString scenario = folder.filePath("it's one.yaml");
    write(scenario, read(example("paper_fig4b")));
    const QString map = folder.filePath("map.csv");
    QCOMPARE(run({"sweep", scenario, "--vary", "beta=0.1:9:7:log", "delta=0,0.5", "--outputs=cor,impulse",
                  "--set", "gamma=0.2", "--shard", "1/1", "-o", map, "--force", "-j2"})
                 .exitCode,
             0);
    const QRegularExpressionMatch match = QRegularExpression("\ncommand: (\"?)(drillwave [^\n]*)\\1\n")
                                              .match(QString::fromUtf8(read(map + ".yaml")));
    QVERIFY(match.hasMatch());
    QString command =
        match.captured(2).replace("\\\\", "\\").replace(0, 9, QStringLiteral(DRILLWAVE_PROGRAM));
    QProcess shell;
    shell.start("/bin/sh", {"-c", command});
    QVERIFY(shell.waitForFinished());
    QVERIFY2(shell.readAllStandardOutput() == read(map), qPrintable(command));
}

void TestResults::aRecordDoesNotDependOnThreads() {
    const QTemporaryDir folder;
    const QString map = folder.filePath("map.csv");
    QByteArray first;
    for (const char* jobs : {"-j1", "-j3"}) {
        QCOMPARE(run({"sweep", example("paper_fig4b"), "--vary", "beta=1:2:9", "-o", map, jobs, "--force"})
                     .exitCode,
                 0);
        if (first.isEmpty()) first = read(map + ".yaml");
        QVERIFY(read(map + ".yaml") == first);
    }
}

void TestResults::recordsFollowTheRulesOfOverwriting() {
    const QTemporaryDir folder;
    const QString map = folder.filePath("map.csv");
    const QStringList words{"sweep", example("paper_fig4b"), "--vary", "beta=1,2", "-o", map};
    write(map + ".yaml", "precious");
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QVERIFY(refused.error.contains("map.csv.yaml: exists already"));
    QCOMPARE(read(map + ".yaml"), QByteArray("precious"));
    QVERIFY(!QFile::exists(map));
    QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
    // The record is the input of the next sweep: it is not written over.
    const QByteArray record = read(map + ".yaml");
    const Finished input = run({"sweep", map + ".yaml", "--vary", "beta=3", "-o", map, "--force"});
    QCOMPARE(input.exitCode, 2);
    QVERIFY2(input.error.contains("is also the input"), input.error);
    QCOMPARE(read(map + ".yaml"), record);
}

void TestResults::noRecordIsLeftWithoutItsRows() {
    const QTemporaryDir folder;
    write(folder.filePath("cases.csv"), "beta\n-1\n");
    QCOMPARE(
        run({"table", example("paper_fig4b"), folder.filePath("cases.csv"), "-o", folder.filePath("r.csv")})
            .exitCode,
        5);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"cases.csv"});
}

void TestResults::theFolderFollowsTheUnitsOfTheScenario() {
    const QTemporaryDir folder;
    QCOMPARE(run({"run", example("paper_fig4b"), "-o", folder.path()}).exitCode, 0);
    const QByteArray histories = read(folder.filePath("histories.csv"));
    QVERIFY(histories.contains("\ntime,impact_force,"));
    QVERIFY(histories.contains("\n# # Columns: incident_wave is a normal force, tension positive"));
    QVERIFY(read(folder.filePath("scenario.yaml")).startsWith("# Written by Drillwave "));
}

void TestResults::theGapIsWrittenInSi() {
    const QStringList words{"gap", example("t38_medium_rock"), "-o", "-"};
    const auto table = [](const QByteArray& csv) {
        QList<QList<QByteArray>> rows;
        for (const QByteArray& line : csv.trimmed().split('\n'))
            if (!line.startsWith('#')) rows << line.split(',');
        return rows;
    };
    const auto plain = table(run(words).out), si = table(run(words + QStringList{"--si"}).out);
    QCOMPARE(si[0],
             QList<QByteArray>({"bit_rock.gap [m]", "cor", "impulse [N s]", "peak_force [N]", "efficiency"}));
    QCOMPARE(si.size(), plain.size());
    // I0 = 51 N s, t0 = 200 us, two roundings
    for (qsizetype i = 1; i < si.size(); ++i) {
        QCOMPARE(si[i][1], plain[i][1]);
        QVERIFY(std::abs(si[i][2].toDouble() / (51 * plain[i][2].toDouble()) - 1) < 1e-15);
        QVERIFY(std::abs(si[i][3].toDouble() / (255e3 * plain[i][3].toDouble()) - 1) < 1e-15);
    }
}

void TestResults::studiesHoldTheirScenario_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("gap") << QStringList{"gap"};
    QTest::newRow("thrust") << QStringList{"thrust"};
    QTest::newRow("accuracy") << QStringList{"accuracy", "--segments", "100"};
}

void TestResults::studiesHoldTheirScenario() {
    QFETCH(QStringList, words);
    const QTemporaryDir folder;
    const QStringList scenario{example("t38_medium_rock"), "--set", "beta=0.9"};
    const Finished study = run(words + scenario + QStringList{"--json"});
    QCOMPARE(study.exitCode, 0);
    write(folder.filePath("study.json"), study.out);
    QCOMPARE(withoutTime(json({"run", folder.filePath("study.json")})),
             withoutTime(json(QStringList{"run"} + scenario)));
}

void TestResults::allOutputsAreAllThereAre() {
    const auto header = [](const QStringList& words) {
        const Finished finished = run(words + QStringList{"--outputs", "all"});
        if (finished.exitCode != 0) qFatal("%s", finished.error.constData());
        return finished.out.left(finished.out.indexOf('\n')).split(',');
    };
    const QList<QByteArray> groups = header({"sweep", example("paper_fig4b"), "--vary", "beta=1,2"});
    const QStringList names = json({"run", example("paper_fig4b")})["dimensionless"].toObject().keys();
    QCOMPARE(groups.size(), names.size() + 1);
    for (const QString& name : names) QVERIFY2(groups.contains(name.toUtf8()), qPrintable(name));
    QVERIFY(!groups.contains("thrust"));
    const QList<QByteArray> si = header({"sweep", example("t38_medium_rock"), "--vary", "beta=1,2", "--si"});
    QCOMPARE(si.size(), names.size() + 5);  // thrust, its margin, power and penetration rate
    QVERIFY(si.contains("thrust [N]"));
    QVERIFY(si.contains("peak_tension_after [Pa]"));
    const QTemporaryDir folder;
    write(folder.filePath("cases.csv"), "beta\n1\n");
    QVERIFY(
        header({"table", example("t38_medium_rock"), folder.filePath("cases.csv")}).contains("thrust [N]"));
}

// A measured blow of 60 000 points is more than a scenario file may hold.
void TestResults::aLongTableOfPointsStaysInItsFile() {
    const QTemporaryDir folder;
    QByteArray points = "time,force\n0,0\n";
    for (int i = 1; i < 60000; ++i) points += QByteArray::number(i) + ",1.25\n";
    write(folder.filePath("blow.csv"), points + "60000,0\n");
    const QString scenario = folder.filePath("case.yaml");
    write(scenario,
          "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\n"
          "pulse: {shape: table, file: blow.csv}\n");
    const QString map = folder.filePath("map.csv");
    QCOMPARE(run({"sweep", scenario, "--vary", "beta=1", "-o", map}).exitCode, 0);
    QVERIFY(read(map + ".yaml").contains("file: " + folder.filePath("blow.csv").toUtf8()));
    QCOMPARE(run({"validate", map + ".yaml"}).exitCode, 0);
    QCOMPARE(run({"run", scenario, "-o", folder.filePath("out")}).exitCode, 0);
    QCOMPARE(withoutTime(json({"run", folder.filePath("out/histories.csv")})),
             withoutTime(json({"run", folder.filePath("out/summary.json")})));
}

void TestResults::aTitleIsSet() {
    const QJsonObject report = json({"run", example("paper_fig4b"), "--set", "title=Variant: 7 \"ü\""});
    QCOMPARE(report["title"].toString(), QString("Variant: 7 \"ü\""));
    QVERIFY(report["scenario"].toString().contains("Variant: 7"));
    QCOMPARE(run({"run", example("paper_fig4b"), "--set", "title=a\x01"}).exitCode, 5);
}

void TestResults::sharesThatAreRoundingAreZero() {
    // An elastic rock keeps nothing.
    const QByteArray out = run({"run", example("reference_case")}).out;
    QVERIFY2(QRegularExpression("in the rock +0 W").match(out).hasMatch(), out);
}

void TestResults::theErrorOfTheLatticeIsToldOnce() {
    const QByteArray out =
        run({"run", example("paper_fig4b"), "--method", "lattice", "--segments", "1000"}).out;
    QCOMPARE(out.count("error estimated as"), 1);
    QVERIFY2(!out.contains("as large as"), out);
}

void TestResults::pdfIsDatedBySourceDateEpoch() {
    const QTemporaryDir folder;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SOURCE_DATE_EPOCH", "1700000000");
    QByteArray first;
    for (const char* out : {"one", "two"}) {
        QCOMPARE(
            run({"run", example("paper_fig4b"), "-o", folder.filePath(out), "--plots", "pdf"}, environment)
                .exitCode,
            0);
        const QByteArray pdf = read(folder.filePath(out) + "/blow.pdf");
        QVERIFY(pdf.contains("/CreationDate (D:20231114221320Z)"));
        if (first.isEmpty()) first = pdf;
        QVERIFY(pdf == first);
        QTest::qWait(1100);  // the clock that must not matter moves on
    }
}

QTEST_GUILESS_MAIN(TestResults)
#include "tst_results.moc"
