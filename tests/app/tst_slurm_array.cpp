// SPDX-License-Identifier: GPL-3.0-or-later
// packaging/slurm/parts.sbatch as Slurm would run its tasks.
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QStringList sweep{"sweep",        example("paper_fig4b"),    "--vary", "beta=0.1:10:20:log",
                        "delta=0:1:33", "--outputs=cor,peak_force"};

/// One task, or a start without Slurm where `task` is negative. `array` is how many tasks the array that it
/// is in has, which must not matter.
int runTask(int task, int array, const QStringList& words) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DRILLWAVE", DRILLWAVE_PROGRAM);
    if (task >= 0) {
        environment.insert("SLURM_ARRAY_TASK_ID", QString::number(task));
        environment.insert("SLURM_ARRAY_TASK_COUNT", QString::number(array));
        environment.insert("SLURM_ARRAY_TASK_MIN", QString::number(task));
    }
    process.setProcessEnvironment(environment);
    process.start(DRILLWAVE_SOURCE_DIR "/packaging/slurm/parts.sbatch", words);
    return process.waitForFinished(60000) ? process.exitCode() : -1;
}

QStringList partsIn(const QString& folder) {
    QStringList parts;
    for (const QString& name : QDir(folder).entryList({"part_*.csv"}, QDir::Files, QDir::Name))
        parts << folder + "/" + name;
    return parts;
}

}  // namespace

class TestSlurmArray : public QObject {
    Q_OBJECT

  private slots:
    void thePartsOfAllTasksMakeTheWhole_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("sweep") << sweep;
        QTest::newRow("table") << QStringList{"table", example("paper_fig4a"), "CASES"};
        QTest::newRow("map") << QStringList{"map", example("paper_fig4b"), "--x", "beta=0.1:10:6",
                                            "--y", "delta=0:1:5"};
    }

    void thePartsOfAllTasksMakeTheWhole() {
        QFETCH(QStringList, words);
        const QTemporaryDir place;
        write(place.filePath("cases.csv"), "beta\n1\n2\n3\n4\n5\n6\n7\n8\n9\n");
        words.replaceInStrings("CASES", place.filePath("cases.csv"));
        const QString folder = place.filePath("the parts");
        for (int task = 1; task <= 5; ++task) QCOMPARE(runTask(task, 5, QStringList{"5", folder} + words), 0);
        // Some of them again, in an array of their own.
        for (int task : {2, 5}) QCOMPARE(runTask(task, 2, QStringList{"5", folder} + words), 0);
        const QString all = place.filePath("all.csv"), whole = place.filePath("whole.csv");
        const Finished joined = run(QStringList{"join"} + partsIn(folder) + QStringList{"-o", all});
        QVERIFY2(joined.exitCode == 0, joined.error);
        output(words + QStringList{"-o", whole});
        QVERIFY(read(all) == read(whole));
        QVERIFY(read(all + ".yaml") == read(whole + ".yaml"));
    }

    void aTaskThatIsRunAgainReplacesItsPart() {
        const QTemporaryDir folder;
        const QStringList words = QStringList{"3", folder.path()} + sweep;
        QCOMPARE(runTask(2, 3, words), 0);
        const QByteArray first = read(folder.filePath("part_00002.csv"));
        write(folder.filePath("part_00002.csv"), "left by a task that was cancelled");
        QCOMPARE(runTask(2, 1, words), 0);
        QVERIFY(read(folder.filePath("part_00002.csv")) == first);
        QCOMPARE(partsIn(folder.path()).size(), 1);
    }

    void whatIsNoPartIsRefused() {
        const QTemporaryDir folder;
        const QStringList words = QStringList{"3", folder.path()} + sweep;
        QVERIFY(runTask(-1, 0, words) == 2);
        for (const int task : {0, 4}) QCOMPARE(runTask(task, 4, words), 2);
        QCOMPARE(runTask(1, 1, {"1", folder.path(), "curve"}), 2);
        QCOMPARE(runTask(1, 1, QStringList{"many", folder.path()} + sweep), 2);
        QCOMPARE(runTask(1, 3, words), 0);
        // The folder is one of three parts.
        QCOMPARE(runTask(1, 4, QStringList{"4", folder.path()} + sweep), 2);
        QCOMPARE(partsIn(folder.path()).size(), 1);
    }
};

QTEST_GUILESS_MAIN(TestSlurmArray)
#include "tst_slurm_array.moc"
