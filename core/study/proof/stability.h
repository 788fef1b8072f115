// SPDX-License-Identifier: GPL-3.0-or-later
// Numerical stability: checks that a wrong solution cannot pass, over the stiff and extreme cases.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/study/proof/stability_cases.h"
#include "core/text/message.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Limits that a case must not exceed, each with the cause of the worst value in use. A limit is within ten
/// times that worst value: a solver ten times worse fails.
struct StabilityMarks {
    double momentum = 3e-13;  ///< sums of 1e6 pieces round: 3e-14
    double energy = 4e-10;    ///< of soft rock, with joined pieces of wave: 7e-11
    double pull = 2e-14;      ///< a force that has decayed to rounding: 2e-15
    double reach = 1e-14;     ///< the rounding of a distance of order one; none has been seen
    double change = 4e-8;     ///< where the slope of e is steepest, times 1e-10: 4e-9
    double limit = 0.07;      ///< the constants of the estimates are generous: 0.007
    double lattice = 2;       ///< its error estimate is a factor above the error: 0.3
    double bound = 3;         ///< the stated error should be a bound: 0.7
};
inline constexpr StabilityMarks stabilityMarks{};

/// Case solved and checked. An empty optional: the check does not apply, or the histories were too long to
/// keep.
struct StabilityRow {
    StabilityCase stabilityCase;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< why it was not solved
    double cor = 0;
    double corError = 0;
    long pieces = 0;
    double seconds = 0;                ///< of the solve with Detail::ledger
    double momentumResidual = 0;       ///< of I0: impulse of F against the waves that are left
    double energyResidual = 0;         ///< of the work W or of F0² t0/Z where that is larger: W, rock, waves
    std::optional<double> leastForce;  ///< smallest F, of the peak: the rock cannot pull
    std::optional<double> reach;  ///< farthest the free front end gets towards the rock after the end, d0/2
    double change = 0;            ///< of e over neighbours 1e-10 away in each parameter
    std::optional<double> limitDistance;    ///< |e − limit| over what theory allows, ≤ 1 is right
    std::optional<double> latticeDistance;  ///< |e − e of the lattice| over the lattice's own error estimate
    std::optional<double> boundDistance;    ///< |e − e in long double| over the stated errors of both
    std::vector<Message> failures;          ///< the checks that failed, in words

    bool passed() const { return outcome == Outcome::rebounded && failures.empty(); }
};

/// Distance of a case from failing: the largest of its measures over their limits.
struct StabilityWorst {
    std::string_view measure;  ///< "momentum", "energy" …; "not solved"
    double ratio = 0;          ///< at most 1 where the case passes; infinite where it was not solved
};
StabilityWorst worstOf(const StabilityRow& row);

struct StabilityReport {
    std::vector<StabilityRow> rows;  ///< in the order of the cases
    bool stopped = false;            ///< rows are missing
    std::size_t notSolved() const;
    std::size_t failed() const;  ///< solved, but a check failed
};

/// Called on the calling thread with the report so far, whenever a row is done.
using StabilityProgress = std::function<void(const StabilityReport& soFar)>;

/// Solves and checks every case on `jobs` threads.
StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const StabilityProgress& progress);

}  // namespace drillwave
