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
    /// Absolute error of e, |e − e of the reference|; for the exact method, plus the error of the reference.
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
    /// Whether all results of the lattice in a ring equal, bit for bit, those of the lattice that moves its
    /// waves through memory.
    bool sameAsMoved = true;
};

/// Comparison of the accuracy of all methods for one scenario.
struct Accuracy {
    Groups groups;
    /// Rows in the order exact, closed form, lattice in a ring, lattice as in the paper.
    std::vector<AccuracyRow> rows;
    /// Exact solution, the reference of the other rows; if it is notSolved, there are no rows.
    Impact exact;
    Impact extended;              ///< solution in long double, the reference of the first row
    double extendedTime = 0;      ///< computing time of the long double solution [s]
    int extendedDigits = 0;       ///< number of mantissa bits of long double
    EquationResiduals residuals;  ///< residuals of the equations for the exact histories
    /// Order of convergence of the lattice: least-squares slope of the error of e over all resolutions.
    double latticeOrder = 0;
    bool isStopped = false;  ///< set if a stop request ended the comparison; rows are then missing
    /// Whether all rows are solved and the values that need several rows are computed.
    bool isRelated = false;
};

/// Returns the numbers of lattice segments to compare: 100, 200, 500 … 20,000. The paper used 10,000, and
/// 20,000 "for accurate determination".
std::vector<int> latticeLadder();
inline constexpr int paperSegments = 10'000;

/// Returns the work of a list of lattice resolutions, in moves of a wave by one segment. Each row is counted
/// once, for a blow of duration t0 and one transit time. The whole study does about 3e7 moves per second;
/// latticeLadder() has 5.3e8.
double latticeMoves(const std::vector<int>& ladder);

/// Callback for progress, called with the completed share of the work, 0 … 1.
using AccuracyProgress = std::function<void(double done)>;

/// Callback, called with the rows so far whenever one is done. Values that need several rows are still
/// missing.
using AccuracyRows = std::function<void(const Accuracy& soFar)>;

/// Returns the accuracy and computing time of all methods for a valid scenario. `ladder` lists numbers of
/// segments in ascending order. Speeds are known only if it contains paperSegments. latticeLadder() takes
/// about ten seconds, mostly for the lattice as in the paper.
Accuracy measureAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                         const std::stop_token& stop = {}, const AccuracyProgress& progress = {},
                         const AccuracyRows& onRow = {});

}  // namespace drillwave
