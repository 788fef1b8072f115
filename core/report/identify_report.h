// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of an identification: text, JSON, and the tables of its output files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/figure.h"
#include "core/study/identify/identify_study.h"
#include "core/text/handy_text.h"
#include "core/text/json.h"

namespace drillwave {

/// Question and result of an identification, with scenario texts.
struct IdentifyReport {
    IdentifyQuestion question;
    IdentifyFindings findings;
    std::string scenarioText;  ///< text of the scenario file given
    /// Scenario file with the identified rock; equal to `scenarioText` if nothing was identified.
    std::string identifiedText;
};

/// Number of random samples of the rock parameters in posterior.csv.
inline constexpr std::size_t posteriorRows = 200;

/// Returns the report as text, at most 40 lines for one record. The identified rock comes first, then the
/// sources of error, the agreement of the waves, and warnings.
std::string identifyText(const IdentifyReport& report, const ReadingStyle& style = plainStyle());
std::string identifyJson(const IdentifyReport& report);

/// Returns the measured and computed waves over time as CSV, with the columns `time [s]`, `incident [N]`,
/// `measured [N]`, `model [N]`, `residual [N]`. With several records, `record` is the first column.
std::string matchCsv(const IdentifyReport& report);
/// Returns the rock response as CSV with the columns `time [s]`, `penetration [m]`, `force [N]`, `model_force
/// [N]`. With several records, `record` is the first column.
std::string forcePenetrationCsv(const IdentifyReport& report);
/// Returns random samples of the identified parameters as CSV, with keys and units as headings. `design
/// --draws` reads them as uncertain inputs. Empty if there are none.
std::string posteriorCsv(const IdentifyReport& report);
/// Returns the identified values as CSV, with one row for each record.
std::string recordsCsv(const IdentifyReport& report);
/// Returns the incident wave of the main record (IdentifyFindings::main()) as CSV, from the first rise of the
/// wave to its end. The columns are `time [us]` and `force [kN]`.
std::string incidentCsv(const IdentifyReport& report);

/// Returns the sentence for the code of a warning about a record. `scenario` provides the names of its
/// sections.
Message identifyRemark(std::string_view code, const RecordAnswer& answer, const Scenario& scenario,
                       const ReadingStyle& style);
/// Returns whether reports list the warning with this code. They omit three warnings whose content is already
/// in other parts of the report.
bool isRemarkShown(std::string_view code);
/// Returns the warnings that a report lists: those of one record, then those of all records together.
std::vector<Message> identifyRemarks(const IdentifyReport& report, const RecordAnswer& answer,
                                     const ReadingStyle& style);
/// Returns the first sentence about a record: whether the model agrees with it, and which rock parameters it
/// determines.
Message identifySentence(const RecordAnswer& answer);
/// Returns a sentence about several records. It says with how many of them the model agrees, and which
/// stiffness the rock will have at the next blow (95 % interval). Empty for a single record.
Message recordsSentence(const IdentifyFindings& findings, const ReadingStyle& style);
/// Returns the name of a record: its file, followed by the number of the blow (from 1) if `hasBlows`, as for
/// files with several blows.
std::string recordName(const RecordAnswer& answer, bool hasBlows);
/// Returns the name of a rock law or disturbance that was tried to explain a record (TriedLaw::law), such as
/// "power law".
Message lawWords(std::string_view law);
/// Returns in a few words whether a record agrees with the model, or why it was refused.
Message recordVerdict(const RecordAnswer& answer);
/// Returns the most likely reason why the model disagrees with a rejected record.
Message rejectionReason(const RecordAnswer& answer);

/// Returns the name of a dimension of a section, such as its diameter. If the reader uses commands, its key
/// follows: "diameter of bit head (string.bit_head.diameter)". If `key` is not a parameter, it is returned
/// unchanged.
Message sizeWords(const std::string& key, const Scenario& scenario, const ReadingStyle& style);
/// Returns a short length such as a gap as text, in mm or in the unit that the reader chose for such lengths.
/// `si` is in m.
std::string shortLength(double si, int digits, const ReadingStyle& style);

/// Row of a table of identified values, for example "rock when it is first loaded", "stiffness", "131.2
/// MN/m", "127.1 MN/m … 135.4 MN/m", "known".
struct IdentifyRow {
    std::string key;  ///< key of the parameter
    Message what, term;
    std::string value;
    std::string interval;  ///< 95 % interval; empty if it is not bounded on both sides
    Message verdict;
};
/// Returns the rows of a table of identified values: first the values of one record. If there are several
/// records, the values expected at the next blow follow.
std::vector<IdentifyRow> identifyRows(const RecordAnswer& answer,
                                      const std::vector<NextBlowParameter>& nextBlow,
                                      const ReadingStyle& style);

/// Source of error that limits the accuracy of the identified rock parameters.
struct IdentifyLimit {
    Message cause;
    std::string key;  ///< key of option --known that sets this tolerance; empty if there is none
    Message tolerance;
    /// Relative half-width of the 95 % interval of stiffness or gamma that this source of error causes. Empty
    /// if the record does not determine the parameter.
    std::optional<double> onStiffness, onGamma;
    bool isAssumed = false;
};
/// Returns at most six sources of error, the largest first; empty for a record that is refused or rejected.
std::vector<IdentifyLimit> identifyLimits(const RecordAnswer& answer, const Scenario& scenario,
                                          const ReadingStyle& style);
/// Returns the relative error IdentifyLimit::onStiffness or onGamma as text: a percentage, "over 100 %", or
/// "-" if it is empty.
Message limitWords(std::optional<double> effect, const ReadingStyle& style);
/// Returns a sentence that recommends the measurement that would best reduce the error of the identified
/// rock; empty if none is known.
Message identifyNext(const RecordAnswer& answer, const Scenario& scenario, const ReadingStyle& style);

/// Returns the figure of one record of `findings` that is not refused. Panels from top to bottom: measured
/// and computed waves over time, residual of the model, force over penetration. With several records, two
/// panels with stiffness and gamma of all records replace the last one. Times are those of the record;
/// compression is positive.
StudyFigure identifyFigure(const IdentifyFindings& findings, const RecordAnswer& answer);

}  // namespace drillwave
