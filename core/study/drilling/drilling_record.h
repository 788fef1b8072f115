// SPDX-License-Identifier: GPL-3.0-or-later
// One march of a study of many blows, kept blow by blow.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/text/message.h"
#include "core/wave/drilling/drilling_march.h"
#include "core/wave/drilling/drilling_problem.h"

namespace drillwave {

enum class DrillingOutcome {
    done,
    pushedBack,  ///< the machine is pushed back: no bounded motion
    notSolved,
    stopped,
};
/// "done", "pushed_back", …
std::string_view name(DrillingOutcome outcome);

/// Blows that are recorded in full, from 1.
struct BlowRange {
    long first = 1, last = 1;
};

/// State at one time, by straight lines between the marched ones; in units of Problem.
struct DrillingInstant {
    double time = 0, force = 0, penetration = 0, frontVelocity = 0, rearVelocity = 0, damperForce = 0,
           bodyPlace = 0;
};
inline constexpr std::size_t mostDrillingInstants = 200'000;

/// Called with the number of further blows done; by one thread at a time.
using DrillingProgress = std::function<void(long)>;

/// Result of a march.
struct DrillingRecord {
    std::vector<DrillingBlow> blows;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;
    DrillingLedger ledger;
    double momentumResidual = 0;
    double lateShare = 0;  ///< largest
    std::vector<DrillingInstant> instants;
    std::vector<double> growths;  ///< ln of how a small distance has grown, of each blow
};

/// Permitted work of one march by default [cells × nodes].
inline constexpr double mostDrillingWork = 4e9;

/// Length of a march, and extent of its record.
struct RecordLength {
    long blows;
    double mostWork = mostDrillingWork;  ///< a march that needs more is given up after its first blows
    bool lyapunov = false;
    std::optional<BlowRange> histories = {};
    int jobs = 1;  ///< the march of λ has a thread of its own where they are more
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Called after every blow: true ends the march there because what follows is known.
    std::function<bool(const std::vector<DrillingBlow>&)> stopEarly = {};
};

/// Number of blows with a growing gap, of a machine that is pushed back on their mean, after which the bit is
/// away for ever.
inline constexpr long growingBlows = 50;

/// J, of the last so many blows. Requires blows.
double meanImpulse(const std::vector<DrillingBlow>& blows, std::size_t last);

/// Why a march cannot be kept in memory; empty where it can.
Message memoryProblem(const DrillingProblem& problem, const DrillingGrid& grid);

/// Returns why a march is given up: the work of all blows [cells × nodes]; empty if that is permitted.
/// Requires a blow.
Message workProblem(const DrillingMarch& march, long blows, double mostWork);

DrillingRecord recordOf(const DrillingProblem& problem, const DrillingGrid& grid, const RecordLength& length,
                        const std::stop_token& stop, const DrillingProgress& progress);

}  // namespace drillwave
