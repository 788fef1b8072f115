// SPDX-License-Identifier: GPL-3.0-or-later
// Every key of JSON and every heading of CSV that a command writes stands in files.md, as `key`.
#include <QTest>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <set>

#include "core/blow/outputs.h"
#include "core/manual/chapter.h"
#include "core/manual/markdown.h"
#include "core/model/parameter.h"
#include "core/report/stability_report.h"
#include "core/study/paper/figures.h"
#include "core/text/handy_text.h"
#include "tests/support/program.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// All that stands between backquotes in a section of files.md and those below it.
std::set<std::string> codeOf(std::span<const ManualBlock> chapter, const char* section) {
    std::set<std::string> words;
    const auto add = [&](std::string_view text) {
        for (const std::string_view word : codeIn(text)) words.emplace(word);
    };
    for (const ManualBlock& block : sectionOf(chapter, section)) {
        if (block.kind != ManualBlock::Kind::code) add(block.text);
        for (const std::vector<std::string>& row : block.rows)
            for (const std::string& cell : row) add(cell);
    }
    return words;
}

/// Names that have tables of their own: parameters, outputs, and outputs with a statistic, "cor_q05_error".
bool isData(const std::string& key, const std::set<std::string>& documented) {
    if (findParameter(key) || findOutput(key)) return true;
    for (std::size_t end = key.find('_'); end != std::string::npos; end = key.find('_', end + 1))
        if (findOutput(key.substr(0, end)) && documented.contains("OUTPUT" + key.substr(end))) return true;
    return false;
}

void collect(const QJsonValue& value, std::set<std::string>& keys) {
    for (const QJsonValue& each : value.toArray()) collect(each, keys);
    const QJsonObject object = value.toObject();
    for (const QString& key : object.keys()) {
        keys.insert(key.toStdString());
        collect(object[key], keys);
    }
}

/// Without units, "peak_force [N]".
std::set<std::string> headingsOf(const QByteArray& csv) {
    std::set<std::string> headings;
    const QList<QList<QByteArray>> rows = rowsOf(csv);
    if (!rows.isEmpty())
        for (const QByteArray& cell : rows.front()) headings.insert(cell.split(' ').front().toStdString());
    return headings;
}

std::set<std::string> keysOf(const QByteArray& text) {
    const QJsonDocument json = QJsonDocument::fromJson(text);
    if (json.isNull()) return headingsOf(text);
    std::set<std::string> keys;
    collect(json.isArray() ? QJsonValue(json.array()) : QJsonValue(json.object()), keys);
    return keys;
}

/// Short marches.
const QStringList fewBlows{"--blows", "12", "--settle", "4", "--cells", "10"};

/// A record of one gauge on a rod.
const QStringList identifiedBar{"identify",  DRILLWAVE_SOURCE_DIR "/tests/cases/identify/clean.yaml",
                                "--signals", DRILLWAVE_SOURCE_DIR "/tests/cases/identify/clean.csv",
                                "--gauge",   "2@1.83m"};

}  // namespace

class TestWrittenKeys : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void keysOfJsonStandInTheManual_data();
    void keysOfJsonStandInTheManual();
    void headingsOfCsvStandInTheManual_data();
    void headingsOfCsvStandInTheManual();
    void filesOfFoldersStandInTheManual_data();
    void filesOfFoldersStandInTheManual();
    void keysOfStabilityStandInTheManual();
    void headingsOfFiguresStandInTheManual();
    void jsonOfEveryCommandHasTheSameHead();

  private:
    /// Names of `keys` that are neither in the manual nor data; none where there are no keys at all.
    QString missing(const std::set<std::string>& keys) const;

    std::set<std::string> m_documented;
};

void TestWrittenKeys::initTestCase() {
    const std::vector<Chapter> manual = manualChapters(plainStyle());
    const std::vector<ManualBlock> files = readMarkdown(findChapter(manual, "files")->text);
    for (const char* section : {"§4", "§5", "§6", "§7", "§10"}) m_documented.merge(codeOf(files, section));
    QVERIFY(m_documented.size() > 200);
}

QString TestWrittenKeys::missing(const std::set<std::string>& keys) const {
    if (keys.size() < 2) return QStringLiteral("nothing was written");
    QStringList names;
    for (const std::string& key : keys)
        if (!m_documented.contains(key) && !isData(key, m_documented)) names << QString::fromStdString(key);
    return names.join(QStringLiteral(", "));
}

void TestWrittenKeys::keysOfJsonStandInTheManual_data() {
    QTest::addColumn<QStringList>("words");
    const QString rod = example("t38_medium_rock"), string = example("r32_string"),
                  groups = example("paper_fig4b");
    QTest::newRow("run rod") << QStringList{"run", rod};
    QTest::newRow("run groups") << QStringList{"run", groups};
    QTest::newRow("run lattice") << QStringList{"run", rod, "--method", "lattice", "--segments", "100"};
    QTest::newRow("run string") << QStringList{"run", string, "--set", "string.rod.yield_strength=200MPa",
                                               "string.rod.fatigue_strength=50MPa"};
    QTest::newRow("run unsolved") << QStringList{"run", rod, "--work-limit", "10"};
    QTest::newRow("curve") << QStringList{"curve",     groups,
                                          "--along",   "delta=0:1.2",
                                          "--family",  "gamma=0.1,1",
                                          "--outputs", "cor,separation_time",
                                          "--level",   "1"};
    QTest::newRow("curve goal") << QStringList{"curve", groups, "--along", "delta=0:1.2", "--goal", "1"};
    QTest::newRow("curve goal not reached")
        << QStringList{"curve", groups, "--along", "delta=0:1.2", "--goal", "9"};
    QTest::newRow("curve unsolved") << QStringList{"curve",           groups,         "--along",
                                                   "tau=0.001:1:log", "--work-limit", "1000"};
    QTest::newRow("map") << QStringList{"map",     groups, "--x", "delta=0:1:3", "--y", "gamma=0.1:0.4:3",
                                        "--level", "1"};
    QTest::newRow("map unsolved") << QStringList{
        "map", groups, "--x", "tau=0.001:1:3", "--y", "gamma=0.1:0.4:3", "--work-limit", "1000"};
    QTest::newRow("map of many blows") << QStringList{"map",           rod,
                                                      "--x",           "drill.thrust=7kN:9kN:2",
                                                      "--y",           "gamma=0.1:0.4:2",
                                                      "--output",      "drill_gap_mean",
                                                      "--level",       "0.1",
                                                      "--set",         "drill.blows=12",
                                                      "drill.settle=4"};
    QTest::newRow("gap rod") << QStringList{"gap", rod, "--gap-deviation", "0.2mm"};
    QTest::newRow("gap groups") << QStringList{"gap", example("paper_fig8_minimum")};
    QTest::newRow("thrust") << QStringList{"thrust", rod, "--along", "bit_rock.gamma=0.1,0.2"};
    QTest::newRow("thrust unsolved") << QStringList{"thrust", rod, "--along", "rod.bore=10mm,60mm"};
    QTest::newRow("thrust string") << QStringList{"thrust", string};
    QTest::newRow("design") << QStringList{"design",
                                           rod,
                                           "--uncertain",
                                           "bit_rock.stiffness=50MN/m:150MN/m",
                                           "bit_rock.gamma=+-20%",
                                           "--choose",
                                           "pulse.duration=100us,200us",
                                           "--at-most",
                                           "peak_compression@q95=900MPa",
                                           "--samples",
                                           "64"};
    QTest::newRow("design constant") << QStringList{
        "design", groups, "--uncertain", "delta=1:1.1", "--aim", "max:work_ratio@mean", "--samples", "64"};
    QTest::newRow("drill") << QStringList{"drill", rod} + fewBlows;
    QTest::newRow("drill groups") << QStringList{"drill", rod, "--dimensionless"} + fewBlows;
    QTest::newRow("drill scan") << QStringList{"drill", rod, "--scan", "drill.thrust=7kN,9kN"} + fewBlows;
    QTest::newRow("identify") << identifiedBar + QStringList{"--backing", "bar", "--check", "2@0.5m"};
    QTest::newRow("accuracy rod") << QStringList{"accuracy", groups, "--segments", "100"};
    QTest::newRow("accuracy string") << QStringList{"accuracy", string};
}

void TestWrittenKeys::keysOfJsonStandInTheManual() {
    QFETCH(QStringList, words);
    const Finished finished = run(words + QStringList{"--json"});
    // A study with unsolved points prints its JSON, too, and ends with 6.
    QVERIFY2(finished.exitCode == 0 || finished.exitCode == 6, finished.error.constData());
    QCOMPARE(missing(keysOf(finished.out)), QString());
}

void TestWrittenKeys::headingsOfCsvStandInTheManual_data() {
    QTest::addColumn<QStringList>("words");
    const QString rod = example("t38_medium_rock"), string = example("r32_string");
    QTest::newRow("sweep rod") << QStringList{"sweep", rod, "--vary", "gamma=0.1", "--outputs", "all"};
    QTest::newRow("sweep string") << QStringList{"sweep",     string, "--vary", "bit_rock.gap=0mm",
                                                 "--outputs", "all",  "--si"};
    QTest::newRow("curve") << QStringList{"curve", rod, "--along", "bit_rock.gamma=0.2:0.3", "--si"};
    QTest::newRow("map") << QStringList{"map", rod, "--x", "gamma=0.1:0.2:2", "--y", "beta=1:2:2"};
    QTest::newRow("gap") << QStringList{"gap", rod, "--si"};
    QTest::newRow("thrust") << QStringList{"thrust", rod, "--along", "bit_rock.gamma=0.1,0.2"};
    QTest::newRow("drill") << QStringList{"drill", rod} + fewBlows;
    QTest::newRow("drill scan") << QStringList{"drill", rod, "--scan", "drill.thrust=7kN"} + fewBlows;
    QTest::newRow("accuracy rod") << QStringList{"accuracy", rod, "--segments", "100"};
    QTest::newRow("accuracy string") << QStringList{"accuracy", string};
    QTest::newRow("figures") << QStringList{"figures"};
}

void TestWrittenKeys::headingsOfCsvStandInTheManual() {
    QFETCH(QStringList, words);
    QCOMPARE(missing(headingsOf(output(words + QStringList{"-o", "-"}))), QString());
}

void TestWrittenKeys::filesOfFoldersStandInTheManual_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("place");
    QTest::addColumn<int>("files");  // with keys or headings
    const QString rod = example("t38_medium_rock"), groups = example("paper_fig4b");
    QTest::newRow("run rod") << QStringList{"run", rod} << "out" << 3;
    QTest::newRow("run string") << QStringList{"run", example("r32_string")} << "out" << 3;
    QTest::newRow("drill") << QStringList{"drill", rod, "--histories", "1:1"} + fewBlows << "out" << 3;
    QTest::newRow("drill gaps") << QStringList{"drill",         rod, "--scan", "drill.thrust=9kN", "--gaps",
                                               "PLACE/gaps.csv"} +
                                       fewBlows
                                << "scan.csv" << 2;
    QTest::newRow("design") << QStringList{"design",
                                           rod,
                                           "--uncertain",
                                           "bit_rock.stiffness=50MN/m:150MN/m",
                                           "--choose",
                                           "pulse.duration=100us,200us",
                                           "--keep-energy",
                                           "--samples",
                                           "64"}
                            << "out" << 5;
    QTest::newRow("identify") << identifiedBar << "out" << 5;
    QTest::newRow("curve goal") << QStringList{"curve",    groups,        "--along", "delta=0:1.2",
                                               "--family", "gamma=0.9,1", "--goal",  "1"}
                                << "curve.csv" << 2;
    QTest::newRow("map contours") << QStringList{"map",         groups, "--x",
                                                 "delta=0:1:3", "--y",  "gamma=0.1:0.4:3",
                                                 "--level",     "1"}
                                  << "map.csv" << 2;
}

void TestWrittenKeys::filesOfFoldersStandInTheManual() {
    QFETCH(QStringList, words);
    QFETCH(QString, place);
    QFETCH(int, files);
    const QTemporaryDir folder;
    words.replaceInStrings(QStringLiteral("PLACE"), folder.path());
    output(words + QStringList{"-o", folder.filePath(place) + (place.contains('.') ? "" : "/")});
    const QDir written(place.contains('.') ? folder.path() : folder.filePath(place));
    const QStringList names = written.entryList({"*.csv", "*.json"}, QDir::Files);
    QCOMPARE(names.size(), files);
    for (const QString& name : names) {
        const QString keys = missing(keysOf(read(written.filePath(name))));
        QVERIFY2(keys.isEmpty(), (name + QStringLiteral(": ") + keys).toUtf8());
    }
}

void TestWrittenKeys::keysOfStabilityStandInTheManual() {
    const StabilityReport report =
        checkStability({stabilityCases().front()}, 1, {}, [](const StabilityReport&) {});
    QCOMPARE(missing(keysOf(QByteArray::fromStdString(stabilityJson(report, 0)))), QString());
    QCOMPARE(missing(headingsOf(QByteArray::fromStdString(stabilityCsv(report)))), QString());
}

void TestWrittenKeys::headingsOfFiguresStandInTheManual() {
    std::set<std::string> headings;
    for (const Figure& figure : paperFigures())
        for (const FigurePanel& panel : figure.panels)
            headings.merge(headingsOf(QByteArray::fromStdString(panelCsv(panel))));
    QCOMPARE(missing(headings), QString());
}

void TestWrittenKeys::jsonOfEveryCommandHasTheSameHead() {
    const QString rod = example("t38_medium_rock");
    const QList<QStringList> commands{
        {"run", rod},
        {"curve", rod, "--along", "bit_rock.gamma=0.2:0.3"},
        {"map", rod, "--x", "gamma=0.1:0.2:2", "--y", "beta=1:2:2"},
        {"gap", rod},
        {"thrust", rod},
        {"design", rod, "--uncertain", "bit_rock.gamma=+-20%", "--samples", "64"},
        {"drill", rod, "--cells", "10"},
        {"drill", rod, "--scan", "drill.thrust=9kN", "--cells", "10"}};
    const QStringList set{"--set", "drill.blows=12", "drill.settle=4"};
    const QJsonObject run = json(commands.front() + set);
    for (const QStringList& words : commands) {
        const QJsonObject object = json(words + set);
        for (const char* key : {"version", "title", "scenario"})
            QVERIFY2(object[key] == run[key], (words.front() + " " + key).toUtf8());
        for (const char* group : {"beta", "gamma", "tau", "delta"})
            QVERIFY2(object["groups"][group] == run["groups"][group], words.front().toUtf8());
        QVERIFY2(object["method"].isString() && object["run_time"].isDouble() &&
                     !object["units"].toObject().isEmpty(),
                 words.front().toUtf8());
    }
}

QTEST_GUILESS_MAIN(TestWrittenKeys)
#include "tst_written_keys.moc"
