// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of FILE: a file, standard input, a pipe, a built-in example; and presets by name.
#include <QTest>

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "app/scenario_argument.h"
#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QString program = QStringLiteral(DRILLWAVE_PROGRAM);

QJsonObject scenarioOf(const QStringList& words) {
    const Finished finished = run(QStringList{"run"} + words + QStringList{"--json"});
    if (finished.exitCode != 0) qFatal("%s", finished.error.constData());
    return QJsonDocument::fromJson(finished.out).object();
}

}  // namespace

class TestInputs : public QObject {
    Q_OBJECT

  private slots:
    void scenariosComeFromPipes_data();
    void scenariosComeFromPipes();
    void resultsComeFromPipes();
    void problemsOfAPipeAreThoseOfStandardInput();
    void anEndlessPipeIsRefused();
    void tablesComeFromPipes_data();
    void tablesComeFromPipes();
    void aLongTableFromAPipeTakesNoMemory();
    void examplesGoByTheirName();
    void presetsAreListedWithTheirSources();
    void presetsAreFoundByWords();
    void presetsAreTakenByName();
    void presetsOfOnesOwnAreTaken();
    void anEmptyNameIsNoFileOfPresets();
    void presetsAreValidatedAsPresets();
    void noInputIsOverwritten_data();
    void noInputIsOverwritten();
    void everyOptionThatReadsAFileIsAnInput();
};

void TestInputs::scenariosComeFromPipes_data() {
    QTest::addColumn<QString>("line");
    for (const char* command :
         {"run %1 --json | grep -v run_time", "sweep %1 --vary beta=1,2", "gap %1 -o -", "thrust %1",
          "validate %1", "accuracy %1 --segments 100 -o - | cut -d, -f1-6"}) {
        const QString line = QStringLiteral("drillwave ") + command;
        QTest::newRow(qPrintable(QString("- ") + command)) << line.arg("- < %1");
        QTest::newRow(qPrintable(QString("/dev/stdin ") + command)) << "cat %1 | " + line.arg("/dev/stdin");
        QTest::newRow(qPrintable(QString("<(…) ") + command)) << line.arg("<(cat %1)");
    }
}

void TestInputs::scenariosComeFromPipes() {
    QFETCH(QString, line);
    const QString file = example("t38_medium_rock");
    QString direct = line;
    direct.replace("- < %1", "%1")
        .replace("cat %1 | ", "")
        .replace("/dev/stdin", "%1")
        .replace("<(cat %1)", "%1");
    const Finished expected = shell(direct.arg(file));
    QVERIFY2(expected.exitCode == 0, expected.error);
    const Finished finished = shell(line.arg(file));
    QVERIFY2(finished.exitCode == 0, finished.error);
    QCOMPARE(finished.out, expected.out);
    QCOMPARE(finished.error, QByteArray());
}

void TestInputs::resultsComeFromPipes() {
    const QTemporaryDir folder;
    const QString file = example("t38_medium_rock");
    const QByteArray expected = shell("drillwave run " + file + " --json | grep -v run_time").out;
    QVERIFY(expected.size() > 1000);
    QCOMPARE(shell("drillwave run " + file + " --json | drillwave run - --json | grep -v run_time").out,
             expected);
    QCOMPARE(run({"run", file, "-o", folder.path()}).exitCode, 0);
    QCOMPARE(shell("drillwave run - --json < histories.csv | grep -v run_time", folder.path()).out, expected);
    // As a result without its leading "# " is a scenario.
    QCOMPARE(shell("sed -n 's/^# \\{0,1\\}//p' histories.csv | drillwave run - --json | grep -v run_time",
                   folder.path())
                 .out,
             expected);
}

void TestInputs::problemsOfAPipeAreThoseOfStandardInput() {
    const Finished invalid = shell(
        "printf 'drillwave: 1\\ndimensionless: {beta: -1, gamma: 1, tau: 1, delta: 0}\\npulse: {shape: "
        "rectangular}\\n' | drillwave run -");
    QCOMPARE(invalid.exitCode, 5);
    QVERIFY2(invalid.error.startsWith("standard input:2:"), invalid.error);
    const Finished closed = shell("drillwave run - <&-");
    QCOMPARE(closed.exitCode, 3);
    QCOMPARE(closed.error.count('\n'), 1);
    QVERIFY2(closed.error.contains("cannot be read"), closed.error);
    QVERIFY(shell("drillwave run - < /dev/null").exitCode != 0);
}

void TestInputs::anEndlessPipeIsRefused() {
    // Sanitizers reserve more addresses than the limit that shows an unbounded read.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    const QString limit;
#else
    const QString limit = QStringLiteral("ulimit -v 2000000; ");
#endif
    for (const char* line : {"drillwave run - < /dev/zero", "yes '# x' | drillwave run -",
                             "yes '{ \"scenario\": [' | drillwave run -"}) {
        const Finished finished = shell(limit + line);
        QVERIFY2(finished.exitCode == 3 || finished.exitCode == 5, finished.error);
        QCOMPARE(finished.error.count('\n'), 1);
    }
}

void TestInputs::tablesComeFromPipes_data() {
    QTest::addColumn<QString>("line");
    QTest::newRow("-") << "drillwave table %1 - < cases.csv";
    QTest::newRow("/dev/stdin") << "cat cases.csv | drillwave table %1 /dev/stdin";
    QTest::newRow("<(…)") << "drillwave table %1 <(cat cases.csv)";
    QTest::newRow("named pipe") << "mkfifo pipe; cat cases.csv > pipe & drillwave table %1 pipe";
    QTest::newRow("both") << "drillwave table <(cat %1) - < cases.csv";
}

void TestInputs::tablesComeFromPipes() {
    QFETCH(QString, line);
    const QTemporaryDir folder;
    QByteArray cases = "beta,note\n";
    for (int i = 1; i <= 3000; ++i) cases += QByteArray::number(i / 1000.0) + ",\"a, b\"\n";
    write(folder.filePath("cases.csv"), cases);
    const QByteArray expected = run({"table", example("paper_fig4b"), folder.filePath("cases.csv")}).out;
    QCOMPARE(expected.count('\n'), 3001);
    const Finished finished = shell(line.arg(example("paper_fig4b")), folder.path());
    QVERIFY2(finished.exitCode == 0, finished.error);
    QVERIFY(finished.out == expected);
}

void TestInputs::aLongTableFromAPipeTakesNoMemory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("sanitizers keep freed memory");
#endif
    // 30 MB of rows, whose last one is wrong: all of them are read. A program takes some 25 MB by itself.
    const Finished finished = shell(
        "(echo beta,note; for i in {1..30}; do yes \"1,$(printf %0990d 0)\" | head -n 1000; done; echo x,) | "
        "(drillwave table " +
        example("paper_fig4b") +
        " - > /dev/null & pid=$!; while kill -0 $pid 2>/dev/null; do "
        "grep VmHWM /proc/$pid/status 2>/dev/null; sleep 0.02; done; wait $pid)");
    QCOMPARE(finished.exitCode, 5);
    QVERIFY2(finished.error.contains("standard input:30002:1: beta = x"), finished.error);
    double most = 0;
    for (const QByteArray& line : finished.out.split('\n'))
        most = std::max(most, line.simplified().split(' ').value(1).toDouble());
    QVERIFY2(most > 0 && most < 50000, qPrintable(QString("%1 kB").arg(most)));
}

void TestInputs::examplesGoByTheirName() {
    const QTemporaryDir folder;
    const Finished named = shell("drillwave run t38_medium_rock --json | grep -v run_time", folder.path());
    QCOMPARE(named.out,
             shell("drillwave run " + example("t38_medium_rock") + " --json | grep -v run_time").out);
    QCOMPARE(shell("drillwave gap paper_fig4b", folder.path()).exitCode, 0);
    QCOMPARE(shell("drillwave validate paper_fig4b", folder.path()).exitCode, 0);
    // A file of that name goes first.
    write(folder.filePath("t38_medium_rock"), read(example("paper_fig4b")));
    QVERIFY(shell("drillwave run t38_medium_rock", folder.path()).out.contains("tau 10"));
}

void TestInputs::presetsAreListedWithTheirSources() {
    const Finished list = run({"presets"});
    QCOMPARE(list.exitCode, 0);
    for (const char* part :
         {"T38, round 38 mm", "medium drifter, piston", "very hard rock", "assumed", "--rock"})
        QVERIFY2(list.out.contains(part), part);
    for (const QByteArray& line : list.out.split('\n')) QVERIFY2(line.size() < 200, line);
}

void TestInputs::presetsAreFoundByWords() {
    const Finished found = run({"presets", "--search", "t38 COUPLING"});
    QCOMPARE(found.exitCode, 0);
    QVERIFY2(found.out.contains("T38, 190 mm, worn") && !found.out.contains("T51"), found.out);
    QVERIFY2(!found.out.contains("rods, for"), found.out);
    QVERIFY(run({"presets", "--search", "rods fatigue 39"}).out.contains("T38, round 39 mm"));
    for (const char* kind : {"rock", "rocks"}) {
        const QByteArray rocks = run({"presets", kind}).out;
        QVERIFY2(rocks.contains("hard rock") && !rocks.contains("--rod"), rocks);
    }
    const Finished none = run({"presets", "--search", "T38 T51"});
    QCOMPARE(none.exitCode, 6);
    QVERIFY2(none.error.contains("no preset has all of \"T38 T51\"") && none.out.isEmpty(), none.error);
    QCOMPARE(run({"presets", "--search", ""}).out, run({"presets"}).out);
}

void TestInputs::presetsAreTakenByName() {
    const QString file = example("t38_medium_rock");
    const QJsonObject report = scenarioOf({file, "--rod", "T51", "--rock", "HARD rock", "--hammer",
                                           "heavy drifter, piston", "--set", "bit_rock.gamma=0.3"});
    const QString scenario = report["scenario"].toString();
    QVERIFY2(scenario.contains("diameter: 52 mm"), qPrintable(scenario));
    QVERIFY(scenario.contains("shape: piston"));
    QVERIFY(scenario.contains("gamma: 0.3"));
    QVERIFY(report["groups"] != scenarioOf({file})["groups"]);
    // A preset changes only the parameters that it lists.
    QVERIFY(scenarioOf({file, "--rock", "hard rock"})["scenario"].toString().contains("diameter: 38 mm"));
    QCOMPARE(run({"sweep", file, "--rod", "GT60", "--vary", "beta=1,2"}).exitCode, 0);
    QCOMPARE(run({"thrust", file, "--rock", "soft rock"}).exitCode, 0);
}

void TestInputs::presetsOfOnesOwnAreTaken() {
    const QTemporaryDir folder;
    const QString mine = folder.filePath("mine.yaml");
    write(mine,
          "drillwave_presets: 1\nrocks:\n  - name: my quarry\n    stiffness: [123 MN/m, fitted]\n"
          "    gamma: [0.2, fitted]\n");
    QVERIFY(run({"presets", mine}).out.contains("my quarry"));
    for (const char* piped :
         {"drillwave presets - < mine.yaml", "cat mine.yaml | drillwave presets /dev/stdin",
          "drillwave run t38_medium_rock --presets - --rock 'my quarry' < mine.yaml",
          "drillwave validate - < mine.yaml", "cat mine.yaml | drillwave validate /dev/stdin"}) {
        const Finished finished = shell(QLatin1String(piped), folder.path());
        QVERIFY2(finished.exitCode == 0, finished.error);
        QCOMPARE(finished.error, QByteArray());
    }
    const QJsonObject report =
        scenarioOf({example("t38_medium_rock"), "--presets", mine, "--rock", "my quarry"});
    QVERIFY(report["scenario"].toString().contains("stiffness: 123 MN/m"));
}

void TestInputs::anEmptyNameIsNoFileOfPresets() {
    for (const QStringList& words :
         {QStringList{"presets", ""},
          QStringList{"run", "t38_medium_rock", "--presets", "", "--rock", "hard rock"}}) {
        const Finished finished = run(words);
        QCOMPARE(finished.exitCode, 2);
        QVERIFY2(finished.error.contains("empty name"), finished.error);
        QCOMPARE(finished.out, QByteArray());
    }
}

void TestInputs::presetsAreValidatedAsPresets() {
    const QTemporaryDir folder;
    QCOMPARE(
        run({"validate", QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/presets/presets.yaml")}).exitCode,
        0);
    const QString bad = folder.filePath("bad.yaml");
    write(bad,
          "drillwave_presets: 1\nrocks:\n  - name: mine\n    stiffness: [123, fitted]\n    gamma: 0.2\n");
    const Finished finished = run({"validate", bad});
    QCOMPARE(finished.exitCode, 5);
    QCOMPARE(finished.error.count('\n'), 2);
    QVERIFY2(finished.error.startsWith(bad.toUtf8() + ":4:"), finished.error);
}

void TestInputs::noInputIsOverwritten_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("presets");
    const auto row = [](const char* words, const char* presets) {
        QTest::newRow(words) << QString(words) << QString(presets);
    };
    row("run FILE -o .", "summary.json");
    row("run FILE -o . --plots svg", "blow.svg");
    row("run FILE -o .", "scenario.yaml");
    row("sweep FILE --vary beta=1 -o mine.csv", "mine.csv");
    row("sweep FILE --vary beta=1 -o mine.csv", "mine.csv.yaml");
    row("sweep FILE --vary beta=1:2:3 -o mine.csv --plots svg", "mine.svg");
    row("sweep FILE --vary beta=1 -o mine.csv --resume", "mine.csv.yaml");
    row("table FILE cases.csv -o mine.csv", "mine.csv");
    row("curve FILE --along beta=1:2 -o mine.csv", "mine.csv");
    row("curve FILE --along beta=1:2 --goal 0.5 -o mine.csv", "mine_goal.csv");
    row("map FILE --x beta=1:2:2 --y gamma=0.1:1:2 -o mine.csv", "mine.csv");
    row("map FILE --x beta=1:2:2 --y gamma=0.1:1:2 --level 0.5 -o mine.csv", "mine_contours.csv");
    row("gap FILE -o mine.csv", "mine.csv");
    row("thrust FILE --along drill.blow_frequency=20Hz:40Hz:2 -o mine.csv", "mine.csv");
    row("drill FILE -o mine.csv", "mine.csv.yaml");
    row("drill FILE -o .", "summary.json");
    row("drill FILE --scan drill.thrust=3kN:4kN:2 -o mine.csv", "mine.csv");
    row("design FILE --choose rod.length=3m,4m --uncertain gamma=0.1:0.3 --aim max:efficiency@mean -o .",
        "best.yaml");
    row("accuracy FILE --segments 50,100 -o .", "accuracy.csv");
    row("report FILE -o mine.html", "mine.html");
    row("report FILE -o .", "report.pdf");
}

void TestInputs::noInputIsOverwritten() {
    QFETCH(QString, words);
    QFETCH(QString, presets);
    const QTemporaryDir folder;
    const QByteArray mine = read(QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/presets/presets.yaml"));
    QVERIFY(mine.size() > 1000);
    write(folder.filePath(presets), mine);
    write(folder.filePath("cases.csv"), "beta\n1\n");
    const QString line = "drillwave " + words.replace("FILE", example("t38_medium_rock")) +
                         " --rod T51 --presets " + presets + " --force";
    const Finished refused = shell(line, folder.path());
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("is also the input (" + presets.toUtf8() + ")"), refused.error);
    QVERIFY(read(folder.filePath(presets)) == mine);
}

void TestInputs::everyOptionThatReadsAFileIsAnInput() {
    // By what the help says of options that take a file and do not write one.
    QStringList found;
    for (const char* command : {"run", "sweep", "table", "curve", "map", "gap", "thrust", "accuracy", "drill",
                                "design", "report"}) {
        const QString help = QString::fromUtf8(output({"help", command}));
        static const QRegularExpression option("^ +--([a-z-]+) FILE", QRegularExpression::MultilineOption);
        for (auto match = option.globalMatch(help); match.hasNext();) {
            const QString name = match.next().captured(1);
            if (name != "gaps" && !found.contains(name)) found << name;
        }
    }
    QStringList inputs;
    for (const std::string_view name : drillwave::inputOptions)
        inputs << QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    found.sort();
    inputs.sort();
    QCOMPARE(found, inputs);
}

QTEST_GUILESS_MAIN(TestInputs)
#include "tst_inputs.moc"
