// SPDX-License-Identifier: GPL-3.0-or-later
// Random scenarios in which some numbers are absurd: none ends in a crash or a hang, none has a number where
// it is not valid, and no text holds what is not a number.
#include <QRegularExpression>
#include <QTest>

#include <array>
#include <cmath>
#include <limits>

#include "core/blow/blow.h"
#include "core/model/parameter.h"
#include "core/model/section_field.h"
#include "core/model/validation.h"
#include "core/report/blow_json.h"
#include "core/report/blow_text.h"
#include "core/report/curve_report.h"
#include "core/report/curve_text.h"
#include "core/report/design_report.h"
#include "core/report/drilling_report.h"
#include "core/report/gap_report.h"
#include "core/report/row_csv.h"
#include "core/report/thrust_report.h"
#include "core/study/curve/curve.h"
#include "core/study/curve/sampled_curve.h"
#include "core/study/design/design_study.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/drilling/marched_blow.h"
#include "core/study/gap/gap_study.h"
#include "core/study/map/map.h"
#include "core/study/proof/accuracy.h"
#include "core/study/proof/string_accuracy.h"
#include "core/study/rows/sweep.h"
#include "core/study/scan/drilling_scan.h"
#include "core/study/thrust/thrust_curve.h"
#include "core/study/thrust/thrust_study.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/random_scenarios.h"
#include "tests/support/row_text.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

/// A number that nobody means, or one far from what was there.
double absurd(double value, Chance& chance) {
    constexpr std::array values{nan,    infinity, -infinity, 0.0,   -0.0, -1.0,   5e-324,   1e-308,
                                1e-300, 1e-100,   1e-30,     1e-15, 1e-9, 1e-6,   1e-3,     1.0,
                                1.5,    5.5,      1e3,       1e6,   1e9,  1e12,   1e15,     1e30,
                                1e100,  1e300,    1e308,     -1e-3, -1e9, -1e300, 1 - 1e-16};
    switch (chance.below(4)) {
        case 0:
            return values[chance.below(values.size())];
        case 1:
            return value * chance.logarithmic(1e-12, 1e12);
        case 2:
            return value * chance.logarithmic(1e-3, 1e3);
        default:
            return chance.oneIn(2) ? -value : value * (1 + 1e-15);
    }
}

template <class Value>
void insane(std::optional<double>& value, Value usual, Chance& chance) {
    value = absurd(value.value_or(usual), chance);
}

/// Makes what is not a single number absurd: lists, words, repeats.
void breakStructure(Scenario& scenario, Chance& chance) {
    Pulse& pulse = scenario.pulse;
    DrillString& drillString = scenario.drillString;
    BitRock& rock = scenario.bitRock;
    switch (chance.below(10)) {
        case 0:
            pulse.shape = static_cast<PulseShape>(chance.below(8));
            break;
        case 1: {
            std::vector<TablePoint> points;
            for (unsigned i = chance.below(5); i > 0; --i)
                points.push_back({absurd(i * 1e-4, chance), absurd(1e5, chance)});
            pulse.shape = PulseShape::table;
            pulse.tablePoints = TablePoints(points);
            break;
        }
        case 2:
            rock.law = static_cast<RockLaw>(chance.below(3));
            break;
        case 3:
            rock.law = RockLaw::corners;
            for (unsigned i = chance.below(4); i > 0; --i)
                rock.corners.push_back({absurd(i * 5e4, chance), absurd(0.5 * i, chance)});
            break;
        case 4:
            drillString.parts.clear();
            break;
        case 5:
            drillString.hammer.sections.clear();
            break;
        case 6:
            if (!drillString.parts.empty()) {
                StringPart& part = drillString.parts[chance.below(unsigned(drillString.parts.size()))];
                constexpr std::array repeats{0, -1, 2, 300, 100'000, 2'147'483'647, -2'147'483'647};
                part.repeat = repeats[chance.below(repeats.size())];
                part.group = chance.oneIn(2);
                if (chance.oneIn(4)) part.sections.clear();
            }
            break;
        case 7:
            scenario.form = static_cast<ScenarioForm>(chance.below(3));
            break;
        case 8:
            drillString.parts.push_back({.sections = {Section{}}});
            break;
        default:
            pulse.impulseFromForce = !pulse.impulseFromForce;
    }
}

/// Makes one to three things of a scenario absurd.
void makeAbsurd(Scenario& scenario, Chance& chance) {
    for (unsigned left = 1 + chance.below(3); left > 0; --left) {
        if (chance.oneIn(4)) {
            breakStructure(scenario, chance);
            continue;
        }
        std::vector<const Parameter*> possible;
        for (const Parameter& parameter : parameters())
            if (parameter.applies(scenario) && !parameter.isGroup()) possible.push_back(&parameter);
        std::vector<Section*> sections;
        if (isString(scenario)) {
            for (Section& section : scenario.drillString.hammer.sections) sections.push_back(&section);
            for (StringPart& part : scenario.drillString.parts)
                for (Section& section : part.sections) sections.push_back(&section);
        }
        if (!sections.empty() && chance.oneIn(2)) {
            Section& section = *sections[chance.below(unsigned(sections.size()))];
            const auto fields = sectionFields();
            const SectionField& field = fields[chance.below(unsigned(fields.size()))];
            field.assign(section, absurd(field.value(section).value_or(1), chance));
        } else if (scenario.form == ScenarioForm::dimensionless) {
            Groups& groups = scenario.groups;
            double* const of[] = {&groups.beta, &groups.gamma, &groups.tau, &groups.delta};
            double& value = *of[chance.below(4)];
            value = absurd(value, chance);
        } else if (!possible.empty()) {
            const Parameter& parameter = *possible[chance.below(unsigned(possible.size()))];
            parameter.assign(scenario, absurd(parameter.value(scenario).value_or(1), chance));
        }
    }
}

Scenario absurdScenario(Chance& chance) {
    Scenario scenario;
    if (chance.oneIn(6)) {
        scenario.form = ScenarioForm::dimensionless;
        scenario.groups = {chance.logarithmic(0.05, 50), chance.logarithmic(0.02, 1),
                           chance.logarithmic(0.3, 30), chance.oneIn(2) ? 0 : 3 * chance.fraction()};
        scenario.pulse.shape = static_cast<PulseShape>(chance.below(6));
    } else {
        scenario = parseScenario(randomScenarioText(chance), "scene.yaml").scenario;
        if (chance.oneIn(2)) {
            scenario.drill.machineMass = 200;
            scenario.drill.damperDamping = 5000;
        }
    }
    if (!chance.oneIn(8)) makeAbsurd(scenario, chance);
    return scenario;
}

/// Work that a blow of the test may take.
constexpr WorkLimits smallWork{.pieces = 100'000, .cells = 1'000'000};

/// The same of a march of few blows.
constexpr double smallMarch = 5e7;

/// Wave pieces of a blow in a study of many.
constexpr long fewPieces = 5'000;

/// Returns the seed of a case, which is another one for every study and every commit.
std::uint64_t chanceOf(int study, int number) {
    return (static_cast<std::uint64_t>(seed()) * 100 + static_cast<std::uint64_t>(study)) * 1'000'000 +
           static_cast<std::uint64_t>(number);
}

/// Cases of one row: Qt Test gives each row five minutes, and its name tells where one hangs.
constexpr int casesOfRow = 100;

/// Returns the place where a text has no number, empty where there is none.
QByteArray faultOf(const std::string& text) {
    static const QRegularExpression noNumber(QStringLiteral("(?<![\\w'])[-+]?(nan|inf)(?![\\w'])"));
    const QString all = QString::fromStdString(text);
    const QRegularExpressionMatch found = noNumber.match(all);
    if (!found.hasMatch()) return {};
    return all.mid(std::max(qsizetype(0), found.capturedStart() - 200), 260).toUtf8();
}

/// Counts faults and keeps the first ones.
class Faults {
  public:
    void add(const std::string& name, const QByteArray& fault) {
        if (m_count++ < 20) m_first += QByteArray::fromStdString(name) + ": " + fault + "\n";
    }
    bool isEmpty() const { return m_count == 0; }
    QByteArray list() const { return QByteArray::number(m_count) + " faults\n" + m_first; }

  private:
    int m_count = 0;
    QByteArray m_first;
};

}  // namespace

class TestAbsurdScenarios : public QObject {
    Q_OBJECT

  private slots:
    void run_data();
    void run();
    void studies_data();
    void studies();
};

void TestAbsurdScenarios::run_data() {
    QTest::addColumn<int>("first");
    const int count = tries("DRILLWAVE_ABSURD_RUNS", 3 * casesOfRow, 200 * casesOfRow);
    for (int first = 0; first < count; first += casesOfRow)
        QTest::newRow(QByteArray::number(first).constData()) << first;
}

void TestAbsurdScenarios::run() {
    QFETCH(int, first);
    int solved = 0, invalid = 0;
    Faults faults;
    MethodSolver solver(smallWork);
    for (int i = first; i < first + casesOfRow; ++i) {
        const std::string name = "run " + std::to_string(i);
        Chance chance(chanceOf(0, i));
        const Scenario scenario = absurdScenario(chance);
        const bool isValid = validate(scenario).empty();
        const auto detail = chance.oneIn(3) ? static_cast<Detail>(chance.below(5)) : Detail::ledger;
        MethodChoice method;
        if (chance.oneIn(8)) method.method = static_cast<Method>(chance.below(3));
        const Blow blow =
            solveBlow(scenario, method, detail, {}, static_cast<Stresses>(chance.below(2)), solver);
        if (!isValid) {
            ++invalid;
            if (blow.isSolved() || blow.impact.reason.isEmpty()) faults.add(name, "invalid, and solved");
            continue;
        }
        if (!blow.isSolved()) {
            if (blow.impact.reason.isEmpty()) faults.add(name, "not solved without a reason");
            continue;
        }
        ++solved;
        if (!(blow.summary.cor >= -1 - 1e-9)) faults.add(name, "cor " + QByteArray::number(blow.summary.cor));
        if (detail < Detail::ledger) continue;  // texts have what is in waves
        for (const std::string& text : {blowJson(blow, {}), blowText(blow)})
            if (const QByteArray fault = faultOf(text); !fault.isEmpty()) faults.add(name, fault);
    }
    QVERIFY2(faults.isEmpty(), faults.list());
    QVERIFY(solved > casesOfRow / 8 && invalid > casesOfRow / 8);
}

namespace {

/// An answer of a study with its texts, or the reason why there is none.
struct Answer {
    bool isAnswer = false;
    std::string reason;
    std::vector<std::string> texts;
};

Answer answerOf(const Message& reason, std::vector<std::string> texts) {
    return {reason.isEmpty(), reason.text(), std::move(texts)};
}

Answer drilling(const Scenario& scenario) {
    DrillingSettings settings{.blows = 12, .settle = 3, .cells = 10};
    const DrillingResult result =
        studyDrilling(scenario, settings, {.blowAlone = false, .mostWork = smallMarch});
    if (result.outcome == DrillingOutcome::notSolved) return answerOf(result.reason, {});
    const DrillingReport report{result, {}, {}};
    return {true,
            {},
            {drillingJson(report, OutputUnits::si), drillingText(report, OutputUnits::si),
             drillingCsv(report, OutputUnits::dimensionless)}};
}

Answer marched(const Scenario& scenario) {
    const Blow blow = marchedBlow(scenario, {.blows = 12, .settle = 3, .cells = 10}, 7, {}, smallMarch);
    return {blow.isSolved(), blow.impact.reason.text(), {}};
}

Answer scanned(const Scenario& scenario) {
    const ParsedAxis axis = parseAxis("bit_rock.gamma=0.2,0.4");
    const DrillingScan scan =
        scanDrilling(scenario, axis.axis, {.blows = 12, .settle = 3, .cells = 10}, {.mostWork = smallMarch});
    if (!scan.refusal.isEmpty()) return answerOf(scan.refusal, {});
    return {scan.points.size() >= 2, {}, {}};
}

Answer gaps(const Scenario& scenario) {
    const GapStudy study = studyGap(scenario, NormalGap{1, 0.3}, {}, {}, 300'000);
    if (!study.curve.isComplete()) return {false, study.curve.reason.text(), {}};
    return {true, {}, {gapJson(study, {}), gapText(study), gapCsv(study, OutputUnits::dimensionless)}};
}

Answer thrust(const Scenario& scenario) {
    const ThrustStudy study = studyThrust(scenario, {}, {}, 300'000, smallWork);
    if (!study.reason.isEmpty()) return answerOf(study.reason, {});
    const ThrustReport report{scenario, study};
    return {true, {}, {thrustJson(report, {}), thrustText(report)}};
}

Answer thrustCurve(const Scenario& scenario) {
    const ThrustCurve curve =
        thrustAlong(scenario, *findParameter("drill.blow_frequency"), std::array{30.0}, 1);
    return answerOf(curve.points.at(0).reason, {});
}

Answer rows(const Scenario& scenario) {
    Sweep sweep{.base = scenario,
                .axes = {parseAxis("gamma=0.3").axis},
                .columns = chooseOutputs("cor,efficiency,peak_force", OutputUnits::dimensionless).columns,
                .shard = {}};
    RowText sink;
    const RowCounts counts = runSweep(sweep, 1, {}, sink, {});
    if (!counts.refusal.isEmpty()) return answerOf(counts.refusal, {});
    if (counts.failed > 0) return {false, counts.failures.front().reason.text(), {}};
    return {true, {}, {sink.text()}};
}

Answer mapped(const Scenario& scenario) {
    const MapStudy study{.base = scenario,
                         .x = parseAxis("gamma=0.2:0.4:2").axis,
                         .y = parseAxis("beta=0.5:1:2").axis,
                         .output = chooseOutputs("cor", OutputUnits::dimensionless).columns.front()};
    const MapGrid grid = solveMap(study, 1);
    if (!grid.refusal().isEmpty()) return answerOf(grid.refusal(), {});
    if (grid.failed() > 0) return {false, grid.failures().front().reason.text(), {}};
    return {true, {}, {}};
}

Answer curve(const Scenario& scenario) {
    CurveQuestion question{.base = scenario,
                           .along = parseRange("gamma=0.3:0.31").axis,
                           .family = {},
                           .columns = chooseOutputs("cor", OutputUnits::dimensionless).columns,
                           .levels = {0.5},
                           .workLimit = smallWork.pieces};
    if (isString(scenario)) question.along.count = 3;
    const CurveStudy study = isString(scenario) ? sampleCurve(question, 1) : studyCurve(question, 1);
    if (!study.refusal.isEmpty()) return answerOf(study.refusal, {});
    const CurveReport report{study, 0, {}};
    return {true, {}, {curveJson(report), curveText(report)}};
}

Answer designed(const Scenario& scenario) {
    DesignStudy study;
    study.base = scenario;
    study.uncertain = {parseUncertain("bit_rock.stiffness=+-1%").input};
    study.samples = leastDesignSamples;
    study.aims = {{Sense::largest, findOutput("cor"), {}}};
    study.workLimit = fewPieces;
    const DesignFindings findings = runDesign(study, {});
    for (const Message& reason : {findings.refusal, findings.unsolved})
        if (!reason.isEmpty()) return answerOf(reason, {});
    if (!findings.best.robust) return {false, "no design has statistics", {}};
    const DesignReport report{study, findings, {}};
    return {true, {}, {designJson(report), designText(report)}};
}

Answer accuracy(const Scenario& scenario) {
    if (isString(scenario))
        return answerOf(measureStringAccuracy(scenario, {}, {}, smallWork.cells).reason, {});
    const Accuracy accuracy = measureAccuracy(scenario, {minimumSegments});
    return {accuracy.exact.isSolved(), accuracy.exact.reason.text(), {}};
}

struct StudyCase {
    const char* name;
    Answer (*ask)(const Scenario&);
    int by = 1;  ///< one scenario in so many: what takes long
};
constexpr StudyCase studyCases[] = {
    {"drilling", drilling, 10}, {"marched", marched, 5},    {"scan", scanned, 20},
    {"gap", gaps, 10},          {"thrust", thrust, 10},     {"thrust curve", thrustCurve, 10},
    {"rows", rows, 2},          {"map", mapped, 10},        {"curve", curve, 2},
    {"design", designed, 5},    {"accuracy", accuracy, 50},
};

}  // namespace

void TestAbsurdScenarios::studies_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<int>("first");
    const int count = tries("DRILLWAVE_ABSURD_STUDIES", casesOfRow, 10 * casesOfRow);
    for (int i = 0; i < int(std::size(studyCases)); ++i)
        for (int first = 0; first < count; first += casesOfRow)
            QTest::addRow("%s %d", studyCases[i].name, first) << i << first;
}

void TestAbsurdScenarios::studies() {
    QFETCH(int, which);
    const StudyCase& study = studyCases[which];
    QFETCH(int, first);
    int answers = 0;
    std::string lastReason;
    Faults faults;
    for (int i = first; i < first + casesOfRow; i += isNightly() ? 1 : study.by) {
        const std::string name = std::string(study.name) + " " + std::to_string(i);
        Chance chance(chanceOf(1 + which, i));
        const Scenario scenario = absurdScenario(chance);
        const bool isValid = validate(scenario).empty();
        const Answer answer = study.ask(scenario);
        if (!answer.isAnswer && answer.reason.empty()) faults.add(name, "no answer and no reason");
        // Rows, maps, curves and scans set numbers of their own, which may replace a wrong one.
        for (const std::string& text : answer.texts)
            if (const QByteArray fault = faultOf(text); !fault.isEmpty()) faults.add(name, fault);
        const bool setsNumbers = study.ask == rows || study.ask == mapped || study.ask == curve ||
                                 study.ask == scanned || study.ask == thrustCurve;
        if (!isValid && answer.isAnswer && !setsNumbers) faults.add(name, "invalid, and an answer");
        answers += answer.isAnswer;
        if (!answer.isAnswer) lastReason = answer.reason;
    }
    qInfo("%s: %d answers, last reason: %s", study.name, answers, lastReason.c_str());
    QVERIFY2(faults.isEmpty(), faults.list());
}

QTEST_GUILESS_MAIN(TestAbsurdScenarios)
#include "tst_absurd_scenarios.moc"
