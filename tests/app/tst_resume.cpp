// SPDX-License-Identifier: GPL-3.0-or-later
// `--resume`: a run of rows that is ended at any moment goes on to the bytes of the run in one piece.
#include <QTest>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>
#include <random>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QString program = QStringLiteral(DRILLWAVE_PROGRAM);

/// Takes some seconds on one thread.
QStringList longSweep() {
    return {"sweep",
            example("paper_fig4b"),
            "--vary",
            "beta=0.1:10:200:log",
            "gamma=0.1:1:500",
            "--outputs",
            "cor,peak_force",
            "-j",
            "1"};
}

}  // namespace

class TestResume : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_place = std::make_unique<QTemporaryDir>(); }
    void anEndedRunGoesOn_data();
    void anEndedRunGoesOn();
    void anInterruptionSaysWhereTheRowsAre();
    void rowsOfAnotherRunAreNotGoneOnWith();
    void damagedRowsAreMadeAnew();
    void twoRunsNeverWriteTheSameRows();
    void rowsThatAreThereAreLeft();
    void itNeedsAFileAndRowsAlone_data();
    void itNeedsAFileAndRowsAlone();
    void hoursOfWorkAreAnnounced();
    void rowsThatNoDiskHoldsAreRefused();

  private:
    QString path(const QString& name) const { return m_place->filePath(name); }
    QStringList resumed(const QStringList& words) const {
        return words + QStringList{"--resume", "-o", path("rows.csv")};
    }
    /// Whether some rows are kept.
    bool hasRows() const {
        QFile notes(path("rows.csv.partial.yaml"));
        return notes.open(QIODevice::ReadOnly) && notes.readAll().contains("\n  - [");
    }
    /// Starts a run and ends it once rows are kept; false where it came to its end before.
    bool leaveRows(const QStringList& words, int signal = SIGKILL) const;
    std::unique_ptr<QTemporaryDir> m_place;
};

bool TestResume::leaveRows(const QStringList& words, int signal) const {
    QProcess process;
    process.start(program, resumed(words));
    while (process.state() != QProcess::NotRunning && !hasRows()) process.waitForFinished(5);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    process.waitForFinished();
    return hasRows();
}

void TestResume::anEndedRunGoesOn_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("sweep") << longSweep();
    QTest::newRow("part") << (longSweep() << "--shard"
                                          << "2/2");
    QTest::newRow("map") << QStringList{"map", example("paper_fig4b"), "--x", "beta=0.1:10:200:log",
                                        "--y", "gamma=0.1:1:300",      "-j",  "1"};
    QTest::newRow("table") << QStringList{"table", example("paper_fig4b"), "CASES", "-j", "1"};
}

void TestResume::anEndedRunGoesOn() {
    QFETCH(QStringList, words);
    QByteArray cases = "beta,remark\n";
    for (int i = 1; i <= 60000; ++i) cases += QByteArray::number(i * 1e-3) + ",\"two\nlines\"\n";
    write(path("cases.csv"), cases);
    words.replaceInStrings("CASES", path("cases.csv"));
    output(words + QStringList{"-o", path("whole.csv")});
    std::mt19937 random(55);
    int ended = 0;
    for (int round = 0; round < 4; ++round) {
        QProcess process;
        process.start(program, resumed(words));
        if (!process.waitForFinished(static_cast<int>(20 + random() % 300))) ++ended;
        process.kill();
        process.waitForFinished();
    }
    QVERIFY(ended > 0);
    const Finished finished = run(resumed(words));
    QVERIFY2(finished.exitCode == 0, finished.error);
    QVERIFY(read(path("rows.csv")) == read(path("whole.csv")));
    QCOMPARE(read(path("rows.csv.yaml")), read(path("whole.csv.yaml")));
    QCOMPARE(QDir(m_place->path()).entryList({"*partial*"}), QStringList());
}

void TestResume::anInterruptionSaysWhereTheRowsAre() {
    QProcess process;
    process.start(program, resumed(longSweep()));
    while (!hasRows()) process.waitForFinished(5);
    process.terminate();
    process.waitForFinished();
    QCOMPARE(process.exitCode(), 130);
    const QByteArray error = process.readAllStandardError();
    QVERIFY2(error.contains("of 100000 rows are kept in ") && error.contains("rows.csv.partial"), error);
    QVERIFY(!QFile::exists(path("rows.csv")));
}

void TestResume::rowsOfAnotherRunAreNotGoneOnWith() {
    QVERIFY(leaveRows(longSweep()));
    const QByteArray before = read(path("rows.csv.partial"));
    const Finished refused = run(resumed(longSweep() + QStringList{"--set", "delta=0.5"}));
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.error.contains("rows.csv.partial.yaml: belongs to another run"), refused.error);
    QVERIFY(read(path("rows.csv.partial")) == before);
}

void TestResume::damagedRowsAreMadeAnew() {
    output(longSweep() + QStringList{"-o", path("whole.csv")});
    QVERIFY(leaveRows(longSweep()));
    QByteArray rows = read(path("rows.csv.partial"));
    rows[rows.size() / 3] = 'x';
    write(path("rows.csv.partial"), rows);
    output(resumed(longSweep()));
    QVERIFY(read(path("rows.csv")) == read(path("whole.csv")));
}

void TestResume::twoRunsNeverWriteTheSameRows() {
    QProcess process;
    process.start(program, resumed(longSweep()));
    while (!hasRows()) process.waitForFinished(5);
    const Finished refused = run(resumed(longSweep()));
    process.kill();
    process.waitForFinished();
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.error.contains("another process writes these rows"), refused.error);
}

void TestResume::rowsThatAreThereAreLeft() {
    const QStringList some = {"sweep", example("paper_fig4b"), "--vary", "beta=1,1e-300"};
    QCOMPARE(run(resumed(some)).exitCode, 6);
    const QByteArray rows = read(path("rows.csv"));
    const Finished again = run(resumed(some));
    QCOMPARE(again.exitCode, 6);
    QVERIFY2(again.error.contains("has all of these rows already") &&
                 again.error.contains("1 of 2 rows could not be solved"),
             again.error);
    QVERIFY(read(path("rows.csv")) == rows);
    QCOMPARE(run(resumed(some + QStringList{"--outputs", "impulse"})).exitCode, 4);
    QVERIFY(read(path("rows.csv")) == rows);
}

void TestResume::itNeedsAFileAndRowsAlone_data() {
    QTest::addColumn<QStringList>("more");
    QTest::newRow("no file") << QStringList{};
    QTest::newRow("standard output") << QStringList{"-o", "-"};
    QTest::newRow("plots") << QStringList{"-o", "rows.csv", "--plots", "svg"};
    QTest::newRow("contours") << QStringList{"-o", "rows.csv", "--level", "0.5"};
}

void TestResume::itNeedsAFileAndRowsAlone() {
    QFETCH(QStringList, more);
    const Finished refused = run(
        QStringList{"map", example("paper_fig4b"), "--x", "beta=1:2:3", "--y", "gamma=0.1:1:3", "--resume"} +
        more);
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("--resume"), refused.error);
}

void TestResume::hoursOfWorkAreAnnounced() {
    QProcess process;
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(program,
                  {"sweep", example("paper_fig4b"), "--vary", "beta=0.1:10:100000", "delta=0:1:1000000"});
    QByteArray error;
    process.setReadChannel(QProcess::StandardError);
    while (!error.contains('\n') && process.waitForReadyRead(60000)) error += process.readAllStandardError();
    process.kill();
    process.waitForFinished();
    QVERIFY2(error.startsWith("100000000000 rows take about ") && error.contains("--resume") &&
                 error.contains("--shard"),
             error);
}

void TestResume::rowsThatNoDiskHoldsAreRefused() {
    const Finished refused = run({"sweep", example("paper_fig4b"), "--vary", "beta=0.1:10:1000000",
                                  "delta=0:1:1000000", "-o", path("rows.csv")});
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(
        refused.error.contains("1000000000000 rows take about") && refused.error.contains("the disk has"),
        refused.error);
    QCOMPARE(QDir(m_place->path()).entryList(QDir::Files | QDir::Hidden), QStringList());
}

QTEST_GUILESS_MAIN(TestResume)
#include "tst_resume.moc"
