// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of sections, each as the uniform pieces that stand for it.
#pragma once

#include <vector>

#include "core/model/drill_string.h"

namespace drillwave {

bool isUniform(const Section& section);
/// All of hammer and string.
bool hasUniformSections(const DrillString& drillString);

/// Cross-section [m²] at `share` of the length, 0 at the rear end … 1: of a cone the diameter is linear, the
/// bore constant; of one that is given by areas, the diameter of a full bar.
double areaAt(const Section& section, double share);

/// Outer diameter [m] there; of a section given by its area that of a full bar.
double outerDiameterAt(const Section& section, double share);

/// The larger one of its ends.
double largestDiameter(const Section& section);

/// The mean of areaAt() between two shares [m²]: a uniform piece of that area has the mass of what is there.
double meanArea(const Section& section, double from = 0, double to = 1);

/// `count` uniform pieces, one behind the other, of equal lengths and of the mass of what they stand for, the
/// lumped mass and the joint behind the last one: count > 0; one of a uniform section is the section. Waves
/// in them differ from those in a cone by the square of the lengths of the pieces.
std::vector<Section> uniformPieces(const Section& section, int count);

}  // namespace drillwave
