// SPDX-License-Identifier: GPL-3.0-or-later
// Many blows of a scenario, with what they come to (drilling §5).
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

/// The groups of many blows (drilling §5).
struct DrillingGroups {
    double phi = 0;                      ///< Fe/(f I0), of a string with the mean J
    double roundTrips = 0;               ///< n_b
    double mu = 0, zeta = 0, kappa = 0;  ///< of machine and damper; 0 without
    Groups blow;
};

/// λ per blow, with its 95 % error.
struct Lyapunov {
    double value = 0;
    std::optional<double> error;
};

/// Factor of the change caused by other cells, twice or half as large, in stated errors.
inline constexpr double coveringCells = 3;

/// Factor of a relative rounding of the interval in stated errors: it has changed means by up to 180 times as
/// much, which other cells do not show.
inline constexpr double coveringRounding = 300;

/// Requested results besides the blows: each march costs one of its own.
struct DrillingRequest {
    bool cellError = true;  ///< from other cells, see comparedDrillingGridOf()
    bool lyapunov = true;
    bool blowAlone = true;  ///< the single blow for comparison
    std::optional<BlowRange> histories = {};
    double mostWork = mostDrillingWork;  ///< of each march [cells times nodes]
    int jobs = 1;  ///< marches that may run side by side, each on a thread; does not change the results
    /// Called with every blow of the march itself, as soon as it is done.
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Called after every blow of the march itself; true ends the march there because what follows is known.
    /// Then there are no statistics.
    std::function<bool(const std::vector<DrillingBlow>&)> stopEarly = {};
};

struct DrillingResult {
    Scenario scenario;
    DrillingSettings settings;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;  ///< if it is not done
    std::vector<DrillingBlow> blows;
    std::vector<DrillingInstant> instants;  ///< of the blows that are recorded in full
    /// Nothing if the motion is not bounded.
    std::optional<DrillingStatistics> statistics;
    /// Errors of the means, three times the change by other cells; 0 if not requested.
    std::array<double, blowQuantities.size()> cellErrors{};
    std::optional<Lyapunov> lyapunov;
    DrillingGroups groups;
    /// Nothing if not requested, or not solved.
    std::optional<BlowAlone> alone;
    double meanImpulse = 1;  ///< J [units of Problem]
    DrillingLedger ledger;
    double momentumResidual = 0;  ///< over N Fe/f
    double energyResidual = 0;    ///< over the hammer work
    double frequencyUsed = 0;     ///< [Hz]
    double cellsPerDuration = 0;  ///< that were taken
    std::vector<Alert> alerts;
    DrillingUnits units;
    Scales scales;
    double runTime = 0;  ///< [s]

    bool hasLoss = false;            ///< waves fade
    bool hasWholeTrips = true;       ///< the round trips of all sections are whole cells
    bool cellsDecideMotion = false;  ///< other cells give another motion
    /// Returns the error of a mean: from batches, cells and transients; nothing if any is unknown.
    std::optional<double> meanError(std::size_t quantity) const;
    const BlowSpread& spread(std::size_t quantity) const { return statistics->spreads[quantity]; }
};

/// Blows of all marches of a study.
long foreseenBlows(const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns the number of instants of that many blows.
double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range);

/// Returns the estimated work [cells × nodes].
double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingRequest& wants);

/// Returns no solution if there are drillingRefusals(), which are the reason.
DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingRequest& wants = {}, const std::stop_token& stop = {},
                             const DrillingProgress& progress = {});

}  // namespace drillwave
