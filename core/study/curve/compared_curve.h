// SPDX-License-Identifier: GPL-3.0-or-later
// An output along a parameter, with the curves to compare it with.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/study/curve/sampled_curve.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {

/// Reference stiffness k0 of the reference curve. This curve shows the coefficient of restitution e of a rod
/// that arrives without waves. Its e depends only on γ and k/k0, with the stiffness k.
enum class ReferenceScale {
    none,       ///< no reference curve
    byTransit,  ///< k0 = Z/(2T), as in the paper's figures
    byPulse,    ///< k0 = Z/t0, as for the other curves
};

struct ComparedCurveQuestion {
    CurveQuestion curve;
    ReferenceScale reference = ReferenceScale::none;
    /// Whether to compute the curve by the closed form, too; only possible for a rectangular hammer force.
    bool closedForm = false;
    bool operator==(const ComparedCurveQuestion&) const = default;

    /// Returns whether the curve is solved only at CurveQuestion::along.count points, because it cannot be
    /// followed continuously.
    bool isSampled() const { return studyPlan(curve.base).curvePoints.has_value(); }
    /// Returns whether a reference curve (rod without waves) is possible. The first output must be e, the
    /// parameter stiffness or β, and the family γ or none.
    bool hasReference() const;
};

struct ComparedCurve {
    ComparedCurveQuestion question;
    CurveStudy curve;
    /// Reference curve: e of a rod without waves over β = k/k0, with the k0 of ReferenceScale. It has the
    /// same family as `curve`; empty if not requested or not possible.
    std::optional<CurveStudy> reference;
    std::optional<CurveStudy> closedForm;
};

/// Sets the varied parameter of a study to a fixed `value` in a scenario. Scenarios that differ only in this
/// parameter then compare equal and share one curve. Does nothing if the hammer force depends on the
/// parameter.
void takeOut(Scenario& scenario, const Parameter& parameter, double value);

/// Returns the reasons why a question cannot be studied, one message each; empty if it can.
std::vector<Message> problemsOf(const ComparedCurveQuestion& question);

/// Callback that receives an incomplete curve with the points solved so far.
using ComparedCurvePreview = std::function<void(const ComparedCurve& soFar)>;

/// Returns `question` for the scenario of a pinned run (a run kept for comparison): one curve, without
/// family, levels and goal. Returns nullopt if the run lacks the parameter, the units or the output.
std::optional<CurveQuestion> questionOfRun(const CurveQuestion& question, const Scenario& run);

/// Returns the requested curve and, if requested, the reference curve and the closed form to compare it with.
/// The curve is bit for bit the result of studyCurve(), or of sampleCurve() if isSampled(). In the latter
/// case there are no other curves. Requires problemsOf() to be empty.
ComparedCurve studyComparedCurve(const ComparedCurveQuestion& question, int jobs, std::stop_token stop = {},
                                 const CurveProgress& progress = {},
                                 const ComparedCurvePreview& preview = {});

}  // namespace drillwave
