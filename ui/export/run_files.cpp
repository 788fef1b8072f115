// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/run_files.h"

#include <QDir>
#include <QFile>
#include <algorithm>
#include <iterator>

#include "core/report/blow_csv.h"
#include "core/report/result_remarks.h"
#include "ui/export/blow_report.h"
#include "ui/export/plot_export.h"
#include "ui/plot/plot_rendering.h"

namespace drillwave {
namespace {

const QString scenarioName = QStringLiteral("scenario.yaml");
const QString summaryName = QStringLiteral("summary.json");
const QString historiesName = QStringLiteral("histories.csv");
const QString eventsName = QStringLiteral("events.csv");

// Files of these names that are no run's may be there too: those are left alone.
bool holdsRun(const QDir& folder) {
    QFile file(folder.filePath(historiesName));
    return file.open(QIODevice::ReadOnly) && file.readLine(64).startsWith("# # Written by Drillwave ");
}

// With other formats the plots of an earlier run would stay beside the new numbers.
QStringList plotsOfEarlierRun(const QDir& folder) {
    return holdsRun(folder) ? runFilesThere(folder.path(), plotFormats()) : QStringList();
}

}  // namespace

OutputUnits customaryUnits(const Scenario& scenario) {
    return scenario.form == ScenarioForm::dimensional ? OutputUnits::si : OutputUnits::dimensionless;
}

QByteArray runHeader(const SolvedRun& run) {
    return QByteArray::fromStdString(scenarioHeader(run.scenarioText, describe(run.blow.method)));
}

QByteArray historiesFile(const SolvedRun& run) {
    const Blow& blow = run.blow;
    return QByteArray::fromStdString(
        scenarioHeader(run.scenarioText, describe(blow.method), historyColumns(run.units)) +
        historiesCsv(blow.impact, blow.solved, run.units, blow.scales));
}

QByteArray eventsFile(const SolvedRun& run) {
    return runHeader(run) + QByteArray::fromStdString(eventsCsv(run.blow.impact, run.units, run.blow.scales));
}

QByteArray scenarioFile(const SolvedRun& run) {
    return QByteArray::fromStdString(remarksText(".", describe(run.blow.method)) + run.scenarioText);
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

FolderEnd writeRunFolder(const QString& folder, const SolvedRun& run, const QStringList& plotFormats,
                         ExistingFiles existing, const std::stop_token& stop) {
    FolderFiles contents;
    contents.outdated = plotsOfEarlierRun;
    contents.files = {{scenarioName, scenarioFile(run)},
                      {historiesName, historiesFile(run)},
                      {eventsName, eventsFile(run)}};
    if (!plotFormats.isEmpty()) {
        BlowPictures pictures = drawBlowPlots(run.blow.scenario, run.blow.impact, plotFormats, stop);
        if (stop.stop_requested()) return {FolderEnd::Kind::stopped, {}};
        if (!pictures.problem.isEmpty()) return {FolderEnd::Kind::failed, pictures.problem};
        std::ranges::move(pictures.files, std::back_inserter(contents.files));
    }
    contents.files.push_back({summaryName, reportJson(run.blow, run.scenarioText)});
    return writeWholeFolder(folder, contents, existing, stop);
}

}  // namespace drillwave
