// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of an identification: text, JSON, and the tables of its files.
#pragma once

#include <string>
#include <string_view>

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

/// Sentence of a remark by its code.
Message identifyRemark(std::string_view code, const RecordAnswer& answer, const ReadingStyle& style);
/// First sentence about one record: whether the model holds and what is known.
Message identifySentence(const RecordAnswer& answer);
/// Reason why a rejected record may be so, most likely first.
Message rejectionReason(const RecordAnswer& answer);

/// The rock in comments of a file: "identified from string.csv: 127.1 to 135.4 MN/m (95 %)" by key.
std::string identifiedComment(const IdentifyReport& report, const IdentifiedParameter& parameter);

}  // namespace drillwave
