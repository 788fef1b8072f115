// SPDX-License-Identifier: GPL-3.0-or-later
// Error against computing time: every method at several resolutions, for one scenario.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/blow/method.h"
#include "core/model/scenario.h"
#include "core/numeric/run_time.h"
#include "core/study/proof/equation_residuals.h"
#include "core/text/message.h"

namespace drillwave {

/// Result of one method at one resolution, with its errors and computing time. Errors are absolute; NaN if
/// unknown.
struct AccuracyRow {
    MethodChoice choice;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< reason why the method did not solve the blow; empty if it did

    double cor = 0;
    /// Absolute difference of e from that of the reference solution. For the exact method, the stated error
    /// of the reference is added.
    double corError = 0;
    double corEstimate = 0;     ///< error of e that the method itself states (Impact::corError)
    double peakForceError = 0;  ///< error of the peak force, in units of F0
    /// Largest error of the force history (L∞), in units of F0 (see ForceDifference::largest).
    double forceError = 0;
    double forceErrorInMiddles = 0;

    long pieces = 0;  ///< number of smooth wave pieces; for a lattice, number of steps
    long events = 0;
    int contacts = 0;

    RunTime time;  ///< computing time of a solve for e only, without an error estimate
    /// Speed relative to the lattice of 10,000 segments used in the paper: median time of that lattice
    /// divided by the median time of this row.
    double speed = 0;
    /// Order of convergence of the error of e, compared with the previous row of the same method.
    double observedOrder = 0;
    /// Whether the results of a lattice with a ring buffer equal, bit for bit, those of the lattice that
    /// moves its waves through memory. True for other methods.
    bool sameAsMoved = true;
};

/// Comparison of the accuracy of all methods for one scenario.
struct Accuracy {
    Groups groups;
    /// Results in the order exact, closed form, lattice with a ring buffer, lattice that moves its waves as
    /// in the paper.
    std::vector<AccuracyRow> rows;
    /// Exact solution, with which all other methods are compared. If it is not solved, there are no rows.
    Impact exact;
    Impact extended;              ///< solution in long double, the reference of the first row
    double extendedTime = 0;      ///< computing time of the long double solution [s]
    int extendedDigits = 0;       ///< number of mantissa bits of long double
    EquationResiduals residuals;  ///< residuals of the equations for the exact histories
    /// Order of convergence of the lattice: least-squares slope of the error of e over all resolutions.
    double latticeOrder = 0;
    bool isStopped = false;  ///< set if a stop request ended the comparison; rows are then missing
    /// Whether all rows are finished, so that the values that need several rows, such as `speed`, are
    /// computed.
    bool isRelated = false;
};

/// Returns the numbers of lattice segments that are compared by default: 100, 200, 500 … 20,000. The paper
/// used 10,000, and 20,000 "for accurate determination".
std::vector<int> latticeLadder();
inline constexpr int paperSegments = 10'000;

/// Returns the estimated work of comparing lattices with these numbers of segments, in moves of a wave by one
/// segment. It counts one solution by each lattice, for a blow of duration t0 and one transit time. The whole
/// study does about 3e7 such moves per second; latticeLadder() has 5.3e8.
double latticeMoves(const std::vector<int>& ladder);

/// Callback for progress, called with the completed share of the work, 0 … 1.
using AccuracyProgress = std::function<void(double done)>;

/// Callback, called with the rows so far whenever one is done. Values that need several rows, such as
/// AccuracyRow::speed, are still missing.
using AccuracyRows = std::function<void(const Accuracy& soFar)>;

/// Returns the accuracy and computing time of all methods for a valid scenario of a uniform rod. `ladder`
/// lists the numbers of lattice segments to compare, ascending. AccuracyRow::speed is known only if they
/// include paperSegments. With latticeLadder() this takes about ten seconds.
Accuracy measureAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                         const std::stop_token& stop = {}, const AccuracyProgress& progress = {},
                         const AccuracyRows& onRow = {});

}  // namespace drillwave
