// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of YAML text in place: of values, entries of maps and items of lists.
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

/// Exception for an edit that cannot be made in place; the caller must then rewrite part of the text.
struct NotPatchable {};

/// Collector of edits of a YAML text. Lines without an edit remain byte for byte. Comment lines remain even
/// if their item or entry is removed. Edits throw NotPatchable if they cannot be made.
class YamlEdits {
  public:
    /// Starts with the unchanged `text`, which must outlive this object.
    explicit YamlEdits(std::string_view text);

    /// Returns the text with all edits.
    std::string edited() &&;
    /// Makes the edits of `patch` and returns true. If it throws NotPatchable, undoes them and returns false.
    bool attempt(const std::function<void()>& patch);

    /// Adds lines at the end of the text. They end with "\n", which is converted to the line ends of the
    /// text.
    void append(const std::string& lines) { insertLines(m_text.size(), inLines(lines)); }
    /// Replaces the value of a key, and removes the comment after it, which described the old value.
    void replaceValue(const YamlNode& key, const YamlNode& value, std::string text);
    /// Replaces the lines of a map entry by other lines. `at` is the index of its key in the children of the
    /// map.
    void replaceEntry(const YamlNode& map, std::size_t at, const std::string& lines);
    /// Removes an entry from a map. `at` is the index of its key in the children of the map.
    void removeEntry(const YamlNode& map, std::size_t at);
    /// Adds the entry "KEY: VALUE" to a map, after the existing key `before`. If `before` is nullptr, the new
    /// entry becomes the first one.
    void addEntry(const YamlNode& map, const YamlNode* before, const std::string& entry);
    /// Adds a list with this key after the last entry of a map, one item per line.
    void addList(const YamlNode& map, std::string_view key, const std::vector<std::string>& items);
    /// Replaces the list of a map entry, or removes the entry if there are no items. `at` is the index of its
    /// key in the children of the map.
    void replaceList(const YamlNode& map, std::size_t at, const std::vector<std::string>& items);
    /// Writes a list in brackets, "[a, b]", as the value of `key` into a map in braces. If the map has the
    /// key, `at` is its index in the children of the map, and its value is replaced. Otherwise the key and
    /// the list are added at the end.
    void writeFlowList(const YamlNode& map, std::size_t at, std::string_view key,
                       const std::vector<std::string>& items);

    // Items of a list on one or more lines each:

    /// Returns the complete lines of a list item; the first one begins with the dash of the item.
    TextExtent itemLines(const YamlNode& item) const;
    /// Returns the column of the dash in the lines of a list item, from 0.
    std::size_t dashColumn(TextExtent lines) const { return m_text.find('-', lines.begin) - lines.begin; }
    /// Adds items to a list, before the line that begins at the byte `place`. `column` is the column of their
    /// dashes, from 0.
    void addItems(std::size_t place, const std::vector<std::string>& items, std::size_t column);
    /// Replaces a list item, which is on these lines, by other items; removes it if there are none. `column`
    /// is the column of the dashes, from 0.
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
