// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the page Design: its question, and the answer while it gets better.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/report/design_report.h"
#include "ui/document/document.h"
#include "ui/job/study_job.h"

namespace drillwave {

/// Samples of an answer which is there while the hand still moves.
inline constexpr std::uint64_t quickSamples = 256;

/// A study, and the seconds that it may take; without them it takes what it needs.
struct DesignQuestion {
    DesignStudy study;
    std::optional<double> seconds = {};
    bool operator==(const DesignQuestion&) const = default;
};

/// The answer so far.
struct DesignAnswer {
    DesignReport report;                     ///< of as many samples as its study has
    std::uint64_t wanted = 0;                ///< samples of the last answer
    std::vector<Message> problems;           ///< why nothing can be solved: then there is nothing else
    std::optional<double> secondsLeft = {};  ///< expected for the rest, where the seconds were over before
    bool isRefined() const { return report.study.samples == wanted; }
    /// Whether there are designs to be shown, and one of them to be taken.
    bool hasBest() const { return report.findings.best.robust.has_value(); }
};

/// Quick answers first; where the seconds are over, the last of them is the answer. The text of the scenario
/// is left empty.
DesignAnswer answerDesign(const DesignQuestion& question, const StudyFeed<DesignAnswer>& feed);

/// Returns the uncertain inputs of a worst case; those of draws are a row of them.
std::vector<ParameterValue> worstInputs(const DesignStudy& study, const WorstCase& worst);

}  // namespace drillwave
