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

/// Result of one method at one resolution, with its errors compared with a reference solution, and its
/// computing time. Errors are absolute; NaN if unknown.
struct AccuracyRow {
    MethodChoice choice;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< reason why the method did not solve the blow; empty if it did

    double cor = 0;
    /// Absolute difference of e from that of the reference solution. For the exact solver, the reference is
    /// its solution with long double numbers, whose stated error is added. For all other methods, the
    /// reference is the exact solver.
    double corError = 0;
    double corEstimate = 0;     ///< error of e that the method itself states (Impact::corError)
    double peakForceError = 0;  ///< error of the peak force, in units of F0
    /// Largest error of the history of the force on the rock, in units of F0 (see ForceDifference::largest).
    double forceError = 0;
    double forceErrorInMiddles = 0;

    long pieces = 0;  ///< number of smooth wave pieces; for a lattice, number of steps
    long events = 0;
    int contacts = 0;

    RunTime time;  ///< computing time of a solve for e only, without an error estimate
    /// Speed relative to the lattice of 10,000 segments used in the paper: median time of that lattice
    /// divided by the median time of this row.
    double speed = 0;
    /// Order of convergence p of the error of e, which is proportional to 1/(number of segments)^p. It
    /// follows from this row and the previous row of the same kind of lattice; NaN for the first row of a
    /// kind and for other methods.
    double observedOrder = 0;
    /// Whether the two kinds of lattice have bit for bit the same results with this number of segments. One
    /// kind stores waves in a ring buffer, the other moves them through memory. True for other methods.
    bool sameAsMoved = true;
};

/// Comparison of the accuracy of all methods for one scenario.
struct Accuracy {
    Groups groups;
    /// Results of the methods, in the order: exact solver, closed form, lattice with a ring buffer, lattice
    /// that moves its waves through memory as in the paper.
    std::vector<AccuracyRow> rows;
    /// Exact solution, with which all other methods are compared. If it is not solved, there are no rows.
    Impact exact;
    Impact extended;              ///< solution in long double, the reference of the first row
    double extendedTime = 0;      ///< computing time of the long double solution [s]
    int extendedDigits = 0;       ///< number of mantissa bits of long double
    EquationResiduals residuals;  ///< residuals of the equations for the exact histories
    /// Order of convergence p of the lattice: the error of e is proportional to 1/(number of segments)^p. It
    /// is the least-squares slope of log error over log number of segments.
    double latticeOrder = 0;
    bool isStopped = false;  ///< set if a stop request ended the comparison; rows are then missing
    /// Whether all rows are finished. Only then are the values set that require several rows, such as
    /// AccuracyRow::speed.
    bool isRelated = false;
};

/// Returns the numbers of lattice segments that are compared by default: 100, 200, 500 … 20,000. The paper
/// used 10,000, and 20,000 "for accurate determination".
std::vector<int> latticeLadder();
inline constexpr int paperSegments = 10'000;

/// Returns the estimated work of measureAccuracy() with these numbers of lattice segments, to refuse studies
/// that take too long. The unit is the move of a wave by one segment. One solution of each lattice is
/// counted, over one transit time of a wave in the rod. The whole study does about 3e7 such moves per second;
/// latticeLadder() has 5.3e8.
double latticeMoves(const std::vector<int>& ladder);

/// Callback for progress, called with the completed share of the work, 0 … 1.
using AccuracyProgress = std::function<void(double done)>;

/// Callback that receives the rows finished so far, called after each row. Values that require several rows,
/// such as AccuracyRow::speed, are not yet set.
using AccuracyRows = std::function<void(const Accuracy& soFar)>;

/// Returns the accuracy and computing time of all methods for a valid scenario of a uniform rod. `ladder`
/// lists the numbers of lattice segments to compare, ascending. AccuracyRow::speed is known only if `ladder`
/// includes paperSegments. With latticeLadder() this takes about 10 to 20 s.
Accuracy measureAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                         const std::stop_token& stop = {}, const AccuracyProgress& progress = {},
                         const AccuracyRows& onRow = {});

}  // namespace drillwave
