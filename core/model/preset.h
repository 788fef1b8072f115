// SPDX-License-Identifier: GPL-3.0-or-later
// Presets: named sets of values for a part of a scenario, such as a rod, a hammer or a rock.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/model/drill_string.h"
#include "core/model/parameter.h"
#include "core/model/scenario.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Part of a scenario that a preset sets.
enum class PresetKind { rod, hammer, rock };

/// Value of one parameter of a preset, with its source.
struct PresetValue {
    const Parameter* parameter = nullptr;
    double si = 0;
    std::string source;  ///< source of the value, never empty; begins with "assumed" if there is no source
    bool operator==(const PresetValue&) const = default;
};

/// Named set of values for a rod, hammer or rock. Applying it changes only these values. A preset of a rock
/// always sets the loading curve.
struct Preset {
    PresetKind kind = PresetKind::rod;
    std::string name;
    std::optional<PulseShape> shape;  ///< shape of the force, for a hammer; else nullopt
    std::string shapeSource;
    RockLaw law = RockLaw::bilinear;  ///< form of the loading curve, for a rock; corner forces are in N
    std::vector<RockCorner> corners;
    std::string lawSource;            ///< source of the loading curve; empty if the file gives none
    std::vector<PresetValue> values;  ///< values in the order of parameters()
    bool operator==(const Preset&) const = default;
};

/// Returns the scenario with the values of a preset. A hammer of the shape `piston` gets the material of the
/// rod unless the preset sets one. The result may be invalid: call validate(). Requires a scenario in
/// physical units. For a preset of a rod or hammer, it must be a uniform rod.
Scenario withPreset(Scenario scenario, const Preset& preset);

/// Returns whether the scenario already has all values of a preset; false if the preset cannot be used for
/// it.
bool matches(const Preset& preset, const Scenario& scenario);

/// Returns the name of a preset, followed by its translation if there is one: "soft rock — weiches Gestein".
/// Commands accept only the untranslated name.
std::string nameFor(const std::string& name, const ReadingStyle& style);

/// Returns the description of a preset. First comes the pulse shape or loading curve, if it sets one, then
/// one line per value with its source, "diameter: 38 mm — nominal".
std::string description(const Preset& preset, const ReadingStyle& style);

// Named sections of a drill string: a piston, an adapter, a coupling or a bit.

enum class SectionPresetKind { piston, adapter, coupling, bit };
inline constexpr auto sectionPresetKinds = allValues<SectionPresetKind>;

/// Returns the name of a kind of preset sections, "piston". Its plural, "pistons", is the key of the list of
/// such presets in a file.
std::string_view name(SectionPresetKind kind);

/// Preset for sections of a drill string, such as a coupling: their name, sizes and the source of the
/// numbers.
struct SectionPreset {
    SectionPresetKind kind = SectionPresetKind::coupling;
    std::string name;
    std::string source;  ///< source of the numbers, never empty; begins with "assumed" if there is no source
    /// Source of yield and fatigue strength; empty if `source` applies to them too.
    std::string strengthSource;
    std::optional<double> velocity;  ///< impact velocity [m/s], for a piston that has one
    /// Sections of the preset, at least one, from the rear end to the end towards the rock. Each has the name
    /// of the preset.
    std::vector<Section> sections;
    bool operator==(const SectionPreset&) const = default;
};

/// Returns a text with the sizes of the sections, the impact velocity and the source: "300 mm × 50 mm, 250 mm
/// × 38 mm, 10 m/s — assumed". If the strengths have another source, a second line gives them.
std::string description(const SectionPreset& preset, const ReadingStyle& style);

/// Returns a hammer with its sections replaced by those of a piston, and its velocity too if the preset has
/// one. Requires a preset of a piston.
Hammer withPiston(Hammer hammer, const SectionPreset& piston);

// Presets as values of a study: hammers, rods, bits and rocks are chosen by name.

/// Part of a scenario that a preset replaces in a study.
enum class PresetPart { hammer, rod, bit, rock };

/// Returns the name of a part on the command line: "hammer", "rod", "bit" or "rock".
std::string_view name(PresetPart part);
std::optional<PresetPart> findPresetPart(std::string_view name);

/// Preset that can replace a part of a scenario. A SectionPreset replaces the hammer or bit of a drill
/// string. A Preset replaces the rock, or the rod or hammer force of a scenario with a uniform rod.
using PartPreset = std::variant<Preset, SectionPreset>;
const std::string& nameOf(const PartPreset& preset);

/// Returns why no preset can replace this part of the scenario; empty if one can.
Message partProblem(PresetPart part, const Scenario& scenario);

/// Returns whether a preset is of the kind that can replace this part of the scenario. Requires that
/// partProblem() is empty.
bool suits(const PartPreset& preset, PresetPart part, const Scenario& scenario);

/// Replaces a part of the scenario, such as the hammer, by a preset. Returns an empty message when done, else
/// why the part cannot be replaced. Requires that suits() is true.
Message replacePart(Scenario& scenario, PresetPart part, const PartPreset& preset);

/// Presets to choose from for one part of a scenario, such as the hammer; at least one. The list cannot be
/// copied or changed, because words() refers to the names in it.
class PresetChoice {
  public:
    PresetChoice(PresetPart part, std::vector<PartPreset> presets);
    PresetChoice(const PresetChoice&) = delete;
    PresetChoice& operator=(const PresetChoice&) = delete;

    PresetPart part() const { return m_part; }
    const std::vector<PartPreset>& presets() const { return m_presets; }
    /// Returns the names of the presets, in the order of presets().
    std::span<const std::string_view> words() const { return m_words; }
    /// Returns the keys of the parameters that any of the presets sets, each once. For presets of sections,
    /// only the key of the impact velocity is listed. Form and corners of a loading curve are left out.
    std::vector<std::string_view> keys() const;

  private:
    PresetPart m_part;
    std::vector<PartPreset> m_presets;
    std::vector<std::string_view> m_words;
};

/// Shared pointer, possibly empty, to the presets over which an axis of a study varies. Copies of the axis
/// share the list. Two pointers are equal if their lists are for the same part of a scenario and have equal
/// presets.
class SharedPresetChoice {
  public:
    SharedPresetChoice() = default;
    explicit SharedPresetChoice(std::shared_ptr<const PresetChoice> choice) : m_choice(std::move(choice)) {}

    explicit operator bool() const { return m_choice != nullptr; }
    const PresetChoice& operator*() const { return *m_choice; }
    const PresetChoice* operator->() const { return m_choice.get(); }
    friend bool operator==(const SharedPresetChoice& one, const SharedPresetChoice& other);

  private:
    std::shared_ptr<const PresetChoice> m_choice;
};

/// Index of a name in a list, or the reason why it was not found.
struct FoundName {
    std::size_t number = 0;
    Message problem;
};

/// Returns the index of the preset with this name, ignoring capitals, or of the only preset whose name begins
/// with it. So `T51` finds "T51, round 52 mm". `list` is the command that lists all names, for the message if
/// none is found.
FoundName findPresetName(std::span<const std::string_view> names, std::string_view wanted,
                         const std::string& list);

}  // namespace drillwave
