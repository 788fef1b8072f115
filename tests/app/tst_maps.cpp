// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave map: rows, contours, record, and what it refuses.
#include <QTest>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

const QStringList xAndY{"--x", "beta=0.1:10:41:log", "--y", "delta=0:2:31"};

QStringList mapOf(const QString& name, const QStringList& more) {
    return QStringList{"map", example(name)} + xAndY + more;
}

}  // namespace

class TestMaps : public QObject {
    Q_OBJECT

  private slots:
    void theRowsAreThoseOfASweep();
    void theBytesDoNotDependOnTheNumberOfThreads();
    void contourPointsSolveToTheirLevel();
    void theRecordGivesTheSameMapAgain();
    void jsonHoldsRangeAndContours();
    void levelsInSiTakeUnits();
    void pointsWithoutASolutionAreCounted();
    void picturesStandBesideThePoints();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
};

void TestMaps::theRowsAreThoseOfASweep() {
    QCOMPARE(output(mapOf("paper_fig4b", {"-o", "-"})),
             output({"sweep", example("paper_fig4b"), "--vary", xAndY[1], "--vary", xAndY[3]}));
    const QStringList axes{"bit_rock.stiffness=10MN/m:1000MN/m:20:log", "rod.length=10ft:40ft:10"};
    QCOMPARE(output({"map", example("t38_medium_rock"), "--x", axes[0], "--y", axes[1], "--output",
                     "peak_force", "--si", "-o", "-"}),
             output({"sweep", example("t38_medium_rock"), "--vary", axes[0], "--vary", axes[1], "--outputs",
                     "peak_force", "--si"}));
}

void TestMaps::theBytesDoNotDependOnTheNumberOfThreads() {
    QTemporaryDir folder;
    QByteArrayList maps, contours;
    for (const char* jobs : {"1", "2", "7"}) {
        const QString path = folder.filePath(QString("%1.csv").arg(jobs));
        output(mapOf("paper_fig4a", {"--level", "1", "--level=1.2", "-j", jobs, "-o", path}));
        maps << read(path);
        contours << read(folder.filePath(QString("%1_contours.csv").arg(jobs)));
    }
    QVERIFY(maps[0] == maps[1] && maps[0] == maps[2]);
    QVERIFY(contours[0] == contours[1] && contours[0] == contours[2]);
    QVERIFY(contours[0].size() > 5000);
}

// The border of super rebound, e = 1.
void TestMaps::contourPointsSolveToTheirLevel() {
    QTemporaryDir folder;
    const QByteArray text = output(mapOf("paper_fig4a", {"--level", "1", "-o", folder.filePath("map.csv")}));
    const auto rows = rowsOf(read(folder.filePath("map_contours.csv")));
    QCOMPARE(rows[0].join(','), QByteArray("level,line,beta,delta,cor,residual,jump_width"));
    QVERIFY(rows.size() > 100);
    for (int n = 1; n < rows.size(); ++n) {
        QVERIFY(rows[n][5].toDouble() < 1e-9);
        QCOMPARE(rows[n][6], QByteArray());
        if (n % 40 != 1) continue;
        const QJsonObject blow =
            json({"run", example("paper_fig4a"), "--set", "beta=" + rows[n][2], "delta=" + rows[n][3]});
        QCOMPARE(blow["dimensionless"]["cor"].toDouble(), rows[n][4].toDouble());
    }
    QVERIFY(text.contains("cor = 1: ") && text.contains("smallest") && text.contains("largest"));
}

void TestMaps::theRecordGivesTheSameMapAgain() {
    QTemporaryDir folder;
    const QString path = folder.filePath("map.csv"), again = folder.filePath("again.csv");
    output(mapOf("paper_fig4a", {"--set", "gamma=0.5", "--level", "1", "-o", path}));
    const QByteArray record = read(path + ".yaml");
    QVERIFY(record.contains("--set gamma=0.5"));
    QVERIFY(record.contains("--x beta=0.1:10:41:log --y delta=0:2:31"));
    QVERIFY(record.contains("--level 1"));
    QVERIFY(record.contains("rows: 1271"));
    output(QStringList{"map", path + ".yaml"} + xAndY + QStringList{"-o", again});
    QCOMPARE(read(again), read(path));
    QVERIFY(!QFile::exists(folder.filePath("again_contours.csv")));
}

void TestMaps::jsonHoldsRangeAndContours() {
    const QJsonObject map = json(mapOf("paper_fig4a", {"--level", "1"}));
    QCOMPARE(map["points"].toInt(), 1271);
    QCOMPARE(map["x"]["parameter"].toString(), QString("beta"));
    QCOMPARE(map["x"]["logarithmic"].toBool(), true);
    QVERIFY(map["range"]["max"]["value"].toDouble() > 1.4);
    QCOMPARE(map["range"]["max"]["y"].toDouble(), 0.0);
    const QJsonObject contour = map["contours"].toArray().first().toObject();
    int points = 0, closed = 0;
    for (const QJsonValue& line : contour["lines"].toArray()) {
        const QJsonArray x = line["x"].toArray(), y = line["y"].toArray();
        QCOMPARE(x.size(), y.size());
        points += int(x.size());
        closed += x.first() == x.last() && y.first() == y.last() ? 1 : 0;
    }
    QCOMPARE(points - closed, contour["points"].toInt());
    QVERIFY(contour["worst_residual"].toDouble() < 1e-9);
    QVERIFY(map["unsolved"].toArray().isEmpty());
    QVERIFY(map["scenario"].toString().contains("beta: 0.5"));
}

void TestMaps::levelsInSiTakeUnits() {
    QTemporaryDir folder;
    QByteArrayList contours;
    for (const char* level : {"300 kN", "300000"}) {
        const QString path = folder.filePath(QString("%1.csv").arg(contours.size()));
        output({"map", example("t38_medium_rock"), "--x", "bit_rock.stiffness=10MN/m:1000MN/m:9:log", "--y",
                "gamma=0.1:1:9", "--output", "peak_force", "--si", "--level", level, "-o", path});
        contours << read(path.chopped(4) + "_contours.csv");
    }
    QCOMPARE(contours[0], contours[1]);
    QVERIFY(contours[0].startsWith(
        "level,line,bit_rock.stiffness [MN/m],gamma,peak_force [N],residual,jump_width\n"));
    QVERIFY(contours[0].count('\n') > 5);
}

void TestMaps::pointsWithoutASolutionAreCounted() {
    QTemporaryDir folder;
    const QString path = folder.filePath("map.csv");
    const Finished finished = run({"map", example("paper_fig4b"), "--x", "beta=1e-7:10:12:log", "--y",
                                   "gamma=0.1:0.5:5", "--work-limit", "100", "-o", path});
    QCOMPARE(finished.exitCode, 6);
    const auto rows = rowsOf(read(path));
    const auto empty = std::ranges::count_if(rows, [](const auto& row) { return row[2].isEmpty(); });
    QVERIFY(empty > 0 && empty < 60);
    QVERIFY(finished.error.startsWith("drillwave map: " + QByteArray::number(qlonglong(empty)) +
                                      " of 60 points could not be solved"));
    QVERIFY(finished.error.contains("--work-limit, now 100, permits more"));
    QCOMPARE(finished.error.count('\n'), 1);
    QVERIFY(finished.out.contains(QByteArray::number(qlonglong(empty)) + " points not solved: "));
}

void TestMaps::picturesStandBesideThePoints() {
    QTemporaryDir folder;
    for (const char* name : {"map", "again"})
        output(mapOf("paper_fig4a", {"--level", "1", "--plots", "png,svg", "-o",
                                     folder.filePath(QLatin1String(name) + ".csv")}));
    QCOMPARE(QDir(folder.path()).entryList({"map*"}, QDir::Files, QDir::Name),
             (QStringList{"map.csv", "map.csv.yaml", "map.png", "map.svg", "map_contours.csv"}));
    QVERIFY(read(folder.filePath("map.png")).startsWith("\x89PNG"));
    QVERIFY(read(folder.filePath("map.svg")).contains("<svg"));
    for (const char* ending : {".png", ".svg"})
        QVERIFY(read(folder.filePath("map") + ending) == read(folder.filePath("again") + ending));
    QCOMPARE(run(mapOf("paper_fig4a", {"--plots", "png"})).exitCode, 2);
}

void TestMaps::whatIsWrongIsSaid_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArray>("message");
    const QStringList x{"--x", "beta=1:2:3"}, y{"--y", "delta=0:1:3"};
    QTest::newRow("one axis") << x << 2 << QByteArray("--y is missing");
    QTest::newRow("one dash") << QStringList{"-x", "beta=1:2:3"} + y << 2
                              << QByteArray("unknown option `-x`");
    QTest::newRow("a list") << QStringList{"--x", "beta=1,2"} + y << 2
                            << QByteArray("a map needs KEY=START:STOP:COUNT");
    QTest::newRow("no count") << QStringList{"--x", "beta=1:2"} + y << 2
                              << QByteArray("KEY=START:STOP:COUNT:log; `drillwave sweep` takes a list");
    QTest::newRow("no parameter") << QStringList{"--x", "bet=1:2:3"} + y << 2
                                  << QByteArray("did you mean `beta`?");
    QTest::newRow("out of range") << QStringList{"--x", "gamma=0.5:2:3"} + y << 5
                                  << QByteArray("must be in (0, 1]");
    QTest::newRow("too many points") << QStringList{"--x", "beta=1:2:5000", "--y", "delta=0:1:5000"} << 5
                                     << QByteArray("more than 16000000 points");
    QTest::newRow("set twice") << x + y + QStringList{"--set", "beta=2"} << 2
                               << QByteArray("set the same thing");
    QTest::newRow("two outputs") << x + y + QStringList{"--output", "cor,impulse"} << 2
                                 << QByteArray("a map has one output");
    QTest::newRow("no output") << x + y + QStringList{"--output", "corr"} << 2
                               << QByteArray("did you mean `cor`?");
    QTest::newRow("no level") << x + y + QStringList{"--level", "one"} << 2
                              << QByteArray("--level one: is not a number");
    QTest::newRow("SI of groups") << x + y + QStringList{"--si"} << 5
                                  << QByteArray("SI columns need a scenario in physical units");
    QTest::newRow("levels nowhere") << x + y + QStringList{"--level", "1", "-o", "-"} << 2
                                    << QByteArray("--level cannot be used with -o -, which prints the map");
    QTest::newRow("force nothing") << x + y + QStringList{"--force"} << 2 << QByteArray("add -o FILE.csv");
    QTest::newRow("no folder") << x + y + QStringList{"-o", "/nowhere/map.csv"} << 4
                               << QByteArray("/nowhere/map.csv");
    QTest::newRow("an input") << x + y + QStringList{"-o", example("paper_fig4b"), "--force"} << 2
                              << QByteArray("paper_fig4b.yaml");
}

void TestMaps::whatIsWrongIsSaid() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QByteArray, message);
    const Finished finished = run(QStringList{"map", example("paper_fig4b")} + words);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(finished.error.contains(message), finished.error.constData());
    QCOMPARE(finished.error.count('\n'), 1);
    QVERIFY(finished.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestMaps)
#include "tst_maps.moc"
