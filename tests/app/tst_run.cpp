// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave run: the JSON object, the files, and running a case again from them.
#include <QTest>

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QJsonObject blow(const QStringList& words) {
    return json(QStringList{"run"} + words);
}

const QStringList outputNames{"cor",
                              "impulse",
                              "peak_force",
                              "max_penetration",
                              "residual_penetration",
                              "first_contact_time",
                              "separation_time",
                              "contact_duration",
                              "work_ratio",
                              "rock_work",
                              "rebound_energy",
                              "residual_wave_energy",
                              "efficiency",
                              "momentum_residual",
                              "energy_residual",
                              "cor_error",
                              "peak_compression",
                              "peak_tension",
                              "peak_compression_after",
                              "peak_tension_after"};

}  // namespace

class TestRun : public QObject {
    Q_OBJECT

  private slots:
    void jsonGivesTheKnownRestitution_data();
    void jsonGivesTheKnownRestitution();
    void jsonHasEveryNameOfTheContract();
    void jsonInSiIsTheDimensionlessResultTimesTheScales();
    void anUnsolvedCaseHasNullsAndExitCodeSix();
    void aYieldStrengthAddsAWarningAndChangesNothingElse();
    void settingsApplyWhateverTheirOrder();
    void theSummaryIsForPeople();
    void theSummaryHasWhatADrillerDecidesBy();
    void filesAreWrittenAndNotOverwritten();
    void plotsOfAnEarlierRunDoNotStay();
    void everyRunWritesTheSameBytes();
    void aRunIsRepeatedFromItsHistories();
    void theScenarioOfARunKeepsCommentsAndSources();
    void aTableOfPointsIsCompleteInTheHistories();
    void aDrillStringHasHistoriesAndPlots();
    void energiesInSiAreInJoules();
    void velocityAndMomentumOfAStringHaveTheirUnits();
    void sectionsHoldTheLargestStressOfAllTimesAndOfEachSpan();
    void plotsAreWrittenWithoutADisplay();
    void theLocaleDoesNotMatter();
};

void TestRun::jsonGivesTheKnownRestitution_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<double>("cor");
    QTest::addColumn<double>("tolerance");
    // 33-digit event-driven solution; the tolerance is the accuracy of the solver in double precision.
    const QString elastic = example("paper_fig4a");
    const QString reference = example("reference_case");
    const auto set = [](const QString& file, std::initializer_list<const char*> settings) {
        QStringList words{file};
        for (const char* setting : settings) words << "--set" << setting;
        return words;
    };
    QTest::newRow("paper Fig. 4 (a)") << QStringList{elastic} << 1.4010824845070556 << 1e-13;
    QTest::newRow("paper Fig. 4 (b)") << QStringList{example("paper_fig4b")} << 0.40671074387478970 << 1e-13;
    QTest::newRow("paper Fig. 8, minimum")
        << QStringList{example("paper_fig8_minimum")} << 0.84210576467383562 << 1e-13;
    QTest::newRow("soft and inelastic")
        << set(elastic, {"beta=0.01", "gamma=0.1"}) << 0.14105214688032185 << 1e-13;
    QTest::newRow("nearly elastic") << set(elastic, {"gamma=0.99999999", "delta=0.1"}) << 1.2742670575735909
                                    << 1e-13;
    QTest::newRow("soft reference") << set(reference, {"tau=1", "beta=5e-4"}) << 0.99999999498851341 << 1e-13;
    QTest::newRow("soft and short") << set(elastic, {"tau=0.6", "beta=0.001"}) << 1.0000500288434207 << 1e-13;
    QTest::newRow("very stiff") << set(elastic, {"beta=1e8", "gamma=0.1", "delta=0.3"}) << 0.99999998802999747
                                << 1e-13;
}

void TestRun::jsonGivesTheKnownRestitution() {
    QFETCH(QStringList, words);
    QFETCH(double, cor);
    QFETCH(double, tolerance);
    const QJsonObject result = blow(words)["dimensionless"].toObject();
    const double found = result["cor"].toDouble();
    QVERIFY2(std::abs(found - cor) <= tolerance, qPrintable(QString::number(found - cor)));
    QVERIFY(result["cor_error"].toDouble() >= std::abs(found - cor) - 1e-16);
}

void TestRun::jsonHasEveryNameOfTheContract() {
    const QJsonObject object = blow({example("t38_medium_rock")});
    for (const char* key :
         {"groups", "dimensionless", "si", "events", "method", "run_time", "alerts", "outcome"})
        QVERIFY2(object.contains(key), key);
    for (const QString& name : outputNames) {
        QVERIFY2(object["dimensionless"].toObject()[name].isDouble(), qPrintable(name));
        QVERIFY2(object["si"].toObject()[name].isDouble(), qPrintable(name));
    }
    for (const char* group : {"beta", "gamma", "tau", "delta"})
        QVERIFY(object["groups"].toObject()[group].isDouble());
    QVERIFY(object["si"].toObject()["thrust"].isDouble());
    QVERIFY(!object["dimensionless"].toObject().contains("thrust"));
    QCOMPARE(object["method"].toString(), QString("exact"));
    QCOMPARE(object["outcome"].toString(), QString("rebounded"));
    QVERIFY(object["run_time"].toDouble() > 0);
    const QJsonArray events = object["events"].toArray();
    QCOMPARE(events.first().toObject()["kind"].toString(), QString("contact"));
    QCOMPARE(events.last().toObject()["kind"].toString(), QString("separation"));
    QVERIFY(events.last().toObject()["time"].isDouble());
    // Given by its groups, a scenario has no SI values.
    QVERIFY(!blow({example("paper_fig4a")}).contains("si"));
    const QJsonArray alerts = blow({example("paper_fig4a")})["alerts"].toArray();
    for (const char* key : {"level", "code", "parameter", "text"})
        QVERIFY(alerts.first().toObject().contains(key));
}

void TestRun::jsonInSiIsTheDimensionlessResultTimesTheScales() {
    const QJsonObject object = blow({example("t38_medium_rock")});
    const QJsonObject plain = object["dimensionless"].toObject();
    const QJsonObject si = object["si"].toObject();
    const auto scale = [&](const char* name) { return si[name].toDouble() / plain[name].toDouble(); };
    // I0 = 51 N s, t0 = 200 us; two roundings.
    QVERIFY(std::abs(scale("impulse") / 51 - 1) < 1e-15);
    QVERIFY(std::abs(scale("separation_time") / 200e-6 - 1) < 1e-15);
    QVERIFY(std::abs(scale("peak_force") / 255e3 - 1) < 1e-15);
    QCOMPARE(si["cor"], plain["cor"]);
    QVERIFY(std::abs(si["thrust"].toDouble() / (60 * si["impulse"].toDouble()) - 1) < 1e-15);
}

void TestRun::anUnsolvedCaseHasNullsAndExitCodeSix() {
    const Finished finished = run({"run", example("paper_fig4a"), "--set", "beta=1e-300", "--json"});
    QCOMPARE(finished.exitCode, 6);
    const QJsonObject object = QJsonDocument::fromJson(finished.out).object();
    QCOMPARE(object["outcome"].toString(), QString("not_solved"));
    QVERIFY(!object["reason"].toString().isEmpty());
    for (const QString& name : outputNames) QVERIFY(object["dimensionless"].toObject()[name].isNull());
}

void TestRun::aYieldStrengthAddsAWarningAndChangesNothingElse() {
    const QString file = example("r32_hard_rock");
    const auto strong = blow({file, "--set", "rod.yield_strength=2000 MPa"});
    const auto weak = blow({file, "--set", "rod.yield_strength=200 MPa"});
    const auto none = blow({file});
    QCOMPARE(strong["dimensionless"], none["dimensionless"]);
    QCOMPARE(weak["si"], none["si"]);
    QCOMPARE(strong["alerts"], none["alerts"]);
    const QJsonArray alerts = weak["alerts"].toArray();
    QCOMPARE(alerts.size(), none["alerts"].toArray().size() + 1);
    const auto yields = std::ranges::find_if(
        alerts, [](const QJsonValue& alert) { return alert["code"] == QString("stress_above_yield"); });
    QVERIFY(yields != alerts.end());
    QCOMPARE(yields->toObject()["parameter"].toString(), QString("rod.yield_strength"));
}

void TestRun::settingsApplyWhateverTheirOrder() {
    const QString file = example("t38_medium_rock");
    const QJsonObject one = blow({file, "--set", "beta=0.8", "--set", "rod.diameter=45 mm"});
    const QJsonObject two = blow({file, "--set", "rod.diameter=45mm", "--set", "beta=0.8"});
    QCOMPARE(one["groups"], two["groups"]);
    QCOMPARE(one["groups"].toObject()["beta"].toDouble(), 0.8);
    QCOMPARE(one["dimensionless"], two["dimensionless"]);
}

void TestRun::theSummaryIsForPeople() {
    const Finished finished = run({"run", example("t38_medium_rock")});
    QCOMPARE(finished.exitCode, 0);
    QCOMPARE(finished.error, QByteArray());
    for (const char* part :
         {"T38 rod, medium rock", "restitution", " kN", " mm", " ms", " J", "feed required"})
        QVERIFY2(finished.out.contains(part), part);
    for (const QByteArray& line : finished.out.split('\n'))
        QVERIFY2(line.size() < 160 || line.startsWith("  warning: "), line);
    const Finished warned = run({"run", example("t38_medium_rock"), "--set", "drill.thrust=1kN"});
    QVERIFY2(warned.out.contains("The feed force of 1 kN is less than the mean force of the blows, 3.06 kN"),
             warned.out);
    // The recommendation stands first.
    QVERIFY2(finished.out.startsWith(
                 "T38 rod, medium rock\n"
                 "  A feed force of 8 kN is enough for a single blow at any gap (7.253 kN required)."),
             finished.out);
}

// As the window puts them first.
void TestRun::theSummaryHasWhatADrillerDecidesBy() {
    const auto lineOf = [](const Finished& finished, const QByteArray& name) {
        for (const QByteArray& line : finished.out.split('\n'))
            if (line.trimmed().startsWith(name)) return line;
        return QByteArray();
    };
    const QString file = example("t38_medium_rock");
    const Finished finished = run({"run", file});
    const QJsonObject si = blow({file})["si"].toObject();
    const QByteArray tension = lineOf(finished, "largest tension");
    QVERIFY(tension.contains(QByteArray::number(si["peak_tension"].toDouble() / 1e6, 'g', 6) + " MPa"));
    QVERIFY2(tension.contains(" from the hammer, at "), tension);
    QVERIFY(lineOf(finished, "largest compression").contains(" MPa "));
    const QByteArray power = QByteArray::number(si["percussion_power"].toDouble() / 1e3, 'g', 4) + " kW";
    QVERIFY2(lineOf(finished, "percussion power").endsWith(power), lineOf(finished, "percussion power"));
    QVERIFY(lineOf(finished, "penetration rate").contains(" of blows like this one"));
    QVERIFY(lineOf(finished, "feed required").endsWith("installed 8 kN"));
    QVERIFY(lineOf(finished, "at every gap").contains(", met with "));
    const Finished weak = run({"run", file, "--set", "drill.thrust=4.5kN"});
    const double margin =
        blow({file, "--set", "drill.thrust=4.5kN"})["si"].toObject()["thrust_margin"].toDouble();
    QVERIFY(margin < 0);
    const QByteArray share = "(" + QByteArray::number(-100 * margin, 'g', 3) + " %)";
    const QByteArray said = lineOf(weak, "at every gap");
    QVERIFY2(said.contains(", not met: short by ") && said.endsWith(share), said);
    // In groups there is neither a frequency nor a stress in MPa.
    const Finished groups = run({"run", example("paper_fig4a")});
    QVERIFY(lineOf(groups, "largest compression").contains(" F0/A  at x/L = "));
    QVERIFY(lineOf(groups, "percussion power").isEmpty());
}

void TestRun::filesAreWrittenAndNotOverwritten() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("new/folder");
    const QStringList words{"run", example("t38_medium_rock"), "-o", out};
    QCOMPARE(run(words).exitCode, 0);
    QCOMPARE(QDir(out).entryList(QDir::Files),
             QStringList({"events.csv", "histories.csv", "scenario.yaml", "summary.json"}));
    const QByteArray histories = read(out + "/histories.csv");
    QVERIFY(histories.startsWith("# # Written by Drillwave "));
    QVERIFY(
        histories.contains("\ntime [s],impact_force [N],impulse [N s],momentum [N s],incident_wave [N],"
                           "penetration [m],front_velocity [m/s]\n"));
    QVERIFY(read(out + "/events.csv").contains("\nkind,time [s]\ncontact,"));
    const QJsonObject summary = QJsonDocument::fromJson(read(out + "/summary.json")).object();
    QCOMPARE(summary["dimensionless"].toObject()["separation_time"].toDouble(),
             blow({example("t38_medium_rock")})["dimensionless"].toObject()["separation_time"].toDouble());

    // One of the files is enough to refuse, and nothing is touched then.
    QVERIFY(QFile::remove(out + "/events.csv") && QFile::remove(out + "/summary.json"));
    const Finished refused = run(words);
    QCOMPARE(refused.exitCode, 4);
    QVERIFY(refused.error.contains("scenario.yaml: exists already; use --force"));
    QVERIFY(!QFileInfo::exists(out + "/events.csv"));
    QCOMPARE(run(words + QStringList{"--force", "--dimensionless"}).exitCode, 0);
    QVERIFY(read(out + "/histories.csv").contains("\ntime,impact_force,impulse,momentum,incident_wave,"));
    QVERIFY(read(out + "/events.csv").contains("\nkind,time\ncontact,"));
    QCOMPARE(run(words + QStringList{"--force", "--si"}).exitCode, 0);
    QVERIFY(read(out + "/histories.csv") == histories);
}

// With other formats the old plots would stay beside the new numbers.
void TestRun::plotsOfAnEarlierRunDoNotStay() {
    const QTemporaryDir folder;
    const QStringList words{"run", example("paper_fig4b"), "-o", folder.path(), "--force"};
    QCOMPARE(run(words + QStringList{"--plots", "svg"}).exitCode, 0);
    write(folder.filePath("notes.txt"), "mine");
    QCOMPARE(run(words + QStringList{"--plots", "png"}).exitCode, 0);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
             QStringList({"blow.png", "events.csv", "histories.csv", "notes.txt", "rock.png", "rod.png",
                          "scenario.yaml", "summary.json", "wave_picture.png"}));

    // A folder that holds no run holds no plots of one.
    const QTemporaryDir other;
    write(other.filePath("blow.svg"), "mine");
    QCOMPARE(run({"run", example("paper_fig4b"), "-o", other.path(), "--force"}).exitCode, 0);
    QCOMPARE(read(other.filePath("blow.svg")), QByteArray("mine"));
}

// Containers of Qt are in another order in every process: what is drawn must not follow it.
void TestRun::everyRunWritesTheSameBytes() {
    const QTemporaryDir folder;
    QMap<QString, QByteArray> first;
    for (int round = 0; round < 5; ++round) {
        const QString out = folder.filePath(QString::number(round));
        QCOMPARE(run({"run", example("t38_medium_rock"), "-o", out, "--plots", "png,svg"}).exitCode, 0);
        for (const char* name :
             {"scenario.yaml", "histories.csv", "events.csv", "blow.png", "blow.svg", "rock.png", "rock.svg",
              "rod.png", "rod.svg", "wave_picture.png", "wave_picture.svg"}) {
            const QByteArray bytes = read(out + "/" + name);
            if (round == 0) first[name] = bytes;
            QVERIFY2(bytes == first[name], name);
        }
    }
}

void TestRun::aRunIsRepeatedFromItsHistories() {
    const QTemporaryDir folder;
    const QStringList settings{"--set", "beta=0.7", "--set", "pulse.shape=half_sine"};
    const QString out = folder.filePath("out");
    QCOMPARE(run(QStringList{"run", example("t38_medium_rock"), "-o", out} + settings).exitCode, 0);
    QJsonObject first = blow(QStringList{example("t38_medium_rock")} + settings);
    for (const char* file : {"/histories.csv", "/events.csv"}) {
        QJsonObject again = blow({out + file});
        for (QJsonObject* object : {&first, &again}) object->remove("run_time");
        QCOMPARE(again, first);
    }
    // Into another folder: what a run is repeated from stays as it is.
    const QByteArray before = read(out + "/histories.csv");
    const Finished refused = run({"run", out + "/histories.csv", "--set", "beta=2", "-o", out, "--force"});
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.error.contains("is also the input"), refused.error);
    QCOMPARE(read(out + "/histories.csv"), before);
}

// With --set values put in; a comment behind a value that was set was about another one.
void TestRun::theScenarioOfARunKeepsCommentsAndSources() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.yaml"), out = folder.filePath("out");
    QByteArray scenario = read(example("t38_string"));
    write(file, scenario);
    QCOMPARE(
        run({"run", file, "-o", out, "--set", "bit_rock.gamma=0.2", "--set", "drill.thrust=9 kN"}).exitCode,
        0);
    scenario.replace("gamma: 0.1                  # as the paper takes it for drilling", "gamma: 0.2");
    scenario.replace("thrust: 10 kN               # assumed", "thrust: 9 kN");
    const QByteArray written = read(out + "/scenario.yaml");
    QVERIFY2(written.endsWith(scenario), written);
    QCOMPARE(written.count('#'),
             scenario.count('#') + written.first(written.size() - scenario.size()).count('#'));
    // Histories and a report hold it to be run again.
    QVERIFY(json({"run", out + "/summary.json"})["scenario"].toString().contains(
        "# usual size of a T38 coupling"));
    const QString page = folder.filePath("report.html");
    QCOMPARE(run({"report", file, "--no-plots", "-o", page, "--set", "bit_rock.gamma=0.2"}).exitCode, 0);
    const QString again = json({"run", page})["scenario"].toString();
    QVERIFY2(again.contains("# usual size of a T38 coupling") && again.contains("gamma: 0.2\n"),
             qPrintable(again));
}

void TestRun::aTableOfPointsIsCompleteInTheHistories() {
    const QTemporaryDir folder;
    write(folder.filePath("blow.csv"), "time [us],force [kN]\n0,0\n100,300\n250,0\n");
    QByteArray scenario = read(example("t38_medium_rock"));
    const qsizetype pulse = scenario.indexOf("pulse:");
    scenario.replace(pulse, scenario.indexOf("bit_rock:") - pulse,
                     "pulse:\n  shape: table\n  file: blow.csv\n");
    write(folder.filePath("case.yaml"), scenario);
    const QString out = folder.filePath("out");
    QCOMPARE(run({"run", folder.filePath("case.yaml"), "-o", out}).exitCode, 0);
    const QJsonObject first = blow({folder.filePath("case.yaml")});
    // The points are in the file itself: the table may be gone.
    QVERIFY(QFile::remove(folder.filePath("blow.csv")));
    const QJsonObject again = blow({out + "/histories.csv"});
    QCOMPARE(again["groups"], first["groups"]);
    QCOMPARE(again["dimensionless"], first["dimensionless"]);
}

void TestRun::aDrillStringHasHistoriesAndPlots() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("out");
    QCOMPARE(run({"run", "t38_string", "-o", out, "--plots", "svg"}).exitCode, 0);
    QCOMPARE(QDir(out).entryList(QDir::Files, QDir::Name),
             QStringList({"blow.svg", "events.csv", "histories.csv", "rock.svg", "rod.svg", "scenario.yaml",
                          "summary.json", "wave_picture.svg"}));
    const QByteArray csv = read(out + "/histories.csv");
    QVERIFY(
        csv.contains("\ntime [s],impact_force [N],impulse [N s],momentum [N s],penetration [m],"
                     "front_velocity [m/s],face_force [N],normal_force [N],positive_wave [N],"
                     "negative_wave [N],velocity [m/s]\n"));
    QVERIFY(csv.contains("1.83 m from the rear end of section 3 of the string (rod)"));
    const double impulse = csv.trimmed().split('\n').last().split(',').at(2).toDouble();
    const QJsonObject si = blow({"t38_string"})["si"].toObject();
    QVERIFY(std::abs(impulse / si["impulse"].toDouble() - 1) < 1e-6);
    // and it can be run again
    QCOMPARE(blow({out + "/histories.csv"})["dimensionless"], blow({"t38_string"})["dimensionless"]);
}

void TestRun::energiesInSiAreInJoules() {
    const QJsonObject rod = blow({example("t38_medium_rock")});
    const QJsonObject si = rod["si"].toObject(), plain = rod["dimensionless"].toObject();
    QCOMPARE(rod["units"].toObject()["rock_work"].toString(), QString("J"));
    // 60 blows a second of the work of the hammer
    const double work = si["percussion_power"].toDouble() / 60;
    for (const char* name : {"rock_work", "rebound_energy", "residual_wave_energy"})
        QVERIFY(std::abs(si[name].toDouble() - work * plain[name].toDouble()) < 1e-12 * work);
    QCOMPARE(si["efficiency"], plain["efficiency"]);
    const QJsonObject string = blow({"t38_string"});
    const double hammer = 342.5;  // J, to as many digits as here
    QVERIFY(std::abs(string["si"].toObject()["rock_work"].toDouble() / hammer -
                     string["dimensionless"].toObject()["rock_work"].toDouble()) < 1e-4);
}

void TestRun::velocityAndMomentumOfAStringHaveTheirUnits() {
    const QJsonObject string = blow({"t38_string"});
    const QJsonObject si = string["si"].toObject(), units = string["units"].toObject();
    QCOMPARE(units["hammer_rebound_velocity"].toString(), QString("m/s"));
    QCOMPARE(units["string_momentum"].toString(), QString("N s"));
    const Finished row = run({"sweep", "t38_string", "--vary", "bit_rock.gamma=0.1", "--si", "--outputs",
                              "hammer_rebound_velocity,string_momentum"});
    const QList<QList<QByteArray>> rows = rowsOf(row.out);
    QCOMPARE(rows[0].mid(1), QList<QByteArray>({"hammer_rebound_velocity [m/s]", "string_momentum [N s]"}));
    // Swept strings are solved to fewer digits.
    QVERIFY(std::abs(rows[1][1].toDouble() / si["hammer_rebound_velocity"].toDouble() - 1) < 1e-6);
    QVERIFY(std::abs(rows[1][2].toDouble() / si["string_momentum"].toDouble() - 1) < 1e-6);
}

void TestRun::sectionsHoldTheLargestStressOfAllTimesAndOfEachSpan() {
    const QJsonObject string = blow({"t38_string", "--set", "bit_rock.stiffness=300MN/m"});
    double largestInBlow = 0;
    int afterTheBlow = 0;
    for (const QJsonValue& section : string["sections"].toArray()) {
        const auto stress = [&](const QString& name) { return section[name]["stress"].toDouble(-1); };
        for (const QString& kind : {QStringLiteral("compression"), QStringLiteral("tension")}) {
            const double during = stress(kind + "_blow"), after = stress(kind + "_after");
            QVERIFY(during >= 0 && after >= 0);
            QCOMPARE(stress(kind), std::max(during, after));
            QCOMPARE(section[kind], section[kind + (after > during ? "_after" : "_blow")]);
            afterTheBlow += after > during;
        }
        largestInBlow = std::max(largestInBlow, stress("tension_blow"));
    }
    QVERIFY(afterTheBlow > 0);
    QCOMPARE(largestInBlow, string["si"]["peak_tension"].toDouble());
}

void TestRun::plotsAreWrittenWithoutADisplay() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "XDG_RUNTIME_DIR"})
        environment.remove(name);
    const QTemporaryDir folder;
    const QStringList words{"run", example("paper_fig4b"), "-o", folder.path(), "--plots", "png,svg,pdf"};
    const Finished finished = run(words, environment);
    QCOMPARE(finished.exitCode, 0);
    QCOMPARE(finished.error, QByteArray());
    QVERIFY(read(folder.filePath("blow.png")).startsWith("\x89PNG"));
    QVERIFY(read(folder.filePath("blow.svg")).contains("<svg"));
    QVERIFY(read(folder.filePath("blow.pdf")).startsWith("%PDF"));
    QVERIFY(QFile::remove(folder.filePath("summary.json")));
    QCOMPARE(run(words, environment).exitCode, 4);
}

void TestRun::theLocaleDoesNotMatter() {
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert("LC_ALL", "de_DE.UTF-8");
    german.insert("LANG", "de_DE.UTF-8");
    const QStringList words{"run",      example("t38_medium_rock"), "--set", "rod.length=4.27 m", "--set",
                            "beta=0.55"};
    const auto withoutTime = [](const QByteArray& out) {
        QList<QByteArray> lines = out.split('\n');
        lines.removeIf([](const QByteArray& line) { return line.contains("solved in"); });
        return lines.join('\n');
    };
    QCOMPARE(withoutTime(run(words, german).out), withoutTime(run(words).out));
    QVERIFY(run(words, german).out.contains("beta 0.55 "));
}

QTEST_GUILESS_MAIN(TestRun)
#include "tst_run.moc"
