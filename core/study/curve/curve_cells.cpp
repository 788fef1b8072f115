// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/model/scales.h"
#include "core/numeric/fit_features.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {

namespace {

constexpr std::size_t leastCells = 16;
constexpr std::size_t mostCells = 256;
constexpr double cellsOfPeriod = 8;
/// Maximum refusals in a cell: they cost nothing, and this is enough for four brackets of their ends.
constexpr std::uint64_t mostFailuresOfCell = 200;
/// Work for each output of a cell, in blows at the work limit.
constexpr long mostBlowsAtLimit = 2;
/// Work for all outputs of a cell, in blows at the work limit. Nearly all cells take less than a hundredth.
constexpr long mostEffortAtLimit = 5;
/// Accuracy near zero of outputs that are no ratio, in their unit.
constexpr double smallOfUnit = 1e-4;
/// At least this number of blows of a cell, where StudyPlan::blowsOfPiece limits them.
constexpr long leastBlowsOfCell = 150;
/// Half of this number of blows brackets a kink.
constexpr std::uint64_t blowsOfKink = 80;
constexpr const char* notSmooth = translatable("not smooth within the work permitted");
constexpr const char* isRounding = translatable("errors do not vary smoothly");
constexpr const char* isOfManyBlows =
    translatable("result of many blows, not necessarily smooth: straight lines between points");

bool isRatio(Measure measure) {
    return measure == Measure::number || measure == Measure::share || measure == Measure::energy ||
           measure == Measure::work;
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

/// At the first of some places where there is a scenario.
double unitIn(CurveSampler& sampler, const std::array<double, 2>& cuts, std::size_t output) {
    for (const double share : {cuts[0], cuts[1], (cuts[0] + cuts[1]) / 2})
        if (const double unit = sampler.unitAt(share, output); unit > 0) return unit;
    return 1;
}

}  // namespace

Message whyRough(const Output& output) {
    if (output.needsDrilling()) return isOfManyBlows;
    return output.measure == Measure::error ? isRounding : Message();
}

std::size_t cellCount(const CurveQuestion& question) {
    const auto gapAt = [&](double value) {
        Scenario scenario = question.base;
        question.along.assign(scenario, value);
        return groupsOf(scenario).delta;
    };
    if (question.along.key() != "delta" && question.along.key() != "bit_rock.gap") return leastCells;
    const double cells = cellsOfPeriod * (gapAt(question.along.stop) - gapAt(question.along.start));
    return static_cast<std::size_t>(std::clamp(std::ceil(cells), double(leastCells), double(mostCells)));
}

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

void CellFitter::operator()(CellTask& task, const std::stop_token& stop) const {
    CurveSampler sampler(m_question, m_axes, task.line, stop);
    task.outputs.clear();
    for (std::size_t i = 0; i < m_question.columns.size(); ++i)
        task.outputs.push_back(fit(sampler, task, i, stop));
    task.solves = sampler.solves();
    task.effort = sampler.effort();
}

CellOutput CellFitter::fit(CurveSampler& sampler, const CellTask& task, std::size_t output,
                           const std::stop_token& stop) const {
    const std::array cuts{task.start, task.end};
    const Measure measure = m_question.columns[output].output->measure;
    if (!whyRough(*m_question.columns[output].output).isEmpty()) return {{openPiece(cuts[0], cuts[1])}, {}};
    const double unit = unitIn(sampler, cuts, output);
    const bool grows = !isRatio(measure) || measure == Measure::work;
    FitSettings settings{.scale = {isRatio(measure) ? unit : unit * smallOfUnit, 0, 0},
                         .scaleGrows = {grows, false, false},
                         .failuresOfCell = mostFailuresOfCell,
                         .mostFailedEffort = mostBlowsAtLimit * m_question.workLimit,
                         .ends = FitSettings::Ends::bracketed};
    if (const std::optional<long> blows = studyPlan(m_question.base).blowsOfPiece; !blows) {
        settings.mostEffort = mostEffortAtLimit * m_question.workLimit;
    } else {
        const long most = *blows * m_question.workLimit / std::max(1L, sampler.effortAt(cuts[0]));
        const auto solves = static_cast<std::uint64_t>(std::max(leastBlowsOfCell, most));
        settings.solvesOfCell = std::min(settings.solvesOfCell, solves);
        settings.kinksOfCell = std::min(settings.kinksOfCell, solves / blowsOfKink);
    }
    PiecewiseFit fitted = fitPiecewise(
        settings, cuts, [&](double share) { return sampler(share, output); }, stop);
    return {openRoughPieces(std::move(fitted.pieces)), sampler.reason()};
}

void addStretch(std::vector<CurveStretch>& stretches, const CurveRange& range, const FitPiece& piece,
                const Message& reason) {
    const double start = range.at(piece.start), end = range.at(piece.end);
    if (!stretches.empty() && stretches.back().end == start)
        stretches.back().end = end;
    else
        stretches.push_back({start, end, reason});
}

void addCell(CurveLine& line, const CurveQuestion& question, CellTask& task) {
    for (std::size_t i = 0; i < task.outputs.size(); ++i) {
        CurveOutput& output = line.outputs[i];
        const Message rough = whyRough(*question.columns[i].output);
        for (FitPiece& piece : task.outputs[i].pieces) {
            if (isOpen(piece))
                addStretch(output.grid, line.range, piece, rough.isEmpty() ? notSmooth : rough);
            if (!piece.solved) addStretch(output.unsolved, line.range, piece, task.outputs[i].reason);
            output.pieces.push_back(std::move(piece));
        }
    }
}

}  // namespace drillwave
