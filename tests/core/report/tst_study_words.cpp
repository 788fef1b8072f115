// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the studies in the language of their reader: every word of the program can be translated, and
// every number has the decimal sign of the language.
#include <QTest>

#include "core/report/design_report.h"
#include "core/report/drilling_report.h"
#include "core/report/drilling_scan_report.h"
#include "core/report/map_report.h"
#include "core/report/thrust_report.h"
#include "core/yaml/examples.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/map.h"
#include "tests/support/marked_style.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// A text for any reader, of a study that is made once.
using Told = std::function<std::string(const ReadingStyle&)>;

class MarkedCommaStyle : public MarkedStyle {
  public:
    std::string number(double value, int digits) const override {
        std::string text = MarkedStyle::number(value, digits);
        std::ranges::replace(text, '.', ',');
        return text;
    }
};

Told thrust(const Scenario& scenario) {
    const SweepAxis axis = parseAxis("drill.thrust=2.5kN,7.5kN").axis;
    const ThrustReport report{
        .scenario = scenario,
        .study = studyThrust(scenario),
        .along = ThrustAlong{axis, thrustAlong(scenario, *axis.parameter, axis.list, 1)}};
    return [report](const ReadingStyle& style) { return thrustText(report, style); };
}

Told thrustUphill(Scenario scenario) {
    scenario.drill.thrust = 100;
    scenario.drill.inclination = -30;
    const ThrustReport report{scenario, studyThrust(scenario), {}, {}};
    return [report](const ReadingStyle& style) { return thrustText(report, style); };
}

Told noThrust(Scenario scenario) {
    scenario.drill.thrust.reset();
    const ThrustReport report{scenario, studyThrust(scenario), {}, {}};
    return [report](const ReadingStyle& style) { return thrustText(report, style); };
}

constexpr DrillingSettings fewBlows{.blows = 12, .settle = 4, .cells = 10};

Told toldDrilling(const Scenario& scenario, OutputUnits units) {
    const DrillingReport report{studyDrilling(scenario, fewBlows, {.cellError = false}), {}, {}};
    return [report, units](const ReadingStyle& style) { return drillingText(report, units, style); };
}

Told drilling(const Scenario& scenario) {
    return toldDrilling(scenario, OutputUnits::si);
}

Told drillingOnADamper(Scenario scenario) {
    scenario.drill.machineMass = 200;
    scenario.drill.damperDamping = 6300;
    scenario.drill.damperStiffness = 1e4;
    return toldDrilling(scenario, OutputUnits::dimensionless);
}

Told drillingPushedBack(Scenario scenario) {
    scenario.drill.thrust = 100;
    return toldDrilling(scenario, OutputUnits::si);
}

/// From where the machine is pushed back on.
DrillingScan scanOfThrust(const Scenario& scenario) {
    return scanDrilling(scenario, parseAxis("drill.thrust=0.1kN,5.5kN,9.5kN").axis, fewBlows, {});
}

Told toldScan(const DrillingScan& scan) {
    const DrillingScanReport report{scan, {}};
    return [report](const ReadingStyle& style) { return drillingScanText(report, OutputUnits::si, style); };
}

Told scan(const Scenario& scenario) {
    return toldScan(scanOfThrust(scenario));
}

/// As of another axis, of which a scan takes seconds, and with what repeats.
Told scanOfDamper(const Scenario& scenario) {
    DrillingScan scan = scanOfThrust(scenario);
    scan.axis = parseAxis("drill.damper_damping=2.5kN s/m,6300N s/m").axis;
    scan.points.back().result.statistics->period = 2;
    scan.points.front().result.outcome = DrillingOutcome::notSolved;
    return toldScan(scan);
}

DesignStudy designStudyOf(const Scenario& scenario) {
    DesignStudy study;
    study.base = scenario;
    for (const char* text : {"bit_rock.gamma=0.3:0.55", "bit_rock.stiffness=+-12.5%"})
        study.uncertain.push_back(parseUncertain(text).input);
    study.aims = {{Sense::largest, findOutput("efficiency"), *findStatistic("q05")},
                  {Sense::least, findOutput("peak_force"), *findStatistic("q95")}};
    study.samples = leastDesignSamples;
    return study;
}

Told toldDesign(const DesignStudy& study, const std::function<void(DesignFindings&)>& change = {}) {
    DesignReport report{study, runDesign(study, {}), {}};
    if (change) change(report.findings);
    return [report](const ReadingStyle& style) { return designText(report, style); };
}

Told design(const Scenario& scenario) {
    return toldDesign(designStudyOf(scenario));
}

/// A rock given by draws, and rare findings about the designs.
Told designOfChoices(const Scenario& scenario) {
    DesignStudy study = designStudyOf(scenario);
    study.uncertain.pop_back();
    study.draws = Draws{{findParameter("bit_rock.stiffness")}, {{1.05e8, 1.25e8, 1.5e8}}};
    study.choices = {parseAxis("bit_rock.gap=0mm,0.25mm,0.5mm").axis};
    study.keepsEnergy = true;
    return toldDesign(study, [](DesignFindings& findings) {
        findings.best.robust = 0;
        findings.best.nominal = 1;
        findings.best.ties = {1, 2};
        findings.best.nextBest = 1;
        findings.feasibility.front().marginal = true;
        findings.designs.front().unsolved = 3;
        findings.designs.front().reason = tooManyPieces;
        findings.designs.front().uncertainShare = 0.0125;
        findings.sensitivity.outputs.front().isConstant = true;
        for (SobolIndex& index : findings.sensitivity.outputs.back().indices) index.first.value = 0.1;
    });
}

/// Machines of other power, and more ties than are printed.
Told designOfMachines(const Scenario& scenario) {
    DesignStudy study = designStudyOf(scenario);
    study.choices = {parseAxis("bit_rock.gap=0mm,0.25mm").axis};
    return toldDesign(study, [](DesignFindings& findings) {
        findings.best.ties.assign(8, 1);
        findings.best.nextBest.reset();
        findings.energySpread = 0.125;
        for (SobolIndex& index : findings.sensitivity.outputs.front().indices) index.total.value = 0.95;
    });
}

MapReport mapReport(const Scenario& scenario, const char* y, OutputUnits units) {
    MapReport report{.study = mapOf(scenario, "bit_rock.gamma=0.2:0.6:3", y, "peak_force", units),
                     .grid = {},
                     .contours = {},
                     .runTime = 1.5,
                     .scenarioText = {}};
    report.grid = solveMap(report.study, 1);
    const auto& extent = *report.grid.extent();
    for (const double level : {(extent.least + extent.largest) / 2, 2 * extent.largest})
        report.contours.push_back(contourOf(report.study, report.grid, level, 1));
    return report;
}

Told map(const Scenario& scenario) {
    const MapReport report =
        mapReport(scenario, "bit_rock.stiffness=50.5MN/m:300MN/m:3:log", OutputUnits::si);
    return [report](const ReadingStyle& style) { return mapText(report, style); };
}

/// Some of its points could not be solved, jump, or do not repeat.
Told mapWithHoles(const Scenario& scenario) {
    MapReport report =
        mapReport(scenario, "bit_rock.stiffness=50.5MN/m:300MN/m:3", OutputUnits::dimensionless);
    report.study.workLimit = 1;
    report.grid = solveMap(report.study, 1);
    Contour& contour = report.contours.front();
    ContourPoint jump{.x = 0.3, .y = 1e8, .value = 1, .residual = 0, .jumpWidth = 0.1, .isIrregular = true};
    contour.lines = {{jump, ContourPoint{}}};
    contour.unplaced = 1;
    contour.reason = tooManyPieces;
    return [report](const ReadingStyle& style) { return mapText(report, style); };
}

struct StudyText {
    const char* name;
    Told (*study)(const Scenario&);
    bool isForStrings = true;  ///< and not only for a rod, where it takes seconds
};

constexpr auto studyTexts = std::to_array<StudyText>({
    {"thrust", thrust},
    {"thrust uphill", [](const Scenario& s) { return thrustUphill(s); }},
    {"no thrust", [](const Scenario& s) { return noThrust(s); }},
    {"drilling", drilling},
    {"drilling on a damper", [](const Scenario& s) { return drillingOnADamper(s); }, false},
    {"drilling pushed back", [](const Scenario& s) { return drillingPushedBack(s); }, false},
    {"scan", scan, false},
    {"scan of the damper", scanOfDamper, false},
    {"design", design, false},
    {"design of choices", designOfChoices, false},
    {"design of machines", designOfMachines, false},
    {"map", map},
    {"map with holes", mapWithHoles, false},
});

/// Returns the names that are the same in every language: keys and names given by the author of the scenario,
/// statistics and aims as options have them, symbols.
QStringList namesOf(const Scenario& scenario) {
    QStringList names{"phi", "FILE", "max",  "min",   "nominal", "log",
                      "MPa", "GPa",  "beta", "gamma", "tau",     "delta"};
    const auto add = [&](std::string_view text) {
        names << wordsOf(QString::fromUtf8(text.data(), qsizetype(text.size())));
    };
    add(scenario.title);
    for (const Parameter& parameter : parameters()) add(parameter.key);
    for (const Output& output : outputs()) add(output.name);
    for (const PulseShape shape : allValues<PulseShape>) add(name(shape));
    return names;
}

}  // namespace

class TestStudyWords : public QObject {
    Q_OBJECT

  private slots:
    void everyWordCanBeTranslated_data();
    void everyWordCanBeTranslated();
    void aRepeatingMotionWithPositiveExponentIsNamedUnstable();
};

void TestStudyWords::everyWordCanBeTranslated_data() {
    QTest::addColumn<std::size_t>("text");
    QTest::addColumn<QString>("example");
    for (std::size_t text = 0; text < studyTexts.size(); ++text)
        for (const char* example : {"r32_hard_rock", "t38_string"})
            if (studyTexts[text].isForStrings || example != std::string_view("t38_string"))
                QTest::addRow("%s: %s", studyTexts[text].name, example) << text << QString(example);
}

void TestStudyWords::everyWordCanBeTranslated() {
    QFETCH(std::size_t, text);
    QFETCH(QString, example);
    const Scenario scenario =
        parseScenario(findExample(example.toStdString())->text, example.toStdString()).scenario;
    const QString told = QString::fromStdString(studyTexts[text].study(scenario)(MarkedCommaStyle()));

    const QStringList names = namesOf(scenario);
    QStringList words = wordsOutsideMarks(told);
    words.removeIf([&](const QString& word) { return names.contains(word); });
    QVERIFY2(words.isEmpty(), qPrintable(words.join(QLatin1String(", ")) + "\n" + told));

    QString numbers = told;
    static const QRegularExpression marked(QStringLiteral("⟦[^⟧]*⟧")), point(QStringLiteral("\\d\\.\\d"));
    numbers.remove(marked);
    QVERIFY2(!numbers.contains(point), qPrintable(told));
}

/// A motion repeats until a disturbance grows: λ beyond its error says so beside the period.
void TestStudyWords::aRepeatingMotionWithPositiveExponentIsNamedUnstable() {
    DrillingResult result;
    result.statistics = DrillingStatistics{};
    result.statistics->regime = DrillingRegime::period;
    result.statistics->period = 1;
    const auto words = [&](double exponent, std::optional<double> error) {
        result.lyapunov = Lyapunov{exponent, error};
        return QString::fromStdString(regimeWords(result).text());
    };
    QVERIFY(words(0.006, 0.001).startsWith("repeats every blow, but a small disturbance grows;"));
    QVERIFY(words(0.001, 0.006).startsWith("repeats every blow;"));
    QVERIFY(words(-0.3, 0.001).startsWith("repeats every blow;"));
    result.statistics->regime = DrillingRegime::irregular;
    QVERIFY(words(0.3, 0.001).startsWith("irregular: use means only;"));
    result.statistics->regime = DrillingRegime::rest;
    result.lyapunov.reset();
    QCOMPARE(QString::fromStdString(regimeWords(result).text()),
             QString("rod back at rest before every blow"));
}

QTEST_GUILESS_MAIN(TestStudyWords)
#include "tst_study_words.moc"
