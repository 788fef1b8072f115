// SPDX-License-Identifier: GPL-3.0-or-later
// Computes a sequence of blows and records it blow by blow.
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
    pushedBack,  ///< machine is pushed back: the motion is not bounded
    notSolved,
    stopped,
};
/// Returns the name of an outcome as in JSON: "done", "pushed_back", …
std::string_view name(DrillingOutcome outcome);

/// Range of blows whose histories are recorded, first and last included, numbered from 1.
struct BlowRange {
    long first = 1, last = 1;
};

/// State of the machine, rod and bit at one time, interpolated linearly between time steps. Values are in the
/// dimensionless units of Problem.
struct DrillingInstant {
    double time = 0, force = 0, penetration = 0, frontVelocity = 0, rearVelocity = 0, damperForce = 0,
           bodyPlace = 0;
};
inline constexpr std::size_t mostDrillingInstants = 200'000;

/// Callback for progress, called with the number of blows computed since the last call; by one thread at a
/// time.
using DrillingProgress = std::function<void(long)>;

/// Record of a sequence of blows: its blows, how it ended, balances, and data recorded on request.
struct DrillingRecord {
    std::vector<DrillingBlow> blows;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;
    DrillingLedger ledger;
    double momentumResidual = 0;
    /// Largest impulse of the hammer on the string after their first separation, as a share of the hammer
    /// momentum. It is the maximum of DrillingMarch::lateShare() over all blows.
    double lateShare = 0;
    std::vector<DrillingInstant> instants;
    /// Natural logarithm of the factor by which a small deviation of the motion grows, for each blow. Used
    /// for the Lyapunov exponent; empty if that is not requested.
    std::vector<double> growths;
};

/// Default maximum work of one sequence of blows [time steps × nodes, which are ends of sections].
inline constexpr double mostDrillingWork = 4e9;

/// Length of a sequence of blows, what is recorded of it, and limits of the computation.
struct RecordLength {
    long blows;
    /// Maximum work [time steps × nodes, which are ends of sections]. A sequence estimated to need more is
    /// abandoned after its first blows.
    double mostWork = mostDrillingWork;
    bool lyapunov = false;
    std::optional<BlowRange> histories = {};
    /// Number of threads, ≥ 1. With more than one, the deviation for the Lyapunov exponent is computed on its
    /// own thread.
    int jobs = 1;
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Callback after every blow, with all blows so far. It returns true to end the sequence early, if no
    /// further blows are needed.
    std::function<bool(const std::vector<DrillingBlow>&)> stopEarly = {};
};

/// Number of successive blows with growing gaps after which the bit may be taken to have left the rock for
/// good. In addition, the feed impulse per blow must not exceed the mean impulse of the hammer in these
/// blows.
inline constexpr long growingBlows = 50;

/// Returns J, the mean impulse that the hammer transfers to the string in the last `last` blows, in the
/// dimensionless units of Problem. Requires at least one blow.
double meanImpulse(const std::vector<DrillingBlow>& blows, std::size_t last);

/// Returns a message if a sequence of blows would need too much memory; empty otherwise.
Message memoryProblem(const DrillingProblem& problem, const DrillingGrid& grid);

/// Returns a message if `blows` blows, judged by those already computed, would need more than `mostWork`
/// [time steps × nodes]; empty otherwise. Requires that at least one blow is computed.
Message workProblem(const DrillingMarch& march, long blows, double mostWork);

/// Computes a sequence of blows and returns its record. DrillingRecord::outcome states whether it ended
/// early, such as by a stop request.
DrillingRecord recordOf(const DrillingProblem& problem, const DrillingGrid& grid, const RecordLength& length,
                        const std::stop_token& stop, const DrillingProgress& progress);

}  // namespace drillwave
