// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/compared_curve.h"

#include <utility>

#include "core/model/assignments.h"
#include "core/model/scales.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {
namespace {

/// The curve itself is most of the work.
constexpr double shareOfCurve = 0.8;

SweepAxis inGroups(SweepAxis axis, std::string_view group, double unit) {
    axis.parameter = findParameter(group);
    axis.unit = &unitsOf(Quantity::ratio).front();
    axis.start /= unit;
    axis.stop /= unit;
    for (double& value : axis.list) value /= unit;
    return axis;
}

/// Takes only the groups, on which alone e depends.
CurveQuestion referenceOf(const ComparedCurveQuestion& question) {
    CurveQuestion reference = question.curve;
    const Groups groups = groupsOf(question.curve.base);
    reference.base = {};
    reference.base.form = ScenarioForm::dimensionless;
    reference.base.groups = groups;
    reference.base.pulse.shape = PulseShape::rigidBody;
    // e depends on k/(Z/2T) and γ alone: with τ = 1/2 that is β.
    if (question.reference == ReferenceScale::byTransit) reference.base.groups.tau = 0.5;
    const bool isStiffness = question.curve.along.key() == "bit_rock.stiffness";
    reference.along =
        inGroups(question.curve.along, "beta", isStiffness ? scalesOf(question.curve.base).stiffness : 1);
    if (reference.family) reference.family = inGroups(*reference.family, "gamma", 1);
    for (OutputColumn& column : reference.columns) column.units = OutputUnits::dimensionless;
    reference.levels.clear();
    reference.goal.reset();
    reference.method = {};
    return reference;
}

CurveQuestion closedFormOf(const CurveQuestion& question) {
    CurveQuestion closed = question;
    closed.method.method = Method::closedForm;
    closed.levels.clear();
    closed.goal.reset();
    return closed;
}

ComparedCurve sampleComparedCurve(const ComparedCurveQuestion& question, int jobs, std::stop_token stop,
                                  const CurveProgress& progress, const ComparedCurvePreview& preview) {
    const auto studyOf = [&](CurveStudy curve) { return ComparedCurve{question, std::move(curve), {}, {}}; };
    SampledProgress told;
    if (progress) told.tell = [&](std::size_t done, std::size_t of) { progress(double(done) / double(of)); };
    if (preview) told.show = [&](CurveStudy soFar) { preview(studyOf(std::move(soFar))); };
    return studyOf(sampleCurve(question.curve, jobs, std::move(stop), told));
}

bool isGamma(const SweepAxis& axis) {
    return axis.key() == "gamma" || axis.key() == "bit_rock.gamma";
}

}  // namespace

bool ComparedCurveQuestion::hasReference() const {
    const std::string_view along = curve.along.key();
    return (along == "beta" || along == "bit_rock.stiffness") && (!curve.family || isGamma(*curve.family)) &&
           curve.columns.front().output->name == "cor";
}

void takeOut(Scenario& scenario, const Parameter& parameter, double value) {
    // A blow that depends on it would stay another one.
    if (!Assignments({parameter.key}).movePulse()) parameter.assign(scenario, value);
}

std::vector<Message> problemsOf(const ComparedCurveQuestion& question) {
    return question.isSampled() ? sampledProblemsOf(question.curve) : problemsOf(question.curve);
}

std::optional<CurveQuestion> questionOfRun(const CurveQuestion& asked, const Scenario& run) {
    const bool isSi = asked.columns.front().units == OutputUnits::si;
    if (isSi && run.form == ScenarioForm::dimensionless) return std::nullopt;
    if (!asked.along.parameter->applies(run)) return std::nullopt;
    CurveQuestion question = asked;
    question.base = run;
    question.base.title.clear();
    question.family.reset();
    question.levels.clear();  // nothing is marked on it
    question.goal.reset();
    takeOut(question.base, *question.along.parameter, question.along.start);
    const std::optional<std::uint64_t> points = studyPlan(run).curvePoints;
    if (points && !studyPlan(asked.base).curvePoints) question.along.count = *points;
    return problemsOf(ComparedCurveQuestion{question}).empty() ? std::optional(question) : std::nullopt;
}

ComparedCurve studyComparedCurve(const ComparedCurveQuestion& question, int jobs, std::stop_token stop,
                                 const CurveProgress& progress, const ComparedCurvePreview& preview) {
    if (question.isSampled()) return sampleComparedCurve(question, jobs, std::move(stop), progress, preview);
    const auto part = [&](double before, double share) {
        return [&progress, before, share](double done) {
            if (progress) progress(before + share * done);
        };
    };
    ComparedCurve study{.question = question,
                        .curve = studyCurve(question.curve, jobs, stop, part(0, shareOfCurve)),
                        .reference = {},
                        .closedForm = {}};
    constexpr double shareOfRest = (1 - shareOfCurve) / 2;
    if (question.reference != ReferenceScale::none && question.hasReference())
        if (const CurveQuestion asked = referenceOf(question); problemsOf(asked).empty())
            study.reference = studyCurve(asked, jobs, stop, part(shareOfCurve, shareOfRest));
    if (question.closedForm && question.curve.base.pulse.shape == PulseShape::rectangular)
        study.closedForm = studyCurve(closedFormOf(question.curve), jobs, stop,
                                      part(shareOfCurve + shareOfRest, shareOfRest));
    return study;
}

}  // namespace drillwave
