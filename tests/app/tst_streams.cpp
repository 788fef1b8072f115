// SPDX-License-Identifier: GPL-3.0-or-later
// Streams, devices, limits and signals around a command: what it cannot write it says before the work, in a
// line.
#include <QTest>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QStringList contents(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
}

/// Whether a started process catches or holds SIGINT by now.
bool answersSignals(const QProcess& process) {
    QFile status(QStringLiteral("/proc/%1/status").arg(process.processId()));
    if (!status.open(QIODevice::ReadOnly)) return false;
    for (const QByteArray& line : status.readAll().split('\n'))
        if ((line.startsWith("SigCgt:") || line.startsWith("SigBlk:")) &&
            line.mid(7).trimmed().toULongLong(nullptr, 16) & 1u << (SIGINT - 1))
            return true;
    return false;
}

}  // namespace

class TestStreams : public QObject {
    Q_OBJECT

  private slots:
    void aClosedOutputIsToldBeforeTheWork_data();
    void aClosedOutputIsToldBeforeTheWork();
    void rowsForAFileNeedNoOutput();
    void aReportGoesToADevice();
    void onlyOneThingIsPrinted();
    void aFileIsNoFolder();
    void theRightPresetsAreNamed();
    void tooLittleMemoryIsNoFaultOfTheProgram();
    void withoutFurtherThreadsTheWorkIsDone();
    void tooFewFilesAreAnOutputThatCannotBeWritten();
    void drawingLeavesNothingInTheTemporaryFolder();
    void aSignalIsAnsweredWhileTheDrawingProgramIsLoaded();
};

void TestStreams::aClosedOutputIsToldBeforeTheWork_data() {
    QTest::addColumn<QString>("line");
    const QString drill = example("t38_medium_rock");
    QTest::newRow("run") << "drillwave run " + drill + " -o out";
    QTest::newRow("curve") << "drillwave curve " + drill + " --along gamma=0.1:1 -o out.csv";
    QTest::newRow("map") << "drillwave map " + drill + " --x gamma=0.1:1:3 --y beta=1:2:3 -o out.csv";
    QTest::newRow("gap") << "drillwave gap " + drill + " -o out.csv";
    QTest::newRow("sweep") << "drillwave sweep " + drill + " --vary gamma=0.1,0.2";
    QTest::newRow("presets") << QStringLiteral("drillwave presets");
}

// The next file that is opened would get what is printed.
void TestStreams::aClosedOutputIsToldBeforeTheWork() {
    QFETCH(QString, line);
    const QTemporaryDir place;
    const Finished finished = shell(line + " >&-", place.path());
    QCOMPARE(finished.exitCode, 4);
    QVERIFY2(finished.error.contains("standard output: is closed"), finished.error);
    QCOMPARE(finished.error.count('\n'), 1);
    QCOMPARE(contents(place.path()), QStringList());
}

void TestStreams::rowsForAFileNeedNoOutput() {
    const QTemporaryDir place;
    const QString sweep = "drillwave sweep " + example("t38_medium_rock") + " --vary gamma=0.1,0.2 -o ";
    QCOMPARE(shell(sweep + "x.csv", place.path()).exitCode, 0);
    QCOMPARE(shell(sweep + "y.csv <&- >&- 2>&-", place.path()).exitCode, 0);
    QVERIFY(read(place.filePath("x.csv")) == read(place.filePath("y.csv")));
}

void TestStreams::aReportGoesToADevice() {
    const QTemporaryDir place;
    const QString report = "drillwave report " + example("t38_medium_rock") + " -o ";
    const Finished printed = shell(report + "-", place.path());
    QCOMPARE(printed.exitCode, 0);
    QVERIFY(printed.out.startsWith("<!DOCTYPE html>"));
    QVERIFY(shell(report + "/dev/stdout", place.path()).out == printed.out);
    QVERIFY(shell(report + "/dev/stdout > file; cat file", place.path()).out == printed.out);
    const Finished nowhere = shell(report + "/dev/null", place.path());
    QCOMPARE(nowhere.exitCode, 0);
    QCOMPARE(nowhere.out, QByteArray());
    QCOMPARE(contents(place.path()), QStringList{"file"});
}

void TestStreams::onlyOneThingIsPrinted() {
    for (const QStringList& command : {QStringList{"gap", example("t38_medium_rock")},
                                       {"accuracy", example("paper_fig4a")},
                                       {"stability"}}) {
        const Finished both = run(command + QStringList{"--json", "-o", "-"});
        QCOMPARE(both.exitCode, 2);
        QVERIFY2(both.error.contains("--json and -o - would both print"), both.error);
    }
}

void TestStreams::aFileIsNoFolder() {
    const QTemporaryDir place;
    const Finished refused =
        run({"sweep", example("t38_medium_rock"), "--vary", "gamma=0.1,0.2", "-o", place.filePath("x/")});
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.error.contains("x/: is a folder; give the name of a file"), refused.error);
}

void TestStreams::theRightPresetsAreNamed() {
    const QTemporaryDir place;
    const QStringList words{"run", example("t38_medium_rock"), "--rod", "xyz"};
    QVERIFY(run(words).error.contains("`drillwave presets` lists them"));
    write(place.filePath("p.yaml"), read(DRILLWAVE_SOURCE_DIR "/resources/presets/presets.yaml"));
    const Finished own = run(words + QStringList{"--presets", place.filePath("p.yaml")});
    QCOMPARE(own.exitCode, 2);
    QVERIFY2(own.error.contains("`drillwave presets " + place.filePath("p.yaml").toUtf8() + "` lists them"),
             own.error);
}

void TestStreams::tooLittleMemoryIsNoFaultOfTheProgram() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("sanitizers reserve more addresses than the limit");
#endif
    // Files hold the histories, which keep every piece of wave.
    const QTemporaryDir place;
    const Finished finished = shell("ulimit -v 60000; drillwave run " + example("t38_medium_rock") +
                                    " --set pulse.duration=20s --work-limit 30000000 -o " +
                                    place.filePath("x") + " 2>&1 | tail -n 1");
    QVERIFY2(finished.out.contains("out of memory: this needs more than is free"), finished.out);
    QVERIFY2(!finished.out.contains("please report"), finished.out);
}

void TestStreams::withoutFurtherThreadsTheWorkIsDone() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("sanitizers reserve more addresses than the limit");
#endif
    // The stack of a thread, as large as the limit of it, does not fit in the addresses.
    const QString limits = "ulimit -s 4000000 && ulimit -v 2000000 && ";
    for (const QString& line :
         {"drillwave sweep " + example("t38_medium_rock") + " --vary gamma=0.1,0.2 -j 2",
          "drillwave drill " + example("t38_medium_rock") +
              " --set drill.blow_frequency=50Hz drill.thrust=8kN --blows 30 --settle 10 --cells 10 -j 2"}) {
        const Finished few = shell(limits + line), usual = shell(line);
        QCOMPARE(few.error, usual.error);
        QCOMPARE(few.out, usual.out);
        QCOMPARE(few.exitCode, usual.exitCode);
    }
}

void TestStreams::tooFewFilesAreAnOutputThatCannotBeWritten() {
#if defined(__SANITIZE_ADDRESS__)
    QSKIP("the sanitizer of undefined behaviour opens a pipe to look at an object");
#endif
    const QTemporaryDir place;
    for (const QString& line : {"sweep " + example("t38_medium_rock") + " --vary gamma=0.1,0.2 -o x.csv",
                                "run " + example("t38_medium_rock") + " -o x",
                                "report " + example("t38_medium_rock") + " -o x.html"}) {
        const Finished finished = shell("ulimit -n 5; drillwave " + line, place.path());
        QVERIFY2(finished.exitCode == 4, qPrintable(line + ": " + finished.error));
        QVERIFY2(finished.error.contains("Too many open files"), finished.error);
        QCOMPARE(contents(place.path()), QStringList());
    }
}

void TestStreams::drawingLeavesNothingInTheTemporaryFolder() {
    const QTemporaryDir place, temporary;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("XDG_RUNTIME_DIR");
    environment.insert("TMPDIR", temporary.path());
    QCOMPARE(run({"report", example("t38_medium_rock"), "-o", place.filePath("x")}, environment).exitCode, 0);
    QCOMPARE(contents(temporary.path()), QStringList());
}

void TestStreams::aSignalIsAnsweredWhileTheDrawingProgramIsLoaded() {
    const QTemporaryDir place;
    int interrupted = 0;
    for (int milliseconds = 0; milliseconds < 30; ++milliseconds) {
        QProcess process;
        process.start(QStringLiteral(DRILLWAVE_PROGRAM), {"report", example("t38_medium_rock"), "-o",
                                                          place.filePath(QString::number(milliseconds))});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY(answersSignals(process));
        QTest::qSleep(milliseconds + 1);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QVERIFY(process.exitCode() == 130 || process.exitCode() == 0);
        interrupted += process.exitCode() == 130;
    }
    QVERIFY(interrupted > 0);
}

QTEST_GUILESS_MAIN(TestStreams)
#include "tst_streams.moc"
