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

/// Where a section stands in a file.
struct SectionSpot {
    bool inHammer = false;
    std::size_t part = 0;   ///< of the string; 0 in the hammer
    std::size_t index = 0;  ///< in the hammer or in the part
    bool operator==(const SectionSpot&) const = default;
};

/// All of them in the order of a file: the hammer from its rear, then the string from the shank.
std::vector<SectionSpot> sectionSpots(const DrillString& drillString);

/// Requires a spot that is there.
const Section& sectionAt(const DrillString& drillString, const SectionSpot& spot);
Section& sectionAt(DrillString& drillString, const SectionSpot& spot);

/// The first place, from 1, that the section has in its hammer or its string with repeats written out: that
/// of its key.
std::uint64_t placeOf(const DrillString& drillString, const SectionSpot& spot);

/// Puts a section behind another one, in the same repeat if that is in one. Returns where it stands.
SectionSpot insertAfter(DrillString& drillString, const SectionSpot& spot, Section section);

/// Puts sections after another one. After the last section of a repeat they come after the repeat, so that
/// they are not repeated. Returns where the last of them stands. Requires at least one section.
SectionSpot insertBehind(DrillString& drillString, const SectionSpot& spot,
                         const std::vector<Section>& sections);

/// Returns whether the sections follow one another in the hammer, in one repeat or outside of repeats.
bool canReplace(const DrillString& drillString, const std::vector<SectionSpot>& spots);
/// Replaces the sections by others. Returns where the last of these stands. Requires canReplace() and at
/// least one section.
SectionSpot replaceSections(DrillString& drillString, const std::vector<SectionSpot>& spots,
                            const std::vector<Section>& sections);

/// Puts sections at an end of the string, outside of any repeat: before all others, or behind them. Returns
/// where the last of them stands.
enum class StringEnd { shank, bit };
SectionSpot insertAt(DrillString& drillString, StringEnd end, const std::vector<Section>& sections);

/// Whether there is another one in its hammer or string, so that it may go.
bool canRemove(const DrillString& drillString, const SectionSpot& spot);
/// Takes a section away, and with the last one of a repeat the repeat. Requires canRemove().
void removeSection(DrillString& drillString, const SectionSpot& spot);

enum class MoveTo { rear, bit };
/// Moves a section one step: past its neighbour, into a repeat beside it, or out of its own at the end; the
/// only section of a repeat goes with its repeat. Returns where it stands then; nothing, and no change, where
/// it is at the end of its hammer or string.
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
