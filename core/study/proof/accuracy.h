// SPDX-License-Identifier: GPL-3.0-or-later
// Error against run time: every method over a ladder of resolutions, for one scenario.
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

/// A method at one resolution. Errors are absolute; NaN if unknown.
struct AccuracyRow {
    MethodChoice choice;
    Outcome outcome = Outcome::notSolved;
    Message reason;  ///< when not solved

    double cor = 0;
    double corError = 0;        ///< |e − e of the reference|, plus the error of that for the exact method
    double corEstimate = 0;     ///< error stated by the method (Impact::corError)
    double peakForceError = 0;  ///< F0
    double forceError = 0;      ///< L∞ of the force history, F0 (ForceDifference::largest)
    double forceErrorInMiddles = 0;

    long pieces = 0;  ///< smooth pieces; steps of a lattice
    long events = 0;
    int contacts = 0;

    RunTime time;              ///< of a solve for e only, without estimate of the error
    double speed = 0;          ///< median time of the paper's choice over that of this row
    double observedOrder = 0;  ///< of the error in e, from the row before it on the ladder
    bool sameAsMoved = true;   ///< ring: all numbers are equal, to the last bit, to those with moved waves
};

/// Accuracy of all methods for one scenario.
struct Accuracy {
    Groups groups;
    std::vector<AccuracyRow> rows;  ///< exact, closed form, lattice in a ring, lattice as in the paper
    Impact exact;                   ///< the reference of the other rows; notSolved: there are no rows
    Impact extended;                ///< the reference of the first row, in long double
    double extendedTime = 0;        ///< s
    int extendedDigits = 0;         ///< bits of mantissa
    EquationResiduals residuals;    ///< of the exact histories
    double latticeOrder = 0;        ///< least-squares slope of the error in e over the whole ladder
    bool isStopped = false;         ///< rows are missing
    bool isRelated = false;         ///< all rows are solved, and the values that need several of them
};

/// The ladder of the lattice: 100, 200, 500 … 20 000 segments. The paper used the last but one, 10 000, and
/// the last one "for accurate determination".
std::vector<int> latticeLadder();
inline constexpr int paperSegments = 10'000;

/// Returns the work of the lattices of a ladder, in moves of a wave by a segment, each row solved once for a
/// blow of one t0 and one transit time: about 3e7 a second of the whole study. 5.3e8 for latticeLadder().
double latticeMoves(const std::vector<int>& ladder);

/// Called with the share of the work that is done, 0 … 1.
using AccuracyProgress = std::function<void(double done)>;

/// Called with the rows so far whenever one is done; values that need several rows are missing.
using AccuracyRows = std::function<void(const Accuracy& soFar)>;

/// Solves, compares and measures. `scenario` must be valid; `ladder` holds numbers of segments in growing
/// order. Speeds are known only if it holds paperSegments. latticeLadder() takes some ten seconds, most of it
/// for moved waves.
Accuracy measureAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                         const std::stop_token& stop = {}, const AccuracyProgress& progress = {},
                         const AccuracyRows& onRow = {});

}  // namespace drillwave
