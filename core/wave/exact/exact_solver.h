// SPDX-License-Identifier: GPL-3.0-or-later
// Exact, event-driven solution of the delay equation of the front end (theory §3).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Default limit of the number of wave pieces for one blow, and the largest limit that may be set. A piece
/// takes 0.05 to 1.5 µs, so the default stops the most expensive blows after one or two seconds. Nearly all
/// blows take less than a thousand pieces.
inline constexpr long defaultWorkLimit = 1'000'000, mostWorkLimit = 30'000'000;

/// Solver for blows on a uniform rod, exact except for rounding, which reuses its memory. With Detail::cor it
/// allocates nothing after the first blows. Each thread needs its own solver.
///
/// There are two representations of the waves. Exponential sums (ExponentialBasis) need few pieces of waves;
/// they are used if reflections are few. Power series on short pieces (SeriesBasis) are used if the sums are
/// unsuitable, inaccurate or do not reach the end. One of them solves the whole blow, for any detail, and
/// ends with the proof of theory §3.3. Detail::summary takes hardly longer than Detail::cor.
///
/// Accuracy: the error of the coefficient of restitution e is at most corError in at least 99 % of blows, for
/// any number of contacts. corError is typically 1e-15 to 1e-13. On soft rock, where a wave meets the rock
/// hundreds of times in one blow, it grows to 1e-9. This concerns βτ below 1e-5, or γ below 0.01 with β below
/// 1e-4. It is not much larger for 1e-7 ≤ β ≤ 1e9, γ ≥ 1e-6, 0.05 ≤ τ ≤ 1000. Exceptions are blows with tens
/// of contacts (exponential and piston blows on short rods). There each contact multiplies the rounding of
/// those before, and e depends on the last digits of the input; corError states by how much.
///
/// Work: a blow typically takes 5 to 300 pieces of waves. Soft rock with γ < 1e-3 takes most, because each of
/// thousands of round trips leaves kinks: up to 1e7 pieces and half a second. Tables of many points with γ <
/// 1e-5 take even more. Many pieces are also needed by blows of many t0 on stiff rock with a short rod, where
/// every wave front leaves a layer. Blows that may multiply rounding (Impact::growth) are solved up to three
/// times.
class ExactSolver {
  public:
    /// Creates a solver. `mostPieces` is the maximum number of pieces of one solution, at 0.05 to 0.3 µs
    /// each; a blow that needs more is not solved.
    explicit ExactSolver(long mostPieces = mostWorkLimit);
    ~ExactSolver();
    ExactSolver(ExactSolver&&) noexcept;
    ExactSolver& operator=(ExactSolver&&) noexcept;

    /// Returns the solution of a blow. Requires β > 0, 0 < γ ≤ 1, τ > 0, δ ≥ 0, all finite, and a force on a
    /// uniform rod (rodRefusal()). A stop request ends it within milliseconds as not solved.
    Impact solve(const Problem& problem, Detail detail = Detail::cor, const std::stop_token& stop = {});

    /// Omits the sums of Detail::ledger in all later solutions with Detail::histories, where they double the
    /// computing time.
    void leaveOutLedger() { m_ledger = false; }

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
    long m_mostPieces;
    bool m_ledger = true;
};

// Histories that are too long to be kept, evaluated while they are computed

/// Function that evaluates the recorded histories of a blow while it is solved. It may remove any part of
/// them from their beginning. It returns the number of recorded pieces at which it is to be called again.
using HandOver = std::function<std::size_t(Impact&)>;

/// Number of wave pieces above which histories are not kept, but evaluated during the computation; that many
/// take 90 MB. Solutions with exponential sums have fewer.
inline constexpr long mostPiecesKept = 100'000;

/// Number of recorded wave pieces (each a short time with one formula) after which the solver calls HandOver
/// for the first time, which evaluates them.
inline constexpr std::size_t piecesHandedOver = 20'000;

/// Returns the solution of a blow whose histories are too long to be kept. They are passed to `handOver` in
/// parts during the computation; the result contains only their last part. Requires that ExactSolver has
/// solved the blow with `pieces` wave pieces, more than mostPiecesKept. Power series are used.
Impact marchInPassing(const Problem& problem, long pieces, const HandOver& handOver,
                      const std::stop_token& stop);

// Exact solution in extended precision

/// Returns the solution of a blow by the method of ExactSolver, always with power series and in long double
/// (on x86, 64 bits of mantissa instead of 53). It is several times slower. corError holds for this
/// arithmetic, including the effect of a changed input (input_move.h). For blows with many contacts, long
/// double has few digits more than double.
///
/// The difference from ExactSolver shows its rounding and truncation, and the errors of its exponential sums
/// where it uses them. It does not show mistakes in the order or kind of events, because both use the same
/// code (ContactMarch). equationResiduals() does.
Impact solveInExtendedPrecision(const Problem& problem, Detail detail = Detail::cor,
                                const std::stop_token& stop = {});

}  // namespace drillwave
