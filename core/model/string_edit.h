// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of the sections of a hammer and a drill string: inserting, removing, moving and repeating. An edit
// may leave the scenario invalid for a moment, for example with two sections of one bore.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/model/drill_string.h"

namespace drillwave {

/// Position of a section in a scenario file, where a repeat lists its sections once.
struct SectionSpot {
    bool inHammer = false;
    std::size_t part = 0;   ///< index of the part of the string, a section or a repeat; 0 in the hammer
    std::size_t index = 0;  ///< index of the section in the hammer or in the part
    bool operator==(const SectionSpot&) const = default;
};

/// Returns the positions of all sections in the order of a file: the hammer from its rear, then the string
/// from the shank.
std::vector<SectionSpot> sectionSpots(const DrillString& drillString);

/// Returns the section at a position, which must exist.
const Section& sectionAt(const DrillString& drillString, const SectionSpot& spot);
Section& sectionAt(DrillString& drillString, const SectionSpot& spot);

/// Returns the number of the section in its hammer or string, counted from 1 with repeats expanded; in a
/// repeat that of its first copy. Keys such as "string.3.length" use this number.
std::uint64_t placeOf(const DrillString& drillString, const SectionSpot& spot);

/// Inserts a section after the section at `spot`, and inside the same repeat if that section is in a repeat.
/// Returns the position of the new section.
SectionSpot insertAfter(DrillString& drillString, const SectionSpot& spot, Section section);

/// Inserts at least one section after the section at `spot`. If that is the last section of a repeat, they
/// are inserted outside the repeat, so that they are not repeated. Returns the position of the last one.
SectionSpot insertBehind(DrillString& drillString, const SectionSpot& spot,
                         const std::vector<Section>& sections);

/// Returns whether the sections at these positions are neighbours in the hammer, in one repeat or outside of
/// repeats, so that others can replace them.
bool canReplace(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Replaces neighbouring sections by at least one other. Returns the position of the last new one. Requires
/// canReplace().
SectionSpot replaceSections(DrillString& drillString, const std::vector<SectionSpot>& spots,
                            const std::vector<Section>& sections);

/// End of a drill string at which sections are inserted: before all others (shank), or after them (bit).
enum class StringEnd { shank, bit };
/// Inserts at least one section at an end of the string, outside any repeat. Returns the position of the last
/// inserted section.
SectionSpot insertAt(DrillString& drillString, StringEnd end, const std::vector<Section>& sections);

/// Returns whether the section may be removed, because the hammer or string has at least one more.
bool canRemove(const DrillString& drillString, const SectionSpot& spot);
/// Removes a section, and also its repeat if the repeat has no other section. Requires canRemove().
void removeSection(DrillString& drillString, const SectionSpot& spot);

enum class MoveTo { rear, bit };
/// Moves a section one step: past its neighbour, into a neighbouring repeat, or out of its own repeat. The
/// only section of a repeat moves together with the repeat. Returns its new position. Returns nullopt and
/// changes nothing at the end of the hammer or string.
std::optional<SectionSpot> moveSection(DrillString& drillString, const SectionSpot& spot, MoveTo direction);

/// Returns whether the sections at these positions are neighbours in the string and in no repeat, so that
/// they can be made a repeat.
bool canRepeat(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Turns neighbouring sections of the string into a repeat of `times` ≥ 1. Requires canRepeat().
void repeatSections(DrillString& drillString, const std::vector<SectionSpot>& spots, int times);
/// Sets how many times a repeat is repeated; 1 replaces the repeat by its sections. Requires a part that is a
/// repeat.
void setRepeat(DrillString& drillString, std::size_t part, int times);

// Rounded lengths of sections. A common step of the lengths keeps the number of time steps of the solver
// small.

/// Returns a length [m] rounded to a multiple of 10 mm for 50 mm and more, of 5 mm for 20 mm and more, else
/// of 1 mm.
double roundedLength(double length);

/// Returns hammer and string with rounded lengths of all sections. A section that changes loses the name of
/// its preset.
DrillString withRoundedLengths(DrillString drillString);

}  // namespace drillwave
