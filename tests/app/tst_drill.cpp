// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave drill: what it prints and writes, and what it refuses.
#include <QTest>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>

#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/svg_texts.h"

using namespace drillwave::test;

namespace {

/// The T38 rod with a soft damper, few blows.
QStringList soft(std::initializer_list<QString> more = {}) {
    QStringList words{"drill",
                      example("t38_medium_rock"),
                      "--set",
                      "drill.thrust=4.3kN",
                      "drill.machine_mass=200kg",
                      "drill.damper_damping=6.3kNs/m",
                      "drill.damper_stiffness=0MN/m",
                      "drill.wave_loss=10%",
                      "--blows",
                      "60",
                      "--cells",
                      "20"};
    for (const QString& word : more) words << word;
    return words;
}

}  // namespace

class TestDrill : public QObject {
    Q_OBJECT

  private slots:
    void theModelOfTheFeedIsNamed();
    void numbersAreSiOrMultiples();
    void aRowForEveryBlowIsWritten();
    void aFolderHoldsAllOfIt();
    void picturesGoWithWhatIsWritten();
    void aThrustBelowTheReactionIsAnAnswer();
    void aScanTellsEveryValue();
    void gapsAloneAreOverwrittenOnRequest();
    void theSameOnAnyNumberOfThreads();
    void outputsOfManyBlowsAreThoseOfAScan();
    void outputsOfManyBlowsAreThereByNameAlone();
    void aMachineThatIsPushedBackHasNoMeans();
    void aCurveOfManyBlowsIsStraightBetweenPoints();
    void aRecordStandsBesideTheRows();
    void theKeysOfManyBlowsChangeNoSingleBlow();
    void badInputIsRefusedInOneLineEach_data();
    void badInputIsRefusedInOneLineEach();
    void allThatIsWrongIsToldAtOnce();
    void whatCannotBeMarchedEndsWithSix();
    void numbersAreRoundedForReaders();
    void anInterruptedMarchLeavesNothing();
    void germanUsersGetTheSameNumbers();
};

void TestDrill::theModelOfTheFeedIsNamed() {
    QVERIFY(output(soft()).simplified().contains(
        "The connection between machine and rod is modelled as a dashpot of 6300 N "
        "s/m, which is an assumption."));
    QVERIFY(output({"drill", example("t38_medium_rock"), "--set", "drill.damper_damping=0Ns/m",
                    "drill.damper_stiffness=0MN/m", "--blows", "40", "--cells", "20"})
                .simplified()
                .contains("The connection between machine and rod is modelled as a constant force."));
}

void TestDrill::numbersAreSiOrMultiples() {
    const QJsonObject si = json(soft()), multiples = json(soft({"--dimensionless"}));
    const double d0 = json({"run", example("t38_medium_rock")})["si_scales"]["penetration"].toDouble();
    const auto mean = [](const QJsonObject& result, const char* name) {
        return result["statistics"][QLatin1String(name)]["mean"].toDouble();
    };
    QVERIFY(mean(si, "penetration") > 1e-3 && mean(si, "penetration") < 3e-3);
    if (d0 > 0) QVERIFY(std::abs(mean(multiples, "penetration") * d0 / mean(si, "penetration") - 1) < 1e-12);
    QVERIFY(std::abs(mean(multiples, "face_impulse") - 1) < 1e-12);
    QCOMPARE(si["units"]["penetration"].toString(), QString("m"));
    QCOMPARE(multiples["units"]["penetration"].toString(), QString("d0"));
    // Fe/f in any bounded motion, but for what the ends of a march hold
    QVERIFY(std::abs(mean(si, "rock_impulse") - 4300 / 60.0) < 1);
    QVERIFY(std::abs(si["momentum_residual"].toDouble()) < 1e-12);
    QVERIFY(std::abs(si["energy_residual"].toDouble()) < 1e-3);
    QCOMPARE(si["frac_gap"].toArray().size(), 20);
    QVERIFY(std::abs(si["groups"]["phi"].toDouble() - 4300 / (60 * 51.0)) < 1e-4);
}

void TestDrill::aRowForEveryBlowIsWritten() {
    QTemporaryDir folder;
    const QString path = folder.filePath("blows.csv");
    output(soft({"-o", path}));
    const auto rows = rowsOf(read(path));
    QCOMPARE(
        rows[0].join(','),
        QByteArray("blow,time [s],gap [m],velocity [m/s],rock_impulse [N s],penetration [m],hole_depth [m],"
                   "peak_force [N],contacts,contact_time [s],damper_peak_force [N],face_impulse [N s],"
                   "hammer_rebound_velocity [m/s],shank_offset [m]"));
    QCOMPARE(rows.size(), 61);
    QCOMPARE(rows[1][0], QByteArray("1"));
    QCOMPARE(rows[1][12], QByteArray());  // only hammers have it
    QCOMPARE(run(soft({"-o", path})).exitCode, 4);
    QCOMPARE(run(soft({"-o", path, "--force"})).exitCode, 0);
    QCOMPARE(output(soft({"-o", "-"})), read(path));
    // the file is a scenario again
    QCOMPARE(json({"drill", path, "--cells", "20"})["statistics"]["gap"]["mean"].toDouble(),
             json(soft())["statistics"]["gap"]["mean"].toDouble());
}

void TestDrill::aFolderHoldsAllOfIt() {
    QTemporaryDir folder;
    const QString path = folder.filePath("drilled");
    output(soft({"-o", path, "--histories", "10:12"}));
    QCOMPARE(QDir(path).entryList(QDir::Files),
             (QStringList{"blows.csv", "histories.csv", "scenario.yaml", "summary.json"}));
    const auto blows = rowsOf(read(path + "/blows.csv")), instants = rowsOf(read(path + "/histories.csv"));
    QCOMPARE(instants[0].first(), QByteArray("time [s]"));
    QVERIFY(std::abs(instants[1][0].toDouble() - blows[10][1].toDouble()) < 1e-4);
    QVERIFY(std::abs(instants.last()[0].toDouble() - blows[13][1].toDouble()) < 1e-4);
    double largest = 0, impulse = 0, before = instants[1][0].toDouble();
    for (qsizetype i = 1; i < instants.size(); ++i) {
        const double time = instants[i][0].toDouble(), force = instants[i][1].toDouble();
        largest = std::max(largest, force);
        impulse += force * (time - before);
        before = time;
    }
    // as the rows have it, of cycles that are behind by the transit time
    double rows = 0, peak = 0;
    for (int n = 10; n <= 12; ++n)
        rows += blows[n][4].toDouble(), peak = std::max(peak, blows[n][7].toDouble());
    QVERIFY2(std::abs(impulse / rows - 1) < 0.02, qPrintable(QString::number(impulse / rows)));
    QVERIFY(std::abs(largest / peak - 1) < 0.03);
    const QJsonObject summary = QJsonDocument::fromJson(read(path + "/summary.json")).object();
    QCOMPARE(summary["outcome"].toString(), QString("done"));
}

void TestDrill::picturesGoWithWhatIsWritten() {
    QTemporaryDir folder;
    const QString path = folder.filePath("drilled"), rows = folder.filePath("rows.csv");
    const auto files = [](const QString& there) { return QDir(there).entryList(QDir::Files); };
    output(soft({"-o", path, "--plots", "png,svg"}));
    QCOMPARE(files(path),
             (QStringList{"blows.csv", "drilling.png", "drilling.svg", "scenario.yaml", "summary.json"}));
    QVERIFY(read(path + "/drilling.png").startsWith("\x89PNG"));
    // those of an earlier run go with its numbers
    output(soft({"-o", path, "--force"}));
    QCOMPARE(files(path), (QStringList{"blows.csv", "scenario.yaml", "summary.json"}));
    output(soft({"-o", rows, "--plots", "svg"}));
    QCOMPARE(files(folder.path()), (QStringList{"rows.csv", "rows.csv.yaml", "rows.svg"}));
    QVERIFY(!read(rows + ".yaml").contains("plots"));
    // a machine that is pushed back has no blows, and the picture says why
    output({"drill", example("t38_medium_rock"), "--set", "drill.thrust=3kN", "-o", path, "--force",
            "--plots", "svg"});
    QVERIFY(svgTexts(read(path + "/drilling.svg")).join(' ').contains("pushed back"));
}

void TestDrill::aThrustBelowTheReactionIsAnAnswer() {
    const QJsonObject result = json({"drill", example("t38_medium_rock"), "--set", "drill.thrust=3kN"});
    QCOMPARE(result["outcome"].toString(), QString("pushed_back"));
    QVERIFY(result["statistics"].isNull());
    const QString statement = result["statement"].toString();
    QCOMPARE(statement.count("the machine is pushed back"), 1);
    QVERIFY(result["ledger"]["hammer"].isNull());  // there are no blows
    QVERIFY(result["energy_residual"].isNull());
}

void TestDrill::aScanTellsEveryValue() {
    QTemporaryDir folder;
    const QString path = folder.filePath("scan.csv"), gaps = folder.filePath("gaps.csv");
    QStringList words = soft({"--scan", "drill.thrust=3kN,3.4kN,8kN", "-o", path, "--gaps", gaps});
    words.removeAll("drill.thrust=4.3kN");
    const QByteArray text = output(words);
    QVERIFY(text.contains("pushed_back") &&
            text.contains("Friction, rotation and buckling are not modelled."));
    QVERIFY2(text.contains("is reached with a feed force of 8 kN."), text.constData());
    const auto rows = rowsOf(read(path));
    QVERIFY(rows.size() >= 4);
    QVERIFY(rows[0].join(',').startsWith("drill.thrust [kN],start,drill_gap_mean [m],"));
    QCOMPARE(rows[1][0], QByteArray("3"));
    QCOMPARE(rows[1][2], QByteArray());  // no statistics of what is pushed back
    QCOMPARE(rows[2][1], QByteArray("rest"));
    QVERIFY(rows.last()[2].toDouble() < rows[2][2].toDouble());
    QVERIFY(rowsOf(read(gaps)).size() >= 2 * 48);
}

void TestDrill::gapsAloneAreOverwrittenOnRequest() {
    QTemporaryDir folder;
    const QString gaps = folder.filePath("gaps.csv");
    write(gaps, "old");
    QStringList words = soft({"--scan", "drill.thrust=8kN", "--gaps", gaps});
    words.removeAll("drill.thrust=4.3kN");
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QVERIFY2(refused.error.contains("use --force to overwrite it"), refused.error);
    output(words + QStringList{"--force"});
    QVERIFY(rowsOf(read(gaps)).size() > 2);
}

void TestDrill::theSameOnAnyNumberOfThreads() {
    QStringList words = soft({"--scan", "drill.thrust=3.2kN:8kN:5", "-o", "-"});
    words.removeAll("drill.thrust=4.3kN");
    QCOMPARE(output(words + QStringList{"-j", "1"}), output(words + QStringList{"-j", "7"}));
    // the marches of a plain one: of the blows, of lambda, of half as many cells
    const auto plain = [](const char* jobs) {
        QJsonObject told = json(soft({"-j", jobs}));
        told.remove("run_time");
        return told;
    };
    QCOMPARE(plain("1"), plain("2"));
}

// One march a row, from rest, in as many blows and cells as those of a scan.
void TestDrill::outputsOfManyBlowsAreThoseOfAScan() {
    QStringList scanned = soft({"--scan", "drill.thrust=3kN,4.3kN,8kN", "-o", "-"});
    scanned.removeAll("drill.thrust=4.3kN");
    QStringList swept{"sweep",
                      example("t38_medium_rock"),
                      "--vary",
                      "drill.thrust=3kN,4.3kN,8kN",
                      "--si",
                      "--outputs",
                      "drill_gap_mean,drill_penetration,drill_period,drill_lyapunov,drill_thrust_number",
                      "--set",
                      "drill.machine_mass=200kg",
                      "drill.damper_damping=6.3kNs/m",
                      "drill.damper_stiffness=0MN/m",
                      "drill.wave_loss=10%",
                      "drill.blows=60"};
    const auto fromScan = rowsOf(output(scanned)), rows = rowsOf(output(swept));
    const auto scanColumn = [&](const QByteArray& header) { return fromScan[0].indexOf(header); };
    QCOMPARE(rows.size(), 4);
    for (qsizetype row = 1; row < rows.size(); ++row) {
        const auto same = std::ranges::find_if(fromScan, [&](const QList<QByteArray>& each) {
            return each[0] == rows[row][0] && each[1] == "rest";
        });
        QVERIFY(same != fromScan.end());
        for (qsizetype column = 1; column < rows[0].size(); ++column)
            QCOMPARE(rows[row][column], (*same)[scanColumn(rows[0][column])]);
    }
    QVERIFY(!rows[2][4].isEmpty());  // lambda, which a scan tells too
}

void TestDrill::outputsOfManyBlowsAreThereByNameAlone() {
    const QString rod = example("t38_medium_rock"), groups = example("paper_fig4a");
    const QByteArray all = output(
        {"sweep", rod, "--vary", "bit_rock.gamma=0.1", "--set", "drill.thrust=5kN", "--outputs", "all"});
    QVERIFY(!all.contains("drill_"));
    QVERIFY(output({"help", "sweep"}).contains("drill_penetration_error"));
    const Finished refused = run({"sweep", groups, "--vary", "beta=0.5", "--outputs", "cor,drill_gap_mean"});
    QCOMPARE(refused.exitCode, 5);
    QVERIFY(refused.error.contains("has no drill"));
    const Finished work = run({"sweep", rod, "--vary", "bit_rock.gamma=0.1", "--set", "drill.thrust=5kN",
                               "drill.blows=100000", "--outputs", "drill_period"});
    QCOMPARE(work.exitCode, 6);
    QVERIFY(work.error.contains("computing steps") && work.error.contains("--work-limit"));
}

void TestDrill::aMachineThatIsPushedBackHasNoMeans() {
    const auto rows = rowsOf(output({"sweep", example("t38_medium_rock"), "--vary", "drill.thrust=2kN",
                                     "--outputs", "cor,drill_gap_mean,drill_thrust_number"}));
    QVERIFY(rows[1][1].toDouble() > 0);
    QCOMPARE(rows[1][2], QByteArray());
    QVERIFY(rows[1][3].toDouble() > 0 && rows[1][3].toDouble() < 1);
}

void TestDrill::aCurveOfManyBlowsIsStraightBetweenPoints() {
    const QStringList words{
        "curve",   example("t38_medium_rock"), "--outputs", "drill_penetration", "--set", "drill.blows=3",
        "--along", "drill.thrust=4.3kN:4.4kN"};
    QVERIFY(output(words).contains("straight lines between points"));
}

void TestDrill::aRecordStandsBesideTheRows() {
    QTemporaryDir folder;
    const QString blows = folder.filePath("blows.csv"), scan = folder.filePath("scan.csv");
    output(soft({"-o", blows}));
    const QByteArray ofBlows = read(blows + ".yaml");
    QVERIFY(ofBlows.startsWith("drillwave_result: 1\n"));
    QVERIFY(ofBlows.contains("command: drillwave drill ") && ofBlows.contains("rows: 60\n"));
    QVERIFY(ofBlows.contains("  - gap [m]\n") && !ofBlows.contains("method:"));
    QStringList words =
        soft({"--scan", "drill.thrust=4.3kN,8kN", "-o", scan, "--gaps", folder.filePath("gaps.csv")});
    words.removeAll("drill.thrust=4.3kN");
    output(words);
    const QByteArray ofScan = read(scan + ".yaml");
    QVERIFY(ofScan.contains("  - column: drill.thrust [kN]\n") && ofScan.contains("count: 2\n"));
    QVERIFY(ofScan.contains("  - drill_lyapunov\n") && !ofScan.contains("gaps.csv"));
    // it is a scenario again
    QCOMPARE(json({"drill", blows + ".yaml", "--cells", "20"})["statistics"]["gap"]["mean"],
             json(soft())["statistics"]["gap"]["mean"]);
    QCOMPARE(run(words).exitCode, 4);
    // the record goes with the file that is replaced
    QCOMPARE(run(words + QStringList{"--force"}).exitCode, 0);
}

void TestDrill::theKeysOfManyBlowsChangeNoSingleBlow() {
    const QStringList keys{"--set",
                           "drill.machine_mass=200kg",
                           "drill.damper_damping=6.3kNs/m",
                           "drill.damper_stiffness=0MN/m",
                           "drill.blows=5",
                           "drill.wave_loss=20%",
                           "drill.indexing=same",
                           "drill.interval_scatter=1%",
                           "drill.seed=7"};
    const QString file = example("t38_medium_rock");
    for (const char* command : {"run", "thrust"}) {
        QJsonObject plain = json({command, file, "--set", "drill.machine_mass=200kg"});
        QJsonObject told = json(QStringList{command, file} + keys);
        for (const char* key : {"run_time", "scenario"})
            plain.remove(QLatin1String(key)), told.remove(QLatin1String(key));
        QCOMPARE(told, plain);
    }
}

void TestDrill::badInputIsRefusedInOneLineEach_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QByteArray>("says");
    const QString file = example("t38_medium_rock");
    const auto set = [&](const char* word) { return QStringList{file, "--set", word}; };
    static const QTemporaryDir folder;
    const QString bare = folder.filePath("bare.yaml");
    QByteArray withoutMachine;
    for (const QByteArray& line : read(file).split('\n'))
        if (!line.contains("machine_mass") && !line.contains("damper_")) withoutMachine += line + '\n';
    write(bare, withoutMachine);
    QTest::newRow("a damper without a body") << QStringList{bare, "--set", "drill.damper_damping=6kNs/m"} << 5
                                             << QByteArray("needs drill.machine_mass");
    QTest::newRow("an impulse as a damping") << set("drill.damper_damping=6kN s") << 5 << QByteArray("N s/m");
    QTest::newRow("all is lost") << set("drill.wave_loss=100%") << 5 << QByteArray("[0, 100) %");
    QTest::newRow("half a blow") << set("drill.blows=2.5") << 5 << QByteArray("whole number");
    QTest::newRow("settles all the time") << QStringList{file, "--blows", "5", "--settle", "5"} << 5
                                          << QByteArray("must be less than the blows");
    QTest::newRow("longer than the interval")
        << set("drill.blow_frequency=6kHz") << 5 << QByteArray("interval");
    QTest::newRow("the reference case") << set("pulse.shape=rigid_body") << 5 << QByteArray("pulse.shape");
    QTest::newRow("without units") << QStringList{example("paper_fig4a")} << 5 << QByteArray("has no drill");
    QTest::newRow("another crater") << set("drill.indexing=old") << 5 << QByteArray("fresh, same");
    QTest::newRow("too few cells") << QStringList{file, "--cells", "5"} << 2 << QByteArray("from 10 to 400");
    QTest::newRow("an unknown axis") << QStringList{file, "--scan", "drill.push=1:2:3"} << 2
                                     << QByteArray("drill.push");
    QTest::newRow("no values") << QStringList{file, "--scan", "drill.thrust=3kN:4kN:0"} << 2
                               << QByteArray("--scan");
    QTest::newRow("no number") << QStringList{file, "--scan", "drill.thrust=nan"} << 2
                               << QByteArray("--scan");
    QTest::newRow("histories without a folder")
        << QStringList{file, "--histories", "1:2"} << 2 << QByteArray("-o DIR");
    QTest::newRow("pictures of what is printed")
        << QStringList{file, "--plots", "png"} << 2 << QByteArray("-o");
    QTest::newRow("pictures of words")
        << QStringList{file,      "--scan", "drill.indexing=fresh,same", "-o", "/tmp/no_such.csv",
                       "--plots", "png"}
        << 2 << QByteArray("has words on its axis");
    QTest::newRow("a word for a number")
        << QStringList{file, "--scan", "drill.thrust=3kN,nan,4kN"} << 2 << QByteArray("--scan");
    QTest::newRow("an unknown key") << set("drill.trust=3kN") << 2 << QByteArray("drill.thrust");
    QTest::newRow("no cells") << QStringList{file, "--cells", "nan"} << 2 << QByteArray("--cells");
    QTest::newRow("blows that are none")
        << QStringList{file, "--blows", "many"} << 2 << QByteArray("--blows");
    for (const char* option : {"blows", "settle", "seed"}) {
        const QString key = QString("drill.") + option;
        QTest::addRow("%s, given twice", option)
            << QStringList{file, "--set", key + "=50", QString("--") + option, "40"} << 2
            << ("--set " + key + "=50 and --" + option + " 40 set the same thing").toUtf8();
    }
    QTest::newRow("settling over values and as one")
        << QStringList{file, "--settle", "40", "--scan", "drill.settle=10,20"} << 2
        << QByteArray("--scan drill.settle=10,20 and --settle 40 set the same thing");
    QTest::newRow("histories behind the end")
        << QStringList{file, "--histories", "5:2", "-o", "/tmp/no_such"} << 2 << QByteArray("A:B");
    QTest::newRow("too much work") << QStringList{file, "--blows", "1000000", "--cells", "400"} << 6
                                   << QByteArray("--work-limit");
}

void TestDrill::badInputIsRefusedInOneLineEach() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QByteArray, says);
    const Finished finished = run(QStringList{"drill"} + words);
    QVERIFY2(finished.error.contains(says), finished.error);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY(finished.out.isEmpty());
}

void TestDrill::allThatIsWrongIsToldAtOnce() {
    QTemporaryDir folder;
    const QString path = folder.filePath("bare.yaml");
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    const QByteArray text = read(example("t38_medium_rock"));
    file.write(text.left(text.indexOf("\ndrill:")) +
               "\ndrill: {damper_damping: 6 kN s/m, blows: 10, settle: 5}\n");
    file.close();
    const Finished finished = run({"drill", path});
    QCOMPARE(finished.exitCode, 5);
    for (const char* says : {"drill.blow_frequency", "drill.thrust", "needs drill.machine_mass"})
        QVERIFY2(finished.error.contains(says), finished.error);
    QCOMPARE(finished.error.trimmed().count('\n'), 2);
}

// A damper whose rates no cell of the march can follow.
void TestDrill::whatCannotBeMarchedEndsWithSix() {
    const QString file = example("t38_medium_rock");
    const QStringList stiff{"--set", "drill.machine_mass=1kg", "drill.damper_stiffness=1e18N/m", "--blows",
                            "20"};
    const Finished alone = run(QStringList{"drill", file} + stiff);
    QVERIFY2(alone.exitCode == 6, alone.error);
    QVERIFY2(alone.error.contains("could not be solved: the damper"), alone.error);
    QTemporaryDir folder;
    const QString rows = folder.filePath("scan.csv");
    const Finished scan = run(QStringList{"drill", file, "--set", "drill.machine_mass=1kg", "--blows", "20",
                                          "--scan", "drill.damper_stiffness=1e6N/m,1e18N/m", "-o", rows});
    QVERIFY2(scan.exitCode == 6, scan.error);
    QVERIFY2(scan.error.contains("1 of 2 rows"), scan.error);
    QCOMPARE(rowsOf(read(rows)).size(), 3);
    // what is scanned is not said to be missing
    QVERIFY2(!scan.error.contains("constant force") && !scan.out.contains("constant force"), scan.out);
}

void TestDrill::numbersAreRoundedForReaders() {
    const QByteArray all = output(soft()), text = all.left(all.indexOf("  balances"));
    QVERIFY2(!text.contains("e+0") && !text.contains("e-1"), text);
    QVERIFY2(text.contains("new rock faces 0 %"), text);
}

void TestDrill::anInterruptedMarchLeavesNothing() {
    QTemporaryDir folder;
    QProcess process;
    process.start(QStringLiteral(DRILLWAVE_PROGRAM),
                  {"drill", example("t38_medium_rock"), "--blows", "300000", "--work-limit", "1e15", "-o",
                   folder.filePath("blows.csv")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForThreads(process, 2));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void TestDrill::germanUsersGetTheSameNumbers() {
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert("LC_ALL", "de_DE.UTF-8");
    QCOMPARE(run(soft({"-o", "-"}), german).out, output(soft({"-o", "-"})));
}

QTEST_GUILESS_MAIN(TestDrill)
#include "tst_drill.moc"
