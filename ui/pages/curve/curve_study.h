// SPDX-License-Identifier: GPL-3.0-or-later
// Study of the page Curve: an output along a parameter, and the curves to compare it with.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/study/curve/sampled_curve.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {

/// The rod that arrives without waves, whose rebound depends on stiffness and γ alone: over which stiffness
/// it is drawn.
enum class ReferenceScale {
    none,       ///< not at all
    byTransit,  ///< in k0 = Z/(2T), as in the paper's figures
    byPulse,    ///< in k0 = Z/t0, as everything else
};

struct CurvePageQuestion {
    CurveQuestion curve;
    ReferenceScale reference = ReferenceScale::none;
    bool closedForm = false;  ///< where it holds
    bool operator==(const CurvePageQuestion&) const = default;

    /// Whether it cannot be followed: its curve is solved at CurveQuestion::along.count points.
    bool isSampled() const { return studyPlan(curve.base).curvePoints.has_value(); }
    /// Whether there is a reference: e along stiffness or β, for a family of γ or none.
    bool hasReference() const;
};

struct CurvePageStudy {
    CurvePageQuestion question;
    CurveStudy curve;
    /// e along β for the same family; β is k over the k0 of the ReferenceScale.
    std::optional<CurveStudy> reference;
    std::optional<CurveStudy> closedForm;
};

/// Fixes a parameter that the study varies, so that scenarios which differ only there compare equal.
void takeOut(Scenario& scenario, const Parameter& parameter, double value);

/// Returns the reasons why a question cannot be studied; empty when it can.
std::vector<Message> problemsOf(const CurvePageQuestion& question);

/// Receives a growing curve as it is so far.
using CurvePagePreview = std::function<void(const CurvePageStudy& soFar)>;

/// The curve is that of studyCurve(), or of sampleCurve() where it is sampled, bit for bit. Requires
/// problemsOf() to be empty.
CurvePageStudy studyCurvePage(const CurvePageQuestion& question, int jobs, std::stop_token stop = {},
                              const CurveProgress& progress = {}, const CurvePagePreview& preview = {});

}  // namespace drillwave
