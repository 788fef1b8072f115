// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of the strengths of sections that the largest stresses of a blow use.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/blow/string_blow.h"

namespace drillwave {

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
