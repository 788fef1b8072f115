// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a text at the places of its YAML: values, entries of maps, items of lists.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/text_edit.h"
#include "core/yaml/yaml_extent.h"
#include "core/yaml/yaml_tree.h"

namespace drillwave {

/// Thrown by edits that cannot be made in place: something has to be written again.
struct NotPatchable {};

/// Collects edits of a text. Lines that no edit names stay byte for byte; lines that are only comments stay
/// also where their item or entry goes. Edits throw NotPatchable.
class YamlEdits {
  public:
    /// The text must outlive the edits.
    explicit YamlEdits(std::string_view text);

    /// Returns the text with all edits.
    std::string edited() &&;
    /// Makes the edits of `patch`; without effect and false if it throws NotPatchable.
    bool attempt(const std::function<void()>& patch);

    /// Adds lines at the end of the text, as all texts with "\n" at their ends.
    void append(const std::string& lines) { insertLines(m_text.size(), inLines(lines)); }
    /// Replaces a value. A comment after it described the value that was there, and goes.
    void replaceValue(const YamlNode& key, const YamlNode& value, std::string text);
    /// Replaces the lines of the entry of that number (even) of a map by lines.
    void replaceEntry(const YamlNode& map, std::size_t at, const std::string& lines);
    /// Removes the entry of that number from a map.
    void removeEntry(const YamlNode& map, std::size_t at);
    /// Adds the entry "KEY: VALUE" after that with the key `before`, or before all of them.
    void addEntry(const YamlNode& map, const YamlNode* before, const std::string& entry);
    /// Adds a list after the last entry of a map, one item per line.
    void addList(const YamlNode& map, std::string_view key, const std::vector<std::string>& items);
    /// Replaces the list of that entry; no items: removes the entry.
    void replaceList(const YamlNode& map, std::size_t at, const std::vector<std::string>& items);
    /// Writes a list in brackets into a map in braces, as the entry of that number or after all others.
    void writeFlowList(const YamlNode& map, std::size_t at, std::string_view key,
                       const std::vector<std::string>& items);

    // Items of a list with a line or more for each:

    /// Returns the lines of an item, which begin with its dash.
    TextExtent itemLines(const YamlNode& item) const;
    /// Returns the column of the dash of lines.
    std::size_t dashColumn(TextExtent lines) const { return m_text.find('-', lines.begin) - lines.begin; }
    /// Adds items before a place at which a line begins.
    void addItems(std::size_t place, const std::vector<std::string>& items, std::size_t column);
    /// Replaces the lines of an item by items, or by nothing.
    void replaceItem(TextExtent lines, const std::vector<std::string>& items, std::size_t column);

  private:
    TextExtent literalExtent(const YamlNode& scalar) const;
    TextExtent valueExtent(const YamlNode& key, const YamlNode& value) const;
    TextExtent entryLines(const YamlNode& map, std::size_t at) const;
    std::size_t endOfValue(const YamlNode& node) const;
    std::string commentLines(TextExtent lines) const;
    std::string inLines(std::string text) const;
    std::string blockList(const YamlNode& map, std::string_view key,
                          const std::vector<std::string>& items) const;
    void exchange(TextExtent extent, std::string text);
    void exchangeLines(TextExtent lines, const std::string& text);
    void insertLines(std::size_t place, std::string text);

    std::string_view m_text;
    std::string_view m_lineEnd;
    std::vector<TextEdit> m_edits;
};

}  // namespace drillwave
