// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the commands in the language of its reader: every word of the program can be translated, and
// numbers have its decimal sign.
#include <QTest>

#include "core/report/accuracy_report.h"
#include "core/report/blow_text.h"
#include "core/report/curve_text.h"
#include "core/report/gap_report.h"
#include "core/report/stability_report.h"
#include "core/study/thrust/thrust_margins.h"
#include "core/text/languages.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/marked_style.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// A text for any reader, of a study that is made once.
using Told = std::function<std::string(const ReadingStyle&)>;

bool anyScenario(const Scenario&) {
    return true;
}

/// A text of a command.
struct CommandText {
    const char* name;
    Told (*study)(const Scenario&);
    bool (*applies)(const Scenario&) = anyScenario;
    std::string (*names)() = nullptr;  ///< that it tells beside those of all texts
};

Told toldBlow(const Scenario& scenario, const MethodChoice& method) {
    Blow blow = solveBlow(scenario, method, Detail::ledger, {}, Stresses::wanted);
    if (gapPeriod(scenario)) addThrustMargin(blow);
    return [blow](const ReadingStyle& style) { return blowText(blow, style); };
}

Told blow(const Scenario& scenario) {
    return toldBlow(scenario, {});
}

Told blowByLattice(const Scenario& scenario) {
    return toldBlow(scenario, {.method = Method::lattice, .lattice = {.segments = 100}});
}

Told blowWithoutThrust(Scenario scenario) {
    scenario.drill.thrust.reset();
    return toldBlow(scenario, {});
}

Told blowWithLittleThrust(Scenario scenario) {
    scenario.drill.thrust = 100;
    scenario.drill.inclination = -30;
    return toldBlow(scenario, {});
}

bool hasFeed(const Scenario& scenario) {
    return hasUnits(scenario) && scenario.drill.blowFrequency;
}

Told gap(const Scenario& scenario) {
    const GapStudy report = studyGap(scenario, NormalGap{.mean = 0.2, .deviation = 0.1});
    return [report](const ReadingStyle& style) { return gapText(report, style); };
}

/// A short way, which takes strings less time.
CurveQuestion questionOf(const Scenario& scenario) {
    return {.base = scenario,
            .along = parseRange(hasUnits(scenario) ? "bit_rock.gap=0mm:0.01mm" : "delta=0:0.1").axis,
            .family = {},
            .columns = chooseOutputs("cor", OutputUnits::dimensionless).columns,
            .levels = {0.5}};
}

Told toldCurve(const CurveQuestion& question) {
    const CurveReport report{studyCurve(question, 2), 0.1, {}};
    return [report](const ReadingStyle& style) { return curveText(report, style); };
}

Told curve(const Scenario& scenario) {
    return toldCurve(questionOf(scenario));
}

Told curveToGoal(const Scenario& scenario) {
    CurveQuestion question = questionOf(scenario);
    question.goal = 3;
    return toldCurve(question);
}

/// Jumps, and points that take too much work.
Told curveWithJumps(const Scenario& scenario) {
    CurveQuestion question = questionOf(scenario);
    question.along = parseRange("tau=0.05:3").axis;
    question.family = parseAxis("gamma=0.1,1").axis;
    question.columns = chooseOutputs("separation_time", OutputUnits::dimensionless).columns;
    question.goal = 7;
    question.workLimit = 100;
    question.levels.clear();
    return toldCurve(question);
}

Told accuracy(const Scenario& scenario) {
    Accuracy measured = measureAccuracy(scenario, {100, 200});
    measured.rows.back().sameAsMoved = false;
    measured.rows.front().time.runs = 1;
    return
        [scenario, measured](const ReadingStyle& style) { return accuracyText(scenario, measured, style); };
}

/// Not measured, which takes seconds.
Told stringAccuracy(const Scenario& scenario) {
    StringAccuracy measured{.reason = {}, .efficiency = 0.51, .reference = 1e-9, .rows = {}};
    for (const StringMethod method : allValues<StringMethod>)
        measured.rows.push_back({method, 1.5e-6, 1.2e-7, 2.5e-7, 3.5e-7, 1000, {1.5e-3, 1.4e-3, 11}});
    return
        [scenario, measured](const ReadingStyle& style) { return accuracyText(scenario, measured, style); };
}

/// Uses a few cases; the last ones failed.
Told stability(const Scenario&) {
    std::vector<StabilityCase> cases = stabilityCases();
    cases.resize(12);
    StabilityReport report = checkStability(cases, 2, {}, [](const StabilityReport&) {});
    report.rows.back().outcome = Outcome::notSolved;
    report.rows.back().reason = tooManyPieces;
    return [report](const ReadingStyle& style) { return stabilityText(report, style); };
}

bool isRod(const Scenario& scenario) {
    return gapPeriod(scenario).has_value();
}

/// A study for all examples, or one that is about none of them, is made of the first.
bool isFirst(const Scenario& scenario) {
    return scenario.title == builtInExamples().front().title;
}

std::string methodNamesOfAccuracy() {
    return "ring moved cells cells_cut plain";
}

/// They stand in the CSV.
std::string caseNames() {
    std::string names;
    for (const StabilityCase& stabilityCase : stabilityCases()) names += stabilityCase.name + "\n";
    return names;
}

constexpr auto commandTexts = std::to_array<CommandText>({
    {"blow", blow},
    {"blow by the lattice", blowByLattice, isRod},
    {"blow without thrust", [](const Scenario& s) { return blowWithoutThrust(s); }, hasFeed},
    {"blow with little thrust", [](const Scenario& s) { return blowWithLittleThrust(s); }, hasFeed},
    {"gap", gap, isRod},
    {"curve", curve},
    {"curve to a goal", curveToGoal, isRod},
    {"curve with jumps", curveWithJumps, isFirst},
    {"accuracy", accuracy, isRod, methodNamesOfAccuracy},
    {"accuracy of a string", stringAccuracy, isString, methodNamesOfAccuracy},
    {"stability", stability, isFirst, caseNames},
});

Scenario scenarioOf(const Example& example) {
    return parseScenario(example.text, example.name).scenario;
}

/// Returns the names that are the same in every language: keys, outputs, methods, shapes, units, and the
/// sections named by the author of the scenario.
QStringList namesOf(const CommandText& text, const Scenario& scenario) {
    QStringList names{"beta", "gamma", "tau", "delta", "cor", "separation_time", "MPa", "GPa", "min"};
    const auto add = [&](std::string_view words) {
        names << wordsOf(QString::fromUtf8(words.data(), qsizetype(words.size())));
    };
    if (text.names) add(text.names());
    for (const Section* section : allSections(scenario.drillString)) {
        add(section->name);
        add("string." + section->name + ".fatigue_strength");
    }
    for (const Parameter& parameter : parameters()) add(parameter.key);
    for (const std::string_view method : methodNames()) add(method);
    add(methodOfStrings);
    for (const PulseShape shape : allValues<PulseShape>) add(name(shape));
    return names;
}

/// Without the title, which is who wrote the scenario's.
QString toldIn(const ReadingStyle& style, const Told& told, const Scenario& scenario) {
    return QString::fromStdString(told(style)).remove(QString::fromStdString(scenario.title));
}

}  // namespace

class TestCommandWords : public QObject {
    Q_OBJECT

  private slots:
    void everyWordCanBeTranslated_data();
    void everyWordCanBeTranslated();
};

void TestCommandWords::everyWordCanBeTranslated_data() {
    QTest::addColumn<std::size_t>("text");
    QTest::addColumn<std::size_t>("example");
    for (std::size_t text = 0; text < commandTexts.size(); ++text)
        for (std::size_t i = 0; i < builtInExamples().size(); ++i) {
            const Example& example = builtInExamples()[i];
            if (!commandTexts[text].applies(scenarioOf(example))) continue;
            QTest::addRow("%s: %s", commandTexts[text].name, example.name.c_str()) << text << i;
        }
}

void TestCommandWords::everyWordCanBeTranslated() {
    QFETCH(std::size_t, text);
    QFETCH(std::size_t, example);
    const Scenario scenario = scenarioOf(builtInExamples()[example]);
    const Told told = commandTexts[text].study(scenario);

    const QStringList names = namesOf(commandTexts[text], scenario);
    QStringList words = wordsOutsideMarks(toldIn(MarkedStyle(), told, scenario));
    words.removeIf([&](const QString& word) { return names.contains(word); });
    QVERIFY2(words.isEmpty(), qPrintable(words.join(QLatin1String(", "))));

    const QString german = toldIn(styleOf(*findLanguage("de")), told, scenario);
    static const QRegularExpression point(QStringLiteral(".*\\d\\.\\d.*")), comma(QStringLiteral("\\d,\\d"));
    QVERIFY2(!german.contains(point), qPrintable(point.match(german).captured()));
    QVERIFY(german.contains(comma));
}

QTEST_GUILESS_MAIN(TestCommandWords)
#include "tst_command_words.moc"
