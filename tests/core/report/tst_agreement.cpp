// SPDX-License-Identifier: GPL-3.0-or-later
// Whether all commands say the same of one scenario: random rods and strings, every study at its smallest
// size.
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "core/archive/result_scenario.h"
#include "core/blow/blow.h"
#include "core/contact/contact_law.h"
#include "core/model/parameter.h"
#include "core/report/blow_json.h"
#include "core/report/blow_text.h"
#include "core/report/row_csv.h"
#include "core/report/thrust_report.h"
#include "core/study/curve/curve.h"
#include "core/study/design/design_study.h"
#include "core/study/design/scenario_designs.h"
#include "core/study/drilling/drilling_mesh.h"
#include "core/study/drilling/drilling_study.h"
#include "core/study/gap/gap_study.h"
#include "core/study/rows/sweep.h"
#include "core/study/rows/table.h"
#include "core/study/thrust/thrust_study.h"
#include "core/text/languages.h"
#include "core/text/units.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/yaml/scenario_file.h"
#include "tests/support/map.h"
#include "tests/support/random_scenarios.h"
#include "tests/support/row_text.h"
#include "tests/support/scene.h"
#include "tests/support/sweep.h"
#include "tests/support/tries.h"

using namespace drillwave;
using namespace drillwave::test;

namespace {

/// Cells of a string that the test takes at most.
constexpr long mostCells = 2'000'000;

/// Stated errors of a result.
struct Errors {
    double cor = 0, efficiency = 0, stress = 0;
};

Errors errorsOf(const Blow& blow) {
    return {blow.summary.corError, blow.summary.efficiencyError, blow.summary.stressError};
}

/// Numbers of one scenario by the name of the output.
struct Said {
    QJsonObject plain, si;
};

/// One scenario with the result of `run`.
struct Case {
    std::string text;
    ScenarioDocument document;
    Blow blow;
    Said run;
    Errors quick;  ///< as studies state them
    bool isString() const { return blow.isOfString(); }
};

double at(const QJsonObject& object, std::string_view name) {
    const QJsonValue value = object[QString::fromUtf8(name.data(), qsizetype(name.size()))];
    return value.isDouble() ? value.toDouble() : std::nan("");
}

/// Which outputs have a stated error in every method, and which one: those that a contact more or less makes
/// jump, and sizes of errors, have none.
enum class Bound { none, cor, efficiency, stress };

Bound boundOf(const Output& output, bool isString) {
    if (output.measure == Measure::error || output.name.ends_with("_residual")) return Bound::none;
    if (output.name.starts_with("peak_") && output.name != "peak_force")
        return isString ? Bound::stress : Bound::cor;
    if (output.measure == Measure::energy || output.measure == Measure::share) return Bound::efficiency;
    if (!isString) return Bound::cor;
    for (const char* name : {"cor", "impulse", "thrust"})
        if (output.name == name) return Bound::cor;
    if (output.name == "penetration_rate" || output.name == "residual_penetration") return Bound::efficiency;
    if (output.name == "work_ratio" || output.name == "percussion_power") return Bound::efficiency;
    return Bound::none;
}

}  // namespace

class TestAgreement : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void rowsAreTheRun();
    void mapAndCurveAreTheRun();
    void gapIsTheRun();
    void thrustIsTheRun();
    void nominalDesignIsTheRun();
    void firstBlowOfASequenceIsTheRun();
    void aFileRunsAgainToTheSameNumbers();
    void languagesHaveTheSameNumbers();
    void groupsAreTheRod();

  private:
    /// Empty where a number agrees with that of the run.
    QByteArray difference(const Case& one, const Output& output, double value, double ofRun,
                          const Errors& study) const;

    std::vector<Case> m_cases;
};

void TestAgreement::initTestCase() {
    const int count = tries("DRILLWAVE_AGREEMENT_SCENES", 20, 300);
    Chance chance(static_cast<std::uint64_t>(seed()) + 1);
    qInfo("%d scenarios, seed %d", count, seed());
    MethodSolver solver;
    while (static_cast<int>(m_cases.size()) < count) {
        Case one;
        one.text = randomScenarioText(chance);
        one.document = parseScenario(one.text, "scene.yaml");
        one.blow = solveBlow(one.document.scenario, {}, Detail::ledger, {}, Stresses::wanted);
        QVERIFY2(one.blow.isSolved(), (one.text + one.blow.impact.reason.text()).c_str());
        if (one.blow.impact.pieces > mostCells) continue;
        const QByteArray json = QByteArray::fromStdString(blowJson(one.blow, one.text));
        const QJsonObject object = QJsonDocument::fromJson(json).object();
        one.run = {object["dimensionless"].toObject(), object["si"].toObject()};
        QVERIFY(!one.run.plain.isEmpty() && !one.run.si.isEmpty());
        for (const char* name : {"rock_work", "rebound_energy", "residual_wave_energy", "string_energy"})
            QVERIFY2(!(at(one.run.plain, name) < -1e-9), (one.text + name).c_str());
        one.quick = errorsOf(solveBlow(one.document.scenario, {}, Detail::ledger, {}, Stresses::wanted,
                                       solver, NetworkAccuracy::quick));
        m_cases.push_back(std::move(one));
    }
}

QByteArray TestAgreement::difference(const Case& one, const Output& output, double value, double ofRun,
                                     const Errors& study) const {
    const Errors run = errorsOf(one.blow);
    double share = 1e-10;  // rounding
    switch (boundOf(output, one.isString())) {
        case Bound::none:
            return {};
        case Bound::cor:
            share += run.cor + study.cor;
            break;
        case Bound::efficiency:
            // On elastic rock nothing stays, and only e tells what waves are off by.
            share += std::max(run.efficiency + study.efficiency, run.cor + study.cor);
            break;
        case Bound::stress:
            share += run.stress + study.stress;
            break;
    }
    // The error of a share is one of the whole.
    double scale = std::abs(ofRun);
    const bool isShare = output.measure == Measure::energy || output.measure == Measure::share;
    if (isShare) {
        const QString name = QString::fromUtf8(output.name.data(), qsizetype(output.name.size()));
        const double own = one.run.plain[name].toDouble();
        scale = own != 0 ? std::abs(ofRun / own) : 1;
    } else if (output.name == "cor") {
        scale = 1;
    } else if (output.name == "residual_penetration" || output.name == "penetration_rate") {
        scale /= std::max(one.blow.summary.energy.rockWork, 1e-6);
    }
    if (std::abs(value - ofRun) <= share * scale || (std::isnan(value) && std::isnan(ofRun))) return {};
    return QByteArray(output.name.data(), qsizetype(output.name.size())) + ": " +
           QByteArray::number(value, 'g', 12) + " for " + QByteArray::number(ofRun, 'g', 12) + ", stated " +
           QByteArray::number(share * scale) + "\n" + QByteArray::fromStdString(one.text);
}

namespace {

/// Rows of CSV by the titles of its columns.
class Rows : public RowText {
  public:
    /// The only row, by column.
    QMap<QByteArray, double> only() const {
        QList<QByteArray> lines;
        for (const QByteArray& line : QByteArray::fromStdString(text()).split('\n'))
            if (!line.isEmpty() && !line.startsWith('#')) lines << line;
        QMap<QByteArray, double> cells;
        const QList<QByteArray> titles = lines.value(0).split(','), values = lines.value(1).split(',');
        for (qsizetype i = 0; i < titles.size(); ++i)
            cells[titles[i].split('[').first().trimmed()] =
                values.value(i).isEmpty() ? std::nan("") : values.value(i).toDouble();
        return cells;
    }
};

void tellsNobody(const RowCounts&) {}

double at(const QMap<QByteArray, double>& row, std::string_view name) {
    return row.value(QByteArray(name.data(), qsizetype(name.size())), std::nan(""));
}

}  // namespace

/// `sweep` and `table`, in groups and in SI.
void TestAgreement::rowsAreTheRun() {
    int compared = 0;
    for (const Case& one : m_cases)
        for (const OutputUnits units : {OutputUnits::dimensionless, OutputUnits::si}) {
            const Scenario& base = one.document.scenario;
            const std::vector<OutputColumn> columns = allOutputsOf(base, units);
            const std::string gamma = number(base.bitRock.gamma);
            Rows swept, tabled;
            const std::string axis = "bit_rock.gamma=" + gamma;
            Sweep sweep = sweepOf(base, {axis.c_str()}, "cor", units);
            sweep.columns = columns;
            sweep.workLimit = mostNetworkCells;
            QCOMPARE(runSweep(sweep, 1, {}, swept, tellsNobody).failed, std::uint64_t{0});
            Table table{.base = base, .source = "cases.csv", .columns = columns, .shard = {}};
            table.workLimit = sweep.workLimit;
            std::istringstream cases("bit_rock.gamma\n" + gamma + "\n");
            const TableCheck check = checkTable(table, cases, 1, {});
            QVERIFY(check.problems.empty());
            cases.clear();
            cases.seekg(0);
            runTable(table, cases, check.rows, 1, {}, tabled, tellsNobody);
            const auto row = swept.only(), other = tabled.only();
            for (const OutputColumn& column : columns) {
                const Output& output = *column.output;
                const bool isSi = column.hasUnit();
                const double ofRun = at(isSi ? one.run.si : one.run.plain, output.name);
                const double value = at(row, output.name);
                QVERIFY(value == at(other, output.name) ||
                        (std::isnan(value) && std::isnan(at(other, output.name))));
                // `run` makes no study of all gaps.
                if (std::isnan(value) || output.needsThrustStudy()) continue;
                const QByteArray told = difference(one, output, value, ofRun, one.quick);
                QVERIFY2(told.isEmpty(), told);
                ++compared;
            }
        }
    QVERIFY2(compared > 30 * static_cast<int>(m_cases.size()), QByteArray::number(compared));
}

void TestAgreement::mapAndCurveAreTheRun() {
    for (const Case& one : m_cases) {
        const Scenario& base = one.document.scenario;
        const double gamma = base.bitRock.gamma, stiffness = base.bitRock.stiffness;
        const auto range = [](double value) {
            return number(value) + "N/m:" + number(1.001 * value) + "N/m:2";
        };
        const double low = gamma / 1.001;
        MapStudy map =
            mapOf(base, "bit_rock.gamma=" + number(low) + ":" + number(gamma) + ":2",
                  "bit_rock.stiffness=" + range(stiffness), "residual_penetration", OutputUnits::si);
        map.workLimit = mostNetworkCells;
        const MapGrid grid = solveMap(map, 1);
        const Output& penetration = *findOutput("residual_penetration");
        QByteArray told =
            difference(one, penetration, grid.value(1, 0), at(one.run.si, penetration.name), one.quick);
        QVERIFY2(told.isEmpty(), told);
        if (one.isString()) continue;  // a curve of a string takes its time
        CurveQuestion question{
            .base = base,
            .along = parseRange("bit_rock.gamma=" + number(low) + ":" + number(gamma)).axis,
            .family = {},
            .columns = chooseOutputs("cor,residual_penetration", OutputUnits::si).columns,
            .levels = {}};
        const CurveStudy curve = studyCurve(question, 1);
        for (std::size_t i = 0; i < 2; ++i) {
            const Output& output = *question.columns[i].output;
            const CurveLine& line = curve.lines.front();
            const double value = line.value(gamma, i).value_or(std::nan(""));
            const double allowed = line.error(gamma, i).value_or(0) + 1e-9 * std::abs(value) + 1e-12;
            QVERIFY2(std::abs(value - at(one.run.si, output.name)) <= allowed,
                     QByteArray::number(value, 'g', 12) + " for " +
                         QByteArray::number(at(one.run.si, output.name), 'g', 12) + "\n" +
                         QByteArray::fromStdString(one.text));
        }
    }
}

void TestAgreement::gapIsTheRun() {
    int compared = 0;
    for (const Case& one : m_cases) {
        if (one.isString() || !gapPeriod(one.document.scenario)) continue;
        const GapStudy study = studyGap(one.document.scenario, {});
        if (!study.curve.reason.isEmpty()) continue;
        ++compared;
        const double gap = groupsOf(one.document.scenario).delta;
        const std::array<std::pair<GapOutput, const char*>, 3> outputs{
            {{GapOutput::cor, "cor"},
             {GapOutput::peakForce, "peak_force"},
             {GapOutput::efficiency, "efficiency"}}};
        for (const auto& [output, name] : outputs) {
            const double value = study.curve.value(output, gap), ofRun = at(one.run.plain, name);
            QVERIFY2(std::abs(value - ofRun) < 1e-8 * std::max(1.0, std::abs(ofRun)),
                     QByteArray(name) + " " + QByteArray::number(value, 'g', 12) + " for " +
                         QByteArray::number(ofRun, 'g', 12) + "\n" + QByteArray::fromStdString(one.text));
        }
    }
    QVERIFY(compared > 0);
}

void TestAgreement::thrustIsTheRun() {
    MethodSolver solver;
    for (const Case& one : m_cases) {
        const Scenario& scenario = one.document.scenario;
        if (!one.isString() && !gapPeriod(scenario)) continue;
        const ThrustStudy study = one.isString()
                                      ? *studyStringThrust(scenario, NetworkAccuracy::sure, solver, {})
                                      : studyThrust(scenario);
        if (!study.reason.isEmpty()) continue;
        const QByteArray json = QByteArray::fromStdString(thrustJson({scenario, study}, one.text));
        const QJsonObject needs = QJsonDocument::fromJson(json).object()["needs"].toObject();
        const QJsonObject blow = needs["scenario"].toObject();
        QVERIFY2(!blow.isEmpty(), json);
        const Estimate& cor = study.need(ThrustCase::scenario).cor;
        const double allowed = cor.error + one.blow.summary.corError + 1e-10;
        QVERIFY(std::abs(blow["cor"].toDouble() - at(one.run.plain, "cor")) <= allowed);
        const double thrust = at(one.run.si, "thrust");
        QVERIFY(std::abs(blow["thrust"].toDouble() - thrust) <= allowed * thrust);
    }
}

void TestAgreement::nominalDesignIsTheRun() {
    for (const Case& one : m_cases) {
        DesignStudy study;
        study.base = one.document.scenario;
        study.uncertain = {parseUncertain("bit_rock.stiffness=+-1%").input};
        study.samples = leastDesignSamples;
        for (const char* name : {"efficiency", "thrust"}) {
            const bool isElastic = study.base.bitRock.gamma == 1;
            study.aims.push_back({.sense = Sense::least,
                                  .output = findOutput(isElastic && name[0] == 'e' ? "cor" : name),
                                  .statistic = {}});
        }
        const ScenarioDesigns designs(study);
        std::vector<double> nominal(designs.outputCount());
        QVERIFY(designs.solver()->solveNominal(0, nominal, {}).isEmpty());
        const std::vector<OutputColumn> columns = study.columns();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Output& output = *columns[i].output;
            const double ofRun = at(columns[i].hasUnit() ? one.run.si : one.run.plain, output.name);
            const QByteArray told = difference(one, output, nominal[i], ofRun, one.quick);
            QVERIFY2(told.isEmpty(), told);
        }
    }
}

/// The first blow from rest where the feed does nothing, by two sizes of cells.
void TestAgreement::firstBlowOfASequenceIsTheRun() {
    int compared = 0;
    for (const Case& one : m_cases) {
        Scenario scenario = one.document.scenario;
        // Sequences are of hammers that strike again and again.
        if (!one.isString() || isForced(scenario)) continue;
        scenario.bitRock.gap = 0;
        const Blow alone = solveBlow(scenario, {}, Detail::ledger);
        const auto penetrationOf = [&](int cells) {
            DrillingMesh mesh = drillingMeshOf(scenario, cells);
            DrillingMarch march(mesh.problem, mesh.grid);
            mesh.problem.feedForce = march.hammerMomentum() / mesh.grid.interval();
            return march.takeBlow({}) ? march.blow().penetration : std::nan("");
        };
        const double coarse = penetrationOf(20), fine = penetrationOf(40);
        if (std::isnan(coarse) || std::isnan(fine)) continue;
        const double ofRun = alone.summary.residualPenetration / lawUnitOfPenetration;
        const double allowed =
            coveringCells * std::abs(fine - coarse) +
            (alone.summary.efficiencyError / std::max(alone.summary.energy.rockWork, 1e-6) + 5e-3) * ofRun;
        QVERIFY2(std::abs(fine - ofRun) <= allowed, QByteArray::number(fine, 'g', 12) + " for " +
                                                        QByteArray::number(ofRun, 'g', 12) + "\n" +
                                                        QByteArray::fromStdString(one.text));
        ++compared;
    }
    qInfo("%d first blows", compared);
}

void TestAgreement::aFileRunsAgainToTheSameNumbers() {
    for (const Case& one : m_cases) {
        const std::string written = writeScenario({one.document.scenario, {}, {}});
        const std::string json = blowJson(one.blow, one.text);
        for (const Scenario& again : {parseScenario(written, "again.yaml").scenario,
                                      parseInput(json, "summary.json").document.scenario}) {
            QVERIFY2(again == one.document.scenario, written.c_str());
            if (one.isString() && &one != &m_cases.front()) continue;
            const Blow blow = solveBlow(again, {}, Detail::ledger, {}, Stresses::wanted);
            QCOMPARE(blow.summary.cor, one.blow.summary.cor);
            QCOMPARE(blow.summary.residualPenetration, one.blow.summary.residualPenetration);
            QCOMPARE(blow.summary.largest.tension, one.blow.summary.largest.tension);
        }
    }
}

void TestAgreement::languagesHaveTheSameNumbers() {
    const auto numbersOf = [](const std::string& text) {
        static const QRegularExpression sign(QStringLiteral("[-−]?\\d+[.,]\\d+(e[-+]?\\d+)?"));
        QStringList numbers;
        for (auto found = sign.globalMatch(QString::fromStdString(text)); found.hasNext();)
            numbers << found.next().captured().replace(',', '.').replace(QChar(0x2212), '-');
        numbers.sort();
        return numbers;
    };
    for (const Case& one : m_cases) {
        const QStringList english = numbersOf(blowText(one.blow, styleOf(languages[0])));
        QVERIFY(english.size() > 12);
        for (const Language& language : languages)
            QCOMPARE(numbersOf(blowText(one.blow, styleOf(language))), english);
    }
}

/// A rod by its groups has the numbers of the rod in physical units.
void TestAgreement::groupsAreTheRod() {
    for (const Case& one : m_cases) {
        if (one.isString() || one.document.scenario.pulse.shape == PulseShape::table) continue;
        Scenario scenario;
        scenario.form = ScenarioForm::dimensionless;
        scenario.pulse.shape = one.document.scenario.pulse.shape;
        scenario.groups = groupsOf(one.document.scenario);
        const Blow blow = solveBlow(scenario, {}, Detail::ledger, {}, Stresses::wanted);
        QVERIFY(blow.isSolved());
        for (const auto& [value, ofRun] :
             {std::pair(blow.summary.cor, one.blow.summary.cor),
              std::pair(blow.summary.residualPenetration, one.blow.summary.residualPenetration),
              std::pair(blow.summary.peakForce, one.blow.summary.peakForce),
              std::pair(*blow.summary.largest.tension, *one.blow.summary.largest.tension)})
            QVERIFY2(std::abs(value - ofRun) <= 1e-10 * std::max(1.0, std::abs(ofRun)), one.text.c_str());
    }
}

QTEST_GUILESS_MAIN(TestAgreement)
#include "tst_agreement.moc"
