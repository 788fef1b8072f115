// SPDX-License-Identifier: GPL-3.0-or-later
// The event-driven exact solution of the scalar delay equation (theory §3).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/wave/impact.h"
#include "core/wave/problem.h"

namespace drillwave {

/// Default and maximum number of wave pieces of one blow. A piece takes 0.05 to 1.5 µs: the costliest blow is
/// given up after one or two seconds, and nearly all take less than a thousand pieces.
inline constexpr long defaultWorkLimit = 1'000'000, mostWorkLimit = 30'000'000;

/// Solves one blow after another, keeping its workspace: no heap allocation per solve once warm with
/// Detail::cor. One solver per thread.
///
/// Two representations of the waves: exponential sums, one piece from front to front (ExponentialBasis),
/// where reflections are few; power series on short pieces (SeriesBasis) where the sums do not suit, lose
/// digits or do not reach an end. A single one solves the whole blow, for any detail, and ends on the proof
/// of theory §3. Detail::summary costs hardly more than Detail::cor.
///
/// Accuracy: |error of e| ≤ corError in at least 99 % of blows, for every number of contacts. It is of the
/// order of 1e-15 to 1e-13. It grows to 1e-9 on soft rock, where a wave meets the rock hundreds of times in
/// one blow (JoiningBudget: βτ below 1e-5, or γ below 0.01 and β below 1e-4), and stays about there for
/// 1e-7 ≤ β, γ ≥ 1e-6 (0.05 ≤ τ ≤ 1000). It stays below for β ≤ 1e9, too, but for blows
/// of tens of contacts (exponential and piston blows on short rods): each contact multiplies the rounding of
/// those before, e depends on the last digits of the input, and corError says how far.
/// Work: typically 5 to 300 pieces. Most are needed by soft rock with γ < 1e-3, where every one of thousands
/// of round trips leaves kinks (up to 1e7, and half a second; for tables of many points and γ < 1e-5 more),
/// and by blows of many t0 on stiff rock and a short rod, where every front leaves a layer. Blows that may
/// multiply rounding (Impact::growth) are solved up to three times.
class ExactSolver {
  public:
    /// `mostPieces` bounds the work of one solve (0.05 to 0.3 µs each): beyond it the outcome is notSolved.
    explicit ExactSolver(long mostPieces = mostWorkLimit);
    ~ExactSolver();
    ExactSolver(ExactSolver&&) noexcept;
    ExactSolver& operator=(ExactSolver&&) noexcept;

    /// Solves a problem (β > 0, 0 < γ ≤ 1, τ > 0, δ ≥ 0, all finite). A stop
    /// ends it within milliseconds as notSolved.
    Impact solve(const Problem& problem, Detail detail = Detail::cor, const std::stop_token& stop = {});

    /// Omits the sums of Detail::ledger with Detail::histories from now on; they double the time.
    void leaveOutLedger() { m_ledger = false; }

  private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
    long m_mostPieces;
    bool m_ledger = true;
};

// Histories too long to be kept, looked at while they are made.

/// Takes as much as it likes out of the histories of an impact that is being solved, from their beginning,
/// and returns how many pieces they should have when it is called again.
using HandOver = std::function<std::size_t(Impact&)>;

/// Pieces above which histories are too long to be kept for some numbers: 90 MB. Closed forms have fewer.
inline constexpr long mostPiecesKept = 100'000;

/// Number of pieces in the first hand-over.
inline constexpr std::size_t piecesHandedOver = 20'000;

/// Solves a blow again that ExactSolver has solved in `pieces`, more than mostPiecesKept and so in power
/// series, and passes its histories to `handOver`. The impact returned has the rest of them.
Impact marchInPassing(const Problem& problem, long pieces, const HandOver& handOver,
                      const std::stop_token& stop);

// Exact solution in extended precision.

/// Solves like ExactSolver, but always in power series and in long double: 64 bits of mantissa instead of 53
/// on x86. Several times slower. corError holds for that arithmetic, moved inputs included (input_move.h):
/// where the bit chatters, long double has few digits more than double.
///
/// The difference to ExactSolver shows its rounding and truncation, and the errors of its closed exponential
/// pieces where it uses them. It does not show mistakes in the order or kind of events, because both march
/// with the same code (ContactMarch). equationResiduals() does.
Impact solveInExtendedPrecision(const Problem& problem, Detail detail = Detail::cor,
                                const std::stop_token& stop = {});

}  // namespace drillwave
