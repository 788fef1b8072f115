// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of the sections of a hammer and a string as parameters, so that --set, sweeps, tables, curves and
// maps take them: "string.adapter.length" (all sections of that name, `_` standing for a blank too),
// "string.3.length" (by place from 1, repeats written out), "hammer.1.diameter", and "string.repeat". A
// section inside a repeat stands in a file once: whichever of its places is set, it is set in every repeat.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/parameter.h"
#include "core/model/section_field.h"

namespace drillwave {

/// Which number of which sections.
struct SectionAddress {
    enum class Chain { hammer, string };
    Chain chain = Chain::string;
    std::string name;         ///< of the sections; empty where a place is given
    std::uint64_t place = 0;  ///< from 1; 0 where a name is given
    const SectionField* field = nullptr;

    /// Whether both are about the same name or place of the same chain.
    bool hasSameSections(const SectionAddress& other) const;
};

/// The parameter of such a key, or none. May be called from several threads.
KeptParameter findSectionParameter(std::string_view key);

/// "string.3", the section of that place.
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place);
/// "string.3.length", its number of that key.
std::string sectionKey(SectionAddress::Chain chain, std::uint64_t place, std::string_view field);

/// Whether the scenario has sections, or a repeat, that the parameter of the scope `section` is about.
bool hasSectionFor(const Parameter& parameter, const Scenario& scenario);

/// Whether both set the same number, or numbers that replace each other, of sections that may be the same
/// ones: a name and a place, or two places.
bool mayMeet(const Parameter& one, const Parameter& other);

/// Why the two cannot both be set, as what stands behind their keys: "set one section, …", where a section
/// that stands in the file once is both; empty when none is. The two scenarios differ in their repeats alone:
/// places count in that of their own.
std::string meetingProblem(const Parameter& one, const Scenario& ofOne, const Parameter& other,
                           const Scenario& ofOther);

/// Why not: "no section of the string is called `adaptor`; did you mean `adapter`?".
std::string whyNoSection(const Parameter& parameter, const Scenario& scenario);

/// The known key most like a mistyped one of a section, as far as it can be told without a scenario; empty
/// when none is close.
std::string nearestSectionKey(std::string_view key);

/// Every number that a section of a string scenario has, by place, in the order of a file; and the repeat.
std::vector<KeptParameter> sectionParameters(const Scenario& scenario);

/// What the section is called that a parameter is about; empty where it is about none or one without a name.
std::string sectionName(const Parameter& parameter, const Scenario& scenario);

/// Why a section cannot have that name: "must be …"; empty when it can.
std::string sectionNameProblem(std::string_view name);

}  // namespace drillwave
