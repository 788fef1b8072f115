// SPDX-License-Identifier: GPL-3.0-or-later
// The other solvers on the command line: run --method, and accuracy.
#include <QTest>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

double cor(const QJsonObject& report) {
    return report["dimensionless"].toObject()["cor"].toDouble();
}

double secondCell(const Finished& csv, int line) {
    return csv.out.split('\n').value(line).split(',').value(1).toDouble();
}

const QStringList shortLadder{"--segments", "200,100"};

}  // namespace

class TestMethods : public QObject {
    Q_OBJECT

  private slots:
    void everyMethodGivesTheSameBlowWithinItsError() {
        const QStringList words{"run", example("paper_fig4a")};
        const double exact = cor(json(words));
        for (const QString method : {"lattice", "closed_form"}) {
            const QJsonObject report = json(words + QStringList{"--method", method});
            QCOMPARE(report["method"].toString(), method);
            const double error = report["dimensionless"].toObject()["cor_error"].toDouble();
            QVERIFY(error > 0 && error < 1e-4);
            QVERIFY(cor(report) != exact && std::abs(cor(report) - exact) <= error);
            QCOMPARE(report["events"].toArray().size(), 2);
        }
    }

    void theLatticeHasTheSegmentsAskedFor() {
        const QStringList words{"run", example("paper_fig4b"), "--method", "lattice"};
        QCOMPARE(json(words)["segments"].toInt(), 10000);
        const QJsonObject coarse = json(words + QStringList{"--segments", "100"});
        QCOMPARE(coarse["segments"].toInt(), 100);
        // two periods of 200 steps and a bit: the contact ends 21 t0 after the first arrival
        QCOMPARE(coarse["pieces"].toInt(), 411);
        QVERIFY(run(words).out.contains("method lattice of 10000 segments"));
    }

    void theHistoriesOfTheLatticeAreWritten() {
        const QTemporaryDir folder;
        const QStringList words{"run", example("paper_fig4b"), "--method", "lattice", "--segments", "100",
                                "-o",  folder.path()};
        QCOMPARE(run(words).exitCode, 0);
        // a step takes two lines of the CSV, its beginning and its end; steps without waves are one piece
        const qsizetype lines = read(folder.filePath("histories.csv")).count('\n');
        QVERIFY2(lines > 400 && lines < 900, qPrintable(QString::number(lines)));
    }

    void rowsAreSolvedByTheMethodAskedFor() {
        const QTemporaryDir folder;
        write(folder.filePath("cases.csv"), "gamma\n1\n0.1\n");
        const QStringList sweep{"sweep", example("paper_fig4a"), "--vary", "gamma=1,0.1"};
        const QStringList table{"table", example("paper_fig4a"), folder.filePath("cases.csv")};
        for (const QStringList& words : {sweep, table}) {
            const Finished lattice = run(words + QStringList{"--method", "lattice", "--segments", "1000"});
            QCOMPARE(lattice.exitCode, 0);
            // 1.1e-7 and 1.3e-5 from the exact ones (theory §6)
            QVERIFY(std::abs(secondCell(lattice, 1) - 1.4010824845 + 1.07e-7) < 1e-8);
            QVERIFY(std::abs(secondCell(lattice, 2) - 0.4067107439 - 1.25e-5) < 1e-6);
            const Finished closedForm = run(words + QStringList{"--method", "closed_form"});
            QCOMPARE(closedForm.exitCode, 6);
            QVERIFY(std::abs(secondCell(closedForm, 1) - 1.4011369896) < 1e-9);
            QVERIFY(closedForm.out.endsWith("\n0.1,\n"));
            QVERIFY(closedForm.error.contains("1 of 2 rows could not be solved"));
        }
    }

    void accuracyHasARowForEachMethodAndResolution() {
        const QJsonObject report = json(QStringList{"accuracy", example("paper_fig4a")} + shortLadder);
        const QJsonArray rows = report["rows"].toArray();
        QStringList found;
        for (const QJsonValue& row : rows)
            found << row["method"].toString() + row["waves"].toString() +
                         (row["segments"].isUndefined() ? "" : QString::number(row["segments"].toInt()));
        QCOMPARE(found, QStringList({"exact", "closed_form", "latticering100", "latticering200",
                                     "latticemoved100", "latticemoved200"}));
        for (const QJsonValue& row : rows) {
            for (const char* key : {"error_cor", "cor_error", "error_peak_force", "error_force", "median_s",
                                    "min_s", "pieces", "events", "runs"})
                QVERIFY2(row[key].isDouble(), key);
            QVERIFY(row["median_s"].toDouble() >= row["min_s"].toDouble() && row["min_s"].toDouble() > 0);
            QVERIFY(row["runs"].toInt() >= 9);
            QVERIFY(row["speed"].isNull());  // the paper's choice is not on this ladder
        }
        QVERIFY(rows[0]["error_cor"].toDouble() < 1e-14);
        // paper, Fig. 7: the closed form is 5.5e-5 off at β = 0.5
        QVERIFY(std::abs(rows[1]["error_cor"].toDouble() - 5.4505e-5) < 1e-8);
        for (const char* key : {"wave", "rate", "law"})
            QVERIFY2(report["residuals"][key].toDouble() < 1e-13, key);
    }

    void accuracyIsToldToPeople() {
        const Finished finished = run(QStringList{"accuracy", example("paper_fig4b")} + shortLadder);
        QCOMPARE(finished.exitCode, 0);
        QCOMPARE(finished.error, QByteArray());
        for (const char* part : {"lattice, ring, 200", "lattice, moved, 100", "to the last bit",
                                 "long double", "law of the penetration", " us "})
            QVERIFY2(finished.out.contains(part), part);
        for (const QByteArray& line : finished.out.split('\n')) QVERIFY2(line.size() < 150, line);
    }

    void accuracyWritesItsTable() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("new/accuracy.csv");
        const QStringList words =
            QStringList{"accuracy", example("paper_fig4b"), "-o", folder.filePath("new")} + shortLadder;
        QCOMPARE(run(words).exitCode, 0);
        const QByteArray csv = read(file);
        QVERIFY(csv.startsWith("# # Written by Drillwave "));
        QVERIFY(csv.contains("\nmethod,waves,segments,outcome,reason,cor,error_cor,cor_error,order,"));
        QVERIFY(csv.contains("\nlattice,moved,200,rebounded,,0.4070"));
        QCOMPARE(run(words).exitCode, 4);
        QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
        // it is a scenario like the files of a run
        QCOMPARE(cor(json({"run", file})), cor(json({"run", example("paper_fig4b")})));
    }

    void anInterruptionEndsALongLatticeAtOnce_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("accuracy") << QStringList{"accuracy", example("paper_fig4a"), "-o", "out"};
        // a soft contact of 1e5 round trips
        QTest::newRow("run") << QStringList{
            "run",       example("paper_fig4a"), "--method", "lattice", "--segments", "1000", "--set",
            "beta=1e-10"};
    }

    void anInterruptionEndsALongLatticeAtOnce() {
        QFETCH(QStringList, words);
        const QTemporaryDir folder;
        QProcess process;
        process.setWorkingDirectory(folder.path());
        process.start(QStringLiteral(DRILLWAVE_PROGRAM), words);
        QVERIFY(process.waitForStarted());
        QVERIFY(waitForThreads(process, 2));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 130);
        // Behind the remark on a softness like that.
        const QByteArray error = process.readAllStandardError();
        QCOMPARE(error.count('\n') - error.count(": warning: "), 1);
        QVERIFY2(error.contains("interrupted; no output was left behind"), error);
        QVERIFY(!QFileInfo::exists(folder.filePath("out")));
    }
};

QTEST_GUILESS_MAIN(TestMethods)
#include "tst_methods.moc"
