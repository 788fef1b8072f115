// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of other rock laws and zero lines. A law that explains the record equally well widens the result or
// replaces it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/identify/fit_errors.h"

namespace drillwave {

/// Rock law that was tried, with its fit and the errors of the fit.
struct LawCandidate {
    /// Name of the law: "bilinear", "corner", "crater", "power", "dashpot", "overload" or "jump".
    std::string name;
    std::shared_ptr<RecordModel> model;
    LawFit fit;
    FitErrors errors;
    double misfit() const { return errors.misfit.misfit; }
};

/// All laws tried on a record, the bilinear law first, and which of them is the result.
struct LawTrials {
    std::vector<LawCandidate> candidates;
    std::size_t answer = 0;
    /// Time of a jump of the zero level, after the front [s]; empty if none was tried.
    std::optional<double> jumpTime;
    bool isLawOpen = false;  ///< whether another acceptable law lies outside the interval of the result
    /// Whether a power or dashpot law leaves less than half the misfit of the result.
    bool isStrained = false;
    const LawCandidate& chosen() const { return candidates[answer]; }
};

/// Returns whether a model with this misfit is accepted. It is if the residual is at most 1.3 times the
/// noise, or the misfit at most 1 % of the peak force.
bool isAccepted(const MisfitFound& misfit);

/// Returns the fits of all laws that the question's choice of law requires (theory of identification C6).
/// Calls `showFirst` as soon as the bilinear law is fitted. `known` is the result of fitFromStarts() for the
/// bilinear law and this record, or empty.
LawTrials tryLaws(const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, ModelFit known, const std::stop_token& stop,
                  const std::function<void(const LawTrials&)>& showFirst);

/// Returns whether a power law without a gap fits as well as the result. The identified gap may then be a
/// curved start of the loading curve instead (theory of identification C10).
bool gapMayBeBend(const LawTrials& trials, const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, const std::stop_token& stop);

/// Returns the 95 % half-width of an unknown, including all acceptable laws. It is at least the distance to
/// the value of each such law plus that law's half-width (limited to `own`). `own` is the half-width in the
/// fit chosen as the result.
double widthWithLaws(const LawTrials& trials, Unknown::Kind kind, double own);

}  // namespace drillwave
