// SPDX-License-Identifier: GPL-3.0-or-later
// Shape of sections, uniform or conical, in numbers and words, and the uniform pieces by which a cone is
// computed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/drill_string.h"
#include "core/text/message.h"

namespace drillwave {

bool isUniform(const Section& section);
/// Returns whether all sections of hammer and string are uniform, so that none is a cone.
bool hasUniformSections(const DrillString& drillString);

/// Returns the cross-section [m²] at `share` of the length of a section, from 0 (rear end) to 1. In a cone
/// the diameter varies linearly and the bore is constant. For a cone given by areas, the diameter of a solid
/// bar varies linearly.
double areaAt(const Section& section, double share);

/// Returns the outer diameter [m] at `share` of the length, from 0 (rear end) to 1. For a section given by
/// its area it is the diameter of a solid bar.
double outerDiameterAt(const Section& section, double share);

/// Returns the larger outer diameter [m] of the two ends of a section.
double largestDiameter(const Section& section);

/// Returns the mean cross-section [m²] between two shares of the length, from 0 (rear end) to 1. A uniform
/// piece of this area has the same mass.
double meanArea(const Section& section, double from = 0, double to = 1);

/// Returns the key of the size at the far end of a cone: "end_diameter" or "end_area".
std::string_view endKey(const Section& section);

/// Contradiction between two sizes of a section, each of which is within its allowed range.
struct ShapeProblem {
    std::string_view field;  ///< key of one of the two sizes, "bore"
    Message reason;          ///< reason: "must be less than the diameter of 39 mm"
};
/// Returns all contradictions between the sizes of a section; empty if there are none.
std::vector<ShapeProblem> shapeProblems(const Section& section);

/// Returns length, outer diameters from the rear to the far end, and bore as text: "3660 mm × 39 mm … 45 mm /
/// 14 mm".
std::string sizeText(const Section& section);

/// Returns a section as `count` > 0 uniform pieces of equal length with the same total mass. Lumped mass and
/// joint of the section are after the last piece. A uniform section in one piece is returned unchanged. The
/// error of the waves in a cone is proportional to the square of the length of the pieces.
///
/// A joint with losses before the section (`behindLoss`) reflects a wave first and weakens it afterwards. A
/// change of impedance at the joint therefore acts differently from one half a piece later. With four or more
/// pieces, the first one has the cross-section of the rear end; the second one gets the mass that this leaves
/// out.
std::vector<Section> uniformPieces(const Section& section, int count, bool behindLoss = false);

}  // namespace drillwave
