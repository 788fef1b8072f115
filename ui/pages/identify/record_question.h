// SPDX-License-Identifier: GPL-3.0-or-later
// Question of the page Identify about records, and its answer, computed outside the window's thread.
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

/// Input of an identification of the rock: files with records of strain gauges, the gauges, and known
/// tolerances.
struct RecordQuestion {
    Scenario scenario;  ///< scenario without the parts that do not affect the answer
    QStringList paths;  ///< paths of the files, in their order along the hole
    /// Number of times that the user has opened files. It distinguishes questions about the same files,
    /// because their contents may have changed.
    int opened = 0;
    SignalOptions settings;  ///< settings for reading the tables
    std::vector<GaugeChoice> gauges;
    LawChoice law = LawChoice::automatic;
    DispersionChoice dispersion = DispersionChoice::fit;
    /// Whether the rock is a specimen between two equal long bars. If false, the rock has a rigid support.
    bool barBehind = false;
    /// Whether every blow in a record is evaluated as a record of its own.
    bool allBlows = false;
    std::vector<KnownTolerance> known;
    bool operator==(const RecordQuestion&) const = default;
};

/// Answer of an identification of the rock, with the question (records and settings) that it belongs to.
struct IdentifiedRecord {
    RecordQuestion question;
    IdentifyReport report;
    bool isPartial = false;  ///< whether records or rock laws remain to be computed
};
using IdentifiedRecordPtr = std::shared_ptr<const IdentifiedRecord>;

/// Returns the scenario without the parts that do not affect the identification: drill data, and the rock
/// unless `law` is LawChoice::file.
Scenario scenarioForRecord(Scenario scenario, LawChoice law);

/// Returns a sentence that says which input is missing; empty if the question is complete.
QString missingIn(const RecordQuestion& question);

/// Returns the file names as used in answers: without folders, unless two names would be equal.
QStringList recordNames(const QStringList& paths);

/// Returns the rock identified from the records. Throws std::runtime_error with a sentence if a record cannot
/// be read or a tolerance is invalid.
IdentifiedRecordPtr identifiedRecord(const RecordQuestion& question,
                                     const StudyFeed<IdentifiedRecordPtr>& feed);

/// Returns the arguments of the command line that gives the same answer: "identify", then its options,
/// without the scenario file.
QStringList identifyWords(const RecordQuestion& question);

}  // namespace drillwave
