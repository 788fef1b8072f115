// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/soft_reference.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/text/message.h"

namespace drillwave {

bool isSoftReference(const Problem& problem) {
    constexpr double softest = 1e-12;
    return problem.law.isBilinear() &&
           problem.law.beta * problem.transitTime() / problem.law.gamma <= softest;
}

Impact softReference(const Problem& problem, Detail detail) {
    Impact impact;
    impact.frontArrival = 0;
    impact.roundTrip = 2 * problem.transitTime();
    if (detail == Detail::histories) {
        impact.hindrance = Hindrance::histories;
        impact.reason = translatable(
            "its histories have more than 4 million polynomial pieces: the rock is so soft that the waves "
            "pass the "
            "rod millions of times in one contact; a stiffer rock needs fewer");
        return impact;
    }
    const double softness = problem.law.beta * problem.transitTime();
    const double root = std::sqrt(problem.law.gamma);
    impact.outcome = Outcome::rebounded;
    impact.cor = root + (1 - problem.law.gamma) * softness / (6 * root);
    impact.corError =
        softness * std::sqrt(softness) / problem.law.gamma + 4 * std::numeric_limits<double>::epsilon();
    impact.impulse = 1 + impact.cor;
    impact.contacts = 1;
    impact.pieces = 1;
    if (detail == Detail::cor) return impact;

    const double quarter = std::numbers::pi / 2 * std::sqrt(problem.transitTime() / problem.law.beta);
    const double loading = quarter * (1 + softness / 6);
    const double unloading = quarter * root * (1 + softness / (6 * problem.law.gamma));
    impact.peakForce = std::sqrt(problem.law.beta / problem.transitTime()) * (1 - softness / 6);
    impact.contactDuration = impact.separationTime = loading + unloading;
    const double work = 1 / (2 * problem.transitTime());  // ½ m v0²
    impact.hammerWork = work;
    impact.rockWork = (1 - problem.law.gamma) * work * (1 - softness / 3);  // (1 − γ)Fm²/(2β)
    impact.finalMomentum = -impact.cor;
    impact.finalEnergy = work - impact.rockWork;
    impact.events.push_back({ContactEvent::contact, 0});
    if (!problem.law.isElastic()) impact.events.push_back({ContactEvent::unloading, loading});
    impact.events.push_back({ContactEvent::separation, impact.separationTime});
    return impact;
}

}  // namespace drillwave
