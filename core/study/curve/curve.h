// SPDX-License-Identifier: GPL-3.0-or-later
// Results of one blow as functions of one parameter, fitted to a known accuracy. Each curve consists of
// smooth functions between kinks, whose positions are solved for.
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

/// Input of a curve study: the scenario, the parameter that varies and the outputs to compute.
struct CurveQuestion {
    Scenario base;
    /// Parameter that varies along the curve, with its range, as read by parseRange().
    SweepAxis along;
    /// Second parameter, if any: one line is computed for each of its values.
    std::optional<SweepAxis> family;
    std::vector<OutputColumn> columns;  ///< outputs to compute, at least one
    /// Values of special interest (levels). The parameter values at which an output crosses them are
    /// reported. The unit is that of the output.
    std::vector<double> levels;
    /// Target value of the output, in the unit of its column. Allowed only with a single column.
    std::optional<double> goal = {};
    MethodChoice method = {};
    /// Maximum work of one blow, in wave pieces (the solver's unit of work). Blows that need more have no
    /// result.
    long workLimit = defaultWorkLimit;

    CurveRange range() const;
    /// Returns a copy of the base scenario in which every varied parameter has the first value of its range.
    Scenario firstScenario() const;
    bool operator==(const CurveQuestion&) const = default;
    /// Returns the varied parameters with their values: the second parameter (family) first if there is one,
    /// then the parameter along the curve.
    std::vector<SweepAxis> axes() const;
};

/// Maximum number of values of the second parameter (family) of a curve study; each value gives one line of
/// curves.
inline constexpr std::size_t maximumCurveLines = 50;

/// Returns the reasons why a curve cannot be computed, one message each; empty if it can. If followProblem()
/// rejects the range, that is the only message.
/// Otherwise the checks are those of a sweep over both parameters (see problemsOf(Sweep)) and three more.
/// Outputs may not need a study of all gaps at every point. The second parameter (family) may not have too
/// many values. A goal is only allowed with a single output.
std::vector<Message> problemsOf(const CurveQuestion& question);

/// Returns an error message if the second parameter (family) has more than maximumCurveLines values; empty
/// otherwise.
Message familyProblem(const CurveQuestion& question);
/// Returns an error message if a goal is set for more than one output; empty if the goal is valid or not set.
Message goalProblem(const CurveQuestion& question);

/// Part of the parameter range (`start` and `end` in SI units) in which the curve is not fitted or has no
/// result, with the reason. If there are several reasons, the first one is given.
struct CurveStretch {
    double start = 0;
    double end = 0;
    Message reason;
    bool operator==(const CurveStretch&) const = default;
};

/// Curve of one output over the parameter range.
struct CurveOutput {
    /// Pieces of the curve in ascending order, each with one smooth function, or none if it has no result.
    /// The argument of the function is the share 0 … 1 of the range (see CurveRange).
    std::vector<FitPiece> pieces;
    /// Parts of the range where the output is not smooth, or where a fit would exceed the permitted work.
    /// Blows are solved there only at CurveLine::points, and the curve is linear between them. The points are
    /// at most 1/500 of the range and 1/16 of the part apart.
    std::vector<CurveStretch> grid;
    std::vector<CurveStretch> unsolved;  ///< stretches where the output has no result, with the reasons
    /// Extremes, kinks, jumps and level crossings of the curve, ascending in the parameter.
    std::vector<CurveFeature> features;

    /// Returns the global minimum or maximum of the curve; nullptr if no point of the curve has a result.
    const CurveFeature* extreme(CurveFeature::Kind kind) const;
};

/// Curves of all outputs for one value of the second parameter (family) of a curve study.
struct CurveLine {
    /// Value of the second parameter (family) of this line in SI units, or the index of its word, such as a
    /// pulse shape. Empty without a second parameter.
    std::optional<double> family;
    CurveRange range;
    /// Parameter values at which to draw and export the curves, ascending, in SI units.
    std::vector<double> points;
    /// Values of the outputs at `points`, indexed [output][point], in the units of their columns; NaN if
    /// there is no result.
    std::vector<std::vector<double>> values;
    std::vector<CurveOutput> outputs;  ///< curves of the outputs, in the order of CurveQuestion::columns
    /// Parameter values for which the output takes the goal value; empty if the question has no goal.
    std::optional<GoalAnswer> goal = {};

    /// Returns the value of an output at any parameter value x (SI) of the range, in the unit of its column.
    /// Empty if there is no result at x.
    std::optional<double> value(double x, std::size_t output) const;
    /// Returns the estimated bound (≥ 0) of the error of value(), in the unit of the output. Empty if there
    /// is no result at x.
    std::optional<double> error(double x, std::size_t output) const;
};

/// Result of a curve study.
struct CurveStudy {
    CurveQuestion question;
    /// Lines of the study: one for each value of the second parameter (family), or one if there is no second
    /// parameter. Each line has a curve for every output.
    std::vector<CurveLine> lines;
    std::uint64_t solves = 0;  ///< number of blows solved
    /// Computing work of all blows of the study: number of polynomial wave pieces, or time steps × nodes for
    /// drill strings.
    long effort = 0;
    bool stopped = false;  ///< set if the stop token ended the study early; `lines` is then empty
    /// Reason why the curves cannot be computed; empty if they can. If there is a reason, `lines` is empty.
    Message refusal = {};

    /// Returns whether every output has a result over the whole range of every line.
    bool isComplete() const;
    /// Returns whether every curve takes the goal value for at least one parameter value. Without a goal,
    /// returns true. If the study was stopped or refused, returns false.
    bool isReached() const;
};

/// Callback for progress, called on the calling thread with the completed share of the work, 0 … 1.
using CurveProgress = std::function<void(double)>;

/// Returns the curves of all outputs over the range of the question. If problemsOf() is not empty, returns a
/// study without lines, with the problems as CurveStudy::refusal.
/// Each output is fitted separately, in the parameter or its logarithm, so other requested outputs do not
/// affect it. The error is at most 1e-10 of the output's size plus the error of the solver.
/// Work is limited: for one output, all blows of a cell (one part of the range) may together take five times
/// CurveQuestion::workLimit. Beyond that, blows are solved only at points, and each may take a sixth of
/// workLimit. The lines do not depend on the number of threads `jobs` (≥ 1).
CurveStudy studyCurve(const CurveQuestion& question, int jobs, std::stop_token stop = {},
                      const CurveProgress& progress = {});

}  // namespace drillwave
