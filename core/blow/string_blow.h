// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses and alerts of the sections of the chain, derived from a solved blow. A rod is one
// section.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/blow/impact_summary.h"
#include "core/model/alerts.h"
#include "core/model/scenario.h"
#include "core/wave/impact.h"

namespace drillwave {

/// Largest stress of a section, in SI, with place and time.
struct StressPeak {
    double stress = 0;  ///< [Pa], ≥ 0
    double place = 0;   ///< [m] from the rear end of the section
    double time = 0;    ///< [s]
};

/// Largest stresses of a section, in the spans of time of SectionForces.
using SectionStress = OfLoads<StressPeak>;
/// Returns the stresses of all sections, hammer first; empty unless the forces were requested.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const Impact& impact);
/// Returns the stresses of a uniform rod in physical units.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const RodForces& forces);

/// Largest stress of a string, and its section.
struct StringPeak {
    std::size_t section = 0;  ///< of sectionStresses()
    StressPeak peak;
};
/// Returns the largest stress of a load over all sections, the first if several are equal. Requires sections.
StringPeak largestStress(const std::vector<SectionStress>& stresses, Load load);

/// Writes the largest stresses of all sections and their stated error into the summary, if forces were
/// requested; `pieces` as in the problem that was solved.
void addStresses(ImpactSummary& summary, const Scenario& scenario, const Impact& impact,
                 const std::vector<int>& pieces);

/// Returns whether the blow was followed beyond its end, so that there are stresses after it.
bool hasStressesAfter(const Impact& impact);

/// Returns `stress_above_yield` when the largest stress in a section exceeds its yield strength,
/// `stress_above_fatigue` when the largest tension exceeds its fatigue strength: a warning while the blow
/// lasts, a remark if only residual waves do. Each has place and time. None without strengths.
std::vector<Alert> stressAlerts(const Scenario& scenario, const std::vector<SectionStress>& stresses);

/// Returns the alerts of solutions on cells: lengths that were rounded, a blow that was not over, stresses
/// that were too much work.
std::vector<Alert> stringAlerts(const Scenario& scenario, const Impact& impact);

// Shares of the strengths of sections that the largest stresses of a blow use.

/// A stress compared with a strength.
struct StrengthUse {
    enum class Strength { yield, fatigue };
    Strength of = Strength::fatigue;
    bool isTension = true;
    StressPeak peak;      ///< of the section while the blow lasts
    double strength = 0;  ///< [Pa]
    double share() const { return peak.stress / strength; }
};

/// Returns the larger of tension over fatigue strength and of tension or compression over yield strength,
/// while the blow lasts; nothing without strengths.
std::optional<StrengthUse> strengthUse(const SectionStress& stress,
                                       const std::optional<double>& yieldStrength,
                                       const std::optional<double>& fatigueStrength);

/// Returns the use of strength of every section of sectionStresses(). A uniform rod is one section.
std::vector<std::optional<StrengthUse>> strengthUses(const Scenario& scenario,
                                                     const std::vector<SectionStress>& stresses);

/// Returns the number of the section with the largest share, the first of several; nothing without strengths.
std::optional<std::size_t> mostUsedSection(const std::vector<std::optional<StrengthUse>>& uses);

}  // namespace drillwave
