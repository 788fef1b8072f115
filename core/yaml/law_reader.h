// SPDX-License-Identifier: GPL-3.0-or-later
// The law of bit and rock in scenario files (files §1.4): its kind and its corners.
#pragma once

#include <string_view>

#include "core/yaml/section_reader.h"

namespace drillwave {

/// The keys of `bit_rock` that are no numbers.
inline constexpr std::string_view lawKey = "law", cornersKey = "corners";

/// The kind of the law, bilinear where nothing is said. False where it is no such word, which is reported.
bool readLaw(SectionReader& reader, const YamlEntries& entries);

/// The corners of a law that has them; reports those that another law is given, and what a corner lacks.
void readCorners(SectionReader& reader, const YamlEntries& entries);

}  // namespace drillwave
