// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave gap, thrust and figures: numbers, names, files and what they refuse.
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

namespace {}  // namespace

class TestStudies : public QObject {
    Q_OBJECT

  private slots:
    void gapGivesTheStatisticsOfThePapersFigure8();
    void gapTakesAScatteredGapInTheUnitsOfTheScenario();
    void gapSaysWhereThePeriodBegins();
    void gapSaysThatTheReferenceCaseHasNone();
    void gapWritesItsCurve();
    void impulsesAreOnePlusRestitutions();
    void thrustGivesNeedsMarginsAndItsState();
    void thrustWithoutAnInstalledOneHasNoMargins();
    void thrustOfAStringIsToldOfItsBlowAndRigidRock();
    void thrustIsProportionalToFrequency();
    void thrustAlongAParameterIsAStudyAtEachValue();
    void weightAlongTheHoleIsPartOfTheFeed();
    void figuresFillAFolder();
    void figuresNeverOverwriteUnasked();
    void anInterruptedStudyLeavesNothing();
    void germanUsersGetTheSameNumbers();
    void roundedNumbersOfSamplesAreTold();
};

// theory §7; half a unit of the last digit given there.
void TestStudies::gapGivesTheStatisticsOfThePapersFigure8() {
    const QJsonObject gap = json({"gap", example("paper_fig8_minimum")});
    const QJsonObject uniform = gap["uniform"].toObject();
    const QJsonObject cor = uniform["cor"].toObject();
    const auto near = [](const QJsonValue& value, double expected, double tolerance) {
        return value.isDouble() && std::abs(value.toDouble() - expected) < tolerance;
    };
    QVERIFY(near(cor["min"]["value"], 0.8419988, 5.1e-8));
    QVERIFY(near(cor["min"]["gap"], 0.52711, 5.1e-6));
    QCOMPARE(cor["min"]["kind"].toString(), QString("smooth"));
    QVERIFY(near(cor["max"]["value"], 1.4010825, 5.1e-8));
    QCOMPARE(cor["max"]["gap"].toDouble(), 0.0);
    QCOMPARE(cor["max"]["kind"].toString(), QString("kink"));
    QVERIFY(near(uniform["share_above_one"]["value"], 0.548346, 5.1e-7));
    QVERIFY(near(gap["crossings"][0]["gap"], 0.326877, 5.1e-7));
    QVERIFY(near(gap["crossings"][1]["gap"], 0.778532, 5.1e-7));
    for (const char* quantile : {"5", "50", "95"})
        QVERIFY(cor["quantiles"][QLatin1String(quantile)]["error"].toDouble() < 1e-9);
    QVERIFY(gap["normal"].isNull());
    const QByteArray text = output({"gap", example("paper_fig8_minimum")});
    QVERIFY(text.contains("0.841999") && text.contains("54.835 %") && text.contains("0 kink"));
}

void TestStudies::gapTakesAScatteredGapInTheUnitsOfTheScenario() {
    const QString drill = example("t38_medium_rock");
    const QJsonObject inLength = json({"gap", drill, "--gap-mean", "1.5 mm", "--gap-deviation", "0.0002m"});
    const double period = inLength["si_scales"]["gap"].toDouble();
    QVERIFY(std::abs(inLength["normal"]["mean"].toDouble() - 1.5e-3 / period) < 1e-14);
    QVERIFY(std::abs(inLength["normal"]["deviation"].toDouble() - 0.2e-3 / period) < 1e-14);
    // The mean of the scenario is taken without --gap-mean.
    const QJsonObject about = json({"gap", drill, "--set", "bit_rock.gap=1.5mm", "--gap-deviation", "0.2mm"});
    QVERIFY(std::abs(about["normal"]["cor"]["mean"]["value"].toDouble() -
                     inLength["normal"]["cor"]["mean"]["value"].toDouble()) < 1e-12);
    const QJsonObject inPeriods =
        json({"gap", example("paper_fig4a"), "--gap-mean", "0.3", "--gap-deviation", "0.1"});
    QCOMPARE(inPeriods["normal"]["mean"].toDouble(), 0.3);
    QVERIFY(output({"gap", drill, "--gap-deviation", "0.2mm"}).contains("cut off at zero"));
}

void TestStudies::gapSaysWhereThePeriodBegins() {
    const QJsonObject gap = json({"gap", example("paper_fig4a"), "--set", "tau=0.3"});
    QCOMPARE(gap["period"]["start"].toDouble(), 1.0);
    QVERIFY(gap["remark"].toString().contains("still pushes"));
    QCOMPARE(json({"gap", example("paper_fig4a")})["remark"].toString(), QString());
}

void TestStudies::gapSaysThatTheReferenceCaseHasNone() {
    const QJsonObject gap = json({"gap", example("reference_case")});
    QCOMPARE(gap["depends_on_gap"].toBool(true), false);
    QVERIFY(gap["remark"].toString().contains("does not depend on the gap"));
    const QJsonObject cor = gap["uniform"]["cor"].toObject();
    QCOMPARE(cor["min"]["value"].toDouble(), cor["max"]["value"].toDouble());
    QCOMPARE(cor["min"]["kind"].toString(), QString("everywhere"));
}

void TestStudies::gapWritesItsCurve() {
    QTemporaryDir folder;
    const QString path = folder.filePath("gap.csv");
    output({"gap", example("paper_fig4a"), "-o", path});
    const auto rows = rowsOf(read(path));
    QCOMPARE(rows[0].join(','), QByteArray("delta,cor,impulse,peak_force,efficiency"));
    QVERIFY(rows.size() > 500);
    QCOMPARE(rows[1][0], QByteArray("0"));
    QCOMPARE(rows.last()[0], QByteArray("1"));
    QCOMPARE(run({"gap", example("paper_fig4a"), "-o", path}).exitCode, 4);
    QCOMPARE(run({"gap", example("paper_fig4a"), "-o", path, "--force"}).exitCode, 0);
    // The file is a scenario again.
    QVERIFY(std::abs(json({"run", path})["dimensionless"]["cor"].toDouble() - rows[1][1].toDouble()) < 1e-12);
    QCOMPARE(output({"gap", example("paper_fig4a"), "-o", "-"}), read(path));
}

void TestStudies::impulsesAreOnePlusRestitutions() {
    const QJsonObject gap = json({"gap", example("paper_fig4b"), "--gap-deviation", "0.2"});
    for (const char* distribution : {"uniform", "normal"}) {
        const QJsonObject all = gap[QLatin1String(distribution)].toObject();
        const double e = all["cor"]["mean"]["value"].toDouble(),
                     i = all["impulse"]["mean"]["value"].toDouble();
        QCOMPARE(i, 1 + e);
    }
}

void TestStudies::thrustGivesNeedsMarginsAndItsState() {
    const QString drill = example("t38_medium_rock");
    const QJsonObject thrust = json({"thrust", drill});
    const QJsonObject needs = thrust["needs"].toObject();
    const double e = json({"run", drill})["dimensionless"]["cor"].toDouble();
    QVERIFY(std::abs(needs["scenario"]["cor"].toDouble() - e) < 1e-12);
    QCOMPARE(needs["rigid_rock"]["thrust"].toDouble(), 60 * 51 * 2.0);
    QCOMPARE(needs["rigid_rock"]["margin"].toDouble(), 8000 / 6120.0 - 1);
    const double worst =
        json({"gap", drill, "--set", "gamma=1"})["uniform"]["cor"]["max"]["value"].toDouble();
    QVERIFY(std::abs(needs["elastic_worst_gap"]["cor"].toDouble() - worst) < 1e-9);
    for (const QJsonValue& need : needs) {
        const double cor = need["cor"].toDouble();
        QVERIFY(std::abs(need["thrust_undamped"].toDouble() / (60 * 51 * (1 + 2 * cor)) - 1) < 1e-14);
    }
    QCOMPARE(thrust["thrust_margin"].toDouble(), needs["elastic_worst_gap"]["margin"].toDouble());
    const QJsonObject feed = thrust["feed"].toObject();
    QCOMPARE(feed["state"].toString(), QString("required_met"));
    QCOMPARE(feed["required"]["worst_gap"].toDouble(), needs["elastic_worst_gap"]["thrust"].toDouble());
    QCOMPARE(feed["return_in_time"]["gaps_95"].toDouble(),
             needs["gap_95_percent"]["thrust_undamped"].toDouble());
    QCOMPARE(feed["examined"].toArray().size(), 4);
    const QJsonObject less = json({"thrust", drill, "--set", "drill.thrust=4kN"});
    QCOMPARE(less["feed"]["state"].toString(), QString("below_required"));
    // The words of this command, of run, drill and the alert are the same.
    const QString sentence = less["statement"].toString().section(". ", 0, 0);
    const QStringList scenario{drill, "--set", "drill.thrust=4kN"};
    const QJsonObject blow = json(QStringList{"run"} + scenario);
    QVERIFY(blow["alerts"][0]["text"].toString().startsWith(sentence + ". "));
    QCOMPARE(blow["feed"].toObject(), less["feed"].toObject());
    const QJsonObject drilled =
        json(QStringList{"drill"} + scenario + QStringList{"--blows", "30", "--cells", "20"});
    QVERIFY(drilled["statement"].toString().startsWith(sentence + ". "));
    QCOMPARE(drilled["feed"].toObject(), less["feed"].toObject());
    QVERIFY(output(QStringList{"run"} + scenario).simplified().contains(sentence.toUtf8()));
}

void TestStudies::thrustWithoutAnInstalledOneHasNoMargins() {
    QTemporaryDir folder;
    QByteArray scenario = read(example("t38_medium_rock"));
    scenario.replace("thrust:", "# thrust:");
    write(folder.filePath("drill.yaml"), scenario);
    const QJsonObject thrust = json({"thrust", folder.filePath("drill.yaml")});
    QVERIFY(thrust["installed_thrust"].isNull());
    QVERIFY(thrust["needs"]["scenario"]["margin"].isNull());
    QVERIFY(thrust["feed"]["state"].isNull() && thrust["feed"]["installed"].isNull());
    QVERIFY(!output({"thrust", folder.filePath("drill.yaml")}).contains("margin "));
}

void TestStudies::thrustOfAStringIsToldOfItsBlowAndRigidRock() {
    const QString drill = example("t38_string");
    const QJsonObject thrust = json({"thrust", drill});
    const QJsonObject needs = thrust["needs"].toObject();
    QCOMPARE(needs.keys(), (QStringList{"rigid_rock", "scenario"}));
    const double handedOn = thrust["impulse"].toDouble();
    for (const QJsonValue& need : needs)
        QVERIFY(std::abs(need["thrust"].toDouble() /
                             (60 * handedOn * (1 + std::max(need["cor"].toDouble(), 0.0))) -
                         1) < 1e-12);
    const QJsonObject run = json({"run", drill});
    QVERIFY(std::abs(needs["scenario"]["thrust"].toDouble() - run["si"]["thrust"].toDouble()) < 1e-6);
    QCOMPARE(thrust["feed"]["state"].toString(), QString("required_met"));
    QCOMPARE(thrust["feed"]["examined"].toArray(), (QJsonArray{"this_blow", "rigid_rock"}));
    QVERIFY(thrust["feed"]["not_examined_reason"].toString().contains("no period"));
    QVERIFY(thrust["thrust_margin"].isNull());
    const QByteArray text = output({"thrust", drill});
    QVERIFY(text.contains("this blow") && text.contains("rigid rock") &&
            text.contains("only the gap entered and"));
    QVERIFY(!text.contains("worst gap  "));
    const auto rows = rowsOf(output({"thrust", drill, "--frequency", "30Hz:120Hz:3", "-o", "-"}));
    QCOMPARE(rows.size(), 4);
    QVERIFY(rows[1][2].isEmpty() && !rows[1][1].isEmpty() && !rows[1][3].isEmpty());
    QVERIFY(output({"run", drill}).simplified().contains("gaps between bit and rock were not examined"));
}

void TestStudies::thrustIsProportionalToFrequency() {
    const QString drill = example("t38_medium_rock");
    const QByteArray csv = output({"thrust", drill, "--frequency", "30Hz:120Hz:4", "-o", "-"});
    QCOMPARE(output({"thrust", drill, "--along", "drill.blow_frequency=30Hz:120Hz:4", "-o", "-"}), csv);
    const auto rows = rowsOf(csv);
    QCOMPARE(rows[0][0], QByteArray("drill.blow_frequency [Hz]"));
    QCOMPARE(rows[0].size(), 14);
    QCOMPARE(rows.size(), 5);
    for (int column = 1; column < 5; ++column) {
        QVERIFY(std::abs(rows[4][column].toDouble() / (4 * rows[1][column].toDouble()) - 1) < 1e-14);
        const double here =
            json({"thrust", drill})["needs"][QString::fromUtf8(rows[0][column].chopped(4))]["thrust"]
                .toDouble();
        QVERIFY(std::abs(rows[2][column].toDouble() / here - 1) < 1e-14);  // 60 Hz
    }
    QCOMPARE(json({"thrust", drill, "--frequency", "40Hz,50Hz"})["along"]["points"].toArray().size(), 2);
}

// Each point is the study of its own scenario, and a sweep has its margin.
void TestStudies::thrustAlongAParameterIsAStudyAtEachValue() {
    const QString drill = example("t38_medium_rock");
    const QJsonArray points =
        json({"thrust", drill, "--along", "gamma=0.1:1:3"})["along"]["points"].toArray();
    QCOMPARE(points.size(), 3);
    const auto rows = rowsOf(output({"sweep", drill, "--vary", "gamma=0.1:1:3", "--outputs",
                                     "thrust_margin,percussion_power,penetration_rate,force_peaks"}));
    QCOMPARE(rows[0][2], QByteArray("percussion_power [W]"));
    QCOMPARE(rows[0][3], QByteArray("penetration_rate [m/s]"));
    for (int i = 0; i < 3; ++i) {
        const QString gamma = QStringLiteral("gamma=%1").arg(points[i]["value"].toDouble(), 0, 'g', 17);
        const QJsonObject alone = json({"thrust", drill, "--set", gamma});
        QCOMPARE(points[i]["needs"].toObject(), alone["needs"].toObject());
        QCOMPARE(rows[i + 1][1].toDouble(), alone["thrust_margin"].toDouble());
        const QJsonObject run = json({"run", drill, "--set", gamma});
        QCOMPARE(run["si"]["thrust_margin"].toDouble(), alone["thrust_margin"].toDouble());
        QCOMPARE(rows[i + 1][2].toDouble(), run["si"]["percussion_power"].toDouble());
        QCOMPARE(rows[i + 1][4].toDouble(), run["si"]["force_peaks"].toDouble());
    }
    // The default number of points, with nothing but rows.
    QCOMPARE(rowsOf(output({"thrust", drill, "--along", "drill.thrust=2kN:20kN:log", "-o", "-"})).size(),
             102);
    for (const char* wrong :
         {"pulse.shape=rectangular", "gamma=1", "gamma=0.1:1:100000", "gamma=1:2:3:4:5"}) {
        const Finished result = run({"thrust", drill, "--along", wrong, "-o", "-"});
        QCOMPARE(result.exitCode, QByteArray(wrong) == "gamma=1" ? 0 : 2);
    }
    const Finished both = run({"thrust", drill, "--along", "gamma=0.1:1", "--frequency", "40Hz,50Hz"});
    QCOMPARE(both.exitCode, 2);
    // A value that no scenario may have: empty cells, counted.
    const Finished bad = run({"thrust", drill, "--along", "rod.diameter=14mm:38mm:2", "-o", "-"});
    QCOMPARE(bad.exitCode, 6);
    QVERIFY(bad.error.contains("1 of 2 points"));
    QVERIFY(bad.out.contains("\n14,,,,,,,,,,,,,\n"));
}

// Down the hole the weight adds to the feed, and everything says so.
void TestStudies::weightAlongTheHoleIsPartOfTheFeed() {
    const QStringList steep{"thrust",           example("t38_medium_rock"), "--set",
                            "drill.thrust=4kN", "drill.machine_mass=300kg", "drill.inclination=90deg"};
    const QJsonObject thrust = json(steep);
    const double weight = thrust["weight_along_hole"].toDouble();
    QVERIFY(weight > 300 * 9.8);
    QCOMPARE(thrust["effective_force"].toDouble(), 4000 + weight);
    QCOMPARE(thrust["needs"]["rigid_rock"]["margin"].toDouble(), (4000 + weight) / 6120 - 1);
    QCOMPARE(thrust["feed"]["state"].toString(), QString("required_at_this_gap"));
    QCOMPARE(thrust["feed"]["effective"].toDouble(), 4000 + weight);
    QVERIFY(output(steep).contains("4 kN (7.215 kN with the weight along the hole) is enough for this blow"));
    const QJsonObject level = json({"thrust", example("t38_medium_rock")});
    QVERIFY(level["weight_along_hole"].isNull());
    QCOMPARE(level["effective_force"].toDouble(), 8000.0);
    QCOMPARE(run({"thrust", example("t38_medium_rock"), "--set", "drill.inclination=91deg"}).exitCode, 5);
}

void TestStudies::figuresFillAFolder() {
    QTemporaryDir folder;
    const QString path = folder.filePath("new/figures");
    QVERIFY(output({"figures", "-o", path}).contains("printed numbers agree"));
    QStringList expected{"discrepancies.csv", "index.html"};
    for (const char* panel : {"fig3a", "fig3b", "fig4a", "fig4b", "fig5a", "fig5b", "fig6", "fig7", "fig8"})
        expected << QLatin1String(panel) + QLatin1String(".csv");
    for (int figure = 3; figure <= 8; ++figure)
        expected << QStringLiteral("fig%1.png").arg(figure) << QStringLiteral("fig%1.svg").arg(figure);
    expected.sort();
    QCOMPARE(QDir(path).entryList(QDir::Files, QDir::Name), expected);
    // The page shows every figure and names every table.
    const QByteArray page = read(path + "/index.html");
    for (const QString& name : expected)
        if (name.startsWith("fig") && !name.endsWith(".png"))
            QVERIFY2(page.contains(name.toUtf8()), qPrintable(name));
    QCOMPARE(output({"figures", "-o", "-"}), read(path + "/discrepancies.csv"));
    // Every printed number is in the page.
    const auto rows = rowsOf(read(path + "/discrepancies.csv"));
    QCOMPARE(page.count("<tr class="), rows.size() - 1);
}

void TestStudies::figuresNeverOverwriteUnasked() {
    QTemporaryDir folder;
    write(folder.filePath("fig7.csv"), "mine");
    const Finished refused = run({"figures", "-o", folder.path()});
    QCOMPARE(refused.exitCode, 4);
    QVERIFY(refused.error.contains("fig7.csv: exists already"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"fig7.csv"});
    output({"figures", "-o", folder.path(), "--force"});
    QVERIFY(read(folder.filePath("fig7.csv")).startsWith("beta,exact,closed_form"));
}

void TestStudies::anInterruptedStudyLeavesNothing() {
    QTemporaryDir folder;
    QProcess process;
    // So soft that each of some thousand blows takes half a second.
    process.start(QStringLiteral(DRILLWAVE_PROGRAM),
                  {"gap", example("paper_fig4b"), "--set", "beta=1e-8", "-o", folder.filePath("gap.csv")});
    QVERIFY(process.waitForStarted());
    QVERIFY(waitForThreads(process, 2));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void TestStudies::germanUsersGetTheSameNumbers() {
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert("LC_ALL", "de_DE.UTF-8");
    for (const QStringList& words :
         {QStringList{"thrust", example("t38_medium_rock"), "--frequency", "37.5Hz,60Hz"},
          QStringList{"figures", "-o", "-"}, QStringList{"gap", example("paper_fig4a"), "-o", "-"}})
        QCOMPARE(run(words, german).out, output(words));
}

void TestStudies::roundedNumbersOfSamplesAreTold() {
    const QStringList design{"design", example("t38_medium_rock"), "--uncertain", "bit_rock.gap=0mm:1mm",
                             "--samples"};
    const Finished rounded = run(design + QStringList{"100"}), taken = run(design + QStringList{"128"});
    QCOMPARE(rounded.error, QByteArray("--samples 100: rounded up to 128, a power of two\n"));
    QCOMPARE(taken.error, QByteArray());
    QCOMPARE(rounded.out, taken.out);
}

QTEST_GUILESS_MAIN(TestStudies)
#include "tst_studies.moc"
