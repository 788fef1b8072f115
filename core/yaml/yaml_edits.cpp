// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/yaml_edits.h"

#include <optional>
#include <utility>

#include "core/yaml/scenario_text.h"

namespace drillwave {

YamlEdits::YamlEdits(std::string_view text)
    : m_text(text), m_lineEnd(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {}

std::string YamlEdits::edited() && {
    return drillwave::edited(m_text, std::move(m_edits));
}

bool YamlEdits::attempt(const std::function<void()>& patch) {
    const std::size_t before = m_edits.size();
    try {
        patch();
        return true;
    } catch (const NotPatchable&) {
        m_edits.resize(before);
        return false;
    }
}

void YamlEdits::replaceValue(const YamlNode& key, const YamlNode& value, std::string text) {
    TextExtent extent = valueExtent(key, value);
    if (const TextExtent comment = commentBehind(m_text, extent.end); comment.begin < comment.end)
        extent.end = comment.end;
    exchange(extent, std::move(text));
}

void YamlEdits::replaceEntry(const YamlNode& map, std::size_t at, const std::string& lines) {
    const TextExtent key = literalExtent(map.children[at]);
    const YamlNode& value = map.children[at + 1];
    const std::size_t end = value.kind == YamlKind::null ? key.end : endOfValue(value);
    exchangeLines(linesOf(m_text, {key.begin, end}), inLines(lines));
}

void YamlEdits::removeEntry(const YamlNode& map, std::size_t at) {
    if (!map.flow) return exchangeLines(entryLines(map, at), "");
    const bool isFirst = at == 0;
    if (isFirst && map.children.size() <= 2) throw NotPatchable();
    exchange({isFirst ? map.children[0].offset : endOfValue(map.children[at - 1]),
              isFirst ? map.children[2].offset : endOfValue(map.children[at + 1])},
             "");
}

void YamlEdits::addEntry(const YamlNode& map, const YamlNode* before, const std::string& entry) {
    if (map.children.empty()) throw NotPatchable();
    const std::size_t at = before ? static_cast<std::size_t>(before - map.children.data()) : 0;
    if (map.flow) {
        const std::size_t place = before ? endOfValue(map.children[at + 1]) : map.children[0].offset;
        return exchange({place, place}, before ? ", " + entry : entry + ", ");
    }
    // The first entry of an item of a list stands behind its dash.
    const bool isBehindDash = before && at == 0;
    const TextExtent lines =
        isBehindDash ? linesOf(m_text, literalExtent(map.children[1])) : entryLines(map, at);
    const TextExtent keyLine = linesOf(m_text, literalExtent(map.children[at]));
    const std::string line = std::string(map.children[at].offset - keyLine.begin, ' ') + entry;
    if (before && m_text[lines.end - 1] != '\n')
        return exchange({lines.end, lines.end}, std::string(m_lineEnd) + line);
    const std::size_t place = before ? lines.end : lines.begin;
    exchange({place, place}, line + std::string(m_lineEnd));
}

void YamlEdits::addList(const YamlNode& map, std::string_view key, const std::vector<std::string>& items) {
    insertLines(linesOf(m_text, {map.children[0].offset, endOfValue(map)}).end, blockList(map, key, items));
}

void YamlEdits::replaceList(const YamlNode& map, std::size_t at, const std::vector<std::string>& items) {
    const YamlNode& key = map.children[at];
    exchangeLines(linesOf(m_text, {literalExtent(key).begin, endOfValue(map.children[at + 1])}),
                  items.empty() ? std::string() : blockList(map, key.text, items));
}

void YamlEdits::writeFlowList(const YamlNode& map, std::size_t at, std::string_view key,
                              const std::vector<std::string>& items) {
    std::string list;
    for (const std::string& item : items) list += (list.empty() ? "[" : ", ") + item;
    list += ']';
    if (at < map.children.size()) {
        const YamlNode& old = map.children[at + 1];
        return exchange({old.offset, endOfValue(old)}, list);
    }
    const std::size_t end = endOfValue(map.children.back());
    exchange({end, end}, ", " + std::string(key) + ": " + list);
}

TextExtent YamlEdits::itemLines(const YamlNode& item) const {
    const TextExtent lines = linesOf(m_text, {item.offset, endOfValue(item)});
    const std::string_view before = m_text.substr(lines.begin, item.offset - lines.begin);
    const std::size_t dash = before.find_first_not_of(' ');
    if (dash == std::string_view::npos || before[dash] != '-' ||
        before.find_first_not_of(' ', dash + 1) != std::string_view::npos)
        throw NotPatchable();
    return lines;
}

void YamlEdits::addItems(std::size_t place, const std::vector<std::string>& items, std::size_t column) {
    insertLines(place, inLines(listText(items, column)));
}

void YamlEdits::replaceItem(TextExtent lines, const std::vector<std::string>& items, std::size_t column) {
    exchangeLines(lines, items.empty() ? std::string() : inLines(listText(items, column)));
}

/// Returns where a scalar stands, with its quotes. Only scalars that stand there literally.
TextExtent YamlEdits::literalExtent(const YamlNode& scalar) const {
    const std::optional<TextExtent> extent = extentOf(m_text, scalar);
    if (!extent) throw NotPatchable();
    return *extent;
}

/// Returns where a value stands; that of a key at the begin of a line, the title, may be several lines.
TextExtent YamlEdits::valueExtent(const YamlNode& key, const YamlNode& value) const {
    const std::optional<TextExtent> extent = extentOf(m_text, value);
    const bool isOfTop = linesOf(m_text, {key.offset, key.offset}).begin == key.offset;
    if (extent || !isOfTop || value.kind != YamlKind::scalar) return literalExtent(value);
    TextExtent lines = linesOf(m_text, {value.offset, value.offset});
    // Lines of the title are indented, or blank between such lines.
    for (std::size_t at = lines.end; at < m_text.size();) {
        const TextExtent line = linesOf(m_text, {at, at});
        const bool isBlank = m_text.find_first_not_of(" \t\r\n", at) >= line.end;
        if (!isBlank && m_text[at] != ' ') break;
        if (!isBlank) lines.end = line.end;
        at = line.end;
    }
    return {value.offset, m_text.find_last_not_of("\r\n", lines.end - 1) + 1};
}

/// Returns the lines of one entry of a block map that has them to itself.
TextExtent YamlEdits::entryLines(const YamlNode& map, std::size_t at) const {
    const YamlNode& value = map.children[at + 1];
    TextExtent extent = literalExtent(map.children[at]);
    const std::size_t begin = extent.begin;
    if (value.kind == YamlKind::scalar) extent.end = valueExtent(map.children[at], value).end;
    if (value.kind == YamlKind::map || value.kind == YamlKind::sequence) extent.end = endOfValue(value);
    const TextExtent lines = linesOf(m_text, extent);
    const std::string_view indentation = m_text.substr(lines.begin, begin - lines.begin);
    if (indentation.find_first_not_of(' ') != std::string_view::npos) throw NotPatchable();
    return lines;
}

std::size_t YamlEdits::endOfValue(const YamlNode& node) const {
    const std::optional<std::size_t> end = endOf(m_text, node);
    if (!end) throw NotPatchable();
    return *end;
}

std::string YamlEdits::commentLines(TextExtent lines) const {
    std::string comments;
    for (std::size_t at = lines.begin; at < lines.end;) {
        const TextExtent line = linesOf(m_text, {at, at});
        const std::size_t word = m_text.find_first_not_of(" \t", at);
        if (word < line.end && m_text[word] == '#')
            comments += m_text.substr(line.begin, line.end - line.begin);
        at = line.end;
    }
    return comments;
}

/// Returns a text with the line ends of the file.
std::string YamlEdits::inLines(std::string text) const {
    if (m_lineEnd == "\r\n")
        for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
            text.replace(at, 1, "\r\n");
    return text;
}

std::string YamlEdits::blockList(const YamlNode& map, std::string_view key,
                                 const std::vector<std::string>& items) const {
    const std::size_t column = map.children[0].offset - linesOf(m_text, literalExtent(map.children[0])).begin;
    return inLines(std::string(column, ' ') + std::string(key) + ":\n" + listText(items, column + 2));
}

void YamlEdits::exchange(TextExtent extent, std::string text) {
    m_edits.push_back({extent.begin, extent.end - extent.begin, std::move(text)});
}

void YamlEdits::exchangeLines(TextExtent lines, const std::string& text) {
    exchange(lines, commentLines(lines) + text);
}

/// Adds lines before a line, or after a last line that is open.
void YamlEdits::insertLines(std::size_t place, std::string text) {
    const bool isOpen = place == m_text.size() && !m_text.ends_with('\n');
    if (isOpen) text.insert(0, m_lineEnd);
    exchange({place, place}, std::move(text));
}

}  // namespace drillwave
