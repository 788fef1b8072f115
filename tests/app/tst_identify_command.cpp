// SPDX-License-Identifier: GPL-3.0-or-later
// `drillwave identify` as a shell runs it: a record of the program itself, and input that is refused.
#include <QTest>

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/program.h"

using namespace drillwave::test;

namespace {

QString recordOf(const char* name) {
    QString path = example(QStringLiteral("identify/") + QLatin1String(name));
    return path.replace(QStringLiteral(".yaml"), QStringLiteral(".csv"));
}

/// Value, low and high end of a parameter; NaN where there is none.
std::array<double, 3> parameter(const QJsonObject& answer, const QString& key) {
    const QJsonArray parameters = answer["parameters"].toArray();
    for (const QJsonValue& one : parameters)
        if (one["key"].toString() == key)
            return {one["value"].toDouble(), one["low"].toDouble(qQNaN()), one["high"].toDouble(qQNaN())};
    return {qQNaN(), qQNaN(), qQNaN()};
}

/// One message, and no folder.
void refused(const Finished& finished, int exitCode, const QString& folder) {
    QVERIFY2(finished.exitCode == exitCode, finished.error.constData());
    QVERIFY2(finished.error.count('\n') == 1, finished.error.constData());
    QVERIFY(!QFile::exists(folder));
}

}  // namespace

class TestIdentifyCommand : public QObject {
    Q_OBJECT

  private slots:
    void aRehearsedRecordGivesTheRockBack_data();
    void aRehearsedRecordGivesTheRockBack();
    void aRehearsalThatCannotBeIsRefused_data();
    void aRehearsalThatCannotBeIsRefused();
    void wrongQuestionsAreRefused_data();
    void wrongQuestionsAreRefused();
    void wrongRecordsAreRefused_data();
    void wrongRecordsAreRefused();
    void aCornerWithoutEffectIsNotCalledKnown();
};

void TestIdentifyCommand::aRehearsedRecordGivesTheRockBack_data() {
    QTest::addColumn<QString>("scenario");
    QTest::addColumn<QStringList>("gauges");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("most");  // relative deviation of stiffness and gamma
    QTest::newRow("rod") << example("t38_medium_rock") << QStringList{"a@1.8m"} << 105e6 << 2e-3;
    QTest::newRow("gauges on opposite sides")
        << example("t38_medium_rock") << QStringList{"a+b@1.8m"} << 105e6 << 2e-3;
    QTest::newRow("string") << example("t38_string") << QStringList{"near@1.1m", "far@2.5m"} << 100e6 << 2e-2;
}

void TestIdentifyCommand::aRehearsedRecordGivesTheRockBack() {
    QFETCH(QString, scenario);
    QFETCH(QStringList, gauges);
    QFETCH(double, stiffness);
    QFETCH(double, most);
    const QTemporaryDir folder;
    QStringList plan{"run", scenario, "-o", folder.filePath("plan")};
    QStringList question{"identify", scenario, "--signals", folder.filePath("plan/record.csv")};
    for (const QString& gauge : gauges) {
        plan << "--record" << gauge;
        question << "--gauge" << gauge;
    }
    QCOMPARE(run(plan).exitCode, 0);
    const QJsonObject answer = json(question);
    const auto k = parameter(answer, "bit_rock.stiffness"), gamma = parameter(answer, "bit_rock.gamma");
    QVERIFY2(std::abs(k[0] / stiffness - 1) < most, qPrintable(QString::number(k[0])));
    QVERIFY2(std::abs(gamma[0] / 0.1 - 1) < most, qPrintable(QString::number(gamma[0])));
    QVERIFY(k[1] < stiffness && stiffness < k[2]);
}

void TestIdentifyCommand::aRehearsalThatCannotBeIsRefused_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    const QString rod = example("t38_medium_rock");
    QTest::newRow("beyond the rod") << QStringList{rod, "--record", "a@9m"} << 5;
    QTest::newRow("at the bit face") << QStringList{rod, "--record", "a@0m"} << 5;
    QTest::newRow("no distance") << QStringList{rod, "--record", "a"} << 2;
    QTest::newRow("three gauges") << QStringList{rod,    "--record", "a@1m", "--record",
                                                 "b@2m", "--record", "c@3m"}
                                  << 2;
    QTest::newRow("noise alone") << QStringList{rod, "--noise", "1%"} << 2;
    QTest::newRow("noise without %") << QStringList{rod, "--record", "a@1m", "--noise", "1"} << 5;
    QTest::newRow("no units") << QStringList{example("paper_fig4a"), "--record", "a@1m"} << 5;
}

void TestIdentifyCommand::aRehearsalThatCannotBeIsRefused() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    const QTemporaryDir folder;
    const QString plan = folder.filePath("plan");
    refused(run(QStringList{"run"} + words + QStringList{"-o", plan}), exitCode, plan);
}

void TestIdentifyCommand::wrongQuestionsAreRefused_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("exitCode");
    const QString gauge = QStringLiteral("--gauge top+bottom@1.83m ");
    QTest::newRow("no gauge") << QString() << 2;
    QTest::newRow("three gauges") << "--gauge top@1m --gauge top@1.7m --gauge bottom@2.4m" << 2;
    QTest::newRow("no distance") << "--gauge top" << 2;
    QTest::newRow("no unit") << "--gauge top@1.83" << 5;
    QTest::newRow("at the bit face") << "--gauge top@0m" << 5;
    QTest::newRow("beyond the rod") << "--gauge top@9m" << 5;
    QTest::newRow("at the struck end") << "--gauge top@3.66m" << 5;
    QTest::newRow("column missing") << "--gauge middle@1.83m" << 5;
    QTest::newRow("column twice") << "--gauge top+top@1.83m" << 5;
    QTest::newRow("column of both gauges") << "--gauge top@1.2m --gauge top@2.4m" << 5;
    QTest::newRow("gauges too near") << "--gauge top@1.2m --gauge bottom@1.6m" << 5;
    QTest::newRow("unknown key") << gauge + "--known rod.colour=+-1mm" << 5;
    QTest::newRow("tolerance larger than its value") << gauge + "--known rod.diameter=+-50mm" << 5;
    QTest::newRow("tolerance 0") << gauge + "--known gain=+-0%" << 5;
    QTest::newRow("unknown law") << gauge + "--law cubic" << 2;
    QTest::newRow("window of no length") << gauge + "--end 0us" << 5;
}

void TestIdentifyCommand::wrongQuestionsAreRefused() {
    QFETCH(QString, words);
    QFETCH(int, exitCode);
    const QTemporaryDir folder;
    const QString rock = folder.filePath("rock");
    refused(run(QStringList{"identify", example("identify/rod"), "--signals", recordOf("rod"), "-o", rock} +
                words.split(' ', Qt::SkipEmptyParts)),
            exitCode, rock);
}

void TestIdentifyCommand::wrongRecordsAreRefused_data() {
    QTest::addColumn<int>("first");  // line of the table after the heading
    QTest::addColumn<int>("last");
    QTest::addColumn<QByteArray>("cell");  // of both gauges in line 300
    QTest::newRow("49 samples of zero") << 462 << 100000 << QByteArray();
    QTest::newRow("trigger inside the blow") << 600 << 100000 << QByteArray();
    QTest::newRow("ends before the reflection") << 1 << 700 << QByteArray();
    QTest::newRow("nothing but zeros") << 1 << 140 << QByteArray();
    QTest::newRow("a word in a cell") << 1 << 100000 << QByteArray("oops");
    QTest::newRow("not a number") << 1 << 100000 << QByteArray("nan");
}

void TestIdentifyCommand::wrongRecordsAreRefused() {
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(QByteArray, cell);
    const QList<QByteArray> lines = read(recordOf("rod")).split('\n');
    const QTemporaryDir folder;
    QFile file(folder.filePath("record.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(lines.first() + '\n');
    for (int line = first; line < std::min<int>(last, static_cast<int>(lines.size())); ++line) {
        const bool isSpoiled = line == 300 && !cell.isEmpty();
        const QByteArray time = lines[line].left(lines[line].indexOf(','));
        file.write((isSpoiled ? time + ',' + cell + ',' + cell : lines[line]) + '\n');
    }
    file.close();
    const QString rock = folder.filePath("rock");
    refused(run({"identify", example("identify/rod"), "--signals", file.fileName(), "--gauge",
                 "top+bottom@1.83m", "-o", rock}),
            3, rock);
}

void TestIdentifyCommand::aCornerWithoutEffectIsNotCalledKnown() {
    const QJsonObject answer = json({"identify", example("identify/rod"), "--signals", recordOf("rod"),
                                     "--gauge", "top+bottom@1.83m", "--law", "corner"});
    const QJsonArray parameters = answer["parameters"].toArray();
    QCOMPARE(parameters.size(), 5);
    const QString verdict = parameters[4]["verdict"].toString();
    // a slope near 1 bends nothing, either
    QVERIFY2(verdict == "not_seen" || std::abs(std::log(parameters[4]["value"].toDouble())) < 0.2,
             qPrintable(verdict));
    const auto k = parameter(answer, "bit_rock.stiffness");
    QVERIFY(k[1] < 130e6 && 130e6 < k[2]);
}

QTEST_GUILESS_MAIN(TestIdentifyCommand)
#include "tst_identify_command.moc"
