// SPDX-License-Identifier: GPL-3.0-or-later
// Presets as values to choose from: hammers, rods and bits by their names.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/model/preset.h"
#include "core/model/scenario.h"
#include "core/model/section_preset.h"
#include "core/text/message.h"

namespace drillwave {

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

/// Finds the name, whatever its case, or the only one that begins with it: `T51` for "T51, round 52 mm".
/// `list` is the command that lists all names, for the message.
FoundName findPresetName(std::span<const std::string_view> names, std::string_view wanted,
                         const std::string& list);

}  // namespace drillwave
