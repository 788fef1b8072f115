// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/sampled_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/numeric/ordered_work.h"
#include "core/study/curve/goal_search.h"
#include "core/study/rows/axis_scenario.h"
#include "core/study/rows/case_solver.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Distance of the points in the first lines shown; that of each further one is half as large.
constexpr std::size_t coarsest = 8;
/// Share of the size below which values do not differ.
constexpr double sameShare = 1e-9;

struct SampleTask {
    std::size_t line = 0, point = 0, stride = 0;
    std::vector<double> values = {};  // of the columns
    Message reason = {};
};

/// Samples of one line.
struct Samples {
    std::vector<std::vector<double>> values;  // of each point, empty before it is solved
    std::vector<Message> reasons;             // of each point; empty if it has a result
};

/// Solves points; one object per thread.
class PointSampler {
  public:
    PointSampler(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question),
          m_axes(axes),
          m_scenario(question.base, axes),
          m_solver(question.columns, question.method, question.workLimit) {}

    void operator()(SampleTask& task, const std::stop_token& stop) {
        std::vector<double> at;
        if (m_question.family) at.push_back(m_question.family->value(task.line));
        at.push_back(m_question.along.value(task.point));
        const Scenario& scenario = m_scenario.set(at);
        task.values.assign(m_question.columns.size(), std::numeric_limits<double>::quiet_NaN());
        task.reason = m_scenario.obstacle() ? m_scenario.obstacle()->reason : Message();
        if (!task.reason.isEmpty()) return;
        m_solver.setPulse(scenario);
        task.reason = m_solver.solve(scenario, task.values, stop);
    }

  private:
    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
    AxisScenario m_scenario;
    CaseSolver m_solver;
};

/// The points in the order in which they are solved.
std::vector<SampleTask> tasksOf(std::size_t lines, std::size_t points) {
    std::vector<SampleTask> tasks;
    for (std::size_t stride = coarsest; stride > 0; stride /= 2)
        for (std::size_t line = 0; line < lines; ++line)
            for (std::size_t point = 0; point < points; ++point) {
                const bool isLast = point + 1 == points;  // with the coarsest, so that the range is whole
                const std::size_t own =
                    isLast ? coarsest : std::min(coarsest, point == 0 ? coarsest : point & ~(point - 1));
                if (own == stride) tasks.push_back({.line = line, .point = point, .stride = stride});
            }
    return tasks;
}

FitPiece straightPiece(double from, double to, double a, double b) {
    FitPiece piece;
    piece.start = from;
    piece.end = to;
    piece.resolved = false;
    piece.solved = std::isfinite(a) && std::isfinite(b);
    if (!piece.solved) return piece;
    const double ends[] = {a, b};
    piece.outputs.emplace_back(from, to, ends);
    piece.error.push_back(std::abs(b - a));
    return piece;
}

/// The least and the largest value, as well as points tell.
void addExtremes(CurveOutput& output, const std::vector<double>& points, const std::vector<double>& values) {
    std::size_t least = values.size(), largest = values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        if (least == values.size() || values[i] < values[least]) least = i;
        if (largest == values.size() || values[i] > values[largest]) largest = i;
    }
    if (least == values.size()) return;
    const bool isSame = values[largest] - values[least] <= sameShare * std::abs(values[largest]);
    const auto add = [&](CurveFeature::Kind kind, std::size_t at) {
        const bool isEnd = at == 0 || at + 1 == values.size();
        const double before = points[at == 0 ? 0 : at - 1];
        const double after = points[std::min(at + 1, points.size() - 1)];
        output.features.push_back({.kind = kind,
                                   .shape = isSame  ? CurveFeature::Shape::everywhere
                                            : isEnd ? CurveFeature::Shape::end
                                                    : CurveFeature::Shape::grid,
                                   .ofAll = true,
                                   .x = {points[at], (after - before) / 2},
                                   .value = {values[at], 0}});
    };
    add(CurveFeature::Kind::minimum, least);
    add(CurveFeature::Kind::maximum, largest);
    std::ranges::stable_sort(output.features, {}, [](const CurveFeature& each) { return each.x.value; });
}

CurveLine lineThrough(const CurveQuestion& question, std::size_t number, const Samples& samples) {
    CurveLine line;
    if (question.family) line.family = question.family->value(number);
    line.range = question.range();
    line.outputs.resize(question.columns.size());
    line.values.resize(question.columns.size());
    std::vector<const Message*> reasons;
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        if (samples.values[i].empty()) continue;
        line.points.push_back(question.along.value(i));
        reasons.push_back(&samples.reasons[i]);
        for (std::size_t c = 0; c < line.values.size(); ++c) line.values[c].push_back(samples.values[i][c]);
    }
    for (std::size_t c = 0; c < line.outputs.size(); ++c) {
        CurveOutput& output = line.outputs[c];
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            output.pieces.push_back(straightPiece(line.range.shareOf(line.points[i]),
                                                  line.range.shareOf(line.points[i + 1]), line.values[c][i],
                                                  line.values[c][i + 1]));
            if (!output.pieces.back().solved)
                output.unsolved.push_back({line.points[i], line.points[i + 1],
                                           *(reasons[i]->isEmpty() ? reasons[i + 1] : reasons[i])});
        }
        output.grid = {{question.along.start, question.along.stop, translatable("solved point by point")}};
        addExtremes(output, line.points, line.values[c]);
    }
    return line;
}

CurveStudy studyOf(const CurveQuestion& question, const std::vector<Samples>& samples, std::uint64_t solves) {
    CurveStudy study{.question = question, .lines = {}, .solves = solves};
    for (std::size_t line = 0; line < samples.size(); ++line)
        study.lines.push_back(lineThrough(question, line, samples[line]));
    return study;
}

}  // namespace

std::vector<Message> sampledProblemsOf(const CurveQuestion& question) {
    const SweepAxis& along = question.along;
    const bool isRange = along.kind == SweepAxis::Kind::linear || along.kind == SweepAxis::Kind::logarithmic;
    if (!isRange || !(along.start < along.stop) || along.count < 2) return {mustRise(along)};
    std::vector<Message> problems = problemsOf(
        Sweep{.base = question.base, .axes = question.axes(), .columns = question.columns, .shard = {}});
    if (Message problem = familyProblem(question); !problem.isEmpty()) problems.push_back(std::move(problem));
    if (Message problem = goalProblem(question); !problem.isEmpty()) problems.push_back(std::move(problem));
    return problems;
}

CurveStudy sampleCurve(const CurveQuestion& question, int jobs, std::stop_token stop,
                       const SampledProgress& progress) {
    if (Message refusal = inOneLine(sampledProblemsOf(question)); !refusal.isEmpty())
        return {.question = question, .lines = {}, .refusal = std::move(refusal)};
    const std::vector<SweepAxis> axes = question.axes();
    std::vector<Samples> samples(question.family ? question.family->count : 1);
    for (Samples& each : samples) {
        each.values.resize(question.along.count);
        each.reasons.resize(question.along.count);
    }
    std::vector<SampleTask> tasks = tasksOf(samples.size(), question.along.count);
    std::size_t next = 0, done = 0;
    const auto fill = [&](SampleTask& task) {
        if (next == tasks.size()) return false;
        task = tasks[next++];
        return true;
    };
    const auto deliver = [&](SampleTask& task) {
        samples[task.line].values[task.point] = std::move(task.values);
        samples[task.line].reasons[task.point] = std::move(task.reason);
        ++done;
        if (progress.tell) progress.tell(done, tasks.size());
        const bool endsStride = done < tasks.size() && tasks[done].stride != task.stride;
        if (progress.show && endsStride) progress.show(studyOf(question, samples, done));
        return true;
    };
    const auto makeWorker = [&] { return PointSampler(question, axes); };
    const WorkEnd end = processInOrder<SampleTask>(jobs, stop, fill, makeWorker, deliver);
    CurveStudy study{.question = question, .lines = {}, .solves = done, .stopped = true};
    if (end != WorkEnd::finished) return study;
    study = studyOf(question, samples, done);
    const GoalWork work = seekGoals(question, study.lines, jobs, std::move(stop));
    study.solves += work.solves;
    study.stopped = work.stopped;
    if (work.stopped) study.lines.clear();
    return study;
}

}  // namespace drillwave
