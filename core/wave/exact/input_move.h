// SPDX-License-Identifier: GPL-3.0-or-later
// How far the result of a blow hangs on the last digits of its input (theory §11.2).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Moves the input by a few units of rounding, β(1 + beta·ε) and τ(1 + tau·ε), ε of the arithmetic in use.
struct InputMove {
    int beta = 0;
    int tau = 0;
};

/// Rounding made in one contact is multiplied by the contacts that follow: where the bit chatters, e may have
/// few digits or none although each step was right to the last one. Up to this growth (Impact::growth, a
/// worst case) the rounding that a march sums up, multiplied by it, covers it.
inline constexpr double coveredGrowth = 8;

/// Rounding of e in a march without that growth, whatever it sums up: an upper bound of all cases seen.
inline constexpr double ordinaryRounding = 1e-13;

/// Returns whether the rounding of a solved blow may have grown beyond its stated error.
inline bool mayOutgrowItsError(const Impact& impact) {
    return impact.growth > coveredGrowth && impact.growth * ordinaryRounding > impact.corError;
}

/// Returns the error of e due to the rounding of a given hammer force; the rock may reflect it once.
inline double roundingOfHammer(const PulseForce& hammer) {
    return 2 * hammer.rounding;
}

/// Raises impact.corError, the error that a march has summed up, to cover its growth in contacts.
///
/// Where contacts may have multiplied it by more than is covered, a single march cannot show how much of that
/// growth is real, but a second one with moved input grows in the same way: solve(InputMove) marches again
/// for e only. Where a moved blow cannot be solved, neither is the impact.
///
/// β and τ are moved together, 16 ε up and down, since moves that keep βτ may have little effect; the second
/// move is left out if the first changes far less than is stated anyway, for a small change may be luck.
/// Eight times the larger change, added to the sum, covers the error of more than 999 in 1000 chattering
/// blows (tst_chatter).
template <class Solve>
void coverGrowth(Impact& impact, const Solve& solve) {
    if (impact.outcome != Outcome::rebounded) return;
    const bool mayOutgrow = mayOutgrowItsError(impact);
    const double rounding = std::min(impact.corError, ordinaryRounding);
    impact.corError += (std::min(impact.growth, coveredGrowth) - 1) * rounding;
    if (!mayOutgrow) return;
    constexpr std::array moves{InputMove{16, 16}, InputMove{-16, -16}};
    constexpr double factor = 8, luck = 4;
    double change = 0;
    for (const InputMove& move : moves) {
        const Impact moved = solve(move);
        if (moved.outcome != Outcome::rebounded) {
            impact.outcome = Outcome::notSolved;
            impact.reason = moved.reason;
            impact.hindrance = moved.hindrance;
            return;
        }
        change = std::max(change, std::abs(moved.cor - impact.cor));
        if (luck * factor * change <= impact.corError) break;  // what grows is too little to count
    }
    impact.corError += factor * change;
    // The march has proven that no contact follows with its own error of the momentum −e. With the grown one
    // that is undecided for a rod nearly at rest: what the rock could still give it is of that size too.
    if (impact.cor <= impact.corError) impact.corError *= 3;
}

}  // namespace drillwave
