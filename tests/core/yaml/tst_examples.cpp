// SPDX-License-Identifier: GPL-3.0-or-later
// The built-in scenarios: the files of resources/examples, each valid and explained.
#include <QTest>

#include <QDir>
#include <QFile>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/report/alert_words.h"
#include "core/wave/exact/exact_solver.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

class TestExamples : public QObject {
    Q_OBJECT

  private slots:
    void theyAreTheFilesOfTheFolder();
    void eachIsAValidScenarioWithoutWarnings_data();
    void eachIsAValidScenarioWithoutWarnings();
    void eachSaysWhatToLookAt_data();
    void eachSaysWhatToLookAt();
    void thePaperScenesGiveTheKnownRestitution_data();
    void thePaperScenesGiveTheKnownRestitution();
    void theDefaultIsTheT38Case();

  private:
    static void addAll();
};

void TestExamples::addAll() {
    QTest::addColumn<QString>("name");
    for (const Example& example : builtInExamples())
        QTest::newRow(example.name.c_str()) << QString::fromStdString(example.name);
}

void TestExamples::theyAreTheFilesOfTheFolder() {
    const QDir folder(QStringLiteral(DRILLWAVE_SOURCE_DIR "/resources/examples"));
    const QStringList files = folder.entryList({"*.yaml"}, QDir::Files);
    QCOMPARE(static_cast<qsizetype>(builtInExamples().size()), files.size());
    for (const Example& example : builtInExamples()) {
        QFile file(folder.filePath(QString::fromStdString(example.name) + ".yaml"));
        QVERIFY2(file.open(QIODevice::ReadOnly), example.name.c_str());
        QVERIFY(file.readAll() ==
                QByteArray(example.text.data(), static_cast<qsizetype>(example.text.size())));
    }
}

void TestExamples::eachIsAValidScenarioWithoutWarnings_data() {
    addAll();
}

void TestExamples::eachIsAValidScenarioWithoutWarnings() {
    QFETCH(QString, name);
    const Example& example = *findExample(name.toStdString());
    const ScenarioDocument document = parseScenario(example.text, example.name);
    QCOMPARE(document.scenario.title, example.title);
    for (const Alert& alert : alertsFor(document.scenario))
        QVERIFY2(alert.level == AlertLevel::information, alertText(alert).c_str());
    QVERIFY(writeScenario(document) == example.text);
}

void TestExamples::eachSaysWhatToLookAt_data() {
    addAll();
}

void TestExamples::eachSaysWhatToLookAt() {
    QFETCH(QString, name);
    const QString text = QString::fromStdString(findExample(name.toStdString())->explanation);
    QVERIFY(text.contains("Look at"));
    QVERIFY(text.endsWith('.') && !text.contains('\n') && !text.contains('#') && !text.contains("  "));
}

void TestExamples::thePaperScenesGiveTheKnownRestitution_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("cor");
    // 33-digit event-driven solution.
    QTest::newRow("paper Fig. 4 (a)") << "paper_fig4a" << 1.4010824845070556;
    QTest::newRow("paper Fig. 4 (b)") << "paper_fig4b" << 0.40671074387478970;
    QTest::newRow("paper Fig. 8, minimum") << "paper_fig8_minimum" << 0.84210576467383562;
}

void TestExamples::thePaperScenesGiveTheKnownRestitution() {
    QFETCH(QString, name);
    QFETCH(double, cor);
    const Scenario scenario = parseScenario(findExample(name.toStdString())->text, "example").scenario;
    const double found = ExactSolver().solve(problemOf(scenario)).cor;
    QVERIFY2(std::abs(found - cor) <= 1e-13, qPrintable(QString::number(found, 'g', 17)));
}

void TestExamples::theDefaultIsTheT38Case() {
    QCOMPARE(&defaultExample(), findExample("t38_medium_rock"));
    QCOMPARE(findExample("no_such_example"), nullptr);
}

QTEST_GUILESS_MAIN(TestExamples)
#include "tst_examples.moc"
