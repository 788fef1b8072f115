// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of an identification: text, JSON, and the tables of its files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/figure.h"
#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_study.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// A question with its answer, and the text of the scenario.
struct IdentifyReport {
    IdentifyQuestion question;
    IdentifyFindings findings;
    std::string scenarioText;    ///< of FILE
    std::string identifiedText;  ///< with the rock as identified; that of FILE where nothing is known
};

/// Draws in posterior.csv.
inline constexpr std::size_t posteriorRows = 200;

/// Answer first, then what limits it and what was seen, at most 40 lines for one record.
std::string identifyText(const IdentifyReport& report, const ReadingStyle& style = plainStyle());
std::string identifyJson(const IdentifyReport& report);

/// `time [s]`, `incident [N]`, `measured [N]`, `model [N]`, `residual [N]`; of several records `record`
/// first.
std::string matchCsv(const IdentifyReport& report);
/// `time [s]`, `penetration [m]`, `force [N]`, `model_force [N]`; of several records `record` first.
std::string forcePenetrationCsv(const IdentifyReport& report);
/// Draws headed by keys with units, for `design --draws`; empty where there are none.
std::string posteriorCsv(const IdentifyReport& report);
/// A row for each record.
std::string recordsCsv(const IdentifyReport& report);
/// `time [us]`, `force [kN]` from the front to the end of the incident wave.
std::string incidentCsv(const IdentifyReport& report);

/// Returns the sentence of a remark by its code; `scenario` gives the names of its sections.
Message identifyRemark(std::string_view code, const RecordAnswer& answer, const Scenario& scenario,
                       const ReadingStyle& style);
/// Whether a remark stands among those that a reader sees; the others are said elsewhere.
bool isRemarkShown(std::string_view code);
/// First sentence about one record: whether the model holds and what is known.
Message identifySentence(const RecordAnswer& answer);
/// Whether a record agrees with the model, in a few words; the reason where it is refused.
Message recordVerdict(const RecordAnswer& answer);
/// Reason why a rejected record may be so, most likely first.
Message rejectionReason(const RecordAnswer& answer);

/// Returns a size in words, with its key if the reader writes commands: "diameter of bit head
/// (string.bit_head.diameter)"; other keys as they are.
Message sizeWords(const std::string& key, const Scenario& scenario, const ReadingStyle& style);
/// Returns a gap or a tolerance of a size in mm, or in the unit that the reader has for millimetres.
std::string shortLength(double si, int digits, const ReadingStyle& style);

/// A value of the answer in words: "rock when it is first loaded", "stiffness", "131.2 MN/m",
/// "127.1 MN/m … 135.4 MN/m", "known".
struct IdentifyRow {
    std::string key;  ///< of the parameter
    Message what, term;
    std::string value;
    std::string interval;  ///< 95 %; empty where there is none on both sides
    Message verdict;
};
/// Returns rows of a record and, of several records, of the next blow.
std::vector<IdentifyRow> identifyRows(const RecordAnswer& answer,
                                      const std::vector<NextBlowParameter>& nextBlow,
                                      const ReadingStyle& style);

/// A cause of the error of an answer.
struct IdentifyLimit {
    Message cause;
    std::string key;  ///< of --known, may be empty
    Message tolerance;
    double onStiffness = 0, onGamma = 0;  ///< relative, 95 %
    bool isAssumed = false;
};
/// Returns the largest causes, the largest first; none of a record that is refused or rejected.
std::vector<IdentifyLimit> identifyLimits(const RecordAnswer& answer, const Scenario& scenario,
                                          const ReadingStyle& style);
/// Returns the one measurement that would help most, in a sentence; empty where there is none.
Message identifyNext(const RecordAnswer& answer, const Scenario& scenario, const ReadingStyle& style);

/// A 95 % tolerance that is assumed where --known gives none.
struct AssumedTolerance {
    std::string key;
    Quantity quantity = Quantity::length;
    std::optional<double> tolerance;  ///< SI; nothing where it depends on the record
};
/// Returns those of the amplifier, the place of the gauges, and the sizes of gauge's section and of the
/// sections towards the bit.
std::vector<AssumedTolerance> assumedTolerances(const Scenario& scenario, const GaugePlace& place);

/// Returns a picture of a record that is not refused, one of the findings. Panels are one below the other:
/// waves over time, what the model leaves over, and force over penetration; of several records stiffness and
/// gamma along the list instead of the last. Times are those of the record, compression is positive.
StudyFigure identifyFigure(const IdentifyFindings& findings, const RecordAnswer& answer);

/// The rock in comments of a file: "identified from string.csv: 127.1 to 135.4 MN/m (95 %)" by key.
std::string identifiedComment(const IdentifyReport& report, const IdentifiedParameter& parameter);

}  // namespace drillwave
