// SPDX-License-Identifier: GPL-3.0-or-later
// Identification of the rock from one record or several.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/study/identify/identify_answer.h"
#include "core/study/identify/identify_question.h"
#include "core/study/identify/identify_record.h"

namespace drillwave {

/// A parameter of the next blow in the same place or hole (theory of identification §9).
struct NextBlowParameter {
    std::string key;
    double value = 0, low = 0, high = 0;  ///< median and 95 % of the next blow, SI
    double scatter = 0;      ///< τ between blows, of the logarithm, of a gap [m]; 0 where none is seen
    bool hasChange = false;  ///< the records differ by more than their errors
};

/// One measurement that would help most.
struct NextMeasurement {
    std::string source;    ///< row of the budget, "noise", "unexplained_wave"
    std::string key;       ///< of --known, may be empty
    double tolerance = 0;  ///< that takes the row below the next one; 0 where there is no tolerance
    std::string unit;
    std::string parameter;  ///< whose half-width falls
    double halfWidth = 0;   ///< to which it falls
};

struct IdentifyFindings {
    std::vector<RecordAnswer> records;
    std::vector<NextBlowParameter> nextBlow;  ///< of several records that are not rejected
    std::vector<std::string> remarks;         ///< of all together: "few_records"
    bool isStopped = false;

    /// The first record that is not refused; the first one where all are.
    const RecordAnswer& main() const;
    bool saysSomething() const;
};

/// Returns problems of places and tolerances, before anything is computed; empty where there are none.
std::vector<Message> identifyProblems(const IdentifyQuestion& question);

/// Called with the records that are identified so far, the last one being new.
using TellIdentified = std::function<void(const IdentifyFindings&)>;

/// Identifies every record. The answer does not depend on `jobs` ≥ 1. `tell` is called on the calling thread;
/// `showFirst` gets a first answer of each record, from any thread, see identifyRecord().
IdentifyFindings runIdentify(const IdentifyQuestion& question, int jobs = 1, const std::stop_token& stop = {},
                             const TellIdentified& tell = {}, const ShowAnswer& showFirst = {});

/// The measurement that would help most; nothing where the model is rejected.
std::optional<NextMeasurement> nextMeasurement(const RecordAnswer& answer);

/// Rows of values that belong together, of the next blow where there are several records.
struct PosteriorDraws {
    std::vector<std::string> keys;          ///< of parameters that are identified or uncertain
    std::vector<std::vector<double>> rows;  ///< SI
};
/// Draws of the answer, cut so that every row is a valid law; empty where the model is rejected or neither
/// stiffness nor gamma is known on both sides.
PosteriorDraws posteriorDraws(const IdentifyFindings& findings, std::size_t count, std::uint64_t seed);

/// The scenario with the rock as identified.
Scenario identifiedScenario(const Scenario& scenario, const IdentifyFindings& findings);

}  // namespace drillwave
