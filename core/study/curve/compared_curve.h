// SPDX-License-Identifier: GPL-3.0-or-later
// An output along a parameter, with the curves to compare it with.
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

struct ComparedCurveQuestion {
    CurveQuestion curve;
    ReferenceScale reference = ReferenceScale::none;
    bool closedForm = false;  ///< where it holds
    bool operator==(const ComparedCurveQuestion&) const = default;

    /// Whether it cannot be followed: its curve is solved at CurveQuestion::along.count points.
    bool isSampled() const { return studyPlan(curve.base).curvePoints.has_value(); }
    /// Whether there is a reference: e along stiffness or β, for a family of γ or none.
    bool hasReference() const;
};

struct ComparedCurve {
    ComparedCurveQuestion question;
    CurveStudy curve;
    /// e along β for the same family; β is k over the k0 of the ReferenceScale.
    std::optional<CurveStudy> reference;
    std::optional<CurveStudy> closedForm;
};

/// Fixes a parameter that the study varies, so that scenarios which differ only there compare equal.
void takeOut(Scenario& scenario, const Parameter& parameter, double value);

/// Returns the reasons why a question cannot be studied; empty when it can.
std::vector<Message> problemsOf(const ComparedCurveQuestion& question);

/// Receives a growing curve as it is so far.
using ComparedCurvePreview = std::function<void(const ComparedCurve& soFar)>;

/// Returns the same question about the scenario of a pinned run: one line, for the run's own value of the
/// family, without levels and goal. Nothing if the run lacks the parameter or the output.
std::optional<CurveQuestion> questionOfRun(const CurveQuestion& question, const Scenario& run);

/// The curve is that of studyCurve(), or of sampleCurve() where it is sampled, bit for bit. Requires
/// problemsOf() to be empty.
ComparedCurve studyComparedCurve(const ComparedCurveQuestion& question, int jobs, std::stop_token stop = {},
                                 const CurveProgress& progress = {},
                                 const ComparedCurvePreview& preview = {});

}  // namespace drillwave
