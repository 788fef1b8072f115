// SPDX-License-Identifier: GPL-3.0-or-later
// Other laws and other zero lines that explain a record as well: they widen the answer or replace it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/identify/fit_errors.h"

namespace drillwave {

/// One law with its fit and errors.
struct LawCandidate {
    std::string name;  ///< "bilinear", "corner", "crater", "power", "dashpot", "overload", "jump"
    std::shared_ptr<RecordModel> model;
    LawFit fit;
    FitErrors errors;
    double misfit() const { return errors.misfit.misfit; }
};

/// Everything that a record was tried with, the bilinear law first.
struct LawTrials {
    std::vector<LawCandidate> candidates;
    std::size_t answer = 0;
    std::optional<double> jumpTime;  ///< after the front [s]
    bool isLawOpen = false;          ///< another law lies outside of the interval of the answer
    bool isStrained = false;         ///< power or dashpot leaves less than half of what the answer leaves
    const LawCandidate& chosen() const { return candidates[answer]; }
};

/// Whether a model with this misfit is accepted.
bool isAccepted(const MisfitFound& misfit);

/// Tries what the choice of the law asks for (theory of identification C6); shows the bilinear law when it is
/// fitted.
LawTrials tryLaws(const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, const std::stop_token& stop,
                  const std::function<void(const LawTrials&)>& showFirst);

/// Whether a power law without gap leaves as little as the answer (C10).
bool gapMayBeBend(const LawTrials& trials, const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, const std::stop_token& stop);

/// Half-width of an unknown of the answer with all laws that count: at least the distance to each of them and
/// their own half-width, this at most that of the answer.
double widthWithLaws(const LawTrials& trials, Unknown::Kind kind, double own);

}  // namespace drillwave
