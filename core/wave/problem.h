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

/// Uniform section of hammer or string in dimensionless form; Zr is the reference impedance, t0 the unit of
/// time.
struct UniformSection {
    /// Impedance of the section, ζ = Z/Zr with the reference impedance Zr; > 0.
    double impedance = 1;
    /// Transit time of a wave through the section, one way, τ = T/t0; > 0.
    double transitTime = 1;
    /// Attenuation αL: decrease of the logarithm of a wave's amplitude over one transit; ≥ 0.
    double decay = 0;
    /// Lumped mass at the front end of the section, μ = M/(Zr t0); ≥ 0.
    double massAfter = 0;
    /// Share η of the energy of a transmitted wave that is lost in the joint at the front end; 0 ≤ η < 1.
    double loss = 0;
    /// Returns the mass of the section without the lumped mass, in units of Zr t0.
    double mass() const { return impedance * transitTime; }
    bool operator==(const UniformSection&) const = default;
};

/// Contact between the hammer face and the rear end of the string (strings §4).
struct HammerFace {
    /// Contact stiffness of the two faces, κc = kc t0/Zr; the faces are rigid if it is absent.
    std::optional<double> stiffness;
    /// Whether hammer and string may meet again after their first separation.
    bool restrike = true;
    bool operator==(const HammerFace&) const = default;
};

/// Hammer made of sections that strikes the string. At t = 0 all its sections move towards the string with
/// the same velocity, and its face touches the string.
struct ElasticHammer {
    /// Number of leading entries of Problem::sections that belong to the hammer; > 0.
    std::size_t sections = 1;
    /// Impact velocity of the hammer, v0 Zr/F0. It is 2, because F0 is defined as Zr v0/2.
    double velocity = 2;
    /// Contact of the hammer with the string.
    HammerFace face;
    bool operator==(const ElasticHammer&) const = default;
};

/// One blow in dimensionless form, the input of all solvers (strings §9). Impedances are in units of the
/// rod's impedance Zr, times in t0, forces in F0, impulses in I0 = F0 t0, velocities in F0/Zr, displacements
/// in I0/Zr, energies in I0²/(Zr t0). A solver either solves a problem or refuses it with a reason.
struct Problem {
    /// Cause of the blow: a force Fa(t)/F0 on the rear end of the first section, or a hammer that strikes
    /// that end.
    std::variant<PulseForce, ElasticHammer> drive;
    /// Sections in order from the rear end: those of an elastic hammer, if any, then those of the string to
    /// the bit. A single section of impedance 1 is a uniform rod.
    std::vector<UniformSection> sections = {{}};
    /// Number of consecutive entries of `sections` that replace one section of the scenario, for each
    /// section. Their transit times are equal. Empty if every section of the scenario is one entry.
    std::vector<int> pieces;
    /// Force–penetration law of bit and rock, with the loading stiffness β = k t0/Zr and the unloading
    /// stiffness β/γ.
    BitRockLaw law;
    /// Gap between bit and rock at the start, δ = d/d0 with d0 = 2 I0/Zr; ≥ 0.
    double gap = 0;
    /// Time t/t0 at which the user wants the computation of a drill string to end; empty if the user sets no
    /// time.
    std::optional<double> endTime;
    /// Time t/t0 of the next blow, if known. Without `endTime`, the computation of a drill string stops at
    /// this time if the end of the blow is not proven before.
    std::optional<double> nextBlow;
    bool operator==(const Problem&) const = default;

    /// Returns whether a prescribed force drives the blow; otherwise a hammer does.
    bool isForced() const { return std::holds_alternative<PulseForce>(drive); }
    /// Returns the hammer force; requires isForced().
    const PulseForce& force() const { return std::get<PulseForce>(drive); }
    /// Returns the hammer; requires !isForced().
    const ElasticHammer& hammer() const { return std::get<ElasticHammer>(drive); }
    /// Returns the number of entries of `sections` that belong to the hammer; 0 for a prescribed force.
    std::size_t hammerSections() const { return isForced() ? 0 : hammer().sections; }

    /// Returns the transit time of the string from its rear end to the bit, τ = T/t0.
    double transitTime() const {
        double time = 0;
        for (std::size_t j = hammerSections(); j < sections.size(); ++j) time += sections[j].transitTime;
        return time;
    }
    /// Returns the mass of the string including its lumped masses, M/(Zr t0).
    double mass() const {
        double sum = 0;
        for (std::size_t j = hammerSections(); j < sections.size(); ++j)
            sum += sections[j].mass() + sections[j].massAfter;
        return sum;
    }
    /// Returns the reference velocity v0 Zr/F0. For a hammer it is its impact velocity, for a prescribed
    /// force I0/M with the mass M of the string.
    double velocity() const { return isForced() ? 1 / mass() : hammer().velocity; }
    /// Returns the gap between bit and rock in units of I0/Zr; the member `gap` is in units of d0, which is
    /// twice that.
    double distance() const { return 2 * gap; }
    /// Returns the gap δ = d/d0 that closes before the first contact; 0 in the reference case (a rod that
    /// arrives as a rigid body), which starts in contact.
    double firstGap() const { return isForced() && force().isRigidBody() ? 0 : gap; }
};

/// Returns whether a joint or a section of the string takes energy from the waves. A loss after the last
/// section does not count, since it has no joint.
bool losesWaves(const Problem& problem);

/// Returns the reason why a solver for uniform rods refuses the problem; empty if the solver accepts it. Such
/// a solver requires a prescribed force on a single uniform rod without losses.
std::string_view rodRefusal(const Problem& problem);

/// Returns the dimensionless blow of a valid scenario. `pieces` gives the number of uniform pieces that
/// replace each section of hammer and string; empty means one each. To solve many blows with the same pulse
/// of up to 100 000 points, change one Problem instead of calling this function again.
Problem problemOf(const Scenario& scenario, const std::vector<int>& pieces = {});

/// Returns the blow of a prescribed force on the rear end of a uniform rod. `groups` are the dimensionless
/// rock stiffness β, the elasticity γ of the rock, the transit time τ and the gap δ.
Problem problemOf(PulseForce force, const Groups& groups);
/// Sets transit time, rock stiffness β, elasticity γ and gap of the problem `rod` from the groups β, γ, τ, δ.
/// The force and the corners of the rock law do not change.
void setGroups(Problem& rod, const Groups& groups);
/// Sets transit time, rock law and gap of the problem `rod` from a valid scenario of a uniform rod. The force
/// does not change.
void setRod(Problem& rod, const Scenario& scenario);

}  // namespace drillwave
