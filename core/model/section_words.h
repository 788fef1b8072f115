// SPDX-License-Identifier: GPL-3.0-or-later
// Names of sections in tables and sentences, and words for the composition of a drill string.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/drill_string.h"
#include "core/model/section_field.h"
#include "core/model/string_edit.h"
#include "core/text/message.h"

namespace drillwave {

/// Returns the names that examples and presets give to sections: "rod", "bit skirt". These names are
/// translated, other names are not.
std::span<const std::string_view> customarySectionNames();
/// Returns the name of a section for use in a sentence; it is translated if it is one of
/// customarySectionNames().
Message sectionNameMessage(const std::string& name);

/// Returns the names of all sections of the string for messages, with repeats expanded: "3rd rod". A name
/// that occurs once has no number, "adapter"; a section without a name is "section 3".
std::vector<Message> stringSectionWords(const DrillString& drillString);

/// Returns the name of a section of the hammer for messages: "hammer 1", or "hammer 1 (piston)" if it has a
/// name. `place` is its number, from 1.
Message hammerSectionWords(const DrillString& drillString, std::size_t place);

/// Returns the names of all sections of hammer and string for messages, in the order of allSections():
/// "hammer 1", "adapter", "3rd rod".
std::vector<Message> sectionWords(const DrillString& drillString);

/// Returns one name for each section that a file lists, in the order of sectionSpots(): "adapter", "3rd rod".
/// A section in a repeat is named with all its copies: "2nd to 4th rod".
std::vector<Message> rowWords(const DrillString& drillString);

/// Returns the name of the section that an address refers to: "2nd to 4th rod", "hammer 1". For an address by
/// name it is that name, "coupling"; if the section does not exist, "section 9".
Message addressedWords(const SectionAddress& address, const DrillString& drillString);

/// Returns a summary of the sections of a drill string: "6 rods, 3 couplings, 2 other sections".
Message stringWords(const DrillString& drillString);

}  // namespace drillwave
