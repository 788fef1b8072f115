// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the sections of a hammer and a string (section_field.h), and "string.repeat", as parameters,
// so that --set, sweeps, tables, curves and maps take them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/section_field.h"

namespace drillwave {

/// The parameter of such a key, or none. May be called from several threads.
KeptParameter findSectionParameter(std::string_view key);

/// Whether the scenario has sections, or a repeat, that the parameter of the scope `section` is about.
bool hasSectionFor(const Parameter& parameter, const Scenario& scenario);

/// Returns whether both set the same number, or numbers that replace each other, of sections that may be the
/// same ones: a name and a place, or two places.
bool mayMeet(const Parameter& one, const Parameter& other);

/// Returns why the two cannot both be set, to be written after their keys: "set one section, …", if the file
/// has it once; empty if they can. The two scenarios only differ in their repeats: each place counts in its
/// own scenario.
Message meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                       const Scenario& ofOther);

/// Returns why there is no such section: "no section of the string is called `adaptor`; did you mean …?".
Message whyNoSection(const Parameter& parameter, const Scenario& scenario);

/// Returns every number that a section of a string scenario has, in the order of a file; and the repeat.
std::vector<KeptParameter> sectionParameters(const Scenario& scenario);

/// Returns the name of the section that a parameter belongs to; empty without a section or a name.
std::string sectionName(const Parameter& parameter, const Scenario& scenario);

// The numbers of sections that are worth varying, to be chosen from a list.

/// Returns every number of a section that changes the results of a string, once, in the order of a file, the
/// repeat before the sections of the string: by name ("string.coupling.diameter") where all sections of that
/// name agree in it, else by place. Empty for a uniform rod.
std::vector<KeptParameter> variableSectionParameters(const Scenario& scenario);

/// Returns the diameter, or area, of the section that matters first in a string: of those called "coupling",
/// else of the first ones in a repeat, else of the first one; nullptr for a uniform rod.
KeptParameter typicalSize(const Scenario& scenario);

}  // namespace drillwave
