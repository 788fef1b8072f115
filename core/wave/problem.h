// SPDX-License-Identifier: GPL-3.0-or-later
// Problem to solve: one blow on one rod or drill string and one rock, dimensionless.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "core/contact/bit_rock_law.h"
#include "core/model/pulse_force.h"

namespace drillwave {

/// A uniform piece of hammer or string.
struct UniformSection {
    double impedance = 1;    ///< ζ = Z/Zr; > 0
    double transitTime = 1;  ///< τ = T/t0, one way; > 0
    double decay = 0;        ///< αL, decrease of the logarithm of an amplitude over one way; ≥ 0
    double massAfter = 0;    ///< μ = M/(Zr t0), lumped at its far end; ≥ 0
    double loss = 0;  ///< η, share of the energy of a wave lost in the joint at its far end; 0 ≤ η < 1
    double mass() const { return impedance * transitTime; }
    bool operator==(const UniformSection&) const = default;
};

/// Contact of hammer and string (strings §4).
struct HammerFace {
    std::optional<double> stiffness;  ///< κc = kc t0/Zr of the faces; rigid without it
    bool restrike = true;             ///< whether the faces may meet again after their first separation
    bool operator==(const HammerFace&) const = default;
};

/// Hammer of sections that strikes the string: at t = 0 all of them move towards it and touch it.
struct ElasticHammer {
    std::size_t sections = 1;  ///< how many of Problem::sections are its own; > 0
    double velocity = 2;       ///< v0 Zr/F0, the impact velocity: F0 is half of Zr v0
    HammerFace face;
    bool operator==(const ElasticHammer&) const = default;
};

/// One blow for all solvers (strings §9): impedances in that of the rod Zr, times in t0, forces in F0,
/// impulses in I0 = F0 t0, velocities in F0/Zr, displacements in I0/Zr, energies in I0²/(Zr t0). A solver
/// takes a problem or refuses it with a reason.
struct Problem {
    /// Force Fa(t)/F0 on the rear end of the first section, or the hammer that strikes it.
    std::variant<PulseForce, ElasticHammer> drive;
    /// Sections of an elastic hammer from its rear end, then of the string to the bit; a single one, of
    /// impedance 1, is a uniform rod.
    std::vector<UniformSection> sections = {{}};
    /// Number of these for each section of the chain, of equal transit times; empty: one for each.
    std::vector<int> pieces;
    BitRockLaw law;                  ///< β = k t0/Zr and γ of bit and rock
    double gap = 0;                  ///< δ = d/d0 between bit and rock, d0 = 2 I0/Zr; ≥ 0
    std::optional<double> endTime;   ///< follow a string to there, and no longer
    std::optional<double> nextBlow;  ///< without an end time: give up the proof of the end there
    bool operator==(const Problem&) const = default;

    bool isForced() const { return std::holds_alternative<PulseForce>(drive); }
    const PulseForce& force() const { return std::get<PulseForce>(drive); }         ///< requires isForced()
    const ElasticHammer& hammer() const { return std::get<ElasticHammer>(drive); }  ///< requires !isForced()
    std::size_t hammerSections() const { return isForced() ? 0 : hammer().sections; }

    /// τ = T/t0 of the string, one way from its rear end to the bit.
    double transitTime() const {
        double time = 0;
        for (std::size_t j = hammerSections(); j < sections.size(); ++j) time += sections[j].transitTime;
        return time;
    }
    /// M/(Zr t0) of the string, with its lumped masses.
    double mass() const {
        double sum = 0;
        for (std::size_t j = hammerSections(); j < sections.size(); ++j)
            sum += sections[j].mass() + sections[j].massAfter;
        return sum;
    }
    /// v0 Zr/F0: of the hammer, or I0/M that a force gives to the string.
    double velocity() const { return isForced() ? 1 / mass() : hammer().velocity; }
    double distance() const { return 2 * gap; }  ///< δ in I0/Zr
    /// The gap that has to close before anything happens: the reference case begins in contact.
    double firstGap() const { return isForced() && force().isRigidBody() ? 0 : gap; }
};

/// Returns whether a joint or a section of the string takes energy from the waves. A loss after the last
/// section does not count, since it has no joint.
bool losesWaves(const Problem& problem);

/// Why this is no force on one uniform section and nothing else, which is all that solvers of rods take.
/// Empty where it is.
std::string_view rodRefusal(const Problem& problem);

/// The blow of a valid scenario, the sections of its chain as so many pieces (uniformPieces()), one each
/// where none are given. The pulse may hold 100 000 points: to solve many blows of one pulse, change one
/// problem.
Problem problemOf(const Scenario& scenario, const std::vector<int>& pieces = {});

/// Returns the blow of this force on the rear end of a uniform rod, on the rod and rock of these groups.
Problem problemOf(PulseForce force, const Groups& groups);
/// Sets another uniform rod and rock for the same force; the corners of the law stay as they are.
void setGroups(Problem& rod, const Groups& groups);
/// Sets rod and rock of a valid scenario.
void setRod(Problem& rod, const Scenario& scenario);

}  // namespace drillwave
