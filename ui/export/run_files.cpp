#include "ui/export/run_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include "core/file/blow_csv.h"
#include "core/file/result_remarks.h"
#include "core/file/result_scenario.h"
#include "core/model/pulse_force.h"
#include "core/model/scales.h"
#include "ui/export/whole_file.h"
#include "ui/plots/plot_export.h"

namespace drillwave {
namespace {

const QString scenarioName = QStringLiteral("scenario.yaml");
const QString summaryName = QStringLiteral("summary.json");
const QString historiesName = QStringLiteral("histories.csv");
const QString eventsName = QStringLiteral("events.csv");

QString tr(const char* text) {
    return QCoreApplication::translate("drillwave::RunFiles", text);
}

// Files of these names that are no run's may be there too: those are left alone.
bool holdsRun(const QDir& folder) {
    QFile file(folder.filePath(historiesName));
    return file.open(QIODevice::ReadOnly) && file.readLine(64).startsWith("# # Written by Drillwave ");
}

QString removeOldPlots(const QDir& folder, const QStringList& wantedFormats) {
    if (!holdsRun(folder)) return {};
    const QStringList wanted = runFileNames(wantedFormats);
    for (const QString& name : runFilesThere(folder.path(), plotFormats()))
        if (!wanted.contains(name) && !QFile::remove(folder.filePath(name)))
            return tr("%1: shows an earlier run and cannot be removed; choose another folder")
                .arg(QDir::toNativeSeparators(folder.filePath(name)));
    return {};
}

}  // namespace

OutputUnits customaryUnits(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional ? OutputUnits::si : OutputUnits::dimensionless;
}

QByteArray runHeader(const SolvedRun& run) {
    return QByteArray::fromStdString(
        scenarioHeader(completeScenarioText(run.document), describe(run.report.choice)));
}

QByteArray historiesFile(const SolvedRun& run) {
    const Scenario& scenario = run.report.scenario;
    return QByteArray::fromStdString(scenarioHeader(completeScenarioText(run.document),
                                                    describe(run.report.choice), historyColumns(run.units)) +
                                     historiesCsv(run.report.impact, pulseForceOf(scenario),
                                                  groupsOf(scenario), run.units, scalesOf(scenario)));
}

QByteArray eventsFile(const SolvedRun& run) {
    return runHeader(run) +
           QByteArray::fromStdString(eventsCsv(run.report.impact, run.units, scalesOf(run.report.scenario)));
}

QByteArray scenarioFile(const SolvedRun& run) {
    return QByteArray::fromStdString(remarksText(".", describe(run.report.choice)) +
                                     completeScenarioText(run.document));
}

QStringList runFileNames(const QStringList& plotFormats) {
    QStringList names{scenarioName, summaryName, historiesName, eventsName};
    for (const QString& format : plotFormats)
        names << QStringLiteral("blow.") + format << QStringLiteral("rock.") + format;
    return names;
}

QStringList runFilesThere(const QString& folder, const QStringList& plotFormats) {
    QStringList there;
    for (const QString& name : runFileNames(plotFormats)) {
        const QFileInfo info(QDir(folder).filePath(name));
        // A dangling link exists too, as something that would be written through.
        if (info.exists() || info.isSymLink()) there.append(name);
    }
    return there;
}

QString writeRunFolder(const QString& folder, const SolvedRun& run, const QStringList& plotFormats) {
    const QDir directory(folder);
    if (!directory.mkpath(QStringLiteral(".")))
        return tr("%1: the folder cannot be made; choose another one")
            .arg(QDir::toNativeSeparators(directory.path()));
    const QByteArray histories = historiesFile(run);
    const QByteArray events = eventsFile(run);
    const QByteArray scenario = scenarioFile(run);
    const QByteArray summary = reportJson(run.report, completeScenarioText(run.document));
    QFile::remove(directory.filePath(summaryName));
    QString problem = removeOldPlots(directory, plotFormats);
    if (problem.isEmpty()) problem = writeWholeFile(directory.filePath(scenarioName), scenario);
    if (problem.isEmpty()) problem = writeWholeFile(directory.filePath(historiesName), histories);
    if (problem.isEmpty()) problem = writeWholeFile(directory.filePath(eventsName), events);
    if (problem.isEmpty() && !plotFormats.isEmpty())
        writeBlowPlots(run.report.scenario, run.report.impact, folder, plotFormats, true, &problem);
    if (problem.isEmpty()) problem = writeWholeFile(directory.filePath(summaryName), summary);
    return problem;
}

}  // namespace drillwave
