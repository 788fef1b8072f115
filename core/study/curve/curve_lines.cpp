// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_lines.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/numeric/ordered_work.h"
#include "core/study/curve/curve_cells.h"
#include "core/study/curve/curve_features.h"
#include "core/study/curve/curve_points.h"
#include "core/study/curve/goal_search.h"

namespace drillwave {

namespace {

/// Points that one thread solves at once.
constexpr std::size_t pointsOfBlock = 32;

/// Makes the lines of a question, pass by pass.
class Study {
  public:
    Study(const CurveQuestion& question, int jobs, std::stop_token stop, const CurveProgress& progress)
        : m_question(question),
          m_axes(question.axes()),
          m_jobs(jobs),
          m_stop(std::move(stop)),
          m_progress(progress) {
        const std::size_t count = question.family ? question.family->count : 1;
        for (std::size_t line = 0; line < count; ++line) {
            CurveLine& made = m_lines.emplace_back();
            if (question.family) made.family = question.family->value(line);
            made.range = question.range();
            made.outputs.resize(question.columns.size());
        }
        m_points.resize(count);
        m_solved.resize(count);
    }

    CurveStudy run() {
        CurveStudy study{.question = m_question, .lines = {}};
        study.stopped = !(fitCells() && fillGrids());
        study.solves = m_solves;
        study.effort = m_effort;
        if (study.stopped) return study;
        for (std::size_t line = 0; line < m_lines.size(); ++line) finish(line);
        const GoalWork work = seekGoals(m_question, m_lines, m_jobs, m_stop);
        study.stopped = work.stopped;
        study.solves += work.solves;
        study.effort += work.effort;
        if (!study.stopped) study.lines = std::move(m_lines);
        return study;
    }

  private:
    /// How much of the work the first pass is taken for.
    static constexpr double shareOfFits = 0.9;

    void tell(double before, double after, std::size_t done, std::size_t of) const {
        if (m_progress)
            m_progress(before + (after - before) * static_cast<double>(done) / static_cast<double>(of));
    }

    bool fitCells() {
        const std::size_t cells = cellCount(m_question);
        const std::size_t count = m_lines.size() * cells;
        std::size_t next = 0, done = 0;
        const auto fill = [&](CellTask& task) {
            const std::size_t cell = next % cells;
            task.line = next / cells;
            task.start = static_cast<double>(cell) / static_cast<double>(cells);
            task.end = static_cast<double>(cell + 1) / static_cast<double>(cells);
            return next++ < count;
        };
        const auto deliver = [&](CellTask& task) {
            addCell(m_lines[task.line], m_question, task);
            m_solves += task.solves;
            m_effort += task.effort;
            tell(0, shareOfFits, ++done, count);
            return true;
        };
        const auto makeWorker = [&] { return CellFitter(m_question, m_axes); };
        return processInOrder<CellTask>(m_jobs, m_stop, fill, makeWorker, deliver) == WorkEnd::finished;
    }

    bool fillGrids() {
        std::vector<PointTask> tasks;
        for (std::size_t line = 0; line < m_lines.size(); ++line) {
            m_points[line] = pointsOf(m_lines[line]);
            const std::vector<double> open = openPointsOf(m_lines[line], m_points[line]);
            for (std::size_t i = 0; i < open.size(); i += pointsOfBlock) {
                PointTask& task = tasks.emplace_back();
                task.line = line;
                const std::size_t end = std::min(i + pointsOfBlock, open.size());
                task.shares.assign(open.begin() + static_cast<std::ptrdiff_t>(i),
                                   open.begin() + static_cast<std::ptrdiff_t>(end));
            }
        }
        std::size_t next = 0, done = 0;
        const auto fill = [&](PointTask& task) {
            if (next == tasks.size()) return false;
            task = std::move(tasks[next++]);
            return true;
        };
        const auto deliver = [&](PointTask& task) {
            std::ranges::move(task.points, std::back_inserter(m_solved[task.line]));
            m_solves += task.solves;
            m_effort += task.effort;
            tell(shareOfFits, 1, ++done, tasks.size());
            return true;
        };
        const auto makeWorker = [&] { return PointSolver(m_question, m_axes); };
        return processInOrder<PointTask>(m_jobs, m_stop, fill, makeWorker, deliver) == WorkEnd::finished;
    }

    void finish(std::size_t number) {
        CurveLine& line = m_lines[number];
        for (std::size_t i = 0; i < line.outputs.size(); ++i) {
            fillPieces(line, i, m_points[number], m_solved[number]);
            CurveOutput& output = line.outputs[i];
            std::ranges::sort(output.unsolved, {}, &CurveStretch::start);
            output.features = featuresOf(output.pieces, line.range, m_question.levels);
        }
        for (const double share : m_points[number]) line.points.push_back(line.range.at(share));
        addExtremePlaces(line);
        for (std::size_t i = 0; i < line.outputs.size(); ++i) {
            std::vector<double>& values = line.values.emplace_back();
            for (const double x : line.points)
                values.push_back(line.value(x, i).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    }

    /// Points of the line are also where its outputs are least and largest, so that nothing that is drawn or
    /// written shows another extreme.
    static void addExtremePlaces(CurveLine& line) {
        for (const CurveOutput& output : line.outputs)
            for (const CurveFeature& feature : output.features)
                if (feature.kind == CurveFeature::Kind::minimum ||
                    feature.kind == CurveFeature::Kind::maximum)
                    line.points.push_back(feature.x.value);
        std::ranges::sort(line.points);
        line.points.erase(std::ranges::unique(line.points).begin(), line.points.end());
    }

    const CurveQuestion& m_question;
    const std::vector<SweepAxis> m_axes;
    int m_jobs;
    std::stop_token m_stop;
    const CurveProgress& m_progress;
    std::vector<CurveLine> m_lines;
    std::vector<std::vector<double>> m_points;     // of each line, as shares
    std::vector<std::vector<LinePoint>> m_solved;  // of each line, ascending
    std::uint64_t m_solves = 0;
    long m_effort = 0;
};

}  // namespace

CurveStudy followLines(const CurveQuestion& question, int jobs, std::stop_token stop,
                       const CurveProgress& progress) {
    return Study(question, jobs, std::move(stop), progress).run();
}

}  // namespace drillwave
