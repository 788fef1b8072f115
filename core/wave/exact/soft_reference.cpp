// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/soft_reference.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace drillwave {

bool isSoftReference(const Groups& groups) {
    constexpr double softest = 1e-12;
    return groups.beta * groups.tau / groups.gamma <= softest;
}

Impact softReference(const Groups& groups, Detail detail) {
    Impact impact;
    impact.frontArrival = 0;
    impact.roundTrip = 2 * groups.tau;
    if (detail == Detail::histories) {
        impact.reason =
            "its histories need more than 4 million wave pieces: the rock is so soft that the waves pass the "
            "rod "
            "millions of times in one contact; a stiffer rock needs fewer";
        return impact;
    }
    const double softness = groups.beta * groups.tau;
    const double root = std::sqrt(groups.gamma);
    impact.outcome = Outcome::rebounded;
    impact.cor = root + (1 - groups.gamma) * softness / (6 * root);
    impact.corError =
        softness * std::sqrt(softness) / groups.gamma + 4 * std::numeric_limits<double>::epsilon();
    impact.impulse = 1 + impact.cor;
    impact.contacts = 1;
    impact.pieces = 1;
    if (detail == Detail::cor) return impact;

    const double quarter = std::numbers::pi / 2 * std::sqrt(groups.tau / groups.beta);
    const double loading = quarter * (1 + softness / 6);
    const double unloading = quarter * root * (1 + softness / (6 * groups.gamma));
    impact.peakForce = std::sqrt(groups.beta / groups.tau) * (1 - softness / 6);
    impact.contactDuration = impact.separationTime = loading + unloading;
    const double work = 1 / (2 * groups.tau);  // ½ m v0²
    impact.hammerWork = work;
    impact.rockWork = (1 - groups.gamma) * work * (1 - softness / 3);  // (1 − γ)Fm²/(2β)
    impact.finalMomentum = -impact.cor;
    impact.finalEnergy = work - impact.rockWork;
    impact.events.push_back({ContactEvent::contact, 0});
    if (groups.gamma < 1) impact.events.push_back({ContactEvent::unloading, loading});
    impact.events.push_back({ContactEvent::separation, impact.separationTime});
    return impact;
}

}  // namespace drillwave
