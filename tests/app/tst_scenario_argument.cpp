// SPDX-License-Identifier: GPL-3.0-or-later
// The scenario that a command line names, in process.
#include <QTemporaryDir>
#include <QTest>

#include "app/command_error.h"
#include "app/scenario_argument.h"
#include "core/model/scales.h"
#include "core/yaml/examples.h"

using namespace drillwave;

namespace {

using Words = std::vector<std::string>;

const std::vector<OptionSpec> options = scenarioOptions();

Arguments parsed(const Words& words) {
    return Arguments::parse(words, options);
}

Scenario loaded(const std::string& path, const Words& words) {
    return loadScenarioInput(path, parsed(words)).document.scenario;
}

/// How loading is refused.
struct Refusal {
    ExitCode code = ExitCode::done;
    std::string line;
};

Refusal refusal(const std::string& path, const Words& words) {
    try {
        loaded(path, words);
    } catch (const CommandError& error) {
        return {error.code(), error.lines().front()};
    }
    return {};
}

constexpr char example[] = "t38_medium_rock";

}  // namespace

class TestScenarioArgument : public QObject {
    Q_OBJECT

  private slots:
    void anExampleIsNamedWithoutItsFile();
    void aFileGoesBeforeTheExampleOfItsName();
    void settingsApplyWhateverTheirOrder();
    void refusalsHaveTheirExitCodes_data();
    void refusalsHaveTheirExitCodes();
    void refusalsAreInTheLanguageOfTheReader();
    void theSectionsOfADrillStringAreSet();
    void anOutputIsNoInput();
    void whatAnAxisChangesIsNotSet();
};

void TestScenarioArgument::anExampleIsNamedWithoutItsFile() {
    QCOMPARE(loaded(example, {}),
             loadScenarioFile(std::string(DRILLWAVE_SOURCE_DIR "/resources/examples/") + example + ".yaml")
                 .document.scenario);
}

void TestScenarioArgument::aFileGoesBeforeTheExampleOfItsName() {
    const QTemporaryDir place;
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(place.path()));
    QFile file(example);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no scenario") > 0);
    file.close();
    const Refusal refused = refusal(example, {});
    QVERIFY(QDir::setCurrent(before));
    QCOMPARE(refused.code, ExitCode::invalidScenario);
}

// beta sets the stiffness that gives it with the other parameters: so those are set first.
void TestScenarioArgument::settingsApplyWhateverTheirOrder() {
    const Scenario first =
        loaded(example, {"--set", "beta=0.7", "rod.diameter=45mm", "pulse.duration=150us"});
    const Scenario last = loaded(example, {"--set", "pulse.duration=150us", "rod.diameter=45mm", "beta=0.7"});
    QCOMPARE(first, last);
    QVERIFY(std::abs(groupsOf(first).beta - 0.7) < 1e-15);  // one rounding of the stiffness, one of beta
    QCOMPARE(first.rod.diameter, 0.045);
}

void TestScenarioArgument::refusalsHaveTheirExitCodes_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("setting");
    QTest::addColumn<ExitCode>("code");
    QTest::addColumn<QString>("part");
    QTest::newRow("no such file") << "nothing.yaml"
                                  << "gamma=1" << ExitCode::unreadableInput << "nothing.yaml";
    QTest::newRow("nearly an example")
        << "t38_medium_rok"
        << "gamma=1" << ExitCode::unreadableInput << "did you mean the example `t38_medium_rock`?";
    QTest::newRow("no key") << example << "gama=1" << ExitCode::usage << "gama";
    QTest::newRow("no value") << example << "gamma" << ExitCode::usage << "needs KEY=VALUE";
    QTest::newRow("out of range") << example << "gamma=1.5" << ExitCode::invalidScenario << "gamma";
    QTest::newRow("invalid with another parameter")
        << example << "rod.bore=50mm" << ExitCode::invalidScenario << "must be less than the diameter";
}

void TestScenarioArgument::refusalsHaveTheirExitCodes() {
    QFETCH(QString, path);
    QFETCH(QString, setting);
    QFETCH(ExitCode, code);
    QFETCH(QString, part);
    const Refusal refused = refusal(path.toStdString(), {"--set", setting.toStdString()});
    QCOMPARE(refused.code, code);
    QVERIFY2(QString::fromStdString(refused.line).contains(part), refused.line.c_str());
}

void TestScenarioArgument::refusalsAreInTheLanguageOfTheReader() {
    const auto said = [](const char* setting, const char* code) {
        try {
            loaded(example, {"--set", setting});
        } catch (const CommandError& error) {
            return QString::fromStdString(styleOf(*findLanguage(code)).said(error.messages().front()));
        }
        return QString();
    };
    QCOMPARE(said("rod.length=-1 m", "en"),
             QStringLiteral("--set rod.length=-1 m: rod.length = -1 m (must be greater than 0)"));
    QCOMPARE(said("rod.length=-1 m", "de"),
             QStringLiteral("--set rod.length=-1 m: rod.length = -1 m (muss größer als 0 sein)"));
}

void TestScenarioArgument::theSectionsOfADrillStringAreSet() {
    const auto with = [](std::vector<std::string> words) {
        return loadScenarioInput("t38_string", parsed(words)).document.scenario;
    };
    const Scenario set = with({"--set", "string.3.length=3 m", "string.rod.bore=12 mm", "string.repeat=2",
                               "hammer.restrike=false"});
    const StringPart& rods = *firstRepeat(set.drillString);
    QCOMPARE(rods.repeat, 2);
    QCOMPARE(rods.sections[1].length, 3.0);
    QCOMPARE(rods.sections[1].bore, 0.012);
    QVERIFY(!set.drillString.hammer.restrike);
    QCOMPARE(with({"--rock", "soft rock"}).bitRock == with({}).bitRock, false);
    QVERIFY_EXCEPTION_THROWN(with({"--rod", "T38"}), CommandError);
    // Both are the rod that the repeat brings to both places.
    QVERIFY_EXCEPTION_THROWN(with({"--set", "string.3.length=3 m", "string.5.length=4 m"}), CommandError);
    QVERIFY_EXCEPTION_THROWN(with({"--set", "string.rod.area=9 cm^2", "string.rod.diameter=3 cm"}),
                             CommandError);
}

void TestScenarioArgument::anOutputIsNoInput() {
    const QTemporaryDir place;
    const std::string path = place.filePath("s.yaml").toStdString();
    QFile file(place.filePath("s.yaml"));
    const std::string text(defaultExample().text);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text.c_str()) > 0);
    file.close();
    const ScenarioDocument document = loadScenarioFile(path).document;
    checkOutputIsNoInput(path + ".csv", parsed({path}), document);
    QVERIFY_EXCEPTION_THROWN(checkOutputIsNoInput(path, parsed({path}), document), CommandError);
    const std::string detour = place.filePath("./s.yaml").toStdString();
    QVERIFY_EXCEPTION_THROWN(checkOutputIsNoInput(detour, parsed({path}), document), CommandError);
    QVERIFY_EXCEPTION_THROWN(checkOutputIsNoInput(path, parsed({"-", "--presets", path}), document),
                             CommandError);
}

void TestScenarioArgument::whatAnAxisChangesIsNotSet() {
    const auto check = [](const std::vector<std::string>& words, const Scenario& scenario,
                          const std::vector<std::string>& axes) {
        std::vector<SweepAxis> parsedAxes;
        for (const std::string& axis : axes) parsedAxes.push_back(parseAxis(axis).axis);
        checkNotSet(parsed(words), scenario, parsedAxes, axes);
    };
    check({"--set", "bit_rock.stiffness=100MN/m"}, Scenario(), {"gamma=0.1,1"});
    QVERIFY_EXCEPTION_THROWN(
        check({"--set", "bit_rock.stiffness=100MN/m"}, Scenario(), {"gamma=0.1,1", "beta=1,2"}),
        CommandError);
    // adapter, three times coupling and rod, bit skirt, bit head
    const Scenario drill = parseScenario(findExample("t38_string")->text, "").scenario;
    QVERIFY_EXCEPTION_THROWN(check({"--set", "string.3.length=1m"}, drill, {"string.rod.length=2m,3m"}),
                             CommandError);
    QVERIFY_EXCEPTION_THROWN(check({"--set", "string.rod.length=1m"}, drill, {"string.5.length=2m,3m"}),
                             CommandError);
    check({"--set", "string.coupling.length=0.1m"}, drill, {"string.5.length=2m,3m"});
    // with two repeats the eighth section is none, with four it is a coupling
    check({"--set", "string.coupling.length=0.1m"}, drill, {"string.8.length=2m,3m"});
    QVERIFY_EXCEPTION_THROWN(check({"--set", "string.coupling.length=0.1m"}, drill,
                                   {"string.repeat=2,4", "string.8.length=2m,3m"}),
                             CommandError);
}

QTEST_GUILESS_MAIN(TestScenarioArgument)
#include "tst_scenario_argument.moc"
