// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of numerical stability with stiff and extreme cases, by checks that a wrong solution cannot pass.
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

/// Limits of the checks of a test case, each with the largest value observed. A limit is at most about ten
/// times that value, so a solver ten times worse fails.
struct StabilityMarks {
    /// Limit of the momentum residual (StabilityRow::momentumResidual), as a share of I0. The largest value
    /// observed is 3e-14, from rounding of sums of 1e6 pieces.
    double momentum = 3e-13;
    /// Limit of the relative energy residual (StabilityRow::energyResidual). The largest value observed is
    /// 7e-11, for soft rock.
    double energy = 4e-10;
    /// Limit of a tensile force on the rock (StabilityRow::leastForce), as a share of the peak force. The
    /// largest value observed is 2e-15, for a force that has decayed to rounding.
    double pull = 2e-14;
    /// Limit of StabilityRow::reach, the movement of the bit back towards the rock after the last separation,
    /// in units of d0/2. Only rounding of a distance of order 1 is allowed; no such movement was observed.
    double reach = 1e-14;
    /// Limit of StabilityRow::change, the change of e when a parameter changes by a relative 1e-10. The
    /// largest value observed is 4e-9, where e is steepest.
    double change = 4e-8;
    /// Limit of StabilityRow::limitDistance, the difference of e from its theoretical limit divided by the
    /// difference that theory allows. The largest value observed is 0.007, because the theoretical estimates
    /// are generous.
    double limit = 0.07;
    /// Limit of StabilityRow::latticeDistance, the difference of e between exact solver and lattice, relative
    /// to the error that the lattice states. The largest value observed is 0.3, because that estimate is
    /// cautious.
    double lattice = 2;
    /// Limit of StabilityRow::boundDistance, the difference of e from the solution in long double, relative
    /// to the stated errors of both. The largest value observed is 0.7; below 1, the stated errors are
    /// bounds.
    double bound = 3;
};
inline constexpr StabilityMarks stabilityMarks{};

/// Results of all checks of one test case. An optional is empty if its check does not apply to the case, or
/// if the histories were too long to keep.
struct StabilityRow {
    StabilityCase stabilityCase;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< reason why the case was not solved; empty if it was
    double cor = 0;
    double corError = 0;
    long pieces = 0;
    double seconds = 0;  ///< computing time of the solve with Detail::ledger [s]
    /// Error of the momentum balance: impulse of the hammer less the impulse on the rock and the momentum of
    /// the residual waves, as a share of I0.
    double momentumResidual = 0;
    /// Error of the energy balance: difference between the hammer work W and the energies of rock and waves.
    /// It is a share of W or of F0² t0/Z, whichever is larger.
    double energyResidual = 0;
    /// Smallest force on the rock during the blow, as a share of the peak force. It must not be negative,
    /// because the rock cannot pull.
    std::optional<double> leastForce;
    /// Largest distance by which the free bit moves towards the rock after the last separation, in units of
    /// d0/2. It is 0 if the solver did not miss a contact.
    std::optional<double> reach;
    double change = 0;  ///< change of e if each parameter is changed by a relative 1e-10
    /// Difference of e from its theoretical limit for very stiff or very soft rock, divided by the difference
    /// that theory allows; at most 1 if correct.
    std::optional<double> limitDistance;
    /// Difference of e between the exact solver and the lattice, divided by the error that the lattice
    /// states.
    std::optional<double> latticeDistance;
    /// Difference of e from the solution in long double, divided by the stated errors of both solutions.
    std::optional<double> boundDistance;
    std::vector<Message> failures;  ///< descriptions of the checks that failed

    bool passed() const { return outcome == Outcome::rebounded && failures.empty(); }
};

/// Check in which a test case is closest to failing: the one with the largest ratio of its result to its
/// limit.
struct StabilityWorst {
    /// Name of the check with the largest ratio: "momentum", "energy", …; "not solved" if the case was not
    /// solved.
    std::string_view measure;
    /// Largest ratio of a check's result to its limit: at most 1 if the case passes, infinite if it was not
    /// solved.
    double ratio = 0;
};
/// Returns which check of a test case is closest to its limit, or furthest beyond it.
StabilityWorst worstOf(const StabilityRow& row);

struct StabilityReport {
    std::vector<StabilityRow> rows;  ///< results in the order of the cases
    bool stopped = false;            ///< set if a stop request ended the tests; rows are then missing
    std::size_t notSolved() const;
    /// Returns the number of cases that were solved but failed a check.
    std::size_t failed() const;
};

/// Callback for progress, called on the calling thread with the report so far whenever a test case is done.
using StabilityProgress = std::function<void(const StabilityReport& soFar)>;

/// Returns the results of solving and checking every test case, on `jobs` threads.
StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const StabilityProgress& progress);

}  // namespace drillwave
