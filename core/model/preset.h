// SPDX-License-Identifier: GPL-3.0-or-later
// A named set of values for a part of a scenario: a rod, a hammer, a rock.
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

/// The part of a scenario that a preset is for.
enum class PresetKind { rod, hammer, rock };

/// Value with its source.
struct PresetValue {
    const Parameter* parameter = nullptr;
    double si = 0;
    std::string source;  ///< never empty; begins with "assumed" where there is none
    bool operator==(const PresetValue&) const = default;
};

/// Named set of values; assigning it changes only these. A rock has a loading curve, named or not.
struct Preset {
    PresetKind kind = PresetKind::rod;
    std::string name;
    std::optional<PulseShape> shape;  ///< of a hammer, else nothing
    std::string shapeSource;
    RockLaw law = RockLaw::bilinear;  ///< of a rock, with its corners in SI
    std::vector<RockCorner> corners;
    std::string lawSource;            ///< empty if the file has no law
    std::vector<PresetValue> values;  ///< in the order of parameters()
    bool operator==(const Preset&) const = default;
};

/// The scenario with the preset's values; the hammer of a `piston` has the rod's material unless the preset
/// names one. It may be invalid, so validate() it. Requires a scenario in physical units, and for a rod and a
/// hammer one of a uniform rod.
Scenario withPreset(Scenario scenario, const Preset& preset);

/// Whether taking the preset would change nothing; never where it cannot be taken.
bool matches(const Preset& preset, const Scenario& scenario);

/// Returns "soft rock — weiches Gestein": the name of a preset, as commands take it, and its translation for
/// a reader of another language.
std::string nameFor(const std::string& name, const ReadingStyle& style);

/// "diameter: 38 mm — nominal", one line for the shape or the law and for each value.
std::string description(const Preset& preset, const ReadingStyle& style);

// A named piece of a drill string: a piston, an adapter, a coupling, a bit.

enum class SectionPresetKind { piston, adapter, coupling, bit };
inline constexpr auto sectionPresetKinds = allValues<SectionPresetKind>;

/// "piston" and so on; its list in a file is called "pistons".
std::string_view name(SectionPresetKind kind);

/// Sections with one source for all of them.
struct SectionPreset {
    SectionPresetKind kind = SectionPresetKind::coupling;
    std::string name;
    std::string source;  ///< never empty; begins with "assumed" where there is none
    std::string
        strengthSource;  ///< the source of yield and fatigue strength; empty where `source` covers them
    std::optional<double> velocity;  ///< [m/s] at impact, for a piston that has one
    std::vector<Section> sections;   ///< at least one, from the rear; each has the name of the preset
    bool operator==(const SectionPreset&) const = default;
};

/// "300 mm × 50 mm, 250 mm × 38 mm, 10 m/s — assumed", and strengths with their source in a line of their
/// own.
std::string description(const SectionPreset& preset, const ReadingStyle& style);

/// Returns the hammer with the sections of a piston, and its velocity if it has one. Requires a piston.
Hammer withPiston(Hammer hammer, const SectionPreset& piston);

// Presets as values to choose from: hammers, rods and bits by their names.

/// The part of a scenario that a chosen preset replaces.
enum class PresetPart { hammer, rod, bit };

/// "hammer", "rod", "bit".
std::string_view name(PresetPart part);
std::optional<PresetPart> findPresetPart(std::string_view name);

/// A preset that can replace a part: a section preset for drill strings, a preset for uniform rods.
using PartPreset = std::variant<Preset, SectionPreset>;
const std::string& nameOf(const PartPreset& preset);

/// Returns why no preset can replace that part of the scenario; empty when one can.
Message partProblem(PresetPart part, const Scenario& scenario);

/// Returns whether the preset replaces that part of the scenario. Requires that there is no partProblem().
bool suits(const PartPreset& preset, PresetPart part, const Scenario& scenario);

/// Replaces the part. Returns why it cannot; empty when done.
Message replacePart(Scenario& scenario, PresetPart part, const PartPreset& preset);

/// Chosen presets of one part, at least one. Immutable once made: words() refers to its own names.
class PresetChoice {
  public:
    PresetChoice(PresetPart part, std::vector<PartPreset> presets);
    PresetChoice(const PresetChoice&) = delete;
    PresetChoice& operator=(const PresetChoice&) = delete;

    PresetPart part() const { return m_part; }
    const std::vector<PartPreset>& presets() const { return m_presets; }
    /// The names of the presets.
    std::span<const std::string_view> words() const { return m_words; }
    /// Returns the keys that any of the presets sets, each once; of a section preset none but the velocity.
    std::vector<std::string_view> keys() const;

  private:
    PresetPart m_part;
    std::vector<PartPreset> m_presets;
    std::vector<std::string_view> m_words;
};

/// A choice shared by copies of an axis, or none. Two are equal that choose equal presets.
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

/// A name found among others, or why not.
struct FoundName {
    std::size_t number = 0;
    Message problem;
};

/// Returns the preset of that name, ignoring case, or the only one that begins with it: `T51` for "T51, round
/// 52 mm". `list` is the command that lists all names, for the message.
FoundName findPresetName(std::span<const std::string_view> names, std::string_view wanted,
                         const std::string& list);

}  // namespace drillwave
