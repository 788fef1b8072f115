// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/goal_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/numeric/brent.h"
#include "core/numeric/ordered_work.h"
#include "core/study/curve/curve_cells.h"
#include "core/study/curve/curve_features.h"
#include "core/study/curve/curve_sampler.h"
#include "core/study/curve/goal_brackets.h"

namespace drillwave {

namespace {

using GoalKind = GoalPlace::Kind;

constexpr double lastDigitsOfShare = 4 * std::numeric_limits<double>::epsilon();
/// A blow confirms a place of the curve within so many of its errors.
constexpr double confirmed = 4;
/// A jump is enclosed to such a share of the way.
constexpr double jumpWidth = 1e-12;
/// Places further off than so many of their errors tell a slope.
constexpr double tellsSlope = 100;

/// Closes a bracket in by solving blows.
class Closing {
  public:
    /// `size` is what accuracies are relative to.
    Closing(CurveSampler& sampler, double goal, double size)
        : m_sampler(sampler), m_goal(goal), m_size(size) {}

    /// Whether both ends have an answer, on different sides.
    bool begin(const GoalBracket& bracket) {
        const FitSample from = take(bracket.from), to = take(bracket.to);
        if (!from.solved || !to.solved || missOf(from) * missOf(to) >= 0) return false;
        m_left = from;
        m_right = to;
        return true;
    }

    /// False where a blow on the way has no answer.
    bool run() {
        const double from = missOf(m_left), to = missOf(m_right);
        const bool isRising = from < 0;
        bool isSolved = true;
        const auto miss = [&](double share) {
            const FitSample sample = take(share);
            isSolved &= sample.solved;
            if (!isSolved) return 0.0;  // ends the search
            const double own = missOf(sample);
            ((own < 0) == isRising ? m_left : m_right) = sample;
            const bool isFound = std::abs(own) <= goalAccuracy * m_size || width() <= jumpWidth;
            return isFound ? 0.0 : own;
        };
        if (width() > jumpWidth && std::abs(missOf(best())) > goalAccuracy * m_size)
            brentRoot(miss, m_left.x, from, m_right.x, to);
        return isSolved;
    }

    bool isJump() const { return std::abs(missOf(best())) > 100 * goalAccuracy * m_size; }
    const FitSample& left() const { return m_left; }
    const FitSample& right() const { return m_right; }
    const FitSample& best() const {
        return std::abs(missOf(m_left)) < std::abs(missOf(m_right)) ? m_left : m_right;
    }
    double width() const { return std::abs(m_right.x - m_left.x); }

    /// How far the place may be off where best() is: by what its value is off, over the slope around it.
    double placeError() const {
        const FitSample& found = best();
        const double off = std::abs(missOf(found)) + found.error;
        double error = width();
        double nearest = std::numeric_limits<double>::infinity();
        for (const FitSample& sample : m_samples) {
            const double rise = std::abs(sample.values[0] - found.values[0]);
            const double way = std::abs(sample.x - found.x);
            if (!(rise > tellsSlope * off) || way >= nearest) continue;
            nearest = way;
            error = off * way / rise;
        }
        return error + lastDigitsOfShare;
    }

  private:
    FitSample take(double share) {
        FitSample sample = m_sampler(share, 0);
        if (sample.solved) m_samples.push_back(sample);
        return sample;
    }
    double missOf(const FitSample& sample) const { return sample.values[0] - m_goal; }

    CurveSampler& m_sampler;
    double m_goal;
    double m_size;
    FitSample m_left, m_right;
    std::vector<FitSample> m_samples;
};

/// Makes places of brackets.
class PlaceFinder {
  public:
    /// `size` is that of the goal and of what the line rises, the larger one.
    PlaceFinder(const CurveQuestion& question, const CurveRange& range, double size)
        : m_goal(*question.goal),
          m_size(size),
          m_range(range),
          m_isRough(!whyRough(*question.columns.front().output).isEmpty()),
          m_isWhole(question.along.parameter->rules.wholeNumber) {}

    /// In SI.
    Estimate placeOf(const Estimate& share) const {
        const double x = m_range.at(share.value);
        return {m_isWhole ? std::round(x) : x, share.error * m_range.slopeAt(x)};
    }

    /// Returns the place from the curve only, without solving.
    GoalPlace unsolved(const GoalBracket& bracket) const {
        GoalPlace place{.rising = bracket.after > bracket.before};
        if (!bracket.isPassed()) {
            place.kind = bracket.before != 0 && bracket.after != 0 ? GoalKind::touch
                         : bracket.before == bracket.after         ? GoalKind::everywhere
                                                                   : GoalKind::end;
            place.value = {m_goal, bracket.margin};
        } else if (bracket.isOpen) {
            return betweenPoints(bracket);
        } else {
            place.value = {m_goal, bracket.margin};
        }
        place.x = placeOf(bracket.share);
        return place;
    }

    GoalPlace solved(const GoalBracket& bracket, CurveSampler& sampler) const {
        GoalPlace place = unsolved(bracket);
        if (m_isWhole || (place.kind == GoalKind::between && m_isRough)) return place;
        const FitSample there = sampler(bracket.share.value, 0);
        const double miss = std::abs(there.values[0] - m_goal);
        const bool isConfirmed = there.solved && miss <= confirmed * bracket.margin + there.error;
        if (isConfirmed || !bracket.isPassed()) {
            if (there.solved) place.value = {there.values[0], there.error};
            if (miss > bracket.margin && isConfirmed) place.x.error *= miss / bracket.margin;
            return place;
        }
        return closedIn(bracket, sampler, place);
    }

  private:
    GoalPlace closedIn(const GoalBracket& bracket, CurveSampler& sampler, GoalPlace place) const {
        Closing closing(sampler, m_goal, m_size);
        if (!closing.begin(bracket) || !closing.run()) {
            place = betweenPoints(bracket);
            if (!bracket.isOpen) place.kind = GoalKind::jump;  // as the curve has it
            return place;
        }
        if (closing.isJump()) {
            place.kind = GoalKind::jump;
            place.x = placeOf(
                {closing.left().x / 2 + closing.right().x / 2, closing.width() / 2 + lastDigitsOfShare});
            place.value = {closing.left().values[0], closing.left().error};
            place.valueAfter = closing.right().values[0];
            return place;
        }
        place.kind = GoalKind::crossing;
        place.x = placeOf({closing.best().x, closing.placeError()});
        place.value = {closing.best().values[0], closing.best().error};
        place.valueAfter = 0;
        return place;
    }

    /// Returns a place between two points; for whole numbers a jump, since there are none between.
    GoalPlace betweenPoints(const GoalBracket& bracket) const {
        const double share = std::clamp(bracket.share.value, bracket.from, bracket.to);
        const double x = m_range.at(share);
        const double error = std::max(share - bracket.from, bracket.to - share) * m_range.slopeAt(x);
        return {.kind = m_isWhole ? GoalKind::jump : GoalKind::between,
                .x = {x, error},
                .value = {bracket.valueFrom, bracket.margin},
                .valueAfter = bracket.valueTo,
                .rising = bracket.after > bracket.before};
    }

    double m_goal;
    double m_size;
    const CurveRange& m_range;
    bool m_isRough;
    bool m_isWhole;
};

struct GoalTask {
    std::size_t line = 0;
    GoalBracket bracket = {};
    GoalPlace place = {};
    std::uint64_t solves = 0;
    long effort = 0;
};

double sizeOf(std::span<const MonotoneSegment> segments, double goal) {
    double least = segments.front().first, largest = least;
    for (const MonotoneSegment& segment : segments) {
        least = std::min(least, segment.lower());
        largest = std::max(largest, segment.upper());
    }
    return std::max(std::abs(goal), largest - least);
}

/// Search on all lines.
class Search {
  public:
    Search(const CurveQuestion& question, std::vector<CurveLine>& lines)
        : m_question(question), m_axes(question.axes()), m_lines(lines), m_sizes(lines.size(), 1.0) {
        for (std::size_t line = 0; line < lines.size(); ++line) answerByCurve(line);
    }

    GoalWork run(int jobs, std::stop_token stop) {
        GoalWork work;
        std::size_t next = 0;
        std::vector<std::size_t> placed(m_lines.size());
        const auto fill = [&](GoalTask& task) {
            if (next == m_tasks.size()) return false;
            task = m_tasks[next++];
            return true;
        };
        const auto deliver = [&](GoalTask& task) {
            m_lines[task.line].goal->places[placed[task.line]++] = task.place;
            work.solves += task.solves;
            work.effort += task.effort;
            return true;
        };
        const auto makeWorker = [this] {
            return [this](GoalTask& task, const std::stop_token& ending) { solve(task, ending); };
        };
        work.stopped =
            processInOrder<GoalTask>(jobs, std::move(stop), fill, makeWorker, deliver) != WorkEnd::finished;
        for (CurveLine& line : m_lines)
            if (line.goal->isReached()) line.goal->nearest.reset();
        return work;
    }

  private:
    /// By its output, and notes what is to be solved for.
    void answerByCurve(std::size_t number) {
        CurveLine& line = m_lines[number];
        const CurveOutput& output = line.outputs.front();
        GoalAnswer& answer = line.goal.emplace();
        answer.isComplete = output.grid.empty() && output.unsolved.empty();
        const std::vector<FitPiece> pieces = limitSliverErrors(output.pieces);
        const std::vector<MonotoneSegment> segments = segmentsOf(pieces, 0);
        if (segments.empty()) return;
        m_sizes[number] = sizeOf(segments, *m_question.goal);
        const PlaceFinder finder(m_question, line.range, m_sizes[number]);
        for (const GoalBracket& bracket : goalBrackets(segments, *m_question.goal)) {
            answer.places.push_back(finder.unsolved(bracket));
            if (answer.places.size() <= mostSoughtPlaces)
                m_tasks.push_back({.line = number, .bracket = bracket});
        }
        const NearestValue nearest = nearestTo(segments, *m_question.goal);
        answer.nearest = {finder.placeOf(nearest.share), nearest.value};
    }

    void solve(GoalTask& task, const std::stop_token& stop) const {
        CurveSampler sampler(m_question, m_axes, task.line, stop);
        const PlaceFinder finder(m_question, m_lines[task.line].range, m_sizes[task.line]);
        task.place = finder.solved(task.bracket, sampler);
        task.solves = sampler.solves();
        task.effort = sampler.effort();
    }

    const CurveQuestion& m_question;
    const std::vector<SweepAxis> m_axes;
    std::vector<CurveLine>& m_lines;
    std::vector<double> m_sizes;  // of each line
    std::vector<GoalTask> m_tasks;
};

}  // namespace

GoalWork seekGoals(const CurveQuestion& question, std::vector<CurveLine>& lines, int jobs,
                   std::stop_token stop) {
    return question.goal ? Search(question, lines).run(jobs, std::move(stop)) : GoalWork();
}

}  // namespace drillwave
