// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs along one parameter, to a known accuracy: smooth pieces between kinks that are found, not stepped
// over.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/numeric/piecewise_fit.h"
#include "core/study/curve/curve_feature.h"
#include "core/study/curve/curve_goal.h"
#include "core/study/curve/curve_range.h"
#include "core/study/rows/output_column.h"
#include "core/study/rows/row_counts.h"
#include "core/study/rows/sweep_axis.h"
#include "core/text/message.h"
#include "core/wave/exact/exact_solver.h"

namespace drillwave {

/// Parameters and outputs of a curve study.
struct CurveQuestion {
    Scenario base;
    /// The parameter to go along, as parseRange() gives it.
    SweepAxis along;
    std::optional<SweepAxis> family;    ///< a line for each of its values
    std::vector<OutputColumn> columns;  ///< at least one
    std::vector<double> levels;         ///< for every output to cross, each in its own unit
    std::optional<double> goal = {};    ///< target of the only output, in the unit of its column
    MethodChoice method = {};
    long workLimit = defaultWorkLimit;  ///< most wave pieces of a blow; beyond, it is not solved

    CurveRange range() const;
    /// The base with the first value of every axis.
    Scenario firstScenario() const;
    bool operator==(const CurveQuestion&) const = default;
    std::vector<SweepAxis> axes() const;  ///< the family, if there is one, and the parameter to go along
};

/// Maximum number of lines of a family.
inline constexpr std::size_t maximumCurveLines = 50;

/// Returns the problems of a question, each a line: a range that cannot be followed (see followProblem()),
/// and then no others; as problemsOf(Sweep), axes of one quantity, or no end that is a scenario; outputs that
/// need a study at every point. Empty if it can be studied.
std::vector<Message> problemsOf(const CurveQuestion& question);

/// Returns why the family has too many lines; empty if it has not.
Message familyProblem(const CurveQuestion& question);
/// Why the goal of a question is none; empty when it is one, or there is none.
Message goalProblem(const CurveQuestion& question);

/// A part of the range, SI, and why it is not as the others (there may be other reasons within).
struct CurveStretch {
    double start = 0;
    double end = 0;
    Message reason;
    bool operator==(const CurveStretch&) const = default;
};

/// An output along the range.
struct CurveOutput {
    /// Over shares of the range (CurveRange), 0 … 1, ascending, one function each.
    std::vector<FitPiece> pieces;
    /// Stretches where the output is not smooth, or not within the permitted work: only computed at the
    /// points of the line, no more than 1/500 of the range and 1/16 of the stretch apart, and straight
    /// between them.
    std::vector<CurveStretch> grid;
    std::vector<CurveStretch> unsolved;  ///< without results
    std::vector<CurveFeature> features;  ///< by place

    /// The least or largest of the line; nullptr where there is no answer at all.
    const CurveFeature* extreme(CurveFeature::Kind kind) const;
};

/// All outputs along the range, for one value of the family.
struct CurveLine {
    std::optional<double> family;  ///< SI, or the number of a shape
    CurveRange range;
    std::vector<double> points;               ///< to draw and write: ascending values of the parameter, SI
    std::vector<std::vector<double>> values;  ///< of each output at each point; NaN where there is none
    std::vector<CurveOutput> outputs;         ///< in the order of CurveQuestion::columns
    std::optional<GoalAnswer> goal = {};      ///< where the question has one

    /// An output anywhere in the range; nothing where there is no answer.
    std::optional<double> value(double x, std::size_t output) const;
    /// The bound on its error as estimated; nothing where there is no answer.
    std::optional<double> error(double x, std::size_t output) const;
};

/// The answer.
struct CurveStudy {
    CurveQuestion question;
    std::vector<CurveLine> lines;  ///< one for each value of the family, one without
    std::uint64_t solves = 0;      ///< blows solved
    long effort = 0;               ///< their wave pieces, or cells of drill strings
    bool stopped = false;          ///< on the stop token: there are no lines
    Message refusal = {};          ///< why the question has no answer: there are no lines; empty otherwise

    /// Whether every output has an answer all along every line.
    bool isComplete() const;
    /// Whether every line takes the goal somewhere, where there is one.
    bool isReached() const;
};

/// Called on the calling thread with the share of the work that is done, 0 … 1.
using CurveProgress = std::function<void(double)>;

/// Fits every output by itself, in the parameter or its logarithm, to 1e-10 of its size and the error of the
/// solver: other requested outputs change nothing. Work is bounded: all blows of a cell for one output have
/// as many wave pieces together as five at the work limit; beyond, the output is only known at points, each
/// of which may take a sixth of the limit. The lines do not depend on `jobs` (≥ 1). Requires problemsOf() to
/// be empty.
CurveStudy studyCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                      const CurveProgress& progress = {});

}  // namespace drillwave
