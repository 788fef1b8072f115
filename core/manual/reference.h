// SPDX-License-Identifier: GPL-3.0-or-later
// The references of the manual, written from the tables of parameters and outputs, so that none can be behind
// them, in the words of a reader.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/outputs.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_field.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// The chapter of all parameters, in Markdown: a section for each, whose heading begins with its key.
std::string parameterReference(const ReadingStyle& style);
/// That of all outputs.
std::string outputReference(const ReadingStyle& style);

/// The section of one of them alone, its heading first.
std::string referenceOf(const Parameter& parameter, const ReadingStyle& style);
std::string referenceOf(const SectionField& field, const ReadingStyle& style);
std::string referenceOf(const WordParameter& parameter, const ReadingStyle& style);
std::string referenceOf(const Output& output, const ReadingStyle& style);

/// "I0", "t0": what an output that is not in SI only is a multiple of; "–" for a plain number.
std::string_view scaleName(const Output& output);
/// Its unit in SI, "–" where it has none.
std::string_view siName(const Output& output);

}  // namespace drillwave
