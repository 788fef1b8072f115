// SPDX-License-Identifier: GPL-3.0-or-later
// What is solved of a drill string: hammer, sections, joints, bit and rock, dimensionless.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/contact/bit_rock_law.h"

namespace drillwave {

/// A uniform piece of hammer or string.
struct NetworkSection {
    double impedance = 1;    ///< ζ = Z/Zr; > 0
    double transitTime = 1;  ///< τ = T/t0, one way; > 0
    double decay = 0;        ///< αL, what the logarithm of an amplitude loses on one way; ≥ 0
    double massAfter = 0;    ///< μ = M/(Zr t0), lumped at its far end; ≥ 0
    double loss = 0;  ///< η, share of the energy of a wave lost in the joint at its far end; 0 ≤ η < 1
    double mass() const { return impedance * transitTime; }
    bool operator==(const NetworkSection&) const = default;
};

/// How hammer and string meet (strings §4).
struct NetworkFace {
    std::optional<double> stiffness;  ///< κc = kc t0/Zr of the faces; rigid without it
    bool restrike = true;             ///< whether the faces may meet again after their first separation
    bool operator==(const NetworkFace&) const = default;
};

/// One blow on a drill string as a solver takes it (strings §9): impedances in that of the rod Zr, times in
/// t0, velocities in the impact velocity v0, forces in Zr v0, displacements in v0 t0, energies in Zr v0² t0.
/// At t = 0 all sections of the hammer move with velocity 1 and touch the string at rest.
struct NetworkProblem {
    std::vector<NetworkSection> sections;  ///< of the hammer from its rear end, then of the string to the bit
    std::size_t hammerSections = 1;        ///< how many of them are the hammer; 0 < that < sections.size()
    NetworkFace face;
    BitRockLaw law;                  ///< β = k t0/Zr and γ
    double gap = 0;                  ///< d/(v0 t0) between bit and rock; ≥ 0
    std::optional<double> endTime;   ///< follow the blow to there, and no longer
    std::optional<double> nextBlow;  ///< without an end time: give up the proof of the end there
    bool operator==(const NetworkProblem&) const = default;
};

/// Of a wave from the shank to the bit [t0].
inline double stringTransit(const NetworkProblem& problem) {
    double time = 0;
    for (std::size_t j = problem.hammerSections; j < problem.sections.size(); ++j)
        time += problem.sections[j].transitTime;
    return time;
}

}  // namespace drillwave
