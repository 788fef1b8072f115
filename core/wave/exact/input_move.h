// SPDX-License-Identifier: GPL-3.0-or-later
// Sensitivity of the result of a blow to the last digits of its input (theory §11.2).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/pulse_force.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Change of the input by a few units of rounding: β(1 + beta·ε) and τ(1 + tau·ε), with the machine epsilon
/// ε.
struct InputMove {
    int beta = 0;
    int tau = 0;
};

/// Growth of rounding errors (Impact::growth, a worst case) up to which the stated error is multiplied by the
/// growth. If the growth is larger, the blow is solved again with changed input. With many contacts, the
/// coefficient of restitution may have few correct digits or none.
inline constexpr double coveredGrowth = 8;

/// Upper bound of the rounding error of the coefficient of restitution if contacts do not amplify it; no
/// tested blow exceeded this value.
inline constexpr double ordinaryRounding = 1e-13;

/// Returns whether the real error of a solved blow, after the growth of rounding errors, may exceed
/// impact.corError.
inline bool mayOutgrowItsError(const Impact& impact) {
    return impact.growth > coveredGrowth && impact.growth * ordinaryRounding > impact.corError;
}

/// Returns the error of the coefficient of restitution caused by the rounding of the points of a hammer force
/// given as a table; 0 for other forces. The factor of two allows for one reflection by the rock.
inline double roundingOfHammer(const PulseForce& hammer) {
    return 2 * hammer.rounding;
}

/// Raises impact.corError so that it covers the growth of rounding errors in contacts.
///
/// If the worst-case growth (Impact::growth) is at most coveredGrowth, the error is multiplied by it. If it
/// is larger, solve(InputMove) solves the blow again with slightly changed input. The change of the
/// coefficient of restitution e then shows how much of the growth is real. If the changed blow cannot be
/// solved, `impact` becomes not solved.
///
/// β and τ are changed together, by 16 ε up and down (machine epsilon ε), since changes that keep βτ may have
/// little effect. The second change is left out if the first one has far less effect than the stated error. A
/// small effect may be chance. So eight times the larger change of e is added to the error; this covers more
/// than 999 in 1000 blows with many contacts (tst_chatter).
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
        if (luck * factor * change <= impact.corError) break;  // the change is negligible
    }
    impact.corError += factor * change;
    // It was proven that no contact follows, with the error of the momentum −e before it was raised. With the
    // raised error this is undecided for a rod nearly at rest. The impulse of a further contact would be as
    // small as that error, so it is covered by a factor of 3.
    if (impact.cor <= impact.corError) impact.corError *= 3;
}

}  // namespace drillwave
