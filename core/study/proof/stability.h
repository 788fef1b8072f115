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

/// Limits of the checks of a case. Each comment gives the cause and size of the worst value observed. A limit
/// is at most ten times that value, so a solver ten times worse fails.
struct StabilityMarks {
    double momentum = 3e-13;  ///< momentum: rounding of sums of 1e6 pieces, 3e-14 observed
    double energy = 4e-10;    ///< energy: soft rock with merged wave pieces, 7e-11 observed
    double pull = 2e-14;      ///< tensile force: a force that has decayed to rounding, 2e-15 observed
    /// Return of the bit after the end: rounding of a distance of order 1, none observed.
    double reach = 1e-14;
    /// Change by neighbouring parameters: where the slope of e is steepest, times 1e-10, 4e-9 observed.
    double change = 4e-8;
    /// Distance from theoretical limits: the constants of the estimates are generous, 0.007 observed.
    double limit = 0.07;
    /// Distance from the lattice: its error estimate is well above the error, 0.3 observed.
    double lattice = 2;
    double bound = 3;  ///< distance from long double: the stated error should be a bound, 0.7 observed
};
inline constexpr StabilityMarks stabilityMarks{};

/// Result of the checks of one case. An empty optional means that the check does not apply, or that the
/// histories were too long to keep.
struct StabilityRow {
    StabilityCase stabilityCase;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< reason why the case was not solved; empty if it was
    double cor = 0;
    double corError = 0;
    long pieces = 0;
    double seconds = 0;  ///< computing time of the solve with Detail::ledger [s]
    /// Difference between the impulse of F and the momentum of the residual waves, as a share of I0.
    double momentumResidual = 0;
    /// Difference between the work W and the energies of rock and waves. A share of W or of F0² t0/Z,
    /// whichever is larger.
    double energyResidual = 0;
    /// Smallest force F, as a share of the peak force; must not be negative, because the rock cannot pull.
    std::optional<double> leastForce;
    /// Largest distance by which the free front end advances towards the rock after the end, in units of
    /// d0/2.
    std::optional<double> reach;
    double change = 0;  ///< change of e if each parameter is changed by a relative 1e-10
    /// Distance of e from its theoretical limit, divided by the difference that theory allows; at most 1 if
    /// correct.
    std::optional<double> limitDistance;
    /// Difference of e from the lattice, divided by the error estimate of the lattice.
    std::optional<double> latticeDistance;
    /// Difference of e from that in long double, divided by the stated errors of both.
    std::optional<double> boundDistance;
    std::vector<Message> failures;  ///< descriptions of the checks that failed

    bool passed() const { return outcome == Outcome::rebounded && failures.empty(); }
};

/// Closeness of a case to failing: the largest ratio of a measure to its limit.
struct StabilityWorst {
    /// Name of the measure with the largest ratio: "momentum", "energy", …; "not solved" if the case was not.
    std::string_view measure;
    double ratio = 0;  ///< at most 1 if the case passes; infinite if it was not solved
};
/// Returns the measure of a case that is closest to its limit, or furthest beyond it.
StabilityWorst worstOf(const StabilityRow& row);

struct StabilityReport {
    std::vector<StabilityRow> rows;  ///< results in the order of the cases
    bool stopped = false;            ///< set if a stop request ended the tests; rows are then missing
    std::size_t notSolved() const;
    /// Returns the number of cases that were solved but failed a check.
    std::size_t failed() const;
};

/// Callback for progress, called on the calling thread with the report so far whenever a case is done.
using StabilityProgress = std::function<void(const StabilityReport& soFar)>;

/// Returns the results of solving and checking every case on `jobs` threads.
StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const StabilityProgress& progress);

}  // namespace drillwave
