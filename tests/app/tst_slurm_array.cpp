// SPDX-License-Identifier: GPL-3.0-or-later
// packaging/slurm/sweep.sbatch as Slurm would run its tasks.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QStringList scenarioAndAxes{example("paper_fig4b"), "PARTS", "beta=0.1:10:20:log",
                                  "delta=0:1:33",         "--",    "--outputs=cor,peak_force"};

/// One task of an array, or a start without Slurm where `task` is 0.
int runTask(int task, int tasks, QStringList words, const QString& parts) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DRILLWAVE", DRILLWAVE_PROGRAM);
    if (task > 0) {
        environment.insert("SLURM_ARRAY_TASK_ID", QString::number(task));
        environment.insert("SLURM_ARRAY_TASK_COUNT", QString::number(tasks));
    }
    process.setProcessEnvironment(environment);
    words.replaceInStrings("PARTS", parts);
    process.start(DRILLWAVE_SOURCE_DIR "/packaging/slurm/sweep.sbatch", words);
    return process.waitForFinished(60000) ? process.exitCode() : -1;
}

}  // namespace

class TestSlurmArray : public QObject {
    Q_OBJECT

  private slots:
    void thePartsOfAllTasksMakeTheWholeTable() {
        const QTemporaryDir folder;
        const QString parts = folder.filePath("parts");
        QByteArray together;
        for (int task = 1; task <= 11; ++task) {
            QCOMPARE(runTask(task, 11, scenarioAndAxes, parts), 0);
            together += read(parts + QString("/part_%1.csv").arg(task, 5, 10, QChar('0')));
        }
        const Finished whole = run({"sweep", example("paper_fig4b"), "--vary", "beta=0.1:10:20:log",
                                    "delta=0:1:33", "--outputs=cor,peak_force"});
        QCOMPARE(whole.exitCode, 0);
        QVERIFY(together == whole.out);
    }

    void aTaskThatIsRunAgainReplacesItsPart() {
        const QTemporaryDir folder;
        QCOMPARE(runTask(2, 3, scenarioAndAxes, folder.path()), 0);
        const QByteArray first = read(folder.filePath("part_00002.csv"));
        write(folder.filePath("part_00002.csv"), "left by a task that was cancelled");
        QCOMPARE(runTask(2, 3, scenarioAndAxes, folder.path()), 0);
        QVERIFY(read(folder.filePath("part_00002.csv")) == first);
    }

    void outsideAnArrayItSaysWhatIsMissing() {
        const QTemporaryDir folder;
        QVERIFY(runTask(0, 0, scenarioAndAxes, folder.path()) > 0);
        QCOMPARE(runTask(1, 1, {"only-a-scenario"}, folder.path()), 2);
    }
};

QTEST_GUILESS_MAIN(TestSlurmArray)
#include "tst_slurm_array.moc"
