// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/blow/undamped_motion.h"

#include <limits>

namespace drillwave {

UndampedMotion undampedMotion(double feed, double cor) {
    using Kind = UndampedMotion::Kind;
    if (!(feed > 1)) return {.kind = Kind::pushedBack};
    if (feed >= restingFeed(cor)) return {.kind = Kind::resting, .stable = true};
    const double velocity = feed / (1 + cor);              // (T36)
    const double delay = cor * velocity - (feed - 1) / 2;  // (T36)
    return {.kind = Kind::bouncing,
            .impactVelocity = velocity,
            .delay = delay,
            .gap = velocity * delay - (feed - 1) * delay * delay / 2,  // (T36)
            .stable = cor < 1};
}

double restingFeed(double cor) {
    return cor < 1 ? (1 + cor) / (1 - cor) : std::numeric_limits<double>::infinity();
}

}  // namespace drillwave
