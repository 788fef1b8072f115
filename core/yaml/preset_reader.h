// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a YAML text to presets, with every problem and its place.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/preset.h"
#include "core/model/section_preset.h"
#include "core/yaml/preset_list.h"
#include "core/yaml/section_reader.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

class PresetReader {
  public:
    explicit PresetReader(std::string_view text) : m_reader(text) {}

    /// Good for nothing if there are problems.
    std::vector<Preset> read(const YamlNode& root);
    /// Those of sections; after read().
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
