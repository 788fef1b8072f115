// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of the loading curve of the rock from scenario files (files §1.4): its form and its corners.
#pragma once

#include <string_view>

#include "core/yaml/section_reader.h"

namespace drillwave {

/// Keys of the section `bit_rock` whose values are not numbers.
inline constexpr std::string_view lawKey = "law", cornersKey = "corners";

/// Reads the key `law`, the form of the loading curve, into the scenario of `reader`. Without this key the
/// curve is bilinear. Returns false and reports an error if the value is no known form.
bool readLaw(SectionReader& reader, const YamlEntries& entries);

/// Reads the corners of a loading curve into the scenario. Reports as errors: corners in a curve of another
/// form, a missing list of corners, and corners without a force or slope.
void readCorners(SectionReader& reader, const YamlEntries& entries);

}  // namespace drillwave
