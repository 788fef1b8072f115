// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave sweep and table: rows in order, the same bytes from any number of threads and parts.
#include <QTest>

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QString referenceCases = QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/reference.csv");

}  // namespace

class TestRows : public QObject {
    Q_OBJECT

  private slots:
    void theReferenceCasesAgree_data();
    void theReferenceCasesAgree();
    void theReferenceWorkOnTheRockAgrees();
    void theBytesDoNotDependOnThreadsOrParts_data();
    void theBytesDoNotDependOnThreadsOrParts();
    void aFileGetsTheBytesOfStandardOutput();
    void existingFilesAreKeptWithoutForce();
    void aFullDiskLeavesTheFileBefore();
    void noInputIsOverwritten();
    void badCellsAreNamedBeforeAnythingIsWritten();
    void unknownColumnsAreWarnedOf();
    void unsolvedRowsAreWrittenEmptyAndExitCodeIsSix();
    void aSweepComparesPresetsOfRockAndHammer();
    void theWorkOfARowHasALimit();
    void anInterruptionLeavesNoFile();
    void aMillionPointsTakeNoMoreMemoryThanAFew();
};

void TestRows::theReferenceCasesAgree_data() {
    QTest::addColumn<QString>("output");
    QTest::addColumn<bool>("relative");
    QTest::addColumn<double>("tolerance");
    // 33-digit solution, each case agreed between two resolutions to 1e-15; tolerances are those the solver
    // promises.
    QTest::newRow("restitution") << "cor" << false << 1e-12;
    QTest::newRow("peak force") << "peak_force" << true << 1e-9;
    QTest::newRow("residual penetration") << "residual_penetration" << true << 1e-9;
    QTest::newRow("separation") << "separation_time" << true << 1e-9;
}

void TestRows::theReferenceCasesAgree() {
    QFETCH(QString, output);
    QFETCH(bool, relative);
    QFETCH(double, tolerance);
    const auto rows = rowsOf(
        drillwave::test::output({"table", example("paper_fig4a"), referenceCases, "--outputs", output}));
    QCOMPARE(rows.size(), 81);
    const qsizetype column = rows[0].indexOf(output.toUtf8());
    QCOMPARE(rows[0].last(), output.toUtf8());
    QVERIFY(column + 1 < rows[0].size());
    for (const auto& row : rows.mid(1)) {
        const double expected = row[column].toDouble();
        const double error = std::abs(row.last().toDouble() - expected);
        QVERIFY2(!row.last().isEmpty() && error <= tolerance * (relative ? std::abs(expected) : 1.0),
                 row.join(','));
    }
}

// The column of the reference is an energy in I0²/(Z t0); the output is a fraction of W, and W0 is 1/(2τ) in
// that unit.
void TestRows::theReferenceWorkOnTheRockAgrees() {
    const auto rows = rowsOf(
        output({"table", example("paper_fig4a"), referenceCases, "--outputs", "work_ratio,rock_work"}));
    const qsizetype energy = rows[0].indexOf("rock_work");
    const qsizetype tau = rows[0].indexOf("tau");
    for (const auto& row : rows.mid(1)) {
        const double work = row[row.size() - 2].toDouble() / (2 * row[tau].toDouble());
        QVERIFY2(std::abs(row.last().toDouble() * work - row[energy].toDouble()) <= 1e-11, row.join(','));
    }
}

void TestRows::theBytesDoNotDependOnThreadsOrParts_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("sweep of groups") << QStringList{"sweep", example("paper_fig4b"), "--vary",
                                                    "beta=0.1:9:41:log", "delta=0:1:53"};
    QTest::newRow("sweep of a drill") << QStringList{
        "sweep",     example("t38_medium_rock"),      "--vary", "pulse.shape=rectangular,half_sine",
        "--vary",    "rod.length=2m:7m:31",           "--vary", "drill.blow_frequency=40Hz:70Hz:20",
        "--outputs", "cor,peak_force,thrust,impulse", "--si"};
    QTest::newRow("table") << QStringList{"table", example("paper_fig4a"), referenceCases, "--outputs",
                                          "cor,cor_error,separation_time"};
}

void TestRows::theBytesDoNotDependOnThreadsOrParts() {
    QFETCH(QStringList, words);
    const QByteArray alone = output(words + QStringList{"-j", "1"});
    QVERIFY(alone.count('\n') > 80);
    for (const char* jobs : {"2", "4"}) QVERIFY(output(words + QStringList{"-j", jobs}) == alone);
    QVERIFY(output(words) == alone);
    QByteArray parts;
    for (const char* part : {"1/3", "2/3", "3/3"})
        parts += output(words + QStringList{"--shard", part, "-j2"});
    QVERIFY(parts == alone);
}

void TestRows::aFileGetsTheBytesOfStandardOutput() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("out.csv");
    const QStringList words{"sweep", example("paper_fig4a"), "--vary=beta=1:2:5", "--outputs=cor,impulse"};
    QCOMPARE(output(words + QStringList{"-o", path}), QByteArray());
    QVERIFY(read(path) == output(words));
    QVERIFY(read(path) == output(words + QStringList{"-o", "-"}));
    QVERIFY(read(path).startsWith("beta,cor,impulse\n1,1.3"));
}

void TestRows::existingFilesAreKeptWithoutForce() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("out.csv");
    write(path, "precious");
    const QStringList words{"sweep", example("paper_fig4a"), "--vary", "beta=1,2", "-o", path};
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QVERIFY(refused.error.contains("--force"));
    QCOMPARE(read(path), QByteArray("precious"));
    QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
    QVERIFY(read(path).startsWith("beta,cor\n"));
}

// The last bytes of a small file are written when it is closed: that they found no room must not be missed.
// The limit on the size of files stands for the end of the disk.
void TestRows::aFullDiskLeavesTheFileBefore() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("rows.csv");
    write(out, "the file before");
    QProcess shell;
    const QString command = QStringLiteral("ulimit -f 1; exec %1 sweep %2 --vary beta=1:2:200 --force -o %3")
                                .arg(QStringLiteral(DRILLWAVE_PROGRAM), example("paper_fig4b"), out);
    shell.start("sh", {"-c", command});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(shell.exitCode(), 4);
    QVERIFY(shell.readAllStandardError().contains("rows.csv: cannot be written"));
    QCOMPARE(read(out), QByteArray("the file before"));
}

void TestRows::noInputIsOverwritten() {
    const QTemporaryDir folder;
    const QString cases = folder.filePath("cases.csv");
    const QString blow = folder.filePath("blow.csv");
    const QString scenario = folder.filePath("case.yaml");
    const QString link = folder.filePath("link.csv");
    write(cases, "beta\n0.5\n");
    write(blow, "time,force\n0,0\n1,1\n2,0\n");
    write(scenario,
          "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\n"
          "pulse: {shape: table, file: blow.csv}\n");
    QVERIFY(QFile::link(cases, link));
    const QStringList table{"table", scenario, cases};
    const QStringList sweep{"sweep", scenario, "--vary", "beta=1,2"};
    const QList<QPair<QStringList, QString>> overwritten{{table, cases},
                                                         {table, link},
                                                         {table, scenario},
                                                         {table, blow},
                                                         {sweep, blow},
                                                         {sweep, scenario},
                                                         {{"gap", scenario}, scenario}};
    for (const auto& [words, output] : overwritten) {
        const QByteArray before = read(output);
        const Finished refused = run(words + QStringList{"-o", output, "--force"});
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.error.contains("is also the input"), refused.error);
        QCOMPARE(read(output), before);
    }
    QCOMPARE(run(table + QStringList{"-o", folder.filePath("rows.csv")}).exitCode, 0);
}

void TestRows::badCellsAreNamedBeforeAnythingIsWritten() {
    const QTemporaryDir folder;
    const QString cases = folder.filePath("cases.csv");
    write(cases, "beta,gamma\n1,0.5\nx,0.5\n1,7\n");
    const QString out = folder.filePath("out.csv");
    const Finished finished = run({"table", example("paper_fig4a"), cases, "-o", out});
    QCOMPARE(finished.exitCode, 5);
    const QStringList lines = QString::fromUtf8(finished.error).trimmed().split('\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines[0].startsWith(cases + ":3:1: beta = x"));
    QVERIFY(lines[1].startsWith(cases + ":4:2: gamma = 7 (must be in (0, 1])"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"cases.csv"});
}

void TestRows::unknownColumnsAreWarnedOf() {
    const QTemporaryDir folder;
    const QString cases = folder.filePath("cases.csv");
    write(cases, "beta,gama,cor\n1,0.5,\n");
    const Finished finished = run({"table", example("paper_fig4a"), cases});
    QCOMPARE(finished.exitCode, 0);
    QCOMPARE(finished.error.count('\n'), 2);
    QVERIFY(finished.error.contains("did you mean `gamma`?"));
    QVERIFY(finished.error.contains("`cor` is passed through unchanged"));
    QVERIFY(finished.out.startsWith("beta,gama,cor,cor\n1,0.5,,1.3"));
}

void TestRows::aSweepComparesPresetsOfRockAndHammer() {
    const QString rod = example("t38_medium_rock");
    const auto rocks = rowsOf(run({"sweep", rod, "--vary", "rock=all", "-j1"}).out);
    QVERIFY(rocks.size() > 4);
    QCOMPARE(rocks[0], QList<QByteArray>({"rock", "cor"}));
    for (qsizetype row = 1; row < rocks.size(); ++row) {
        const Finished same = run({"run", rod, "--rock", rocks[row][0], "--json"});
        QVERIFY2(same.out.contains("\"cor\": " + rocks[row][1].left(12)), same.out);
    }
    // Names with commas are one cell.
    const Finished hammers = run({"sweep", example("t38_string"), "--vary", "hammer=T38 drifter,R32", "-j1"});
    QVERIFY2(hammers.out.contains("\n\"T38 drifter, 50 and 38 mm\","), hammers.out);
    // A preset needs units; other commands name the one that takes presets.
    QCOMPARE(run({"sweep", example("paper_fig4a"), "--vary", "rock=all"}).exitCode, 5);
    const Finished curve = run({"curve", rod, "--along", "rock=all"});
    QCOMPARE(curve.exitCode, 2);
    QVERIFY2(curve.error.contains("`sweep --vary rock=all` compares them"), curve.error);
    QCOMPARE(run({"design", example("piston_for_unknown_rock"), "--choose", "rock=all"}).exitCode, 2);
}

void TestRows::unsolvedRowsAreWrittenEmptyAndExitCodeIsSix() {
    const Finished finished = run({"sweep", example("paper_fig4a"), "--vary", "beta=1,1e-300,2", "-j1"});
    QCOMPARE(finished.exitCode, 6);
    QVERIFY2(
        finished.error.contains("1 of 3 rows could not be solved: their output cells are empty; 1 row: its "
                                "waves have more polynomial pieces than the work limit permits"),
        finished.error);
    QVERIFY2(finished.error.contains("--work-limit, now 1000000, permits more"), finished.error);
    QCOMPARE(finished.error.count('\n'), 1);
    const auto rows = rowsOf(finished.out);
    QCOMPARE(rows.size(), 4);
    QCOMPARE(rows[2], QList<QByteArray>({"1e-300", ""}));
    QVERIFY(!rows[3][1].isEmpty());
}

// A limit of pieces, not of seconds: the same cells are empty on every machine.
void TestRows::theWorkOfARowHasALimit() {
    const QStringList words{"sweep", example("paper_fig4b"), "--vary", "beta=0.5,1e-7", "-j1"};
    const auto whole = rowsOf(output(words));
    QVERIFY(!whole[1][1].isEmpty() && !whole[2][1].isEmpty());
    const Finished limited = run(words + QStringList{"--work-limit", "10000"});
    QCOMPARE(limited.exitCode, 6);
    QVERIFY2(limited.error.contains("--work-limit, now 10000,"), limited.error);
    const auto rows = rowsOf(limited.out);
    QCOMPARE(rows[1], whole[1]);
    QVERIFY(rows[2][1].isEmpty());
    QCOMPARE(run(words + QStringList{"--work-limit", "0"}).exitCode, 2);
    QCOMPARE(run(words + QStringList{"--work-limit", "30000001"}).exitCode, 2);
}

void TestRows::anInterruptionLeavesNoFile() {
    const QTemporaryDir folder;
    QProcess process;
    process.start(QStringLiteral(DRILLWAVE_PROGRAM),
                  {"sweep", example("paper_fig4a"), "--vary", "beta=0.1:10:1000000", "delta=0:1:100000",
                   "-j2", "-o", folder.filePath("out.csv")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForThreads(process, 4));  // with two workers
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QCOMPARE(process.readAllStandardError().count('\n'), 1);
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TestRows::aMillionPointsTakeNoMoreMemoryThanAFew() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("sanitizers keep freed memory");
#endif
    const auto peak = [](const char* beta) {
        QProcess process;
        process.start(
            "/bin/sh",
            {"-c", QString("\"%1\" sweep \"%2\" --vary %3 delta=0:1:1000 -j2 -o /dev/null & pid=$!; "
                           "while kill -0 $pid 2>/dev/null; do "
                           "grep VmHWM /proc/$pid/status 2>/dev/null; sleep 0.02; done; wait $pid")
                       .arg(QStringLiteral(DRILLWAVE_PROGRAM), example("paper_fig4a"), beta)});
        process.waitForFinished(120000);
        double most = 0;
        for (const QByteArray& line : process.readAllStandardOutput().split('\n'))
            most = std::max(most, line.simplified().split(' ').value(1).toDouble());
        return process.exitCode() == 0 ? most : -1;
    };
    const double few = peak("beta=0.1:10:100");
    const double many = peak("beta=0.1:10:1000");
    QVERIFY2(few > 0 && many > 0, "no measurement");
    // VmHWM in kB; the allocator's arenas vary by some hundred.
    QVERIFY2(many < few + 2000, qPrintable(QString("%1 kB, then %2 kB").arg(few).arg(many)));
}

QTEST_GUILESS_MAIN(TestRows)
#include "tst_rows.moc"
