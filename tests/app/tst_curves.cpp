// SPDX-License-Identifier: GPL-3.0-or-later
// drillwave curve: features, points, record, and what it refuses.
#include <QTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QJsonArray featuresOf(const QJsonObject& curve, const char* output = "cor", int line = 0) {
    return curve["lines"][line]["outputs"][QLatin1String(output)]["features"].toArray();
}

}  // namespace

class TestCurves : public QObject {
    Q_OBJECT

  private slots:
    void theLargestReboundIsMarked();
    void levelsAreCrossed();
    void jsonHoldsScenarioAndUnits();
    void thePointsAreThoseOfASweep();
    void theRecordGivesTheSameCurveAgain();
    void theBytesDoNotDependOnTheNumberOfThreads();
    void aFamilyIsAColumn();
    void siScalesOutputsAndLevels();
    void aGoalIsGivenByAllItsValues();
    void whatGivesAGoalIsWrittenBeside();
    void aGoalThatNothingGivesIsToldWithTheNearest();
    void aFallingRangeIsFollowedFromItsLowerEnd();
    void whereThereIsNoAnswerCellsAreEmpty();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
};

void TestCurves::theLargestReboundIsMarked() {
    const QByteArray text = output({"curve", example("paper_fig4a"), "--along", "beta=0.1:10:log"});
    QVERIFY(text.contains("1.4140683") && text.contains("0.29982658") && text.contains("largest"));
    const QJsonArray features =
        featuresOf(json({"curve", example("paper_fig4a"), "--along", "beta=0.1:10:log"}));
    QCOMPARE(features.size(), 2);
    QCOMPARE(features[0]["kind"].toString(), QString("maximum"));
    QCOMPARE(features[0]["shape"].toString(), QString("smooth"));
    QVERIFY(features[0]["of_all"].toBool());
    // theory §7: half a unit of the last digit given there
    QVERIFY(std::abs(features[0]["value"].toDouble() - 1.4140683) < 5e-8);
    QVERIFY(std::abs(features[0]["x"].toDouble() - 0.29983) < 5e-6);
    QCOMPARE(features[1]["shape"].toString(), QString("end"));
}

void TestCurves::levelsAreCrossed() {
    const QStringList words{"curve", example("paper_fig4a"), "--along", "delta=0:1.2", "--level",
                            "1",     "--level=1.2"};
    QList<double> places;
    for (const QJsonValue feature : featuresOf(json(words)))
        if (feature["kind"].toString() == "crossing" && feature["level"].toDouble() == 1)
            places << feature["x"].toDouble();
    QCOMPARE(places.size(), 2);
    QVERIFY(std::abs(places[0] - 0.326877) < 5e-7 && std::abs(places[1] - 0.778532) < 5e-7);
    const QByteArray text = output(words);
    QVERIFY(text.contains("falls below 1 ") && text.contains("rises above 1.2"));
}

void TestCurves::jsonHoldsScenarioAndUnits() {
    const QJsonObject curve =
        json({"curve", example("t38_medium_rock"), "--along", "bit_rock.stiffness=20MN/m:500MN/m:log",
              "--outputs", "cor,peak_force", "--si", "--family", "gamma=0.1,1"});
    QVERIFY(curve["scenario"].toString().contains("bit_rock"));
    QCOMPARE(curve["units"]["bit_rock.stiffness"].toString(), QString("N/m"));
    QCOMPARE(curve["units"]["peak_force"].toString(), QString("N"));
    QCOMPARE(curve["units"]["cor"].toString(), QString("1"));
    QCOMPARE(curve["along"]["key"].toString(), QString("bit_rock.stiffness"));
    QCOMPARE(curve["along"]["stop"].toDouble(), 5e8);
    QVERIFY(curve["along"]["log"].toBool());
    QCOMPARE(curve["family"].toString(), QString("gamma"));
    QCOMPARE(curve["lines"].toArray().size(), 2);
    QVERIFY(curve["solves"].toInt() > 100 && curve["run_time"].toDouble() > 0);
}

void TestCurves::thePointsAreThoseOfASweep() {
    const auto rows = rowsOf(output({"curve", example("paper_fig4b"), "--along", "beta=0.1:10:log",
                                     "--outputs", "cor,peak_force", "-o", "-"}));
    QCOMPARE(rows[0], (QList<QByteArray>{"beta", "cor", "peak_force"}));
    QVERIFY(rows.size() > 500);
    QCOMPARE(rows[1][0], QByteArray("0.1"));
    QCOMPARE(rows.last()[0], QByteArray("10"));
    QByteArrayList betas;
    for (int i = 1; i < rows.size(); i += 20) betas << rows[i][0];
    const auto solved = rowsOf(output({"sweep", example("paper_fig4b"), "--vary", "beta=" + betas.join(','),
                                       "--outputs", "cor,peak_force"}));
    for (int i = 1; i < solved.size(); ++i)
        for (const int column : {1, 2})
            // 1e-10 of the size of the outputs is what the curve promises
            QVERIFY(std::abs(solved[i][column].toDouble() - rows[1 + 20 * (i - 1)][column].toDouble()) <
                    4e-10);
}

void TestCurves::theRecordGivesTheSameCurveAgain() {
    QTemporaryDir folder;
    const QString first = folder.filePath("a.csv"), second = folder.filePath("b.csv");
    output({"curve", example("t38_medium_rock"), "--along", "bit_rock.stiffness=20MN/m:500MN/m:log", "--set",
            "gamma=0.3", "-o", first});
    const QByteArray record = read(first + ".yaml");
    QVERIFY(record.contains("command: ") && record.contains("drillwave curve"));
    QVERIFY(record.contains("values: 20MN/m:500MN/m:log"));
    output({"curve", first + ".yaml", "--along", "bit_rock.stiffness=20MN/m:500MN/m:log", "-o", second});
    QCOMPARE(read(second), read(first));
    const Finished again = run({"curve", first + ".yaml", "--along", "beta=1:2", "-o", second});
    QCOMPARE(again.exitCode, 4);
    output({"curve", first + ".yaml", "--along", "beta=1:2", "-o", second, "--force"});
    QVERIFY(read(second) != read(first));
}

void TestCurves::theBytesDoNotDependOnTheNumberOfThreads() {
    QByteArrayList outputs;
    for (const char* jobs : {"1", "2", "7"})
        outputs << output({"curve", example("paper_fig4b"), "--along", "delta=0:2", "--family", "gamma=0.1,1",
                           "--outputs", "cor,separation_time,cor_error", "-j", jobs, "-o", "-"});
    QVERIFY(outputs[0] == outputs[1] && outputs[0] == outputs[2]);
}

void TestCurves::aFamilyIsAColumn() {
    const auto rows = rowsOf(output({"curve", example("paper_fig4b"), "--along", "beta=1:2", "--family",
                                     "pulse.shape=rectangular,half_sine", "-o", "-"}));
    QCOMPARE(rows[0], (QList<QByteArray>{"pulse.shape", "beta", "cor"}));
    QCOMPARE(rows[1][0], QByteArray("rectangular"));
    QCOMPARE(rows.last()[0], QByteArray("half_sine"));
}

void TestCurves::siScalesOutputsAndLevels() {
    const QStringList words{
        "curve", example("t38_medium_rock"), "--along", "gamma=0.05:1", "--outputs", "peak_force", "--si"};
    QVERIFY(output(words + QStringList{"-o", "-"}).startsWith("gamma,peak_force [N]\n"));
    const QJsonArray newton = featuresOf(json(words + QStringList{"--level", "320000"}), "peak_force");
    QCOMPARE(featuresOf(json(words + QStringList{"--level", "320 kN"}), "peak_force"), newton);
}

// theory §7; each is what `run` says of that value.
void TestCurves::aGoalIsGivenByAllItsValues() {
    const QStringList words{"curve", example("paper_fig4a"), "--along", "delta=0:1.2", "--goal", "1"};
    const QJsonObject curve = json(words);
    QCOMPARE(curve["goal"].toDouble(), 1.0);
    const QJsonObject goal = curve["lines"][0]["goal"].toObject();
    QVERIFY(goal["reached"].toBool() && goal["complete"].toBool() && goal["nearest"].isNull());
    const QJsonArray places = goal["places"].toArray();
    QCOMPARE(places.size(), 2);
    const double known[] = {0.326877, 0.778532};
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(places[i]["kind"].toString(), QString("crossing"));
        QCOMPARE(places[i]["rising"].toBool(), i == 1);
        const double x = places[i]["x"].toDouble();
        QVERIFY(std::abs(x - known[i]) < 5e-7 && places[i]["x_error"].toDouble() < 1e-9);
        const QString set = "delta=" + QString::number(x, 'g', 17);
        const QJsonObject blow = json({"run", example("paper_fig4a"), "--set", set});
        QVERIFY(std::abs(blow["dimensionless"]["cor"].toDouble() - 1) < 1e-9);
    }
    const QByteArray text = output(words).simplified();
    QVERIFY2(text.contains("Goal: cor = 1 ") && text.contains("falls through it 0.326877") &&
                 text.contains("There are no others from 0 to 1.2."),
             text.constData());
    QVERIFY(json({"curve", example("paper_fig4a"), "--along", "delta=0:1.2"})["goal"].isNull());
}

void TestCurves::whatGivesAGoalIsWrittenBeside() {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.csv"), beside = folder.filePath("a_goal.csv");
    const QStringList words{"curve",     example("t38_medium_rock"),
                            "--along",   "bit_rock.stiffness=20MN/m:500MN/m:log",
                            "--outputs", "peak_force",
                            "--si",      "--goal",
                            "240 kN",    "-o",
                            path};
    output(words);
    const auto rows = rowsOf(read(beside));
    QCOMPARE(rows[0].join(','), QByteArray("goal,kind,direction,bit_rock.stiffness [MN/m],place_error,"
                                           "peak_force [N],value_error,value_after"));
    QVERIFY(rows.size() >= 2);
    for (int i = 1; i < rows.size(); ++i) {
        QCOMPARE(rows[i][0], QByteArray("240000"));
        QCOMPARE(rows[i][1], QByteArray("crossing"));
        const QJsonObject blow = json({"run", example("t38_medium_rock"), "--set",
                                       "bit_rock.stiffness=" + QString::fromUtf8(rows[i][3]) + "MN/m"});
        // 1e-9 of the force is what a place promises at worst
        QVERIFY(std::abs(blow["si"]["peak_force"].toDouble() - 240e3) < 2.4e-4);
    }
    QVERIFY(read(path + ".yaml").contains("--goal"));
    QCOMPARE(run(words).exitCode, 4);
    // It goes with the study that it is of.
    QStringList without = words;
    without.removeAt(without.indexOf("--goal") + 1);
    without.removeOne("--goal");
    output(without + QStringList{"--force"});
    QVERIFY(QFile::exists(path) && !QFile::exists(beside));
}

void TestCurves::aGoalThatNothingGivesIsToldWithTheNearest() {
    const Finished finished =
        run({"curve", example("paper_fig4a"), "--along", "beta=0.1:10:log", "--goal", "2"});
    QCOMPARE(finished.exitCode, 6);
    QCOMPARE(finished.error.trimmed().count('\n'), 0);
    QVERIFY2(finished.error.contains(
                 "no beta from 0.1 to 10 gives cor = 2: the nearest is 1.4140683, at 0.29982658"),
             finished.error.constData());
    QVERIFY(finished.out.simplified().contains("None: no beta"));
}

void TestCurves::aFallingRangeIsFollowedFromItsLowerEnd() {
    const QStringList curve{"curve", example("paper_fig4a"), "-o", "-", "--along"};
    QCOMPARE(rowsOf(output(curve + QStringList{"beta=2:1:log"})),
             rowsOf(output(curve + QStringList{"beta=1:2:log"})));
}

void TestCurves::whereThereIsNoAnswerCellsAreEmpty() {
    const Finished finished =
        run({"curve", example("paper_fig4a"), "--along", "tau=0.2:5", "--method", "closed_form", "-o", "-"});
    QCOMPARE(finished.exitCode, 6);
    QVERIFY(finished.error.contains("from tau = 0.2 to 1.8") && finished.error.contains("tau >= 0.5"));
    const auto rows = rowsOf(finished.out);
    QCOMPARE(rows[1], (QList<QByteArray>{"0.2", ""}));
    QVERIFY(rows.last()[1].startsWith("1.40"));
}

void TestCurves::whatIsWrongIsSaid_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const auto add = [](const char* name, const QStringList& words, int exitCode, const char* message) {
        QTest::newRow(name) << words << exitCode << message;
    };
    add("no range", {}, 2, "needs --along");
    add("a list", {"--along", "beta=1,2,3"}, 2, "beta needs START:STOP");
    add("a point", {"--along", "beta=1:1"}, 2, "must end above its beginning");
    add("out of range", {"--along", "gamma=0.5:2"}, 5, "must be in (0, 1]");
    add("without meaning", {"--along", "rod.length=1m:2m"}, 5, "does not apply here");
    add("set and varied", {"--along", "beta=1:2", "--set", "beta=3"}, 2, "beta");
    add("one quantity twice", {"--along", "beta=1:2", "--family", "beta=1,2"}, 5, "set the same thing");
    add("an unknown output", {"--along", "beta=1:2", "--outputs", "corr"}, 2, "did you mean `cor`?");
    add("a study at every point", {"--along", "drill.thrust=8kN:9kN", "--outputs", "thrust_margin"}, 5,
        "study of all gaps");
    add("a level that is none", {"--along", "beta=1:2", "--level", "one"}, 2, "--level one");
    add("SI without units", {"--along", "beta=1:2", "--si"}, 5, "SI columns need");
    add("a goal that is none", {"--along", "beta=1:2", "--goal", "much"}, 2, "--goal much");
    add("a goal without an end", {"--along", "beta=1:2", "--goal", "nan"}, 2, "--goal nan");
    add("a goal of a ratio with a unit", {"--along", "beta=1:2", "--goal", "0.7 mm"}, 2, "--goal 0.7 mm");
    add("a goal with a unit without SI", {"--along", "beta=1:2", "--outputs", "peak_force", "--goal", "2kN"},
        2, "add --si");
    add("a goal of another unit",
        {"--along", "drill.thrust=8kN:9kN", "--outputs", "peak_force", "--si", "--goal", "5mm"}, 2, "kN");
    add("a goal of two outputs", {"--along", "beta=1:2", "--outputs", "cor,peak_force", "--goal", "1"}, 2,
        "--goal needs one output");
    add("a goal of a word", {"--along", "beta=1:2", "--outputs", "feed", "--goal", "1"}, 2, "feed");
    add("a goal along words", {"--along", "pulse.shape=rectangular:half_sine", "--goal", "1"}, 2,
        "pulse.shape");
    add("a goal at a point", {"--along", "beta=1:1", "--goal", "1"}, 2, "must end above its beginning");
    add("downwards from nowhere", {"--along", "beta=2:much"}, 5, "beta = much");
    add("downwards below zero by ratios", {"--along", "delta=1:0:log"}, 2, "must begin and end above 0");
    add("a goal on standard output", {"--along", "beta=1:2", "--goal", "1", "-o", "-"}, 2,
        "--goal cannot be used");
    add("force without a file", {"--along", "beta=1:2", "--force"}, 2,
        "--force applies to files; add -o FILE.csv");
}

void TestCurves::whatIsWrongIsSaid() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    const char* name = words.join(' ').contains("drill.") ? "t38_medium_rock" : "paper_fig4b";
    const Finished finished = run(QStringList{"curve", example(name)} + words);
    QCOMPARE(finished.exitCode, exitCode);
    QVERIFY2(finished.error.contains(message.toUtf8()), finished.error.constData());
    QCOMPARE(finished.error.trimmed().count('\n'), 0);
    QVERIFY(finished.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestCurves)
#include "tst_curves.moc"
