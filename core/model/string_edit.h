// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a hammer and a string as a list of sections: places, inserting, removing, moving and repeating. An
// edit may leave a scenario that is invalid for a moment (two sections of one bore).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/model/drill_string.h"

namespace drillwave {

/// Position of a section in a file.
struct SectionSpot {
    bool inHammer = false;
    std::size_t part = 0;   ///< of the string; 0 in the hammer
    std::size_t index = 0;  ///< in the hammer or in the part
    bool operator==(const SectionSpot&) const = default;
};

/// Returns all positions in the order of a file: the hammer from its rear, then the string from the shank.
std::vector<SectionSpot> sectionSpots(const DrillString& drillString);

/// Returns the section at an existing position.
const Section& sectionAt(const DrillString& drillString, const SectionSpot& spot);
Section& sectionAt(DrillString& drillString, const SectionSpot& spot);

/// Returns the first place, from 1, of the section in its hammer or its string with repeats written out: that
/// of its key.
std::uint64_t placeOf(const DrillString& drillString, const SectionSpot& spot);

/// Inserts a section after another one, in the same repeat if that is in one. Returns its position.
SectionSpot insertAfter(DrillString& drillString, const SectionSpot& spot, Section section);

/// Inserts sections after another one. After the last section of a repeat they follow the repeat, so that
/// they are not repeated. Returns the position of the last one. Requires at least one section.
SectionSpot insertBehind(DrillString& drillString, const SectionSpot& spot,
                         const std::vector<Section>& sections);

/// Returns whether the sections follow one another in the hammer, in one repeat or outside of repeats.
bool canReplace(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Replaces the sections by others. Returns the position of the last one. Requires canReplace() and at least
/// one section.
SectionSpot replaceSections(DrillString& drillString, const std::vector<SectionSpot>& spots,
                            const std::vector<Section>& sections);

/// Inserts sections at an end of the string, outside any repeat: before or after all others. Returns the
/// position of the last one.
enum class StringEnd { shank, bit };
SectionSpot insertAt(DrillString& drillString, StringEnd end, const std::vector<Section>& sections);

/// Returns whether its hammer or string has another section, so that it may be removed.
bool canRemove(const DrillString& drillString, const SectionSpot& spot);
/// Removes a section; the last one of a repeat together with the repeat. Requires canRemove().
void removeSection(DrillString& drillString, const SectionSpot& spot);

enum class MoveTo { rear, bit };
/// Moves a section one step: past its neighbour, into a repeat beside it, or out of its own at the end; the
/// only section of a repeat takes the repeat with it. Returns its new position; nothing, and no change, at
/// the end of its hammer or string.
std::optional<SectionSpot> moveSection(DrillString& drillString, const SectionSpot& spot, MoveTo direction);

/// Returns whether these sections follow one another in the string and are in no repeat.
bool canRepeat(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Makes a repeat of them. Requires canRepeat() and a `times` of 1 or more.
void repeatSections(DrillString& drillString, const std::vector<SectionSpot>& spots, int times);
/// Sets the count of a repeat; 1 dissolves it into its sections. Requires a part that is a repeat.
void setRepeat(DrillString& drillString, std::size_t part, int times);

// Lengths of sections in common steps, so that few cells make up a string and its waves can be kept.

/// Returns the nearest multiple of 10 mm of a length [m] from 50 mm on, of 5 mm from 20 mm on, and of 1 mm
/// below.
double roundedLength(double length);

/// Returns the hammer and string with the rounded lengths of all sections. A changed section is from no
/// preset.
DrillString withRoundedLengths(DrillString drillString);

}  // namespace drillwave
