// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of parsed YAML to presets, with all errors and their positions.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/preset.h"
#include "core/yaml/section_reader.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

// Common part of all lists of a preset file. Their items are maps with different names.

/// Reader of one list of presets. Errors go to `reader`, which must outlive it.
class PresetList {
  public:
    /// Makes a reader of the list with this key, such as "rods". Errors are reported to `reader`.
    PresetList(SectionReader& reader, std::string_view key) : m_reader(reader), m_key(key) {}

    /// Calls `read` for every item of the list that is a map, and reports an error for any other item. An
    /// absent list counts as empty.
    void readItems(const YamlNode& list, const std::function<void(const YamlNode&)>& read);
    /// Returns the text of a required key of a preset. If the text is missing or invalid, reports an error
    /// and returns an empty text.
    std::string textOf(const YamlEntries& entries, const YamlNode& item, std::string_view key,
                       const char* missing = translatable("is missing"));
    /// Returns the name of `item`, a preset in the list. Reports an error if the name is missing or an
    /// earlier preset has it.
    std::string nameOf(const YamlEntries& entries, const YamlNode& item);

  private:
    SectionReader& m_reader;
    std::string_view m_key;
    std::set<std::string> m_names;
};

// Pistons, adapters, couplings and bits of a preset file.

/// Returns the keys of the lists of sections: "pistons", "adapters", "couplings", "bits".
std::span<const std::string_view> sectionPresetLists();

/// Returns the presets of sections in a file. `file` has the entries of the entire file; errors go to
/// `reader`.
std::vector<SectionPreset> readSectionPresets(SectionReader& reader, const YamlEntries& file);

class PresetReader {
  public:
    explicit PresetReader(std::string_view text) : m_reader(text) {}

    /// Reads a preset file and returns its presets of rods, hammers and rocks. If takeProblems() then returns
    /// errors, the presets are invalid.
    std::vector<Preset> read(const YamlNode& root);
    /// Returns the presets of sections that read() has found.
    std::vector<SectionPreset> takeSectionPresets() { return std::move(m_sectionPresets); }
    std::vector<InputProblem> takeProblems() { return m_reader.problems().take(); }

  private:
    struct Section;

    bool readFormat(const YamlNode& root);
    void readList(const YamlNode& list, const Section& section);
    void readPreset(PresetList& list, const YamlNode& item, const Section& section);
    YamlEntries valuesOf(const YamlEntries& entries, const Section& section);
    void readValues(Preset& preset, const YamlEntries& values, const YamlEntries& entries,
                    const Section& section, bool isKindKnown);
    bool readKind(Preset& preset, const YamlEntries& values, const YamlEntries& entries);
    bool readShape(Preset& preset, const YamlEntries& values, const YamlEntries& entries);
    bool readCurve(Preset& preset, const YamlEntries& values, const YamlEntries& entries);
    void requireKeys(const Preset& preset, const YamlEntries& entries, const YamlNode& item);
    void checkPhysics(const YamlNode& item, const Section& section);

    SectionReader m_reader;
    std::vector<Preset> m_presets;
    std::vector<SectionPreset> m_sectionPresets;
};

}  // namespace drillwave
