// SPDX-License-Identifier: GPL-3.0-or-later
// Folders that commands write: whole or not at all, whoever else writes there and whenever they are stopped.
#include <QTest>

#include <QDir>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>
#include <memory>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/tries.h"

using namespace drillwave::test;

namespace {

constexpr int concurrentRuns = 6, rounds = 2;

const QStringList filesOfARun{"events.csv", "histories.csv", "scenario.yaml", "summary.json"};

QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

/// The gamma of a scenario file, or of the scenario at the top of a CSV file.
double gammaOf(const QString& path) {
    const auto found = QRegularExpression("gamma: ([0-9.]+)").match(QString::fromUtf8(read(path)));
    return found.captured(1).toDouble();
}

/// The gamma that all files of a run agree on; NaN where they do not.
double commonGamma(const QString& folder) {
    const QJsonObject summary = QJsonDocument::fromJson(read(folder + "/summary.json")).object();
    const double gamma = summary["groups"].toObject()["gamma"].toDouble();
    return gamma == gammaOf(folder + "/histories.csv") && gamma == gammaOf(folder + "/events.csv") &&
                   gamma == gammaOf(folder + "/scenario.yaml")
               ? gamma
               : std::nan("");
}

/// Runs of different scenarios into one folder at once; their exit codes.
QList<int> runTogether(const QString& folder, const QStringList& more) {
    std::vector<std::unique_ptr<QProcess>> runs;
    for (int i = 0; i < concurrentRuns; ++i) {
        runs.push_back(std::make_unique<QProcess>());
        const QStringList words{
            "run", example("t38_medium_rock"), "--set", QString("gamma=0.%1").arg(i + 1), "-o", folder};
        runs.back()->start(QStringLiteral(DRILLWAVE_PROGRAM), words + more);
    }
    QList<int> codes;
    for (const auto& one : runs) {
        if (!one->waitForFinished(60000)) qFatal("a run does not end");
        codes << one->exitCode();
    }
    return codes;
}

}  // namespace

class TestFolders : public QObject {
    Q_OBJECT

  private slots:
    void oneOfSixRunsSucceeds();
    void sixForcedRunsNeverMix();
    void aSignalLeavesAllOrNothing_data();
    void aSignalLeavesAllOrNothing();
    void aSignalDuringAStudyLeavesNoFolder_data();
    void aSignalDuringAStudyLeavesNoFolder();
    void aFullDiskLeavesNothing();
    void reasonsAreNamed_data();
    void reasonsAreNamed();
    void aFailedExportKeepsTheFolderAsItWas();
};

void TestFolders::oneOfSixRunsSucceeds() {
    const QTemporaryDir place;
    for (int round = 0; round < rounds; ++round) {
        const QString folder = place.filePath(QString("new/%1").arg(round));
        const QList<int> codes = runTogether(folder, {});
        QCOMPARE(codes.count(0), 1);
        QCOMPARE(codes.count(4), concurrentRuns - 1);
        QCOMPARE(commonGamma(folder), (int(codes.indexOf(0)) + 1) / 10.0);
        QCOMPARE(contents(folder), filesOfARun);
        QCOMPARE(contents(place.filePath("new")).size(), round + 1);
    }
}

void TestFolders::sixForcedRunsNeverMix() {
    const QTemporaryDir place;
    write(place.filePath("notes.txt"), "mine");
    for (int round = 0; round < rounds; ++round) {
        QCOMPARE(runTogether(place.path(), {"--force"}).count(0), concurrentRuns);
        QVERIFY(commonGamma(place.path()) > 0);
        QCOMPARE(contents(place.path()),
                 QStringList({"events.csv", "histories.csv", "notes.txt", "scenario.yaml", "summary.json"}));
    }
    QCOMPARE(read(place.filePath("notes.txt")), QByteArray("mine"));
}

void TestFolders::aSignalLeavesAllOrNothing_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("replaces");
    QTest::newRow("SIGINT, new folder") << SIGINT << false;
    QTest::newRow("SIGTERM, new folder") << SIGTERM << false;
    QTest::newRow("SIGHUP, new folder") << SIGHUP << false;
    QTest::newRow("SIGINT, folder of a run before") << SIGINT << true;
    QTest::newRow("SIGTERM, folder of a run before") << SIGTERM << true;
}

void TestFolders::aSignalLeavesAllOrNothing() {
    QFETCH(int, signal);
    QFETCH(bool, replaces);
    const QStringList words{
        "run", example("t38_medium_rock"), "--set", "gamma=0.7", "--plots", "png,svg,pdf", "--force"};
    const QTemporaryDir place;
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(run(words + QStringList{"-o", place.filePath("whole")}).exitCode, 0);
    const QStringList all = contents(place.filePath("whole"));
    QCOMPARE(all.size(), 16);
    const qint64 whole = timer.nsecsElapsed();

    constexpr int moments = 6;
    int interrupted = 0;
    for (int i = 1; i < moments; ++i) {
        if (!isChosen(i, 5)) continue;
        const QString folder = place.filePath(QString("%1/out").arg(i));
        if (replaces) {
            QCOMPARE(run({"run", example("t38_medium_rock"), "--set", "gamma=0.3", "-o", folder}).exitCode,
                     0);
            write(folder + "/notes.txt", "mine");
        }
        QProcess process;
        process.start(QStringLiteral(DRILLWAVE_PROGRAM), words + QStringList{"-o", folder});
        QVERIFY(process.waitForStarted());
        QTest::qSleep(static_cast<int>(whole * i / moments / 1'000'000));
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(60000));
        const bool byItself = process.exitStatus() == QProcess::NormalExit;
        const bool done = byItself && process.exitCode() == 0;
        // While the program is being loaded, nothing of it is there yet to catch a signal.
        if (byItself && !done) {
            QCOMPARE(process.exitCode(), 130);
            QCOMPARE(process.readAllStandardError().count('\n'), 1);
            ++interrupted;
        }
        if (replaces) {
            QStringList expected = done ? all : filesOfARun;
            expected << "notes.txt";
            expected.sort();
            QCOMPARE(contents(folder), expected);
            QCOMPARE(commonGamma(folder), done ? 0.7 : 0.3);
        } else {
            QCOMPARE(contents(folder), done ? all : QStringList());
            QCOMPARE(QFileInfo::exists(place.filePath(QString::number(i))), done);
        }
    }
    // a single moment may be before the program listens
    if (isNightly()) QVERIFY2(interrupted >= moments / 4, qPrintable(QString::number(interrupted)));
}

void TestFolders::aSignalDuringAStudyLeavesNoFolder_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("run") << QStringList{"run",      example("paper_fig4a"), "--set", "beta=1e-12", "--set",
                                        "gamma=0.1"};
    QTest::newRow("accuracy") << QStringList{"accuracy", example("paper_fig4a")};
    QTest::newRow("stability") << QStringList{"stability"};
}

void TestFolders::aSignalDuringAStudyLeavesNoFolder() {
    QFETCH(QStringList, words);
    const QTemporaryDir place;
    QProcess process;
    process.start(QStringLiteral(DRILLWAVE_PROGRAM), words + QStringList{"-o", place.filePath("new/out")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForThreads(process, 2));
    ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
    QVERIFY(process.waitForFinished(60000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    const QByteArray error = process.readAllStandardError();
    QVERIFY2(error.contains("interrupted; no output was left behind"), error);
    QCOMPARE(contents(place.path()), QStringList());
}

// The limit on the size of files stands for the end of the disk.
void TestFolders::aFullDiskLeavesNothing() {
    const QTemporaryDir place;
    QProcess shell;
    const QString command =
        QStringLiteral("ulimit -f 8; exec %1 run %2 -o %3")
            .arg(QStringLiteral(DRILLWAVE_PROGRAM), example("t38_medium_rock"), place.filePath("new/out"));
    shell.start("sh", {"-c", command});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(shell.exitCode(), 4);
    const QByteArray error = shell.readAllStandardError();
    QVERIFY2(error.contains("new/out/histories.csv: cannot be written: File too large"), error);
    QCOMPARE(contents(place.path()), QStringList());
}

void TestFolders::reasonsAreNamed_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("part");
    const QString paper = example("paper_fig4a");
    QTest::newRow("a file in place of the folder")
        << QStringList{"run", paper, "-o", "FILE"} << 4 << "FILE: the folder cannot be made: Not a directory";
    QTest::newRow("a file above the folder")
        << QStringList{"accuracy", paper, "-o", "FILE/x"} << 4 << "cannot be made: Not a directory";
    for (const char* command : {"run", "accuracy", "gap"})
        QTest::newRow(qPrintable(QString("%1 into no name").arg(command)))
            << QStringList{command, paper, "-o", ""} << 2 << "-o needs a name";
    QTest::newRow("a folder that does not exist")
        << QStringList{"sweep", paper, "--vary", "beta=1,2", "-o", "nodir/x.csv"} << 4
        << "nodir/x.csv: cannot be written: No such file or directory; choose another place";
}

void TestFolders::reasonsAreNamed() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, part);
    const QTemporaryDir place;
    write(place.filePath("FILE"), "mine");
    words.replaceInStrings("FILE", place.filePath("FILE"));
    part.replace("FILE", place.filePath("FILE"));
    const Finished finished = run(words);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(QString::fromUtf8(finished.error).contains(part), finished.error);
    QVERIFY2(!finished.error.contains("free some space"), finished.error);
    QCOMPARE(finished.error.count('\n'), 1);
    QCOMPARE(contents(place.path()), QStringList{"FILE"});
}

void TestFolders::aFailedExportKeepsTheFolderAsItWas() {
    const QTemporaryDir place;
    const QString folder = place.filePath("out");
    const QStringList words{"figures", "-o", folder, "--force"};
    QCOMPARE(run(words).exitCode, 0);
    const QStringList before = contents(folder);
    QVERIFY(QFile::remove(folder + "/index.html"));
    QVERIFY(QDir(folder).mkpath("index.html/precious"));
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QCOMPARE(contents(folder), before);
    QVERIFY(QFileInfo::exists(folder + "/index.html/precious"));
}

QTEST_GUILESS_MAIN(TestFolders)
#include "tst_folders.moc"
