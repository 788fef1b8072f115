// SPDX-License-Identifier: GPL-3.0-or-later
// A string of sections and the hammer that strikes it, as plain values (files §1.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Material of every section that names none of its own.
struct Material {
    double youngsModulus = 210e9;  ///< E [Pa]
    double density = 7850;         ///< ρ [kg/m³]
    bool operator==(const Material&) const = default;
};

/// Section of a hammer or a string: uniform, or a cone whose diameter changes evenly. Its far end is the one
/// towards the rock.
struct Section {
    std::string name;  ///< "rod", may be empty; several sections may share it
    std::string
        preset;  ///< "T38, 190 mm": the preset that the section is from; may be empty, changes no result
    double length = 0;    ///< L [m]
    double diameter = 0;  ///< outer diameter [m], of a cone at its rear end; unused when `area` is given
    double bore = 0;      ///< flushing hole diameter [m]; unused when `area` is given
    std::optional<double> area;           ///< A [m²], of a cone at its rear end; replaces diameter and bore
    std::optional<double> endDiameter;    ///< [m] of a cone at its far end; unused when `area` is given
    std::optional<double> endArea;        ///< [m²] of a cone at its far end; unused unless `area` is given
    std::optional<double> youngsModulus;  ///< E [Pa], the material's when not given
    std::optional<double> density;        ///< ρ [kg/m³], the material's when not given
    double massAfter = 0;                 ///< M [kg], lumped at the far end; M_b after the last section
    double loss = 0;         ///< η, share of the energy of a wave lost in the joint at the far end
    double attenuation = 0;  ///< α [1/m], decay of the amplitude of a wave
    std::optional<double> yieldStrength;    ///< [Pa] stress above which there is an alert; changes no result
    std::optional<double> fatigueStrength;  ///< [Pa] tension above which there is an alert, for many blows
    bool operator==(const Section&) const = default;
};

/// Item of a string: a section, or several that are repeated.
struct StringPart {
    int repeat = 1;                 ///< how often the sections follow one another; 1 unless `group`
    bool group = false;             ///< written as a repeat, even a single one
    std::vector<Section> sections;  ///< exactly one unless `group`
    bool operator==(const StringPart&) const = default;
};

/// Hammer: the sections that strike, all with the same velocity.
struct Hammer {
    double velocity = 10;                 ///< v0 [m/s] at impact
    std::vector<Section> sections;        ///< from the rear to the face; none: a force drives the string
    std::optional<double> faceStiffness;  ///< k_c [N/m] between hammer and string; rigid when not given
    bool restrike = true;  ///< the hammer stays to be hit again; false: withdrawn once separated
    bool operator==(const Hammer&) const = default;
};

/// Hammer and string.
struct DrillString {
    Material material;
    Hammer hammer;
    std::vector<StringPart> parts;  ///< from the shank to the bit
    std::optional<double> endTime;  ///< [s] until when the blow is followed; to its end when not given
    bool operator==(const DrillString&) const = default;
};

/// Most sections of a string, its repeats written out, and of a hammer.
inline constexpr std::size_t maximumSections = 1000;

/// Number of sections of the string with its repeats written out; saturates instead of overflowing.
std::uint64_t sectionCount(const DrillString& drillString);

/// Returns the sections of the string from shank to bit with repeats written out, so that those of a repeat
/// are in it several times. Requires at most maximumSections of them.
std::vector<const Section*> expandedSections(const DrillString& drillString);

/// Returns the sections of the hammer from its rear, then those of the string, expanded: order of results.
std::vector<const Section*> allSections(const DrillString& drillString);

/// Section as in a file, once, and the first place (from 1) that it has in the string.
struct PlacedSection {
    const Section* section = nullptr;
    std::uint64_t place = 1;
};
/// Returns every section of the string once, in the order of a file.
std::vector<PlacedSection> placedSections(const DrillString& drillString);

/// Returns the section at a place, counted from 1 with repeats written out; nullptr after the last one. All
/// places that a repeat gives to a section return the same one.
const Section* sectionAt(const DrillString& drillString, std::uint64_t place);

/// The first part that is a repeat, or nullptr.
const StringPart* firstRepeat(const DrillString& drillString);

/// Returns the section that the scales of the string refer to: the first one called "rod", or else the
/// longest; nullptr without sections.
const Section* ruleSection(const DrillString& drillString);

}  // namespace drillwave
