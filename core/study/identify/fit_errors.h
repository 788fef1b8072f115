// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the fitted rock parameters from noise, tolerances, and waves that the model does not contain.
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

/// Effect of one source of error on all unknowns of a fit, as a 95 % half-width.
struct BudgetEffect {
    /// Source of the error: "diameter", "length", "gain", "step", "tail", "timing", "material", …
    std::string source;
    std::string key;        ///< key of option --known that sets this tolerance; empty if there is none
    double tolerance = 0;   ///< 95 % tolerance of the source, in `unit`
    std::string_view unit;  ///< unit of the tolerance: "m", "1" or "s"
    /// Whether the tolerance is a default because the user gave none.
    bool isAssumed = false;
    Eigen::VectorXd effect;  ///< effect on each unknown, in the units of the unknowns
};

/// Misfit between record and model below 16 kHz, compared with noise (theory of identification §8).
struct MisfitFound {
    double rms = 0;      ///< rms of the residuals, as a share of the peak force
    double noise = 0;    ///< σ_e, the rms expected from noise only, as a share of the peak force
    double scatter = 0;  ///< s, the relative standard deviation of σ_e between simulated noise records
    double ratio = 0;    ///< q, the ratio of `rms` to `noise`
    double misfit = 0;   ///< m, the misfit beyond noise, √(rms² − noise²), as a share of the peak force
    /// Amplitude of an unexplained wave that would cause the misfit, as a share of the peak force.
    double unexplained = 0;
};

struct FitErrors {
    /// Half-widths (95 %) of the unknowns from noise, with zero lines, dispersion and bending fitted as well.
    Eigen::VectorXd noise;
    Eigen::MatrixXd draws;  ///< change of each unknown (row) for each simulated noise record (column)
    std::vector<BudgetEffect> budget;
    MisfitFound misfit;
    /// Waves between blow and reflection, or with two gauges their difference, as a share of the peak force.
    double quiet = 0;
    /// A, the amplitude of waves that the model does not explain, as a share of the peak force.
    double unexplained = 0;
    /// Whether the amplitude A of unexplained waves was found from the decaying tail of the blow; it is then
    /// applied only to the returning wave.
    bool isTail = false;
    Eigen::VectorXd unexplainedEffect;
    std::vector<std::string> remarks;
    Eigen::Index gap = 0;  ///< index of the unknown that is the gap
    /// Movement of the bit during half a sample [m], which limits how well the gap is known.
    double gapOfSample = 0;
    bool hasCorner = false;  ///< whether the fitted loading curve has a corner
    /// Returns the 95 % half-width of every unknown from all causes together.
    Eigen::VectorXd halfWidths() const;
};

/// Number of simulated noise records from which half-widths are computed.
inline constexpr int noiseDraws = 60;

/// Returns the errors of a fit, by linearising it at its solution. A stop request leaves the result
/// incomplete.
FitErrors fitErrors(RecordModel& model, const LawFit& fit, const IdentifyQuestion& question,
                    const std::vector<KnownSize>& sizes, std::uint64_t seed, const std::stop_token& stop);

/// Returns the errors for a rock law that is not fitted (that of the scenario file). They contain only the
/// misfit and the waves between blow and reflection.
FitErrors heldErrors(RecordModel& model, const LawFit& fit, std::uint64_t seed, const std::stop_token& stop);

/// Returns the misfit of a fit without simulating noise again. `noise` and `scatter` are those of another fit
/// of the same record.
MisfitFound misfitOf(const RecordModel& model, const LawFit& fit, double noise, double scatter);

/// Largest shift of a zero line, of the droop and of a section size, each relative to its prior's 95 %
/// tolerance.
struct UsedUp {
    double zeroLines = 0;
    double droop = 0;
    double sizes = 0;
    std::size_t size = 0;  ///< index of the unknown that is this section size
};
/// Returns the largest shifts of the zero lines, the droop and the section sizes in a fit, each divided by
/// its 95 % tolerance.
UsedUp usedUp(const RecordModel& model, const LawFit& fit);

}  // namespace drillwave
