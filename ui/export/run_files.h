// SPDX-License-Identifier: GPL-3.0-or-later
// The files of one blow: what `drillwave run -o` and the window's export write, in one place.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <stop_token>
#include <string>

#include "core/blow/blow.h"
#include "core/study/rows/output_column.h"
#include "ui/export/whole_folder.h"

namespace drillwave {

/// A blow with what its files say beside it.
struct SolvedRun {
    Blow blow;                 ///< solved with Detail::histories
    std::string scenarioText;  ///< gives its scenario again (completeScenarioText())
    OutputUnits units = OutputUnits::dimensionless;
};

/// Those in which the files of a run are written where nothing else is asked for: SI where the scenario has
/// units.
OutputUnits customaryUnits(const Scenario& scenario);

/// The lines at the top of every CSV file: the whole scenario and how it was solved.
QByteArray runHeader(const SolvedRun& run);

/// histories.csv: the header with the whole scenario, then the curves.
QByteArray historiesFile(const SolvedRun& run);

/// events.csv, likewise.
QByteArray eventsFile(const SolvedRun& run);

/// scenario.yaml: the scenario that was solved, complete in itself, behind who solved it and how.
QByteArray scenarioFile(const SolvedRun& run);

/// The names of the files of a run with plots in these formats.
QStringList runFileNames(const QStringList& plotFormats);

/// Those of runFileNames() that are in the folder already.
QStringList runFilesThere(const QString& folder, const QStringList& plotFormats);

/// Writes the files of a run into a folder, whole or not at all (writeWholeFolder()); plots need a
/// QApplication. Plots that an earlier run left there in formats not asked for would show another blow and
/// are removed. A folder with a summary.json is complete. The same run gives the same bytes wherever it is
/// written from, but for `run_time` in summary.json and the creation date in PDF.
FolderEnd writeRunFolder(const QString& folder, const SolvedRun& run, const QStringList& plotFormats,
                         ExistingFiles existing, const std::stop_token& stop = {});

}  // namespace drillwave
