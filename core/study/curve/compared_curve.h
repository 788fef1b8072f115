// SPDX-License-Identifier: GPL-3.0-or-later
// An output along a parameter, with the curves to compare it with.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "core/study/curve/sampled_curve.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {

/// Choice of the stiffness k0 for the reference curve. This curve shows the coefficient of restitution e of a
/// rod that arrives without waves. Its e depends only on γ and on k/k0, where k is the stiffness of the rock.
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

    /// Returns whether the curve is solved only at CurveQuestion::along.count points. This is the case for
    /// scenarios to which no continuous curve can be fitted, such as drill strings.
    bool isSampled() const { return studyPlan(curve.base).curvePoints.has_value(); }
    /// Returns whether a reference curve (rod without waves) is possible. The first output must be e, the
    /// varied parameter must be the rock stiffness or β, and the family γ or absent.
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

/// Sets the parameter that is varied in a study to a fixed `value` in a scenario. Scenarios that differ only
/// in this parameter then compare equal, so that their curve is computed once. Does nothing if the hammer
/// force depends on the parameter.
void takeOut(Scenario& scenario, const Parameter& parameter, double value);

/// Returns the reasons why the curve cannot be computed, one message each; empty if it can.
std::vector<Message> problemsOf(const ComparedCurveQuestion& question);

/// Callback that receives an incomplete curve, to be drawn until the study is finished. It has the points
/// solved so far.
using ComparedCurvePreview = std::function<void(const ComparedCurve& soFar)>;

/// Returns the question for the same curve of another scenario, `run`, that the user has kept for comparison.
/// It has one line, without family, levels and goal. Returns nullopt if the curve is not possible for the
/// run, for example because the parameter does not apply.
std::optional<CurveQuestion> questionOfRun(const CurveQuestion& question, const Scenario& run);

/// Returns the requested curve and, if requested, the reference curve and the closed form to compare it with.
/// The curve is bit for bit the result of studyCurve() or, if isSampled(), of sampleCurve(). With
/// sampleCurve() there are no other curves. If problemsOf() is not empty, the curve has no lines;
/// CurveStudy::refusal contains the reason.
ComparedCurve studyComparedCurve(const ComparedCurveQuestion& question, int jobs, std::stop_token stop = {},
                                 const CurveProgress& progress = {},
                                 const ComparedCurvePreview& preview = {});

}  // namespace drillwave
