// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the sections of a hammer and a string (section_field.h), and "string.repeat", as parameters for
// --set, sweeps, tables, curves and maps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/section_field.h"

namespace drillwave {

/// Returns the parameter of a section with a key such as "string.3.length", or "string.repeat"; empty for any
/// other key. Thread-safe.
KeptParameter findSectionParameter(std::string_view key);

/// Returns whether the scenario has the section, or the repeat, that this parameter sets. Requires a
/// parameter of the scope `section`.
bool hasSectionFor(const Parameter& parameter, const Scenario& scenario);

/// Returns whether two parameters can set the same number, or numbers that exclude each other, of one
/// section. This is possible if one is by name and one by position, or for two positions in a repeat.
bool mayMeet(const Parameter& one, const Parameter& other);

/// Returns why two parameters of sections cannot both be set, in words that follow their keys: "set one
/// section: …". Empty if they can. A section number in `one` refers to the scenario `ofOne`, one in `other`
/// to `ofOther`. The two scenarios may differ only in the number of repeats.
Message meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                       const Scenario& ofOther);

/// Returns why a scenario has no section for this parameter: "no section of the string is called `adaptor`;
/// did you mean …?".
Message whyNoSection(const Parameter& parameter, const Scenario& scenario);

/// Returns every number that a section of hammer or string has, in the order of a file, and the number of
/// repeats.
std::vector<KeptParameter> sectionParameters(const Scenario& scenario);

/// Returns the name of the section that a parameter belongs to; empty if it has no section, or the section no
/// name.
std::string sectionName(const Parameter& parameter, const Scenario& scenario);

// Numbers of sections that are worth varying, for a list to choose from.

/// Returns every number of the sections that changes the results of a drill string, in the order of a file. A
/// number is by name ("string.coupling.diameter") if all sections of that name have the same value, else by
/// position. "string.repeat" is between hammer and string. Empty for a uniform rod.
std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario);

/// Returns the diameter, or area, of the most important section of a drill string. These are the couplings,
/// else the first section in a repeat, else the first section. Empty for a uniform rod.
KeptParameter typicalSize(const Scenario& scenario);

}  // namespace drillwave
