// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <span>
#include <utility>

#include "core/study/curve/curve_lines.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// The piece that has an answer at a share of the way, or nullptr.
const FitPiece* solvedPieceAt(std::span<const FitPiece> pieces, double share) {
    auto after = std::ranges::upper_bound(pieces, share, {}, &FitPiece::start);
    if (after == pieces.begin()) return nullptr;
    --after;
    // where two meet, the one that has an answer
    if (!after->solved && after != pieces.begin() && std::prev(after)->end == share) --after;
    return after->solved ? &*after : nullptr;
}

}  // namespace

CurveRange CurveQuestion::range() const {
    return {.start = along.start,
            .stop = along.stop,
            .spacing = along.kind == SweepAxis::Kind::logarithmic ? CurveRange::Spacing::logarithmic
                                                                  : CurveRange::Spacing::linear};
}

std::vector<SweepAxis> CurveQuestion::axes() const {
    std::vector<SweepAxis> all;
    if (family) all.push_back(*family);
    all.push_back(along);
    return all;
}

Scenario CurveQuestion::firstScenario() const {
    const std::vector<SweepAxis> all = axes();
    std::vector<double> values;
    for (const SweepAxis& axis : all) values.push_back(axis.value(0));
    return AxisScenario(base, all).set(values);
}

std::vector<Message> problemsOf(const CurveQuestion& question) {
    if (Message problem = followProblem(question.along); !problem.isEmpty()) return {std::move(problem)};
    std::vector<Message> problems = problemsOf(
        Sweep{.base = question.base, .axes = question.axes(), .columns = question.columns, .shard = {}});
    for (const OutputColumn& column : question.columns)
        if (column.output->needsThrustStudy())
            problems.emplace_back(
                translatable(
                    "%1 takes a study of all gaps at every point; `drillwave thrust --along` has it"),
                std::vector<Message>{std::string(column.output->name)});
    if (Message problem = familyProblem(question); !problem.isEmpty()) problems.push_back(std::move(problem));
    if (Message problem = goalProblem(question); !problem.isEmpty()) problems.push_back(std::move(problem));
    return problems;
}

Message goalProblem(const CurveQuestion& question) {
    if (!question.goal || question.columns.size() == 1) return {};
    return translatable("a goal is a value of one output; choose one output");
}

Message familyProblem(const CurveQuestion& question) {
    if (!question.family || question.family->count <= maximumCurveLines) return {};
    return {translatable("a family has at most %1 lines, this one %2"),
            {std::to_string(maximumCurveLines), std::to_string(question.family->count)}};
}

bool CurveStudy::isReached() const {
    return !stopped && refusal.isEmpty() && std::ranges::all_of(lines, [](const CurveLine& line) {
        return !line.goal || line.goal->isReached();
    });
}

const CurveFeature* CurveOutput::extreme(CurveFeature::Kind kind) const {
    const auto found = std::ranges::find_if(
        features, [kind](const CurveFeature& feature) { return feature.ofAll && feature.kind == kind; });
    return found == features.end() ? nullptr : &*found;
}

std::optional<double> CurveLine::value(double x, std::size_t output) const {
    const double share = range.shareOf(x);
    const FitPiece* piece = solvedPieceAt(outputs[output].pieces, share);
    return piece ? std::optional(piece->outputs.front()(share)) : std::nullopt;
}

std::optional<double> CurveLine::error(double x, std::size_t output) const {
    const FitPiece* piece = solvedPieceAt(outputs[output].pieces, range.shareOf(x));
    return piece ? std::optional(piece->error.front()) : std::nullopt;
}

CurveStudy studyCurve(const CurveQuestion& question, int jobs, std::stop_token stop,
                      const CurveProgress& progress) {
    if (Message refusal = inOneLine(problemsOf(question)); !refusal.isEmpty())
        return {.question = question, .lines = {}, .refusal = std::move(refusal)};
    return followLines(question, jobs, std::move(stop), progress);
}

bool CurveStudy::isComplete() const {
    return !stopped && refusal.isEmpty() && std::ranges::all_of(lines, [](const CurveLine& line) {
        return std::ranges::all_of(line.outputs,
                                   [](const CurveOutput& output) { return output.unsolved.empty(); });
    });
}

}  // namespace drillwave
