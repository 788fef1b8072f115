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

/// Range of the blows of a sequence whose histories are recorded, from `first` to `last` inclusive. Blows are
/// numbered from 1.
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

/// Callback for progress, called with the number of blows computed since the last call. Only one thread calls
/// it at a time.
using DrillingProgress = std::function<void(long)>;

/// Record of a sequence of blows: the blows, how the sequence ended, momentum and energy balances, and data
/// recorded on request.
struct DrillingRecord {
    std::vector<DrillingBlow> blows;
    DrillingOutcome outcome = DrillingOutcome::done;
    Message reason;
    DrillingLedger ledger;
    double momentumResidual = 0;
    /// Largest impulse that the hammer gives the drill string after their first separation in a blow, as a
    /// share of the hammer momentum. It is the maximum of DrillingMarch::lateShare() over all blows.
    double lateShare = 0;
    std::vector<DrillingInstant> instants;
    /// Growth of a small deviation of the motion in each blow, as the natural logarithm of the factor. The
    /// mean is the Lyapunov exponent. Empty if that is not requested.
    std::vector<double> growths;
};

/// Default maximum work of one sequence of blows [time steps × nodes; a node is an end of a section of the
/// drill string].
inline constexpr double mostDrillingWork = 4e9;

/// Number of blows to compute, data to record, and limits of the computation.
struct RecordLength {
    long blows;
    /// Maximum work [time steps × nodes; a node is an end of a section of the drill string]. After the first
    /// blows the total is estimated; if it is larger than this, the computation ends.
    double mostWork = mostDrillingWork;
    bool lyapunov = false;
    std::optional<BlowRange> histories = {};
    /// Number of threads, ≥ 1. With more than one, a second thread computes the disturbed motion that the
    /// Lyapunov exponent requires.
    int jobs = 1;
    std::function<void(const DrillingBlow&)> onBlow = {};
    /// Callback after every blow, with all blows so far. It returns true to end the sequence early, if the
    /// caller needs no further blows.
    std::function<bool(const std::vector<DrillingBlow>&)> stopEarly = {};
};

/// Number of successive blows with growing gaps after which the computation may decide that the bit has left
/// the rock for good. It does so only if the feed impulse per blow is not larger than the mean impulse of the
/// hammer in these blows.
inline constexpr long growingBlows = 50;

/// Returns the mean impulse J that the hammer transfers to the drill string, over the last `last` blows, in
/// the dimensionless units of Problem. Requires at least one blow.
double meanImpulse(const std::vector<DrillingBlow>& blows, std::size_t last);

/// Returns an error message if a sequence of blows would need too much memory; empty otherwise.
Message memoryProblem(const DrillingProblem& problem, const DrillingGrid& grid);

/// Returns an error message if a sequence of `blows` blows would need more than `mostWork` [time steps ×
/// nodes]; empty otherwise. The work is estimated from the blows that are already computed. Requires at least
/// one of them.
Message workProblem(const DrillingMarch& march, long blows, double mostWork);

/// Computes a sequence of blows and returns its record. If it ends early, DrillingRecord::outcome shows why,
/// for example a stop request. An end by RecordLength::stopEarly leaves the outcome `done`.
DrillingRecord recordOf(const DrillingProblem& problem, const DrillingGrid& grid, const RecordLength& length,
                        const std::stop_token& stop, const DrillingProgress& progress);

}  // namespace drillwave
