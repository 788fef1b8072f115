// SPDX-License-Identifier: GPL-3.0-or-later
// What a rod does between blows if nothing damps its rebound.
#pragma once

namespace drillwave {

/// The steady motion of a rigid rod that is struck f times a second, is pressed by a constant force and
/// rebounds with e (theory §10).
struct UndampedMotion {
    enum class Kind {
        pushedBack,  ///< φ ≤ 1: the blows push the machine back, and no steady motion is left
        bouncing,  ///< 1 < φ < (1+e)/(1−e): one impact per blow, the bit off the rock when the hammer strikes
        resting,  ///< beyond: it has come to rest on the rock before every blow
    };
    Kind kind = Kind::pushedBack;
    double impactVelocity = 0;  ///< V [v0] (T36), of Kind::bouncing
    double delay = 0;           ///< a, from a blow to the impact [1/f] (T36), of Kind::bouncing
    double gap = 0;             ///< y ≥ 0, between bit and rock when the hammer strikes [v0/f] (T36)
    /// Whether the motion comes back to this one when it is disturbed: not where it bounces with e ≥ 1.
    bool stable = false;
    bool operator==(const UndampedMotion&) const = default;
};

/// For the feed φ = F/(f I0) and e ≥ 0.
UndampedMotion undampedMotion(double feed, double cor);

/// φ = (1+e)/(1−e), from which on the rod rests before every blow; infinite for e ≥ 1.
double restingFeed(double cor);

}  // namespace drillwave
