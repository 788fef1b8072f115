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
    /// Feed number φ = Fe/(f I0), the effective feed force over the mean hammer force. For a drill string, J,
    /// the mean rock impulse, replaces I0.
    double phi = 0;
    double roundTrips = 0;  ///< n_b, round trips of a wave between two blows
    /// Groups of machine and damper: mass, damping and stiffness; 0 without a machine.
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

/// Safety factor of the stated error: multiplies the relative rounding of the interval between blows. That
/// rounding has changed means by up to 180 times as much, which other cell sizes do not reveal.
inline constexpr double coveringRounding = 300;

/// Results requested in addition to the blows themselves. Each costs a further computation of the sequence.
struct DrillingRequest {
    /// Whether to estimate the error from cells of another size (see comparedDrillingGridOf()).
    bool cellError = true;
    bool lyapunov = true;
    bool blowAlone = true;  ///< whether to solve a single blow from rest for comparison
    std::optional<BlowRange> histories = {};
    /// Maximum work of each computation of the sequence [cells × nodes].
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
    /// States over time during the blows recorded in full (DrillingRequest::histories).
    std::vector<DrillingInstant> instants;
    /// Statistics of the counted blows; empty if the motion is not bounded.
    std::optional<DrillingStatistics> statistics;
    /// Errors of the means from the cell size: three times the change with other cells; 0 if not requested.
    std::array<double, blowQuantities.size()> cellErrors{};
    std::optional<Lyapunov> lyapunov;
    DrillingGroups groups;
    /// Single blow from rest for comparison; empty if not requested or not solved.
    std::optional<BlowAlone> alone;
    double meanImpulse = 1;  ///< J, mean impulse on the rock per blow [units of Problem]
    DrillingLedger ledger;
    /// Momentum that is not accounted for, as a share of the feed impulse N Fe/f.
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
    /// Whether cells of another size give a qualitatively different motion.
    bool cellsDecideMotion = false;
    /// Returns the 95 % error of the mean of a quantity (index in blowQuantities). Includes batches, cells
    /// and transient blows; empty if any of these is unknown.
    std::optional<double> meanError(std::size_t quantity) const;
    const BlowSpread& spread(std::size_t quantity) const { return statistics->spreads[quantity]; }
};

/// Returns the number of blows in all computations of a study.
long foreseenBlows(const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the number of instants that recording a range of blows gives.
double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range);

/// Returns the estimated work of all computations of a study [cells × nodes].
double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the result of a sequence of blows. If drillingRefusals() is not empty, the outcome is notSolved
/// with these messages as the reason.
DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingRequest& wants = {}, const std::stop_token& stop = {},
                             const DrillingProgress& progress = {});

}  // namespace drillwave
