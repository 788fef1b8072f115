// SPDX-License-Identifier: GPL-3.0-or-later
// The references of the manual, written from the tables of parameters and outputs, so that none can be behind
// them.
#pragma once

#include <string>
#include <string_view>

#include "core/blow/outputs.h"
#include "core/model/parameter.h"
#include "core/model/section_field.h"
#include "core/model/word_parameter.h"

namespace drillwave {

/// The chapter of all parameters, in Markdown: a section for each, whose heading begins with its key.
std::string parameterReference();
/// That of all outputs.
std::string outputReference();

/// The section of one of them alone, its heading first.
std::string referenceOf(const Parameter& parameter);
std::string referenceOf(const SectionField& field);
std::string referenceOf(const WordParameter& parameter);
std::string referenceOf(const Output& output);

/// "I0", "t0": what an output is a multiple of; "–" for a plain number, "SI only" where there is none.
std::string_view scaleName(const Output& output);
/// Its unit in SI, "–" where it has none.
std::string_view siName(const Output& output);

}  // namespace drillwave
