// SPDX-License-Identifier: GPL-3.0-or-later
// The references of the manual, written from the tables of parameters and outputs, so that none can be behind
// them, in the words of a reader.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/blow/outputs.h"
#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_field.h"
#include "core/text/handy_text.h"

namespace drillwave {

// Descriptions of the numbers of a scenario, in the words of a reader: for the reference and `help`.

/// One row of a table of numbers.
struct ParameterFacts {
    std::string key;        ///< "bit_rock.gamma"; of sections "string.NAME.length"
    std::string title;      ///< "elasticity γ"
    std::string meaning;    ///< a sentence without its end
    std::string unit;       ///< customary, may be empty
    std::string range;      ///< "greater than 0", "in (0, 1]"
    std::string usual;      ///< "1 – 10000 MN/m"; other values get an alert
    std::string presence;   ///< whether it may be left out, a sentence without its full stop
    std::string condition;  ///< scenarios that have it, a sentence without its full stop; empty: all
};

ParameterFacts factsOf(const Parameter& parameter, const ReadingStyle& style);
ParameterFacts factsOf(const SectionField& field, const ReadingStyle& style);

/// Values that the built-in presets give it, each with who has it and where it is from, or from where to
/// where where they are many; empty where none gives it.
std::vector<std::string> presetValues(const Parameter& parameter, const ReadingStyle& style);

/// Returns the chapter of all parameters, in Markdown: a section for each, whose heading begins with its key.
std::string parameterReference(const ReadingStyle& style);
/// Returns the chapter of all outputs.
std::string outputReference(const ReadingStyle& style);

/// Returns the section of only one of them, its heading first.
std::string referenceOf(const Parameter& parameter, const ReadingStyle& style);
std::string referenceOf(const SectionField& field, const ReadingStyle& style);
std::string referenceOf(const WordParameter& parameter, const ReadingStyle& style);
std::string referenceOf(const Output& output, const ReadingStyle& style);

/// "I0", "t0": what an output that is not in SI only is a multiple of; "–" for a plain number.
std::string_view scaleName(const Output& output);
/// Its unit in SI, "–" where it has none.
std::string_view siName(const Output& output);

}  // namespace drillwave
