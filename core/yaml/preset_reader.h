// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a YAML text to presets, with every problem and its place.
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

// Common part of all lists of a file of presets: items that are maps, each with a name of its own.

/// One list while it is read; problems go to the reader, which must outlive it.
class PresetList {
  public:
    /// `key` is that of the list, "rods".
    PresetList(SectionReader& reader, std::string_view key) : m_reader(reader), m_key(key) {}

    /// Calls `read` with every item that can be a preset. No list at all is an empty one.
    void readItems(const YamlNode& list, const std::function<void(const YamlNode&)>& read);
    /// The text of a key that an item must have; empty where it is none that can be shown.
    std::string textOf(const YamlEntries& entries, const YamlNode& item, std::string_view key,
                       const char* missing = translatable("is missing"));
    /// Its name, which no item before has.
    std::string nameOf(const YamlEntries& entries, const YamlNode& item);

  private:
    SectionReader& m_reader;
    std::string_view m_key;
    std::set<std::string> m_names;
};

// Pistons, adapters, couplings and bits of a file of presets.

/// The keys of their lists: "pistons" and so on.
std::span<const std::string_view> sectionPresetLists();

/// Reads those lists. `file` are the entries of the whole file; problems go to the reader.
std::vector<SectionPreset> readSectionPresets(SectionReader& reader, const YamlEntries& file);

class PresetReader {
  public:
    explicit PresetReader(std::string_view text) : m_reader(text) {}

    /// Good for nothing if there are problems.
    std::vector<Preset> read(const YamlNode& root);
    /// Returns the presets of sections; after read().
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
