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
    /// Limit of the momentum residual, as a share of I0. The largest value observed is 3e-14, from rounding
    /// of sums of 1e6 pieces.
    double momentum = 3e-13;
    /// Limit of the relative energy residual. The largest value observed is 7e-11, for soft rock with merged
    /// wave pieces.
    double energy = 4e-10;
    /// Limit of a tensile force on the rock, as a share of the peak force. The largest value observed is
    /// 2e-15, for a force that has decayed to rounding.
    double pull = 2e-14;
    /// Limit of the distance by which the bit moves back towards the rock after the last separation, in units
    /// of d0/2. It allows for rounding of a distance of order 1; no such return was observed.
    double reach = 1e-14;
    /// Limit of the change of e when a parameter changes by a relative 1e-10. The largest value observed is
    /// 4e-9, where e is steepest.
    double change = 4e-8;
    /// Limit of the difference between e and its theoretical limit, divided by the difference that theory
    /// allows. The largest value observed is 0.007, because the theoretical estimates are generous.
    double limit = 0.07;
    /// Limit of the difference of e from the lattice, relative to the error estimate of the lattice. The
    /// largest value observed is 0.3, because that estimate is cautious.
    double lattice = 2;
    /// Limit of the difference of e from that in long double, relative to the stated errors of both. The
    /// largest value observed is 0.7; below 1, the stated error is a bound.
    double bound = 3;
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
    /// Difference between the work W and the energies of rock and waves, as a share of W or of F0² t0/Z,
    /// whichever is larger.
    double energyResidual = 0;
    /// Smallest force F, as a share of the peak force; must not be negative, because the rock cannot pull.
    std::optional<double> leastForce;
    /// Largest distance by which the free bit moves towards the rock after the last separation, in units of
    /// d0/2; 0 if the blow ended correctly.
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
    /// Largest ratio of a measure to its limit: at most 1 if the case passes, infinite if it was not solved.
    double ratio = 0;
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
