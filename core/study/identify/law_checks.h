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

/// Rock law fitted to a record as a trial, with the errors of the fit.
struct LawCandidate {
    /// Name of the trial: the rock law "bilinear", "corner", "crater", "power" or "dashpot". Also the
    /// bilinear law with an overloaded amplifier ("overload") or a jump of the zero level ("jump").
    std::string name;
    std::shared_ptr<RecordModel> model;
    LawFit fit;
    FitErrors errors;
    double misfit() const { return errors.misfit.misfit; }
};

/// All rock laws fitted to one record, the bilinear law first, and the index of the one that is the result.
struct LawTrials {
    std::vector<LawCandidate> candidates;
    std::size_t answer = 0;
    /// Time of the fitted jump of the gauge's zero level, after the front [s]; empty if no jump was tried.
    std::optional<double> jumpTime;
    bool isLawOpen = false;  ///< whether another acceptable law lies outside the interval of the result
    /// Whether a power or dashpot law fits clearly better than the result: it leaves less than half of its
    /// misfit.
    bool isStrained = false;
    const LawCandidate& chosen() const { return candidates[answer]; }
};

/// Returns whether a model with this misfit is accepted. The rms residual must be at most 1.3 times that of
/// noise, or the misfit at most 1 % of the peak force.
bool isAccepted(const MisfitFound& misfit);

/// Fits the rock laws that LawChoice of the question requires, and returns the fits (theory of identification
/// C6). Calls `showFirst` as soon as the bilinear law is fitted. `known` is the result of fitFromStarts() for
/// the bilinear law and this record, or empty.
LawTrials tryLaws(const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, ModelFit known, const std::stop_token& stop,
                  const std::function<void(const LawTrials&)>& showFirst);

/// Returns whether a power law without a gap fits the record as well as the chosen law. The identified gap
/// may then be a curved start of the loading curve instead (theory of identification C10).
bool gapMayBeBend(const LawTrials& trials, const PreparedRecord& record, const IdentifyQuestion& question,
                  const std::vector<KnownSize>& sizes, const std::stop_token& stop);

/// Returns the 95 % half-width of an unknown, widened by the uncertainty about the right law. `own` is its
/// half-width in the fit chosen as the result. The interval also covers the value of every other acceptable
/// law, plus that law's half-width (limited to `own`).
double widthWithLaws(const LawTrials& trials, Unknown::Kind kind, double own);

}  // namespace drillwave
