// SPDX-License-Identifier: GPL-3.0-or-later
// Names of sections in tables and sentences, and what a string consists of.
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

/// Returns the names that examples and presets give to sections: "rod", "bit skirt". A reader has them in a
/// language; other names stay as they are.
std::span<const std::string_view> customarySectionNames();
/// Returns the name of a section in a sentence, translated if it is a usual one.
Message sectionNameMessage(const std::string& name);

/// Returns "3rd rod" for every section of the string with repeats written out; "adapter" where only one
/// section has that name, "section 3" where it has none.
std::vector<Message> stringSectionWords(const DrillString& drillString);

/// Returns "hammer 1", or "hammer 1 (piston)" where it has a name. `place` counts from 1.
Message hammerSectionWords(const DrillString& drillString, std::size_t place);

/// Returns the words of all sections of hammer and string, in the order of allSections().
std::vector<Message> sectionWords(const DrillString& drillString);

/// Returns the words for every section in a file, in the order of sectionSpots(): those of sectionWords(),
/// and "2nd to 4th rod" for a section in a repeat.
std::vector<Message> rowWords(const DrillString& drillString);

/// Returns the words for the section of an address, as it is in a file: "2nd to 4th rod", "hammer 1"; for a
/// name that of the sections, "coupling". "section 9" if the string has none.
Message addressedWords(const SectionAddress& address, const DrillString& drillString);

/// Returns "6 rods, 3 couplings, 2 other sections".
Message stringWords(const DrillString& drillString);

}  // namespace drillwave
