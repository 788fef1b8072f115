// SPDX-License-Identifier: GPL-3.0-or-later
// Runs kept in a folder: read back byte for byte; broken files are reported and left where they are.
#include <QTemporaryDir>
#include <QTest>

#include "core/archive/kept_runs.h"
#include "core/yaml/examples.h"
#include "tests/support/files.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

KeptRun run(int number, const char* name, std::string_view text) {
    return {.number = number,
            .name = name,
            .contents = parseScenario(text, ""),
            .isShown = number != 1,
            .isReference = number == 1,
            .cor = 0.1 * number};
}

}  // namespace

class TestKeptRuns : public QObject {
    Q_OBJECT

  private slots:
    void init();
    void everyScenarioFileHasAFolderOfItsOwn();
    void aFolderThatIsNotThereHasNoRuns();
    void runsReadBackByteForByte();
    void aMissingFileIsToldAndTheOthersAreTaken();
    void aBrokenFileIsToldWithItsPlaceAndKeepsItsLetter();
    void aFolderWithoutAnIndexIsTold();
    void anIndexLeadsNowhereElse();
    void tablesAreFoundBesideTheScenario();

  private:
    void writeRuns(const std::vector<KeptRun>& runs) const {
        QVERIFY(writeWholeFolder(m_folder.toStdString(), {runFiles(runs), {}}, ExistingFiles::replaced)
                    .isWritten());
    }
    KeptRuns read() const { return readRuns(m_folder.toStdString(), m_scenario.toStdString()); }
    std::vector<KeptRun> three() const {
        const std::string text(findExample("t38_medium_rock")->text);
        return {run(0, "medium, \"as drilled\"", text),
                run(1, "half, sine", findExample("paper_fig4a")->text),
                run(4, "µ", text + "\n# a comment at the end\n")};
    }

    std::unique_ptr<QTemporaryDir> m_place;
    QString m_scenario;
    QString m_folder;
};

void TestKeptRuns::init() {
    m_place = std::make_unique<QTemporaryDir>();
    m_scenario = m_place->filePath("t38.yaml");
    m_folder = m_place->filePath("t38.runs");
}

void TestKeptRuns::everyScenarioFileHasAFolderOfItsOwn() {
    QCOMPARE(runsFolderOf("/in/a.b/t38.yaml"), std::string("/in/a.b/t38.runs"));
    QCOMPARE(runsFolderOf("/in/a.b/t38.yml"), std::string("/in/a.b/t38.yml.runs"));
    QCOMPARE(runsFolderOf("/in/a.b/t38.soft.yaml"), std::string("/in/a.b/t38.soft.runs"));
    QCOMPARE(runsFolderOf("t38.yaml"), std::string("t38.runs"));
    QCOMPARE(runsFolderOf("/in/a.b/t38"), std::string("/in/a.b/t38.scenario.runs"));
    std::map<std::string, std::string> files;  // by their folders
    const QStringList parts{"", ".yaml", ".yml", ".json", ".scenario", ".runs", ".soft", "."};
    for (const QString& first : parts)
        for (const QString& second : parts)
            for (const QString& third : parts) {
                const std::string file = ("t38" + first + second + third).toStdString();
                const auto [place, isNew] = files.emplace(runsFolderOf(file), file);
                QVERIFY2(isNew || place->second == file, (file + " and " + place->second).c_str());
            }
}

void TestKeptRuns::aFolderThatIsNotThereHasNoRuns() {
    QVERIFY(read().runs.empty());
    QVERIFY(read().problems.empty());
}

void TestKeptRuns::runsReadBackByteForByte() {
    const std::vector<KeptRun> runs = three();
    writeRuns(runs);
    const KeptRuns kept = read();
    QVERIFY(kept.problems.empty());
    QVERIFY(kept.foreign.empty());
    QCOMPARE(kept.runs.size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        QCOMPARE(kept.runs[i].number, runs[i].number);
        QCOMPARE(kept.runs[i].name, runs[i].name);
        QCOMPARE(kept.runs[i].contents.text, runs[i].contents.text);
        QCOMPARE(kept.runs[i].contents.scenario, runs[i].contents.scenario);
        QCOMPARE(kept.runs[i].isShown, runs[i].isShown);
        QCOMPARE(kept.runs[i].isReference, runs[i].isReference);
        QCOMPARE(kept.runs[i].cor, runs[i].cor);
    }
}

void TestKeptRuns::aMissingFileIsToldAndTheOthersAreTaken() {
    writeRuns(three());
    QVERIFY(QFile::remove(m_folder + "/B.yaml"));
    const KeptRuns kept = read();
    QCOMPARE(kept.runs.size(), 2u);
    QCOMPARE(kept.problems.size(), 1u);
    QVERIFY(QString::fromStdString(kept.problems.front()).startsWith("t38.runs/B.yaml: cannot be opened: "));
    QVERIFY(kept.foreign.empty());
}

void TestKeptRuns::aBrokenFileIsToldWithItsPlaceAndKeepsItsLetter() {
    writeRuns(three());
    write(m_folder + "/A.yaml", "drillwave: 1\nrod: {length: 3 kg}\n");
    const KeptRuns kept = read();
    QCOMPARE(kept.runs.size(), 2u);
    QCOMPARE(kept.problems.size(), 1u);
    const QString problem = QString::fromStdString(kept.problems.front());
    QVERIFY2(problem.startsWith("t38.runs/A.yaml:1:1: "), qPrintable(problem));
    QVERIFY2(problem.endsWith("; this run is left out"), qPrintable(problem));
    QCOMPARE(kept.foreign, std::vector<int>{0});
}

void TestKeptRuns::aFolderWithoutAnIndexIsTold() {
    writeRuns(three());
    QVERIFY(QFile::remove(m_folder + "/runs.csv"));
    const KeptRuns kept = read();
    QVERIFY(kept.runs.empty());
    QCOMPARE(kept.problems.size(), 1u);
    QVERIFY(
        QString::fromStdString(kept.problems.front()).startsWith("t38.runs/runs.csv: cannot be opened: "));
    QCOMPARE(kept.foreign, (std::vector<int>{0, 1, 4}));
}

void TestKeptRuns::anIndexLeadsNowhereElse() {
    writeRuns(three());
    write(m_scenario, QByteArray::fromStdString(three().front().contents.text));
    write(m_folder + "/runs.csv",
          "file,name,shown,reference,cor\n../"
          "t38.yaml,up,yes,no,\nA.yaml,right,yes,no,\nA.yaml,again,yes,no,\nB.yaml\n");
    const KeptRuns kept = read();
    QCOMPARE(kept.runs.size(), 1u);
    QCOMPARE(kept.runs.front().name, std::string("right"));
    QCOMPARE(kept.problems.size(), 3u);
    QVERIFY(QString::fromStdString(kept.problems[0]).startsWith("t38.runs/runs.csv:2: "));
    QVERIFY(QString::fromStdString(kept.problems[2]).contains("has 1 cells"));
}

void TestKeptRuns::tablesAreFoundBesideTheScenario() {
    write(m_place->filePath("blow.csv"), "time [us],force [kN]\n0,0\n100,300\n200,0\n");
    const QString text =
        "drillwave: 1\nrod: {length: 3 m, diameter: 38 mm, youngs_modulus: 210 GPa, density: 7850 kg/m^3}\n"
        "pulse: {shape: table, file: blow.csv}\nbit_rock: {stiffness: 100 MN/m, gamma: 0.1, gap: 0 mm}\n";
    KeptRun table = run(0, "measured", findExample("t38_medium_rock")->text);
    table.contents = parseScenario(text.toStdString(), m_scenario.toStdString());
    writeRuns({table});
    const KeptRuns kept = read();
    QVERIFY2(kept.problems.empty(), kept.problems.empty() ? "" : kept.problems.front().c_str());
    QCOMPARE(kept.runs.front().contents.scenario, table.contents.scenario);
}

QTEST_GUILESS_MAIN(TestKeptRuns)
#include "tst_kept_runs.moc"
