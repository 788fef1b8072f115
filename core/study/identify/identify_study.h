// SPDX-License-Identifier: GPL-3.0-or-later
// Identification of the rock from one or several records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/study/identify/gauge_place.h"
#include "core/study/identify/identify_answer.h"
#include "core/study/identify/identify_question.h"
#include "core/study/identify/identify_record.h"
#include "core/text/units.h"

namespace drillwave {

/// Range of a rock parameter expected in the next blow at the same place or hole (theory of identification
/// §9).
struct NextBlowParameter {
    std::string key;
    double value = 0, low = 0, high = 0;  ///< median and 95 % limits for the next blow, in SI units
    /// Scatter τ between blows: standard deviation of the logarithm, for a gap in metres; 0 if none is
    /// detected.
    double scatter = 0;
    bool hasChange = false;  ///< whether the records differ by more than their errors
};

/// Recommendation of the one measurement that would reduce the uncertainty most.
struct NextMeasurement {
    /// Source of the error to reduce: a source of BudgetRow, "noise" or "unexplained_wave".
    std::string source;
    std::string key;  ///< key of option --known that sets this tolerance; empty if there is none
    /// Tolerance to reach, in `unit`; 0 if the source has none. The tolerance of the largest source makes it
    /// equal to the second; no tolerance is below a fifth of the present one.
    double tolerance = 0;
    std::string unit;
    std::string parameter;  ///< key of the parameter whose half-width decreases most
    /// Half-width of that parameter after the measurement: of the logarithm, for a gap in metres.
    double halfWidth = 0;
};

struct IdentifyFindings {
    std::vector<RecordAnswer> records;
    /// Parameters expected in the next blow, from several records that are not rejected; empty otherwise.
    std::vector<NextBlowParameter> nextBlow;
    /// Codes of warnings about all records together, such as "few_records".
    std::vector<std::string> remarks;
    bool isStopped = false;

    /// Returns the first record that is neither refused nor rejected. If there is none, returns the first
    /// that is not refused, otherwise the first.
    const RecordAnswer& main() const;
    /// Returns the number of records with which the model agrees: neither refused nor rejected.
    std::size_t agreeingCount() const;
    bool saysSomething() const;
};

/// Returns the problems of gauge positions and tolerances, found before anything is computed; empty if there
/// are none.
std::vector<Message> identifyProblems(const IdentifyQuestion& question);

/// Callback with the records identified so far, of which the last one is new.
using TellIdentified = std::function<void(const IdentifyFindings&)>;

/// Returns the results of all records. They do not depend on the number of threads `jobs` (≥ 1). `tell` is
/// called on the calling thread after each record. `showFirst` receives preliminary results from any thread
/// (see identifyRecord()).
IdentifyFindings runIdentify(const IdentifyQuestion& question, int jobs = 1, const std::stop_token& stop = {},
                             const TellIdentified& tell = {}, const ShowAnswer& showFirst = {});

/// Returns the measurement that would reduce the uncertainty of stiffness and gamma most; empty if the model
/// is rejected.
std::optional<NextMeasurement> nextMeasurement(const RecordAnswer& answer);

/// Random samples of rock parameters; each row is a possible set of values. With several records, the rows
/// are for the next blow.
struct PosteriorDraws {
    /// Keys of the parameters, all identified or uncertain; one column each.
    std::vector<std::string> keys;
    std::vector<std::vector<double>> rows;  ///< values in SI units, indexed [row][parameter]
};
/// Returns `count` random samples of the identified parameters, restricted so that every row is a valid rock
/// law. Empty if the model is rejected, or if neither stiffness nor gamma is bounded on both sides.
PosteriorDraws posteriorDraws(const IdentifyFindings& findings, std::size_t count, std::uint64_t seed);

/// Returns the scenario with the identified rock law, whose values are rounded to five digits.
Scenario identifiedScenario(const Scenario& scenario, const IdentifyFindings& findings);

/// Default 95 % tolerance, used if --known does not give one.
struct AssumedTolerance {
    std::string key;
    Quantity quantity = Quantity::length;
    std::optional<double> tolerance;  ///< default tolerance in SI units; empty if it depends on the record
};
/// Returns the default tolerances of the amplifier, the gauge positions, and the sizes of the gauge's section
/// and of the sections towards the bit.
std::vector<AssumedTolerance> assumedTolerances(const Scenario& scenario, const GaugePlace& place);

}  // namespace drillwave
