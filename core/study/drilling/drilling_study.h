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

/// Dimensionless numbers that characterise a sequence of blows: those of feed, rod and machine, and those of
/// a single blow.
struct DrillingGroups {
    /// Feed number φ = Fe/(f J): the effective feed force Fe divided by the mean force f J of the hammer,
    /// with the blow frequency f. J is the mean impulse per blow that the hammer transfers; it equals I0 for
    /// a uniform rod with a given hammer force.
    double phi = 0;
    double roundTrips = 0;  ///< n_b, round trips of a wave between two blows
    /// Dimensionless mass μ of the machine, and damping ζ and stiffness κ of its damper; all 0 if the machine
    /// is not modelled as a body on a damper.
    double mu = 0, zeta = 0, kappa = 0;
    Groups blow;
};

/// Lyapunov exponent λ per blow, with its 95 % error.
struct Lyapunov {
    double value = 0;
    std::optional<double> error;
};

/// Safety factor in the stated error of a mean. It multiplies the change of the mean when the time step
/// (cell) is twice or half as large.
inline constexpr double coveringCells = 3;

/// Safety factor in the stated error of a mean, for the interval between blows, which is rounded to whole
/// time steps. It multiplies the relative rounding of the interval. Means have been observed to change by up
/// to 180 times that rounding.
inline constexpr double coveringRounding = 300;

/// Results to compute for a sequence of blows in addition to the blows themselves, and limits of the
/// computation. The error due to the time step (cellError) and the Lyapunov exponent each require one more
/// computation of the sequence.
struct DrillingRequest {
    /// Whether to estimate the error caused by the time steps (cells). This computes the sequence again with
    /// another time step (see comparedDrillingGridOf()) and, if its motion repeats, from another initial
    /// state.
    bool cellError = true;
    bool lyapunov = true;
    bool blowAlone = true;  ///< whether to solve a single blow from rest for comparison
    std::optional<BlowRange> histories = {};
    /// Maximum work of each single computation of the sequence [time steps × nodes; a node is an end of a
    /// section of the drill string].
    double mostWork = mostDrillingWork;
    /// Number of computations that may run at the same time, each on its own thread; does not change the
    /// results.
    int jobs = 1;
    /// Callback for every blow of the requested sequence, called as soon as the blow is computed. It is not
    /// called for blows that are computed again to estimate errors.
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
    /// States of machine, rod and bit over time during the blows that DrillingRequest::histories selects;
    /// empty if it selects none.
    std::vector<DrillingInstant> instants;
    /// Statistics of the counted blows (those after the transient blows). Empty if the sequence is not
    /// complete, or if the blows push the machine back.
    std::optional<DrillingStatistics> statistics;
    /// Errors of the means caused by the time steps (cells); 0 if not requested. They are found by a repeated
    /// computation with another time step. An error is three times the change of the mean, plus an allowance
    /// for rounding of the interval between blows. If the motion no longer repeats after the same number of
    /// blows, its standard deviation is added.
    std::array<double, blowQuantities.size()> cellErrors{};
    std::optional<Lyapunov> lyapunov;
    DrillingGroups groups;
    /// Single blow from rest for comparison; empty if not requested or not solved.
    std::optional<BlowAlone> alone;
    double meanImpulse = 1;  ///< J, mean impulse of the hammer per blow [units of Problem]
    DrillingLedger ledger;
    /// Error of the momentum balance over all N blows, as a share of the feed impulse N Fe/f. Fe is the
    /// effective feed force, f the blow frequency.
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
    /// Whether the motion is uncertain: a repeated computation with another time step (cell), or another
    /// start, repeats after another number of blows and has another mean penetration. Only known if
    /// DrillingRequest::cellError is set.
    bool cellsDecideMotion = false;
    /// Returns the 95 % error of the mean of a quantity (index in blowQuantities). It is the sum of three
    /// errors: the scatter of batches of blows, the effect of the time step, and 2e-5 of the mean for
    /// transient motion that remains. Empty if only one blow is counted.
    std::optional<double> meanError(std::size_t quantity) const;
    const BlowSpread& spread(std::size_t quantity) const { return statistics->spreads[quantity]; }
};

/// Returns the number of blows that a study computes, for example to show progress. Blows are included that
/// are repeated to estimate the error due to the time step and the Lyapunov exponent.
long foreseenBlows(const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the estimated number of states over time that are recorded for a range of blows (see
/// DrillingResult::instants).
double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range);

/// Returns the estimated work of all computations of a study [time steps × nodes; a node is an end of a
/// section of the drill string].
double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingRequest& wants);

/// Computes a sequence of blows and returns its results. If drillingRefusals() is not empty, the outcome is
/// notSolved and the reason contains these messages.
DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingRequest& wants = {}, const std::stop_token& stop = {},
                             const DrillingProgress& progress = {});

}  // namespace drillwave
