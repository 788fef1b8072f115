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

/// Returns the parameter with a key such as "string.3.length" for a number of a section, or "string.repeat"
/// for the number of repeats. Empty for any other key. Thread-safe.
KeptParameter findSectionParameter(std::string_view key);

/// Returns whether the scenario has the section with the number, or the repeat, that this parameter sets.
/// Requires a parameter of the scope `section`.
bool hasSectionFor(const Parameter& parameter, const Scenario& scenario);

/// Returns whether two parameters of sections may contradict each other, depending on the scenario.
/// "string.rod.length" and "string.3.length" do if the third section is called rod. The same holds for two
/// numbers of sections that may be copies in one repeat.
bool mayMeet(const Parameter& one, const Parameter& other);

/// Returns why two parameters of sections cannot both be set, as words that follow their keys in a message:
/// "set one section: …". Empty if they can. Sections of `one` are those of the scenario `ofOne`, sections of
/// `other` those of `ofOther`. The two scenarios may differ only in the number of repeats.
Message meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                       const Scenario& ofOther);

/// Returns why a scenario has no section for this parameter: "no section of the string is called `adaptor`;
/// did you mean …?".
Message whyNoSection(const Parameter& parameter, const Scenario& scenario);

/// Returns every number that the sections have as a parameter, in the order of a file: hammer, number of
/// repeats, string.
std::vector<KeptParameter> sectionParameters(const Scenario& scenario);

/// Returns the name of the section that a parameter belongs to. Empty if the parameter belongs to no section,
/// or if the section has no name.
std::string sectionName(const Parameter& parameter, const Scenario& scenario);

// Numbers of sections that are worth varying, for a list to choose from.

/// Returns every number of the sections that changes the results of a drill string, in the order of a file.
/// The key contains the name of the section, "string.coupling.diameter", if all sections of that name have
/// the same value, else its number. "string.repeat" is between hammer and string. Empty for a uniform rod.
std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario);

/// Returns the size that a study of a drill string proposes to vary: the diameter, or area, of its couplings.
/// Without couplings, it is that of the first section in a repeat, else of the first section. Empty for a
/// uniform rod.
KeptParameter typicalSize(const Scenario& scenario);

}  // namespace drillwave
