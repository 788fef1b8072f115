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

/// Rock parameter expected in the next blow at the same place or hole, with its range (theory of
/// identification §9).
struct NextBlowParameter {
    std::string key;
    double value = 0, low = 0, high = 0;  ///< median and 95 % limits for the next blow, in SI units
    /// Scatter τ of the parameter between blows: standard deviation of its logarithm, or of a gap itself [m].
    /// 0 if no scatter is detected.
    double scatter = 0;
    bool hasChange = false;  ///< whether the records differ by more than their errors
};

/// Recommendation of the one measurement that would reduce the uncertainty of the identified rock most.
struct NextMeasurement {
    /// Name of the error to reduce: one of BudgetRow::source such as "diameter", or "noise".
    std::string source;
    std::string key;  ///< key of option --known that sets this tolerance; empty if there is none
    /// Tolerance that the measurement should reach, in `unit`; 0 if the source has none. For the largest
    /// source of error, it makes the effect as small as that of the second largest. It is at least about a
    /// fifth of the present tolerance.
    double tolerance = 0;
    std::string unit;
    std::string parameter;  ///< key of the parameter whose half-width decreases most
    /// 95 % half-width of `parameter` expected after the measurement, for its natural logarithm.
    double halfWidth = 0;
};

struct IdentifyFindings {
    std::vector<RecordAnswer> records;
    /// Rock parameters expected in the next blow at the same place. Empty with fewer than three usable
    /// records.
    std::vector<NextBlowParameter> nextBlow;
    /// Codes of warnings about all records together, such as "few_records".
    std::vector<std::string> remarks;
    bool isStopped = false;

    /// Returns the record that represents all: the first that is neither refused nor rejected. If there is
    /// none, it is the first not refused, otherwise the first.
    const RecordAnswer& main() const;
    /// Returns the number of records with which the model agrees: neither refused nor rejected.
    std::size_t agreeingCount() const;
    bool saysSomething() const;
};

/// Returns the problems of gauge positions and of option --known, found before anything is computed; empty if
/// there are none.
std::vector<Message> identifyProblems(const IdentifyQuestion& question);

/// Callback after each record, called with the results of all records so far; the last one is new.
using TellIdentified = std::function<void(const IdentifyFindings&)>;

/// Identifies the rock from all records and returns the results. They do not depend on the number of threads
/// `jobs` (≥ 1). `tell` is called on the calling thread after each record. `showFirst` receives preliminary
/// results from any thread (see identifyRecord()).
IdentifyFindings runIdentify(const IdentifyQuestion& question, int jobs = 1, const std::stop_token& stop = {},
                             const TellIdentified& tell = {}, const ShowAnswer& showFirst = {});

/// Returns the measurement that would reduce the uncertainty of stiffness and gamma most; empty if the model
/// is rejected.
std::optional<NextMeasurement> nextMeasurement(const RecordAnswer& answer);

/// Random samples of rock parameters for use as uncertain inputs; each row is a possible set of values. With
/// several records, the rows apply to the next blow.
struct PosteriorDraws {
    /// Keys of the sampled parameters, one for each column of `rows`. Only parameters with the verdict
    /// identified or uncertain are sampled.
    std::vector<std::string> keys;
    std::vector<std::vector<double>> rows;  ///< values in SI units, indexed [row][parameter]
};
/// Returns `count` random samples of the identified parameters, restricted so that every row is a valid rock
/// law. Empty if the model is rejected, or if neither stiffness nor gamma is bounded on both sides.
PosteriorDraws posteriorDraws(const IdentifyFindings& findings, std::size_t count, std::uint64_t seed);

/// Returns the scenario with the identified rock law, whose values are rounded to five digits.
Scenario identifiedScenario(const Scenario& scenario, const IdentifyFindings& findings);

/// Default 95 % tolerance of a size or of the gauge, used if option --known does not give one.
struct AssumedTolerance {
    std::string key;
    Quantity quantity = Quantity::length;
    std::optional<double> tolerance;  ///< default tolerance in SI units; empty if it depends on the record
};
/// Returns the default tolerances used by an identification. They are those of the amplifier, the gauge
/// positions, and the sizes of the sections from the gauge to the bit.
std::vector<AssumedTolerance> assumedTolerances(const Scenario& scenario, const GaugePlace& place);

}  // namespace drillwave
