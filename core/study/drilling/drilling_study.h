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

/// What other cells change, twice or half as large, counts so often.
inline constexpr double coveringCells = 3;

/// A relative rounding of the interval has changed means by up to 180 times as much, which no other cells
/// show.
inline constexpr double coveringRounding = 300;

/// What is wanted beside the blows: each march costs one of its own.
struct DrillingWants {
    bool cellError = true;  ///< the same with other cells, see comparedDrillingGridOf()
    bool lyapunov = true;
    bool blowAlone = true;  ///< the single blow that it is compared with
    std::optional<BlowRange> histories = {};
    double mostWork = mostDrillingWork;  ///< of each march [cells times nodes]
    int jobs = 1;  ///< marches that may run side by side, each on a thread; what comes out is the same
    /// Told every blow of the march itself, as soon as it is done.
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Asked after every blow of the march itself: whether what follows is known. Then it ends there, and
    /// there are no statistics.
    std::function<bool(const std::vector<DrillingBlow>&)> isEnough = {};
};

struct DrillingResult {
    Scenario scenario;
    DrillingSettings settings;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;  ///< where it is not done
    std::vector<DrillingBlow> blows;
    std::vector<DrillingInstant> instants;  ///< of the blows that are told in full
    /// Nothing where nothing bounded comes of it.
    std::optional<DrillingStatistics> statistics;
    /// Of the means, three times what other cells change; 0 where that was not wanted.
    std::array<double, blowQuantities.size()> cellErrors{};
    std::optional<Lyapunov> lyapunov;
    DrillingGroups groups;
    /// Nothing where it was not wanted, or is not solved.
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
    bool cellsDecideMotion = false;  ///< other cells come to another motion
    /// Of a mean, by batches and cells, and what it may still settle by; nothing where any is not known.
    std::optional<double> meanError(std::size_t quantity) const;
    const BlowSpread& spread(std::size_t quantity) const { return statistics->spreads[quantity]; }
};

/// Blows of all marches of a study.
long foreseenBlows(const DrillingSettings& settings, const DrillingWants& wants);

/// How many instants that many blows have.
double foreseenInstants(const Scenario& scenario, const DrillingSettings& settings, const BlowRange& range);

/// What it takes, in cells times nodes.
double drillingWork(const Scenario& scenario, const DrillingSettings& settings, const DrillingWants& wants);

/// Not solved where there are drillingRefusals(), which are the reason.
DrillingResult studyDrilling(const Scenario& scenario, const DrillingSettings& settings,
                             const DrillingWants& wants = {}, const std::stop_token& stop = {},
                             const DrillingProgress& progress = {});

}  // namespace drillwave
