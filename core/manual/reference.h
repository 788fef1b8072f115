// SPDX-License-Identifier: GPL-3.0-or-later
// Reference pages of the manual in the language of the reader. They are made from the tables of parameters
// and outputs, so that they are always up to date.
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

// Descriptions of the numbers of a scenario in the language of the reader, for the reference pages and the
// command `help`.

/// Description of one parameter (numerical input) of a scenario, as the manual and the command `help` show
/// it.
struct ParameterFacts {
    std::string key;       ///< key, "bit_rock.gamma"; for a number of sections "string.NAME.length"
    std::string title;     ///< name of the parameter with its symbol, "elasticity γ"
    std::string meaning;   ///< explanation, a sentence without its full stop
    std::string unit;      ///< default unit, "mm"; may be empty
    std::string range;     ///< allowed range, "greater than 0", "in (0, 1]"
    std::string usual;     ///< typical range, "1 – 10000 MN/m"; other values raise a warning
    std::string presence;  ///< sentence, without its full stop, on whether a file may omit the parameter
    /// Condition on the scenario under which the parameter applies, as a sentence without its full stop.
    /// Empty if it applies to all scenarios.
    std::string condition;
};

ParameterFacts factsOf(const Parameter& parameter, const ReadingStyle& style);
ParameterFacts factsOf(const SectionField& field, const ReadingStyle& style);

/// Returns the values of a parameter in the built-in presets, each with the preset and its source; if there
/// are many, only their range. Empty if no preset sets it.
std::vector<std::string> presetValues(const Parameter& parameter, const ReadingStyle& style);

/// Returns the chapter of the manual on all parameters, in Markdown, with one section for each parameter. The
/// heading of a section begins with the key of its parameter.
std::string parameterReference(const ReadingStyle& style);
/// Returns the chapter of the manual on all outputs, in Markdown.
std::string outputReference(const ReadingStyle& style);

/// Returns the section of the manual on one parameter or output, in Markdown with its heading, as the command
/// `help` prints it.
std::string referenceOf(const Parameter& parameter, const ReadingStyle& style);
std::string referenceOf(const SectionField& field, const ReadingStyle& style);
std::string referenceOf(const WordParameter& parameter, const ReadingStyle& style);
std::string referenceOf(const Output& output, const ReadingStyle& style);

/// Returns the name of the scale by which a dimensionless output is multiplied to give SI, such as "I0" or
/// "t0"; "–" if the output has none.
std::string_view scaleName(const Output& output);
/// Returns the name of the SI unit of an output; "–" if the output has none.
std::string_view siName(const Output& output);

}  // namespace drillwave
