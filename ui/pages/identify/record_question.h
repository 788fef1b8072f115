// SPDX-License-Identifier: GPL-3.0-or-later
// Question of the page Identify about a record, and its answer, computed away from the window's thread.
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

/// A record in a file, where its gauges are, and what is known about both.
struct RecordQuestion {
    Scenario scenario;  ///< without what does not matter
    QString path;
    SignalOptions settings;  ///< by which the table is read
    std::vector<GaugeChoice> gauges;
    LawChoice law = LawChoice::automatic;
    DispersionChoice dispersion = DispersionChoice::fit;
    bool barBehind = false;
    std::vector<KnownTolerance> known;
    bool operator==(const RecordQuestion&) const = default;
};

/// An answer with the question that it answers.
struct IdentifiedRecord {
    RecordQuestion question;
    IdentifyReport report;
};
using IdentifiedRecordPtr = std::shared_ptr<const IdentifiedRecord>;

/// Takes out of a scenario what does not matter to the answer.
Scenario scenarioForRecord(Scenario scenario, LawChoice law);

/// Returns what the user still has to give, in a sentence; empty where the question can be asked.
QString missingIn(const RecordQuestion& question);

/// Reads the record and identifies the rock. Throws std::runtime_error with a sentence where the record
/// cannot be read or a tolerance is wrong.
IdentifiedRecordPtr identifiedRecord(const RecordQuestion& question,
                                     const StudyFeed<IdentifiedRecordPtr>& feed);

/// The words of the command that gives the same answer, from its name on, without FILE.
QStringList identifyWords(const RecordQuestion& question);

}  // namespace drillwave
