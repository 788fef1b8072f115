// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of designs against reference cases and the study of all gaps.
#include <QtTest>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <sstream>

#include "core/model/parameter.h"
#include "core/study/design/constant_energy.h"
#include "core/study/design/design_check.h"
#include "core/study/design/design_study.h"
#include "core/study/design/draws.h"
#include "core/yaml/scenario_file.h"

using namespace drillwave;

namespace {

QJsonArray cases() {
    QFile file(QStringLiteral(DRILLWAVE_SOURCE_DIR "/tests/cases/design_cases.json"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no cases");
    return QJsonDocument::fromJson(file.readAll()).object()["cases"].toArray();
}

UncertainInput inputOf(const QString& key, const QJsonArray& range) {
    using enum DistributionKind;
    UncertainInput input{.parameter = findParameter(key.toStdString())};
    for (const DistributionKind kind : {uniform, log, normal, lognormal, percent})
        if (range[0].toString().toStdString() == name(kind)) input.kind = kind;
    if (input.kind == percent)
        input.percent = range[1].toDouble();
    else
        input.low = range[1].toDouble(), input.high = range[2].toDouble();
    return input;
}

DesignStudy studyOf(const QJsonObject& problem) {
    DesignStudy study;
    study.base = parseScenario(problem["scenario"].toString().toStdString(), "case").scenario;
    const QJsonObject uncertain = problem["uncertain"].toObject(), choices = problem["choose"].toObject();
    for (const QString& key : uncertain.keys())
        study.uncertain.push_back(inputOf(key, uncertain[key].toArray()));
    for (const QString& key : choices.keys()) {
        SweepAxis axis;
        axis.parameter = findParameter(key.toStdString());
        axis.unit = &axis.parameter->displayUnit();
        for (const QJsonValue& value : choices[key].toArray()) axis.list.push_back(value.toDouble());
        axis.count = axis.list.size();
        study.choices.push_back(axis);
    }
    const QJsonObject draws = problem["draws"].toObject();
    if (!draws.isEmpty()) {
        study.draws.emplace();
        for (const QJsonValue& key : draws["keys"].toArray()) {
            const qsizetype column = static_cast<qsizetype>(study.draws->parameters.size());
            study.draws->parameters.push_back(findParameter(key.toString().toStdString()));
            std::vector<double>& values = study.draws->columns.emplace_back();
            for (const QJsonValue& row : draws["rows"].toArray())
                values.push_back(row.toArray()[column].toDouble());
        }
    }
    for (const QJsonValue& aim : problem["aims"].toArray())
        study.aims.push_back({aim[0].toString() == "max" ? Sense::largest : Sense::least,
                              findOutput(aim[1].toString().toStdString()),
                              *findStatistic(aim[2].toString().toStdString())});
    study.keepsEnergy = problem["keep_energy"].toBool();
    return study;
}

}  // namespace

class TestDesignStudy : public QObject {
    Q_OBJECT

  private slots:
    void referenceCasesAreWithinTheErrors();
    void keptEnergiesAreEqual();
    void problemsAreToldTogether();
    void drawsNeedEveryCell();
};

// Nominal values to 1e-9; of the statistics 95 % within both errors, which are of 95 %.
void TestDesignStudy::referenceCasesAreWithinTheErrors() {
    int compared = 0, held = 0;
    for (const QJsonValue& problem : cases()) {
        if (problem["id"] == "corner") continue;  // its keys are not those of every build
        const DesignStudy study = studyOf(problem.toObject());
        QVERIFY(problemsOf(study).empty());
        const DesignFindings found = runDesign(study, {.jobs = 2});
        const QJsonArray designs = problem["reference"]["designs"].toArray();
        for (qsizetype d = 0; d < designs.size(); ++d) {
            // the last choice is the fastest there, too
            const DesignSamples& design = found.designs[static_cast<std::size_t>(d)];
            const std::vector<OutputColumn> columns = study.columns();
            for (std::size_t c = 0; c < columns.size(); ++c) {
                const std::string output(columns[c].output->name);
                const double nominal = designs[d]["nominal"][output.c_str()].toDouble();
                QVERIFY(std::abs(design.nominal[c] / nominal - 1) < 1e-9);
                const std::vector<Statistic> asked = study.statisticsOf(*columns[c].output);
                for (std::size_t s = 0; s < asked.size(); ++s) {
                    if (!asked[s].hasError()) continue;
                    const QJsonValue expected =
                        designs[d]["statistics"][(output + "_" + asked[s].name()).c_str()];
                    const double off = design.statistics[c][s].value - expected["value"].toDouble();
                    ++compared;
                    held += std::abs(off) <= design.statistics[c][s].error() + expected["error"].toDouble();
                }
            }
        }
    }
    QVERIFY(compared > 150);
    QVERIFY2(held >= 0.95 * compared, qPrintable(QString("%1 of %2").arg(held).arg(compared)));
}

void TestDesignStudy::keptEnergiesAreEqual() {
    const DesignStudy study = studyOf(cases()[0].toObject());
    const double energy = blowEnergy(study.base);
    QVERIFY(std::abs(energy - 300) < 0.1);
    for (std::uint64_t d = 0; d < study.designCount(); ++d)
        QVERIFY(std::abs(blowEnergy(designScenario(study, d)) / energy - 1) < 1e-12);
}

void TestDesignStudy::problemsAreToldTogether() {
    DesignStudy study = studyOf(cases()[0].toObject());
    study.uncertain.push_back(study.uncertain.front());
    study.aims.assign(4, study.aims.front());
    const std::vector<DesignProblemLine> problems = problemsOf(study);
    QCOMPARE(problems.size(), std::size_t{2});
    QVERIFY(problems[0].isUsage && !problems[1].isUsage);
    for (const char* wrong : {"bit_rock.gamma=0.3:0.1", "bit_rock.gamma=0.1:0.1", "bit_rock.gamma=0.1:2",
                              "bit_rock.gap=0mm:1mm:log", "bit_rock.stiffness=1MN/m:250MN/m:normal",
                              "pulse.shape=0:1", "no.key=0:1", "string.repeat=1:3"}) {
        const ParsedUncertain parsed = parseUncertain(wrong);
        QVERIFY2(!parsed.problem.empty() && !parsed.isMistyped, wrong);
    }
    QVERIFY(parseUncertain("bit_rock.gamma=0.1:0.2:odd").isMistyped);
    QVERIFY(!findStatistic("q0") && !findStatistic("q00") && !findStatistic("q100"));
}

void TestDesignStudy::drawsNeedEveryCell() {
    std::istringstream missing("bit_rock.gamma,bit_rock.stiffness [MN/m]\n0.1,100\n0.2,\n");
    QCOMPARE(readDraws(missing, "draws.csv").unreadable.size(), std::size_t{1});
    std::istringstream unknown("bit_rock.gamma,foo\n0.1,100\n");
    QCOMPARE(readDraws(unknown, "draws.csv").invalid.size(), std::size_t{1});
    std::istringstream whole("bit_rock.gamma,bit_rock.stiffness [MN/m]\n0.1,100\n0.2,120\n");
    const ReadDraws read = readDraws(whole, "draws.csv");
    QVERIFY(read.unreadable.empty() && read.invalid.empty());
    QCOMPARE(read.draws.columns[1][1], 120e6);
}

QTEST_GUILESS_MAIN(TestDesignStudy)
#include "tst_design_study.moc"
