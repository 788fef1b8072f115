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
/// the outer diameter varies linearly and the bore is constant. A cone given by areas counts as a solid bar
/// whose diameter varies linearly.
double areaAt(const Section& section, double share);

/// Returns the outer diameter [m] at `share` of the length, from 0 (rear end) to 1. For a section given by
/// its area it is the diameter of a solid bar of this area.
double outerDiameterAt(const Section& section, double share);

/// Returns the larger outer diameter [m] of the two ends of a section.
double largestDiameter(const Section& section);

/// Returns the mean cross-section [m²] between two shares of the length, from 0 (rear end) to 1. A uniform
/// piece of this area has the same mass.
double meanArea(const Section& section, double from = 0, double to = 1);

/// Returns the key of the size of a cone at its end towards the rock: "end_diameter" or "end_area".
std::string_view endKey(const Section& section);

/// Contradiction between two sizes of a section, each of which is within its allowed range.
struct ShapeProblem {
    std::string_view field;  ///< key of one of the two sizes, "bore"
    Message reason;          ///< reason: "must be less than the diameter of 39 mm"
};
/// Returns all contradictions between the sizes of a section; empty if there are none.
std::vector<ShapeProblem> shapeProblems(const Section& section);

/// Returns length, outer diameters from the rear to the far end, and bore as text: "3660 mm × 39 mm … 45 mm /
/// 14 mm". For a section given by its area, it gives areas instead.
std::string sizeText(const Section& section);

/// Returns a section as `count` > 0 uniform pieces of equal length with the same total mass. Lumped mass and
/// joint of the section are after the last piece. A uniform section in one piece is returned unchanged. The
/// error of the waves in a cone is proportional to the square of the length of the pieces.
///
/// `behindLoss` means that the joint before the section has losses. The impedance just after such a joint
/// must be exact, because a wave is reflected there before it is weakened. With four or more pieces, the
/// first one therefore gets the cross-section of the rear end. The second one gets the mass that is missing
/// in the first.
std::vector<Section> uniformPieces(const Section& section, int count, bool behindLoss = false);

}  // namespace drillwave
