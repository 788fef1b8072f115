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

/// Position of a section in the lists of a scenario file: in the hammer, in the string, or in a repeat of the
/// string. A repeat counts as one part of the string, however often its sections are repeated.
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

/// Returns the number of the section at `spot` in keys such as "string.3.length", here 3. It counts sections
/// from 1 in the hammer or string, with repeats expanded. A section in a repeat has the number of its first
/// copy.
std::uint64_t placeOf(const DrillString& drillString, const SectionSpot& spot);

/// Inserts a section after the section at `spot`, and inside the same repeat if that section is in a repeat.
/// Returns the position of the new section.
SectionSpot insertAfter(DrillString& drillString, const SectionSpot& spot, Section section);

/// Inserts `sections`, at least one, after the section at `spot`. If that section is the last one of a
/// repeat, they are inserted after the repeat, not into it. Returns the position of the last inserted
/// section.
SectionSpot insertBehind(DrillString& drillString, const SectionSpot& spot,
                         const std::vector<Section>& sections);

/// Returns whether replaceSections() can replace these sections. They must be neighbours: in the hammer, in
/// one repeat, or in the string outside of repeats.
bool canReplace(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Replaces the sections at `spots` by other ones, at least one. Returns the position of the last new
/// section. Requires canReplace().
SectionSpot replaceSections(DrillString& drillString, const std::vector<SectionSpot>& spots,
                            const std::vector<Section>& sections);

/// End of a drill string at which sections are inserted: before all others (shank), or after them (bit).
enum class StringEnd { shank, bit };
/// Inserts at least one section at an end of the string, outside any repeat. Returns the position of the last
/// inserted section.
SectionSpot insertAt(DrillString& drillString, StringEnd end, const std::vector<Section>& sections);

/// Returns whether the section may be removed: the hammer, or the string, must have at least one section
/// left.
bool canRemove(const DrillString& drillString, const SectionSpot& spot);
/// Removes a section, and also its repeat if the repeat has no other section. Requires canRemove().
void removeSection(DrillString& drillString, const SectionSpot& spot);

enum class MoveTo { rear, bit };
/// Moves a section one step towards the rear or the bit: past its neighbour, into a neighbouring repeat, or
/// out of its own repeat. The only section of a repeat moves together with the repeat. Returns the new
/// position. If the section cannot move further, returns nullopt and changes nothing.
std::optional<SectionSpot> moveSection(DrillString& drillString, const SectionSpot& spot, MoveTo direction);

/// Returns whether repeatSections() can make these sections a repeat. They must be neighbours in the string,
/// and outside of repeats.
bool canRepeat(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Turns neighbouring sections of the string into a repeat of `times` ≥ 1. Requires canRepeat().
void repeatSections(DrillString& drillString, const std::vector<SectionSpot>& spots, int times);
/// Sets how many times the sections of a repeat follow one another. If `times` is 1, the repeat is replaced
/// by its sections. `part` is the index of the repeat in DrillString::parts.
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
