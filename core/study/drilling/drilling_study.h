// SPDX-License-Identifier: GPL-3.0-or-later
// Study of a sequence of blows of a scenario, with its statistics (drilling §5).
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/model/alerts.h"
#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "core/study/drilling/blow_alone.h"
#include "core/study/drilling/drilling_case.h"
#include "core/study/drilling/drilling_record.h"
#include "core/study/drilling/drilling_statistics.h"
#include "core/text/message.h"

namespace drillwave {

/// Dimensionless groups of a sequence of blows (drilling §5).
struct DrillingGroups {
    /// Feed number φ = Fe/(f I0), the effective feed force over the mean hammer force. For a drill string, I0
    /// is replaced by J, the mean impulse that the hammer transfers.
    double phi = 0;
    double roundTrips = 0;  ///< n_b, round trips of a wave between two blows
    /// Dimensionless mass μ of the machine, and damping ζ and stiffness κ of its damper; 0 without a machine.
    double mu = 0, zeta = 0, kappa = 0;
    Groups blow;
};

/// Lyapunov exponent λ per blow, with its 95 % error.
struct Lyapunov {
    double value = 0;
    std::optional<double> error;
};

/// Safety factor of the stated error: multiplies the change of a mean when the cells are twice or half as
/// large.
inline constexpr double coveringCells = 3;

/// Safety factor of the stated error: multiplies the relative rounding of the interval between blows. Means
/// have been observed to change by up to 180 times that rounding, which other cell sizes do not reveal.
inline constexpr double coveringRounding = 300;

/// Selection of results of a sequence of blows in addition to the blows themselves, with limits. The cell
/// error and the Lyapunov exponent each take one more computation of the sequence.
struct DrillingRequest {
    /// Whether to estimate the error from cells of another size (see comparedDrillingGridOf()).
    bool cellError = true;
    bool lyapunov = true;
    bool blowAlone = true;  ///< whether to solve a single blow from rest for comparison
    std::optional<BlowRange> histories = {};
    /// Maximum work of each computation of the sequence [time steps × nodes, which are ends of sections].
    double mostWork = mostDrillingWork;
    /// Number of computations that may run at the same time, each on its own thread; does not change the
    /// results.
    int jobs = 1;
    /// Callback for every blow of the requested sequence, called as soon as the blow is done. Repeated
    /// computations for error estimates are not reported.
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Callback after every blow of the requested sequence, with all blows so far. It returns true to end the
    /// sequence early; there are then no statistics.
    std::function<bool(const std::vector<DrillingBlow>&)> stopEarly = {};
};

struct DrillingResult {
    Scenario scenario;
    DrillingSettings settings;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;  ///< reason for an outcome other than done; empty otherwise
    std::vector<DrillingBlow> blows;
    /// States of machine, rod and bit over time during the blows in DrillingRequest::histories; empty if none
    /// were requested.
    std::vector<DrillingInstant> instants;
    /// Statistics of the counted blows. Empty if the sequence is not complete, or if the blows push the
    /// machine back.
    std::optional<DrillingStatistics> statistics;
    /// Errors of the means from the time steps: three times the change with other cells, plus an allowance
    /// for rounding of the interval between blows. If the other cells give another motion, its scatter is
    /// added. 0 if not requested.
    std::array<double, blowQuantities.size()> cellErrors{};
    std::optional<Lyapunov> lyapunov;
    DrillingGroups groups;
    /// Single blow from rest for comparison; empty if not requested or not solved.
    std::optional<BlowAlone> alone;
    double meanImpulse = 1;  ///< J, mean impulse of the hammer per blow [units of Problem]
    DrillingLedger ledger;
    /// Error of the momentum balance over all N blows, as a share of the feed impulse N Fe/f (effective feed
    /// force Fe, blow frequency f).
    double momentumResidual = 0;
    double energyResidual = 0;    ///< energy that is not accounted for, as a share of the hammer work
    double frequencyUsed = 0;     ///< blow frequency after rounding the interval to whole cells [Hz]
    double cellsPerDuration = 0;  ///< number of cells per duration t0 that was used
    std::vector<Alert> alerts;
    DrillingUnits units;
    Scales scales;
    double runTime = 0;  ///< computing time [s]

    bool hasLoss = false;       ///< whether waves lose energy in the rod or string
    bool hasWholeTrips = true;  ///< whether the round-trip times of all sections are whole numbers of cells
    /// Whether cells of another size give a qualitatively different motion, so that neither motion is
    /// certain.
    bool cellsDecideMotion = false;
    /// Returns the 95 % error of the mean of a quantity (index in blowQuantities). It adds the scatter of
    /// batches of blows, the effect of the cell size, and 2e-5 of the mean for the remaining transient
    /// motion. Empty if only one blow is counted.
    std::optional<double> meanError(std::size_t quantity) const;
    const BlowSpread& spread(std::size_t quantity) const { return statistics->spreads[quantity]; }
};

/// Returns the number of blows in all computations of a study, including those for the cell error and the
/// Lyapunov exponent.
long foreseenBlows(const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the estimated number of recorded instants (DrillingResult::instants) for a range of blows.
double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range);

/// Returns the estimated work of all computations of a study [time steps × nodes, which are ends of
/// sections].
double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the result of a sequence of blows. If drillingRefusals() is not empty, the outcome is notSolved
/// with these messages as the reason.
DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingRequest& wants = {}, const std::stop_token& stop = {},
                             const DrillingProgress& progress = {});

}  // namespace drillwave
