// SPDX-License-Identifier: GPL-3.0-or-later
// Question of the page Identify about records, and its answer, computed away from the window's thread.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/report/identify_report.h"
#include "core/signal/signal_reading.h"
#include "core/study/identify/gauge_reading.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Records in files, where their gauges are, and what is known about both.
struct RecordQuestion {
    Scenario scenario;       ///< without what does not matter
    QStringList paths;       ///< in their order along the hole
    int opened = 0;          ///< how often files were opened: they may be others by now
    SignalOptions settings;  ///< by which the tables are read
    std::vector<GaugeChoice> gauges;
    LawChoice law = LawChoice::automatic;
    DispersionChoice dispersion = DispersionChoice::fit;
    bool barBehind = false;
    bool allBlows = false;
    std::vector<KnownTolerance> known;
    bool operator==(const RecordQuestion&) const = default;
};

/// An answer with the question that it answers.
struct IdentifiedRecord {
    RecordQuestion question;
    IdentifyReport report;
    bool isPartial = false;  ///< records or laws are still to come
};
using IdentifiedRecordPtr = std::shared_ptr<const IdentifiedRecord>;

/// Takes out of a scenario what does not matter to the answer.
Scenario scenarioForRecord(Scenario scenario, LawChoice law);

/// Returns what the user still has to give, in a sentence; empty where the question can be asked.
QString missingIn(const RecordQuestion& question);

/// Names of the files as answers have them: without folders, unless two would be called the same.
QStringList recordNames(const QStringList& paths);

/// Reads the records and identifies the rock. Throws std::runtime_error with a sentence where a record cannot
/// be read or a tolerance is wrong.
IdentifiedRecordPtr identifiedRecord(const RecordQuestion& question,
                                     const StudyFeed<IdentifiedRecordPtr>& feed);

/// The words of the command that gives the same answer, from its name on, without FILE.
QStringList identifyWords(const RecordQuestion& question);

}  // namespace drillwave
