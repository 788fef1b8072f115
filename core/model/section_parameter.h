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

/// Returns the parameter with a key such as "string.3.length" (a number of a section) or "string.repeat" (the
/// number of repeats). Returns none for any other key. Thread-safe.
KeptParameter findSectionParameter(std::string_view key);

/// Returns whether the parameter can be set in the scenario. For a number of a section, a matching section
/// must exist and may have this number. For "string.repeat", there must be a repeat. Requires a parameter of
/// the scope `section`.
bool hasSectionFor(const Parameter& parameter, const Scenario& scenario);

/// Returns whether two parameters may set the same number of the same section, depending on the scenario.
/// "string.rod.length" and "string.3.length" do if the third section is called rod. Two section numbers may
/// also be copies of one section in a repeat.
bool mayMeet(const Parameter& one, const Parameter& other);

/// Returns why the parameters `one` and `other` cannot both be set because they set the same section: "set
/// one section: …". The text follows the two keys in a message; empty if there is no conflict. `one` is set
/// in the scenario `ofOne`, `other` in `ofOther`. The two scenarios may differ only in the number of repeats.
Message meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                       const Scenario& ofOther);

/// Returns why a scenario has no section for this parameter: "no section of the string is called `adaptor`;
/// did you mean …?".
Message whyNoSection(const Parameter& parameter, const Scenario& scenario);

/// Returns one parameter for each number that is given in the sections, in the order of a scenario file. If
/// there is a repeat, "string.repeat" is between those of the hammer and those of the string.
std::vector<KeptParameter> sectionParameters(const Scenario& scenario);

/// Returns the name of the section that a parameter belongs to. Empty if the parameter belongs to no section,
/// or if the section has no name.
std::string sectionName(const Parameter& parameter, const Scenario& scenario);

// Numbers of sections that are worth varying, for a list to choose from.

/// Returns every number of the sections that changes the results of a drill string, in the order of a
/// scenario file. If all sections of one name have the same value, they share one key with this name:
/// "string.coupling.diameter". Otherwise each section has a key with its number. "string.repeat" is between
/// hammer and string. Empty for a uniform rod.
std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario);

/// Returns the size that a study of a drill string proposes to vary: the diameter, or area, of its couplings.
/// Without couplings, it is that of the first section in a repeat, else of the first section. Empty for a
/// uniform rod.
KeptParameter typicalSize(const Scenario& scenario);

}  // namespace drillwave
