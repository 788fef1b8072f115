// SPDX-License-Identifier: GPL-3.0-or-later
// Drill string of sections and the hammer that strikes it, as plain values (files §1.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace drillwave {

/// Material of every section that does not have a material of its own.
struct Material {
    double youngsModulus = 210e9;  ///< Young's modulus E [Pa]
    double density = 7850;         ///< density ρ [kg/m³]
    bool operator==(const Material&) const = default;
};

/// Section of a hammer or drill string: uniform, or a cone whose diameter changes linearly. Its far end is
/// the one towards the rock.
struct Section {
    std::string name;  ///< name of the section, "rod"; may be empty, and several sections may have the same
    /// Name of the preset that the section is from, "T38, 190 mm"; may be empty, has no effect on results.
    std::string preset;
    double length = 0;    ///< length L [m]
    double diameter = 0;  ///< outer diameter [m], for a cone at its rear end; unused if `area` is given
    double bore = 0;      ///< diameter of the flushing hole [m]; unused if `area` is given
    /// Cross-section A [m²], for a cone at its rear end; if given, replaces diameter and bore.
    std::optional<double> area;
    /// Outer diameter of a cone at its end towards the rock [m]; unused if `area` is given.
    std::optional<double> endDiameter;
    /// Cross-section of a cone at its end towards the rock [m²]; used only if `area` is given.
    std::optional<double> endArea;
    std::optional<double> youngsModulus;  ///< Young's modulus E [Pa] (default: that of the common material)
    std::optional<double> density;        ///< density ρ [kg/m³] (default: that of the common material)
    /// Mass M [kg] lumped at the end towards the rock; after the last section it is the mass M_b of the bit.
    double massAfter = 0;
    /// Share η of the energy of a wave that is lost in the joint at the end towards the rock, 0 ≤ η < 1.
    double loss = 0;
    double attenuation = 0;  ///< decay α of the amplitude of a wave per length [1/m]
    /// Yield strength [Pa]; a higher stress raises a warning but changes no result.
    std::optional<double> yieldStrength;
    /// Fatigue strength [Pa] for many blows; a higher tensile stress raises a warning.
    std::optional<double> fatigueStrength;
    bool operator==(const Section&) const = default;
};

/// Part of a drill string: one section, or a repeat of several sections.
struct StringPart {
    /// Number of times that the sections of a repeat follow one another; 1 if `group` is false.
    int repeat = 1;
    bool group = false;             ///< whether the file lists the part as a repeat, even of a single section
    std::vector<Section> sections;  ///< sections of the part from its rear end, exactly one unless `group`
    bool operator==(const StringPart&) const = default;
};

/// Hammer: the sections that strike the drill string, all with the same velocity.
struct Hammer {
    double velocity = 10;  ///< impact velocity v0 [m/s]
    /// Sections of the hammer from its rear to its face. Empty if a prescribed force acts instead.
    std::vector<Section> sections;
    std::optional<double> faceStiffness;  ///< stiffness k_c between hammer and string [N/m] (default: rigid)
    /// Whether the hammer may strike again in the same blow. If false, the hammer is removed when it
    /// separates.
    bool restrike = true;
    bool operator==(const Hammer&) const = default;
};

/// Hammer and drill string with their common material.
struct DrillString {
    Material material;
    Hammer hammer;
    std::vector<StringPart> parts;  ///< parts from the shank adapter to the bit
    /// Time [s] at which the simulation of the blow ends (default: when the blow is over).
    std::optional<double> endTime;
    bool operator==(const DrillString&) const = default;
};

/// Largest number of sections of a drill string (with its repeats expanded) or of a hammer.
inline constexpr std::size_t maximumSections = 1000;

/// Returns the number of sections of the string, with repeats expanded. If it is too large for std::uint64_t,
/// returns the largest value of that type.
std::uint64_t sectionCount(const DrillString& drillString);

/// Returns the sections of the string from shank adapter to bit, with repeats expanded: a section in a repeat
/// occurs several times. Requires at most maximumSections of them.
std::vector<const Section*> expandedSections(const DrillString& drillString);

/// Returns the sections of the hammer from its rear, then those of the string with repeats expanded. Results
/// for each section are in this order.
std::vector<const Section*> allSections(const DrillString& drillString);

/// Section of a drill string with its position: its number in the string, from 1 with repeats expanded. A
/// section inside a repeat has the number of its first copy.
struct PlacedSection {
    const Section* section = nullptr;
    std::uint64_t place = 1;
};
/// Returns every section of the string once, in the order of a scenario file, with its number in the string.
std::vector<PlacedSection> placedSections(const DrillString& drillString);

/// Returns the section at a position, from 1 with repeats expanded, or nullptr after the last one. All copies
/// that a repeat makes of a section return the same pointer.
const Section* sectionAt(const DrillString& drillString, std::uint64_t place);

/// Returns the first part of the string that is a repeat, or nullptr.
const StringPart* firstRepeat(const DrillString& drillString);

/// Returns the section whose impedance and cross-section the scales of results use: the first one named
/// "rod", else the longest one. Returns nullptr if the string has no sections.
const Section* ruleSection(const DrillString& drillString);

}  // namespace drillwave
