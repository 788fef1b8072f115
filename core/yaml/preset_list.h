// SPDX-License-Identifier: GPL-3.0-or-later
// What all lists of a file of presets have in common: items that are maps, each with a name of its own.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/yaml/section_reader.h"

namespace drillwave {

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

}  // namespace drillwave
