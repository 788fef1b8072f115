// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/bit_motion.h"

#include <algorithm>
#include <cassert>

#include "core/wave/field/bit_history.h"

namespace drillwave {

double bitDisplacement(const Impact& impact, double t) {
    assert(impact.hasHistories());
    const double s = t - impact.frontArrival;
    return incidentImpulse(impact, s) - impactImpulse(impact, s) / 2;
}

BitState bitState(const std::function<double(double)>& displacementAt,
                  std::span<const ContactInterval> contacts, double delta, double t) {
    const double displacement = displacementAt(t);
    const auto next =
        std::upper_bound(contacts.begin(), contacts.end(), t,
                         [](double time, const ContactInterval& contact) { return time < contact.begin; });
    if (next == contacts.begin()) return {false, 0, std::max(0.0, delta - displacement)};
    const ContactInterval& last = *std::prev(next);
    if (t <= last.end) return {true, displacement - delta, 0};
    return {false, 0, std::max(0.0, displacementAt(last.end) - displacement)};
}

BitState bitState(const Impact& impact, std::span<const ContactInterval> contacts, double delta, double t) {
    return bitState([&](double time) { return bitDisplacement(impact, time); }, contacts, delta, t);
}

}  // namespace drillwave
