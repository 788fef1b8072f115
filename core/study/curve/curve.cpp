// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <span>
#include <utility>

#include "core/numeric/fit_features.h"
#include "core/numeric/ordered_work.h"
#include "core/study/curve/curve_features.h"
#include "core/study/curve/curve_sampler.h"
#include "core/study/rows/sweep_check.h"

namespace drillwave {

namespace {

/// Where to look first, and what threads share: a feature that is narrower, and on which nothing happens at
/// the bit at another time, may be missed.
constexpr std::size_t cellsOfRange = 16;
constexpr double farthestPoints = 1.0 / 500;
constexpr double nearestPoints = 1e-9;
/// Refusals cost nothing, and where they end is bracketed: enough for four brackets of a cell.
constexpr std::uint64_t mostFailuresOfCell = 200;
/// Of blows at the work limit, for each output of a cell.
constexpr long mostBlowsAtLimit = 3;
/// What outputs that are no ratio are known to where they vanish, of the unit that they have.
constexpr double smallOfUnit = 1e-4;
/// Points that one thread computes at once where an output is not smooth.
constexpr std::size_t pointsOfBlock = 32;
constexpr std::string_view notSmooth = "not smooth within the work permitted";
constexpr std::string_view isRounding = "an error, which has no smooth course";

double shareOfCell(std::size_t cell) {
    return static_cast<double>(cell) / cellsOfRange;
}

bool isRatio(Measure measure) {
    return measure == Measure::number || measure == Measure::share || measure == Measure::work;
}

/// One output in one cell.
struct CellOutput {
    std::vector<FitPiece> pieces;  // unresolved ones without functions are to be filled from points
    std::string reason;            // of those without an answer
};

struct CellTask {
    std::size_t line = 0;
    std::size_t cell = 0;
    std::vector<CellOutput> outputs;
    std::uint64_t solves = 0;
};

FitPiece openPiece(double start, double end) {
    FitPiece piece;
    piece.start = start;
    piece.end = end;
    piece.resolved = false;
    return piece;
}

bool isOpen(const FitPiece& piece) {
    return piece.solved && piece.outputs.empty();
}

/// Leaves open what is too rough and too wide for a sliver around a kink.
std::vector<FitPiece> openRoughPieces(std::vector<FitPiece> pieces) {
    std::vector<FitPiece> kept;
    for (FitPiece& piece : pieces) {
        const bool isRough = piece.solved && !piece.resolved && piece.end - piece.start > leastSlopeWidth;
        if (!isRough)
            kept.push_back(std::move(piece));
        else if (!kept.empty() && isOpen(kept.back()))
            kept.back().end = piece.end;
        else
            kept.push_back(openPiece(piece.start, piece.end));
    }
    return kept;
}

/// Fits the outputs of one cell after another.
class CellFitter {
  public:
    CellFitter(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    void operator()(CellTask& task, const std::stop_token& stop) const {
        CurveSampler sampler(m_question, m_axes, task.line, stop);
        task.outputs.clear();
        for (std::size_t i = 0; i < m_question.columns.size(); ++i)
            task.outputs.push_back(fit(sampler, task.cell, i, stop));
        task.solves = sampler.solves();
    }

  private:
    CellOutput fit(CurveSampler& sampler, std::size_t cell, std::size_t output,
                   const std::stop_token& stop) const {
        const std::array cuts{shareOfCell(cell), shareOfCell(cell + 1)};
        const Measure measure = m_question.columns[output].output->measure;
        if (measure == Measure::error) return {{openPiece(cuts[0], cuts[1])}, {}};
        const double unit = sampler.unitAt(cuts[0], output);
        const bool grows = !isRatio(measure) || measure == Measure::work;
        const FitSettings settings{.scale = {isRatio(measure) ? unit : unit * smallOfUnit, 0, 0},
                                   .scaleGrows = {grows, false, false},
                                   .failuresOfCell = mostFailuresOfCell,
                                   .mostFailedEffort = mostBlowsAtLimit * m_question.workLimit,
                                   .ends = FitSettings::Ends::bracketed};
        PiecewiseFit fitted = fitPiecewise(
            settings, cuts, [&](double share) { return sampler(share, output); }, stop);
        return {openRoughPieces(std::move(fitted.pieces)), sampler.reason()};
    }

    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                std::string_view reason) {
    const double start = range.at(piece.start), end = range.at(piece.end);
    if (!stretches.empty() && stretches.back().end == start && stretches.back().reason == reason)
        stretches.back().end = end;
    else
        stretches.push_back({start, end, std::string(reason)});
}

/// Appends what a cell has brought.
void addCell(CurveLine& line, const CurveQuestion& question, CellTask& task) {
    for (std::size_t i = 0; i < task.outputs.size(); ++i) {
        CurveOutput& output = line.outputs[i];
        const bool isError = question.columns[i].output->measure == Measure::error;
        for (FitPiece& piece : task.outputs[i].pieces) {
            if (isOpen(piece)) addStretch(output.grid, line.range, piece, isError ? isRounding : notSmooth);
            if (!piece.solved) addStretch(output.unsolved, line.range, piece, task.outputs[i].reason);
            output.pieces.push_back(std::move(piece));
        }
    }
}

/// Shares of the way at which to draw and write: those of all outputs, and one wherever there is no answer.
std::vector<double> pointsOf(const CurveLine& line) {
    std::vector<double> all{0, 1};
    for (const CurveOutput& output : line.outputs) {
        const std::vector<double> places = samplePlaces(output.pieces, farthestPoints);
        all.insert(all.end(), places.begin(), places.end());
        for (const FitPiece& piece : output.pieces)
            if (!piece.solved) all.push_back(piece.start / 2 + piece.end / 2);
    }
    std::ranges::sort(all);
    std::vector<double> points{0};
    for (const double share : all)
        if (share - points.back() > nearestPoints && 1 - share > nearestPoints) points.push_back(share);
    points.push_back(1);
    return points;
}

/// The points in a piece, from its start to its end.
std::vector<double> pointsIn(const FitPiece& piece, std::span<const double> points) {
    std::vector<double> inside{piece.start};
    for (const double share : points)
        if (share > piece.start && share < piece.end) inside.push_back(share);
    inside.push_back(piece.end);
    return inside;
}

/// One output at points of a line, by solving.
struct Point {
    double share = 0;
    std::vector<FitSample> outputs;
    std::vector<std::string> reasons;
};

struct PointTask {
    std::size_t line = 0;
    std::vector<double> shares;
    std::vector<Point> points;
    std::uint64_t solves = 0;
};

/// Solves at the points of one task after another.
class PointSolver {
  public:
    PointSolver(const CurveQuestion& question, const std::vector<SweepAxis>& axes)
        : m_question(question), m_axes(axes) {}

    void operator()(PointTask& task, const std::stop_token& stop) const {
        CurveSampler sampler(m_question, m_axes, task.line, stop);
        task.points.clear();
        for (const double share : task.shares) {
            Point& point = task.points.emplace_back();
            point.share = share;
            for (std::size_t i = 0; i < m_question.columns.size() && !stop.stop_requested(); ++i) {
                point.outputs.push_back(sampler(share, i));
                point.reasons.push_back(point.outputs.back().solved ? std::string() : sampler.reason());
            }
        }
        task.solves = sampler.solves();
    }

  private:
    const CurveQuestion& m_question;
    const std::vector<SweepAxis>& m_axes;
};

/// A straight line between two points; off by no more than they differ, in all likelihood.
FitPiece straightPiece(const FitSample& a, const FitSample& b) {
    FitPiece piece = openPiece(a.x, b.x);
    piece.solved = a.solved && b.solved;
    piece.label = a.label;
    if (!piece.solved) return piece;
    const std::array ends{a.values[0], b.values[0]};
    piece.outputs.emplace_back(a.x, b.x, ends);
    piece.error.push_back(std::abs(ends[1] - ends[0]) + std::max(a.error, b.error));
    return piece;
}

const Point& pointAt(const std::vector<Point>& points, double share) {
    return *std::ranges::lower_bound(points, share, {}, &Point::share);
}

/// Fills open pieces of an output from points that have been solved.
void fillPieces(CurveLine& line, std::size_t i, std::span<const double> shares,
                const std::vector<Point>& points) {
    CurveOutput& output = line.outputs[i];
    std::vector<FitPiece> filled;
    for (FitPiece& piece : output.pieces) {
        if (!isOpen(piece)) {
            filled.push_back(std::move(piece));
            continue;
        }
        const std::vector<double> nodes = pointsIn(piece, shares);
        for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
            const Point& a = pointAt(points, nodes[n]);
            const Point& b = pointAt(points, nodes[n + 1]);
            filled.push_back(straightPiece(a.outputs[i], b.outputs[i]));
            if (!filled.back().solved)
                addStretch(output.unsolved, line.range, filled.back(),
                           a.reasons[i].empty() ? b.reasons[i] : a.reasons[i]);
        }
    }
    output.pieces = std::move(filled);
}

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
        if (study.stopped) return study;
        for (std::size_t line = 0; line < m_lines.size(); ++line) finish(line);
        study.lines = std::move(m_lines);
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
        const std::size_t count = m_lines.size() * cellsOfRange;
        std::size_t next = 0, done = 0;
        const auto fill = [&](CellTask& task) {
            task.line = next / cellsOfRange;
            task.cell = next % cellsOfRange;
            return next++ < count;
        };
        const auto deliver = [&](CellTask& task) {
            addCell(m_lines[task.line], m_question, task);
            m_solves += task.solves;
            tell(0, shareOfFits, ++done, count);
            return true;
        };
        const auto makeWorker = [&] { return CellFitter(m_question, m_axes); };
        return processInOrder<CellTask>(m_jobs, m_stop, fill, makeWorker, deliver) == WorkEnd::finished;
    }

    /// The points of a line at which open pieces have to be known.
    std::vector<double> openPoints(std::size_t line) const {
        std::vector<double> open;
        for (const CurveOutput& output : m_lines[line].outputs)
            for (const FitPiece& piece : output.pieces) {
                if (!isOpen(piece)) continue;
                const std::vector<double> inside = pointsIn(piece, m_points[line]);
                open.insert(open.end(), inside.begin(), inside.end());
            }
        std::ranges::sort(open);
        open.erase(std::ranges::unique(open).begin(), open.end());
        return open;
    }

    bool fillGrids() {
        std::vector<PointTask> tasks;
        for (std::size_t line = 0; line < m_lines.size(); ++line) {
            m_points[line] = pointsOf(m_lines[line]);
            const std::vector<double> open = openPoints(line);
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
        for (std::size_t i = 0; i < line.outputs.size(); ++i) {
            std::vector<double>& values = line.values.emplace_back();
            for (const double x : line.points)
                values.push_back(line.value(x, i).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    }

    const CurveQuestion& m_question;
    const std::vector<SweepAxis> m_axes;
    int m_jobs;
    std::stop_token m_stop;
    const CurveProgress& m_progress;
    std::vector<CurveLine> m_lines;
    std::vector<std::vector<double>> m_points;  // of each line, as shares
    std::vector<std::vector<Point>> m_solved;   // of each line, ascending
    std::uint64_t m_solves = 0;
};

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

std::vector<std::string> problemsOf(const CurveQuestion& question) {
    std::vector<std::string> problems = problemsOf(
        Sweep{.base = question.base, .axes = question.axes(), .columns = question.columns, .shard = {}});
    if (question.family && question.family->count > maximumCurveLines)
        problems.push_back("a family has at most " + std::to_string(maximumCurveLines) + " lines, this one " +
                           std::to_string(question.family->count));
    return problems;
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

bool CurveStudy::isComplete() const {
    return !stopped && std::ranges::all_of(lines, [](const CurveLine& line) {
        return std::ranges::all_of(line.outputs,
                                   [](const CurveOutput& output) { return output.unsolved.empty(); });
    });
}

CurveStudy studyCurve(const CurveQuestion& question, int jobs, std::stop_token stop,
                      const CurveProgress& progress) {
    assert(jobs >= 1 && !question.columns.empty() && problemsOf(question).empty());
    return Study(question, jobs, std::move(stop), progress).run();
}

}  // namespace drillwave
