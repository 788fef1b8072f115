// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the page Design: its question, and its answer, which is refined in stages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/report/design_report.h"
#include "ui/document/document.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Number of samples of a quick answer, which is computed while the user still changes the input.
inline constexpr std::uint64_t quickSamples = 256;

/// Design study with the time that it may take [s]; unlimited if `seconds` is empty.
struct DesignQuestion {
    DesignStudy study;
    std::optional<double> seconds = {};
    bool operator==(const DesignQuestion&) const = default;
};

/// Answer of a design study as far as it is computed.
struct DesignAnswer {
    DesignReport report;            ///< results with the number of samples computed so far
    std::uint64_t wanted = 0;       ///< number of samples of the final answer
    std::vector<Message> problems;  ///< errors of the question; if not empty, there is no result
    /// Estimated time of the remaining stages [s], if the time limit was reached; otherwise empty.
    std::optional<double> secondsLeft = {};
    /// Returns whether the answer was computed with the full number of samples.
    bool isRefined() const { return report.study.samples == wanted; }
    /// Returns whether the answer contains a best design.
    bool hasBest() const { return report.findings.best.robust.has_value(); }
};

/// Returns the answer of a design study. It first computes and shows answers with fewer samples, and stops
/// refining when the time limit is reached. The scenario text of the report is empty.
DesignAnswer answerDesign(const DesignQuestion& question, const StudyFeed<DesignAnswer>& feed);

/// Returns the values of the uncertain inputs in a worst case. Inputs given as draws (rows of values that
/// belong together) have the values of one row.
std::vector<ParameterValue> worstInputs(const DesignStudy& study, const WorstCase& worst);

}  // namespace drillwave
