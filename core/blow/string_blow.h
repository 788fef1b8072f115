// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses and alerts of the sections of hammer and string, derived from a solved blow. A uniform rod counts
// as one section.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Largest stress of a section in SI, with its position and time.
struct StressPeak {
    /// Magnitude of the stress, in Pa; ≥ 0.
    double stress = 0;
    /// Position of the stress, in m from the rear end of the section.
    double place = 0;
    /// Time of the stress since the start of the blow, in s.
    double time = 0;
};

/// Largest compressive and tensile stress of a section during the blow, and those of the residual waves after
/// it.
using SectionStress = OfLoads<StressPeak>;
/// Returns the largest stresses of all sections in SI, from the rear end of the hammer on; empty unless the
/// largest forces were requested.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const Impact& impact);
/// Returns the largest stresses of a uniform rod in SI, as a list with one section.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const RodForces& forces);

/// Largest stress of hammer and string, and the section in which it occurs.
struct StringPeak {
    std::size_t section = 0;  ///< Index of the section in the result of sectionStresses().
    StressPeak peak;
};
/// Returns the largest stress of one kind of load over all sections; the first one if several are equal.
/// Requires at least one section.
StringPeak largestStress(const std::vector<SectionStress>& stresses, Load load);

/// Sets the largest stresses over all sections of a drill string in `summary`, and their estimated error.
/// Does nothing if the solver was not asked for the largest forces. `pieces` gives for each section the
/// number of uniform pieces that replace it, as in Problem::pieces.
void addStresses(ImpactSummary& summary, const Scenario& scenario, const Impact& impact,
                 const std::vector<int>& pieces);

/// Returns whether a drill string was computed beyond the end of the blow, so that the stresses of the
/// residual waves are known.
bool hasStressesAfter(const Impact& impact);

/// Returns the alerts about strengths; none for sections without a strength. `stress_above_yield`: the
/// largest stress of a section exceeds its yield strength. `stress_above_fatigue`: its largest tension
/// exceeds its fatigue strength. Both are warnings if the strength is exceeded during the blow, and mere
/// information if only residual waves exceed it. Each alert has position and time.
std::vector<Alert> stressAlerts(const Scenario& scenario, const std::vector<SectionStress>& stresses);

/// Returns alerts that the solution of a drill string is inexact or incomplete: section lengths rounded to
/// time steps, waves taken from a coarser computation, or a blow that was not over when the computation
/// ended. One alert says that stresses were omitted because they would take too long.
std::vector<Alert> stringAlerts(const Scenario& scenario, const Impact& impact);

// Stress over strength of the sections, for the largest stresses during a blow

/// Largest stress of a section compared with one of its strengths.
struct StrengthUse {
    /// Kind of strength: yield strength, or fatigue strength for tension.
    enum class Strength { yield, fatigue };
    /// Strength with which the stress is compared.
    Strength of = Strength::fatigue;
    /// Whether the stress is a tension; otherwise it is a compression.
    bool isTension = true;
    /// Largest stress of the section during the blow.
    StressPeak peak;
    /// Yield or fatigue strength of the section, in Pa; > 0.
    double strength = 0;
    /// Returns stress over strength; above 1 the strength is exceeded.
    double share() const { return peak.stress / strength; }
};

/// Returns the largest ratio of stress to strength of a section during the blow. The candidates are tension
/// over fatigue strength, and tension or compression over yield strength. Returns nothing if the section has
/// neither strength.
std::optional<StrengthUse> strengthUse(const SectionStress& stress,
                                       const std::optional<double>& yieldStrength,
                                       const std::optional<double>& fatigueStrength);

/// Returns the largest ratio of stress to strength for every section, in the order of sectionStresses(). A
/// uniform rod is one section.
std::vector<std::optional<StrengthUse>> strengthUses(const Scenario& scenario,
                                                     const std::vector<SectionStress>& stresses);

/// Returns the index of the section with the largest ratio of stress to strength, the first one if several
/// are equal. Nullopt if no section has a strength.
std::optional<std::size_t> mostUsedSection(const std::vector<std::optional<StrengthUse>>& uses);

}  // namespace drillwave
