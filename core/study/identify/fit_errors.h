// SPDX-License-Identifier: GPL-3.0-or-later
// How far the answer of a fit may be off: noise, tolerances, and waves that the model does not contain.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/study/identify/known_sizes.h"
#include "core/study/identify/law_fit.h"

namespace drillwave {

/// Effect of one cause on all unknowns of a fit, 95 %.
struct BudgetEffect {
    std::string source;     ///< "diameter", "length", "gain", "step", "tail", "timing", "material", …
    std::string key;        ///< of --known, may be empty
    double tolerance = 0;   ///< [unit]
    std::string_view unit;  ///< "m", "1" or "s"
    bool isAssumed = false;
    Eigen::VectorXd effect;  ///< on each unknown
};

/// Misfit below 16 kHz against noise (theory of identification §8).
struct MisfitFound {
    double rms = 0;          ///< of what is left over, share of the peak
    double noise = 0;        ///< σ_e, of noise only, share of the peak
    double scatter = 0;      ///< s, relative deviation of σ_e between draws
    double ratio = 0;        ///< q
    double misfit = 0;       ///< m
    double unexplained = 0;  ///< share of the misfit in the unexplained wave
};

struct FitErrors {
    Eigen::VectorXd noise;  ///< half-widths from noise, zero lines, dispersion and bending
    Eigen::MatrixXd draws;  ///< movement of the unknowns in each draw of noise, one column a draw
    std::vector<BudgetEffect> budget;
    MisfitFound misfit;
    double quiet = 0;        ///< waves in the quiet stretch, or between two gauges, share of the peak
    double unexplained = 0;  ///< A, share of the peak
    bool isTail = false;     ///< A is of the tail of the blow, which fades: on the returning wave only
    Eigen::VectorXd unexplainedEffect;
    std::vector<std::string> remarks;
    Eigen::Index gap = 0;                ///< unknown of the gap
    double gapOfSample = 0;              ///< advance of the bit in half a sample [m]
    bool hasCorner = false;              ///< one unknown is a corner of the loading curve
    Eigen::VectorXd halfWidths() const;  ///< of all together
};

/// Draws of noise for half-widths.
inline constexpr int noiseDraws = 60;

/// Everything that follows from a linearised fit.
FitErrors fitErrors(RecordModel& model, const LawFit& fit, const IdentifyQuestion& question,
                    const std::vector<KnownSize>& sizes, std::uint64_t seed, const std::stop_token& stop);

/// Misfit and waves in the quiet stretch of a law that is held.
FitErrors heldErrors(RecordModel& model, const LawFit& fit, std::uint64_t seed, const std::stop_token& stop);

/// Misfit without the draws: `noise` and `scatter` of another fit of the same record.
MisfitFound misfitOf(const RecordModel& model, const LawFit& fit, double noise, double scatter);

/// Largest part of a prior's tolerance that a zero line, droop or size has used up, and which.
struct UsedUp {
    double zeroLines = 0;
    double droop = 0;
    double sizes = 0;
    std::size_t size = 0;  ///< unknown of the size
};
UsedUp usedUp(const RecordModel& model, const LawFit& fit);

}  // namespace drillwave
