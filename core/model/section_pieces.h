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

/// Returns the mean cross-section [m²] of a section between two positions, given as shares of its length. The
/// share 0 is the rear end, 1 the end towards the rock. A uniform piece of this area has the same mass.
double meanArea(const Section& section, double from = 0, double to = 1);

/// Returns the key of the size of a cone at its end towards the rock: "end_diameter" or "end_area".
std::string_view endKey(const Section& section);

/// Contradiction between two sizes of a section, such as a bore wider than the section. Each of the two sizes
/// is within its allowed range.
struct ShapeProblem {
    std::string_view field;  ///< key of one of the two sizes, "bore"
    Message reason;          ///< reason: "must be less than the diameter of 39 mm"
};
/// Returns all contradictions between the sizes of a section; empty if there are none.
std::vector<ShapeProblem> shapeProblems(const Section& section);

/// Returns the sizes of a section as text: length, outer diameter (of a cone at its rear end and its end
/// towards the rock), and bore. Example: "3660 mm × 39 mm … 45 mm / 14 mm". A section given by its area has
/// areas instead of diameters.
std::string sizeText(const Section& section);

/// Divides a section, usually a cone, into `count` > 0 uniform pieces of equal length with the same total
/// mass. The solver replaces a cone by these pieces. Its error is proportional to the square of their length.
/// The last piece gets the lumped mass and the joint of the section. A uniform section in one piece is
/// returned unchanged.
///
/// `behindLoss` means that the joint before the section loses energy. The reflection at such a joint needs
/// the exact impedance of the rear end. With four or more pieces, the first one therefore gets the
/// cross-section of the rear end. The second piece gets the mass that the first one then lacks.
std::vector<Section> uniformPieces(const Section& section, int count, bool behindLoss = false);

}  // namespace drillwave
