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

/// Limits of the checks of the exact solver. Each is at most about ten times the largest value observed in
/// the test cases. A solver whose errors are ten times larger therefore fails.
struct StabilityMarks {
    /// Largest absolute StabilityRow::momentumResidual with which a case passes, as a share of I0. The
    /// largest value observed is 3e-14, from rounding of sums of 1e6 pieces of the force history.
    double momentum = 3e-13;
    /// Largest absolute StabilityRow::energyResidual with which a case passes. The largest value observed is
    /// 7e-11, for soft rock.
    double energy = 4e-10;
    /// Largest tensile force on the rock with which a case passes, as a share of the peak force (see
    /// StabilityRow::leastForce). The largest value observed is 2e-15, for a force that has decayed to the
    /// size of rounding errors.
    double pull = 2e-14;
    /// Largest StabilityRow::reach with which a case passes: how far the bit moves towards the rock after the
    /// last separation, in units of d0/2. Only rounding of a distance of order 1 is allowed; no such movement
    /// was observed.
    double reach = 1e-14;
    /// Largest StabilityRow::change with which a case passes: the change of e when one parameter changes by
    /// 1e-10. A case with a large stated error of e is allowed more. The largest change observed is 4e-9,
    /// where e is steepest.
    double change = 4e-8;
    /// Largest StabilityRow::limitDistance with which a case passes. This ratio compares e with its
    /// theoretical value for very stiff or very soft rock. The largest ratio observed is 0.007, because the
    /// differences that theory allows are generous.
    double limit = 0.07;
    /// Largest StabilityRow::latticeDistance with which a case passes. This ratio is the difference of e
    /// between exact solver and lattice, divided by their stated errors. The largest ratio observed is 0.3,
    /// because the lattice states a cautious error.
    double lattice = 2;
    /// Largest StabilityRow::boundDistance with which a case passes. This ratio is the difference of e from
    /// the solution in long double, divided by the stated errors of both. The largest ratio observed is 0.7.
    /// A ratio below 1 means that the difference is within the stated errors.
    double bound = 3;
};
inline constexpr StabilityMarks stabilityMarks{};

/// Results of all checks of the exact solver in one test case. An optional is empty if its check does not
/// apply to the case. The checks of force histories are also omitted if the histories are too long to keep.
struct StabilityRow {
    StabilityCase stabilityCase;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< reason why the case was not solved; empty if it was
    double cor = 0;
    double corError = 0;
    long pieces = 0;
    double seconds = 0;  ///< computing time of the solve with Detail::ledger [s]
    /// Error of the momentum balance, as a share of I0: the impulse of the hammer minus the impulse on the
    /// rock and the momentum of the residual waves.
    double momentumResidual = 0;
    /// Error of the energy balance: difference between the hammer work W and the energies of rock and waves.
    /// It is a share of W or of F0² t0/Z, whichever is larger.
    double energyResidual = 0;
    /// Smallest force on the rock during the blow, as a share of the peak force. It must not be negative,
    /// because the rock cannot pull.
    std::optional<double> leastForce;
    /// Largest distance by which the free bit moves back towards the rock after the last separation, in units
    /// of d0/2. It is 0 if the solution is correct; a larger value shows that the solver missed a contact.
    std::optional<double> reach;
    double change = 0;  ///< largest change of e if one of the parameters is changed by 1e-10
    /// Difference of e from its theoretical value, divided by the difference that theory allows; at most 1 if
    /// correct. Only known for very stiff rock (e → 1), and for very soft rock with a rod without waves (e →
    /// √γ).
    std::optional<double> limitDistance;
    /// Difference of e between the exact solver and the lattice, an independent numerical method. It is
    /// divided by the sum of the errors that both solvers state.
    std::optional<double> latticeDistance;
    /// Difference of e from a solution with long double numbers, divided by the sum of the errors that both
    /// solutions state.
    std::optional<double> boundDistance;
    std::vector<Message> failures;  ///< descriptions of the checks that failed

    bool passed() const { return outcome == Outcome::rebounded && failures.empty(); }
};

/// Check in which a test case is closest to failing. It has the largest ratio of the checked value to its
/// limit in StabilityMarks.
struct StabilityWorst {
    /// Name of the check in which the result is largest relative to its limit: "momentum", "energy", …; "not
    /// solved" if the case was not solved.
    std::string_view measure;
    /// Checked value divided by its limit in StabilityMarks: at most 1 if the case passes, infinite if it was
    /// not solved.
    double ratio = 0;
};
/// Returns the check in which a test case is closest to failing, or fails most clearly.
StabilityWorst worstOf(const StabilityRow& row);

struct StabilityReport {
    std::vector<StabilityRow> rows;  ///< results in the order of the cases
    bool stopped = false;            ///< set if a stop request ended the tests; rows are then missing
    std::size_t notSolved() const;
    /// Returns the number of cases that were solved but whose solution failed a check.
    std::size_t failed() const;
};

/// Callback for progress, called on the calling thread with the report so far whenever a test case is done.
using StabilityProgress = std::function<void(const StabilityReport& soFar)>;

/// Returns the results of a test of the exact solver: solves every case and checks the solution. Uses `jobs`
/// threads.
StabilityReport checkStability(const std::vector<StabilityCase>& cases, int jobs, std::stop_token stop,
                               const StabilityProgress& progress);

}  // namespace drillwave
