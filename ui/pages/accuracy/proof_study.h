// SPDX-License-Identifier: GPL-3.0-or-later
// The studies of the page Accuracy, which a button runs: each of them takes seconds, and one measures time.
#pragma once

#include <memory>

#include "core/study/proof/accuracy.h"
#include "core/study/proof/stability.h"
#include "core/study/proof/string_accuracy.h"
#include "ui/job/study_job.h"

namespace drillwave {

enum class Proof { accuracy, stability };

/// A request for a study. A repeated one counts as new, so that run times are measured again.
struct ProofQuestion {
    Proof proof = Proof::accuracy;
    Scenario scenario;  ///< of the accuracy
    int run = 0;
    bool operator==(const ProofQuestion&) const = default;
};

/// The result so far of the study requested.
struct ProofAnswer {
    ProofQuestion question;
    std::shared_ptr<const Accuracy> accuracy;
    std::shared_ptr<const StringAccuracy> stringAccuracy;  ///< instead of `accuracy` for drill strings
    std::shared_ptr<const StabilityReport> stability;
};

/// Shows what there is now and then. Throws std::runtime_error where the scenario could not be solved.
ProofAnswer prove(const ProofQuestion& question, const StudyFeed<ProofAnswer>& feed);

}  // namespace drillwave
