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

/// Effect of one source of error on all unknowns of a fit, as 95 % half-widths.
struct BudgetEffect {
    /// Source of the error: "diameter", "length", "gain", "step" (resolution of the recorder), "tail" (stray
    /// waves after the blow), "timing", "material", …
    std::string source;
    std::string key;        ///< key of option --known that sets this tolerance; empty if there is none
    double tolerance = 0;   ///< 95 % tolerance of the source, in `unit`
    std::string_view unit;  ///< unit of the tolerance: "m", "m^2", "N", "s" or "1"
    /// Whether the tolerance is a default, because option --known does not give it.
    bool isAssumed = false;
    Eigen::VectorXd effect;  ///< effect on each unknown, in the units of the unknowns
};

/// Misfit between record and model at frequencies below 16 kHz, compared with noise (theory of identification
/// §8).
struct MisfitFound {
    double rms = 0;      ///< rms of the residuals, as a share of the peak force
    double noise = 0;    ///< σ_e, the rms expected from noise only, as a share of the peak force
    double scatter = 0;  ///< s, the relative standard deviation of σ_e between simulated noise records
    double ratio = 0;    ///< q, the ratio of `rms` to `noise`
    double misfit = 0;   ///< m, the misfit beyond noise, √(rms² − noise²), as a share of the peak force
    /// Amplitude of an unexplained wave that would cause this misfit, as a share of the peak force.
    double unexplained = 0;
};

struct FitErrors {
    /// 95 % half-widths of the unknowns that noise of the gauges causes. Zero lines, dispersion and bending
    /// are free in this fit, which widens them.
    Eigen::VectorXd noise;
    Eigen::MatrixXd draws;  ///< change of each unknown (row) for each simulated noise record (column)
    std::vector<BudgetEffect> budget;
    MisfitFound misfit;
    /// Amplitude of stray waves in the time between the first passage of the wave and its reflection, as a
    /// share of the peak force. With two gauges, it is the rms difference between their signals during the
    /// first passage.
    double quiet = 0;
    /// Amplitude A of waves that the model does not explain, as a share of the peak force.
    double unexplained = 0;
    /// Whether the amplitude A of unexplained waves was found from the decaying end of the blow. It is then
    /// applied only to the returning wave.
    bool isTail = false;
    Eigen::VectorXd unexplainedEffect;
    std::vector<std::string> remarks;
    Eigen::Index gap = 0;  ///< index of the unknown that is the gap
    /// Movement of the bit during half a time step between samples [m], which limits how well the gap is
    /// known.
    double gapOfSample = 0;
    bool hasCorner = false;  ///< whether the fitted loading curve has a corner
    /// Returns the 95 % half-width of every unknown, from all causes of error together, in the units of the
    /// unknowns.
    Eigen::VectorXd halfWidths() const;
};

/// Number of simulated noise records; the scatter of their fits gives the half-widths due to noise.
inline constexpr int noiseDraws = 60;

/// Returns the errors of the unknowns of a fit, from the model linearised at the solution. A stop request
/// leaves the result incomplete.
FitErrors fitErrors(RecordModel& model, const LawFit& fit, const IdentifyQuestion& question,
                    const std::vector<KnownSize>& sizes, std::uint64_t seed, const std::stop_token& stop);

/// Returns the errors for the rock law of the scenario file, which is not fitted. They contain only the
/// misfit and the stray waves between blow and reflection.
FitErrors heldErrors(RecordModel& model, const LawFit& fit, std::uint64_t seed, const std::stop_token& stop);

/// Returns the misfit of a fit without simulating noise. `noise` and `scatter` are MisfitFound::noise and
/// MisfitFound::scatter of another fit of the same record.
MisfitFound misfitOf(const RecordModel& model, const LawFit& fit, double noise, double scatter);

/// Largest fitted shifts of a zero line, of the droop and of a section size, each divided by its 95 %
/// tolerance. Values far above 1 make a fit doubtful.
struct UsedUp {
    double zeroLines = 0;
    double droop = 0;
    double sizes = 0;
    std::size_t size = 0;  ///< index of the unknown that is this section size
};
/// Returns how far a fit has used its tolerances. These are the largest shifts of zero lines, droop and
/// section sizes, each divided by its 95 % tolerance.
UsedUp usedUp(const RecordModel& model, const LawFit& fit);

}  // namespace drillwave
