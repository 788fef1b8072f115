// SPDX-License-Identifier: GPL-3.0-or-later
// Results are solved again as they were recorded; impossible records are refused.
#include <QTest>

#include "core/archive/result_scenario.h"
#include "core/blow/blow.h"
#include "core/report/blow_csv.h"
#include "core/report/blow_json.h"
#include "core/yaml/examples.h"

using namespace drillwave;

namespace {

const char* const scenarioInJson =
    R"("scenario": "drillwave: 1\ndimensionless: {beta: 0.5, gamma: 0.1, tau: 10, delta: 0}\npulse: {shape: rectangular}\n")";

std::string resultWith(const std::string& members) {
    return "{" + members + (members.empty() ? "" : ", ") + scenarioInJson + "}";
}

QString problemOf(const std::string& text, const char* name) {
    try {
        parseInput(text, name);
        return {};
    } catch (const ScenarioError& error) {
        return QString::fromStdString(error.lines().front());
    }
}

}  // namespace

class TestResultScenario : public QObject {
    Q_OBJECT

  private slots:
    void whatAResultSaysOfItselfMustBe_data();
    void whatAResultSaysOfItselfMustBe();
    void ownResultsAreRead();
};

void TestResultScenario::whatAResultSaysOfItselfMustBe_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* name, const std::string& text, const char* problem) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << problem;
    };
    row("nothing", resultWith(""), "");
    row("exact", resultWith(R"("method": "exact", "segments": null)"), "");
    row("lattice", resultWith(R"("method": "lattice", "segments": 500)"), "");
    row("of a string", resultWith(R"("method": "polynomial_cells")"), "");
    row("unknown method", resultWith(R"("method": "magic")"),
        "r.json: method = magic (must be exact, lattice or closed_form)");
    for (const char* segments : {"-5", "1000000000", "9", "5.5", "many"})
        row(segments, resultWith(R"("method": "lattice", "segments": )" + std::string(segments)),
            qPrintable(
                QString("r.json: segments = %1 (must be a whole number from 10 to 1000000)").arg(segments)));
    row("two scenarios", resultWith(scenarioInJson), "r.json: scenario (is given 2 times; keep one of them)");
    row("two methods", resultWith(R"("method": "exact", "method": "lattice")"),
        "r.json: method (is given 2 times");
    row("a newer record", "drillwave_result: 2\n" + std::string(scenarioInJson) + "\n",
        "r.json: drillwave_result = 2 (this program reads the format 1)");
}

void TestResultScenario::whatAResultSaysOfItselfMustBe() {
    QFETCH(QByteArray, text);
    QFETCH(QString, problem);
    const QString said = problemOf(text.toStdString(), "r.json");
    QVERIFY2(problem.isEmpty() ? said.isEmpty() : said.startsWith(problem), qPrintable(said));
}

void TestResultScenario::ownResultsAreRead() {
    for (const Example& example : builtInExamples()) {
        const Scenario scenario = parseScenario(example.text, "here").scenario;
        const Blow blow = solveBlow(scenario, {}, Detail::ledger);
        const std::string text(example.text);
        QVERIFY(parseInput(blowJson(blow, text), "r.json").document.scenario == scenario);
        for (const char* method : {"method exact", "method lattice, 500 segments", "method closed_form"})
            QVERIFY(parseInput(scenarioHeader(text, method), "r.csv").method);
        for (const char* method : {"method magic", "method lattice, -5 segments", "method lattice"})
            QVERIFY(problemOf(scenarioHeader(text, method), "r.csv").contains("was solved by"));
    }
}

QTEST_GUILESS_MAIN(TestResultScenario)
#include "tst_result_scenario.moc"
