// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from a solved blow for the sections of the chain: their stresses, alerts. A rod is one
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

/// A largest stress of a section, in SI, and where.
struct StressPeak {
    double stress = 0;  ///< [Pa], ≥ 0
    double place = 0;   ///< [m] from the rear end of the section
    double time = 0;    ///< [s]
};

/// Those of a section, in the spans of time of SectionForces.
using SectionStress = OfLoads<StressPeak>;
/// Of every section of the hammer and then of the string, where the forces were asked for.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const Impact& impact);
/// Of a uniform rod in physical units.
std::vector<SectionStress> sectionStresses(const Scenario& scenario, const RodForces& forces);

/// A largest stress of a string, and where.
struct StringPeak {
    std::size_t section = 0;  ///< of sectionStresses()
    StressPeak peak;
};
/// That of a load over all sections, of the first where several are as large. Requires sections.
StringPeak largestStress(const std::vector<SectionStress>& stresses, Load load);

/// Writes the largest stresses of all sections and their stated error into the summary, where the forces were
/// asked for; `pieces` as in the problem that was solved.
void addStresses(ImpactSummary& summary, const Scenario& scenario, const Impact& impact,
                 const std::vector<int>& pieces);

/// Whether the blow was followed beyond its end, so that there are stresses after it.
bool hasStressesAfter(const Impact& impact);

/// `stress_above_yield` when the largest stress in a section exceeds its yield strength,
/// `stress_above_fatigue` when the largest tension exceeds its fatigue strength: a warning while the blow
/// lasts, a remark where only the waves left do. Each says where and when. None without strengths.
std::vector<Alert> stressAlerts(const Scenario& scenario, const std::vector<SectionStress>& stresses);

/// What else cells give reason to say: lengths that were rounded, a blow that was not over, stresses that
/// were too much work.
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

/// Returns that of every section of sectionStresses(). A uniform rod is one section.
std::vector<std::optional<StrengthUse>> strengthUses(const Scenario& scenario,
                                                     const std::vector<SectionStress>& stresses);

/// Returns the number of the section with the largest share, the first of several; nothing without strengths.
std::optional<std::size_t> mostUsedSection(const std::vector<std::optional<StrengthUse>>& uses);

}  // namespace drillwave
