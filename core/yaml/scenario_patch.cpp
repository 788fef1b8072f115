// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_patch.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

#include "core/model/blow_traits.h"
#include "core/text/text_edit.h"
#include "core/yaml/design_setup_text.h"
#include "core/yaml/list_pairs.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_extent.h"

namespace drillwave {
namespace {

using Extent = TextExtent;

/// Thrown inside this file if the text has to be rewritten.
struct NotPatchable {};

/// Returns the place of a scalar, with its quotes. Only for scalars that are there literally.
Extent literalExtent(std::string_view text, const YamlNode& scalar) {
    const std::optional<Extent> extent = extentOf(text, scalar);
    if (!extent) throw NotPatchable();
    return *extent;
}

/// The keys of lists, which are no values of a map.
bool isListKey(std::string_view section, std::string_view key) {
    if (section == "pulse") return key == "points";
    if (section == "bit_rock") return key == "corners";
    return key == "sections" || key == "of";
}

class Patcher {
  public:
    Patcher(std::string_view text, const Scenario& scenario, const DesignSetup& design)
        : m_text(text),
          m_scenario(scenario),
          m_isOfSections(hasSections(scenario)),
          m_design(design),
          m_values(savedValues(scenario)) {
        m_lineEnd = text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
        std::ranges::copy(savedDesignValues(design), std::back_inserter(m_values));
        for (const SavedValue& value : m_values) m_sections[value.section].push_back(&value);
    }

    std::string patched(const YamlNode& root) {
        // In another form little of the file stays: its sections are better put in order again.
        if (m_scenario.form != formOf(root) || root.flow) return patchedBraces(root);
        patchMap(root, "");
        patchOrReplace(root, "dimensionless", {});
        patchOrReplace(root, "rod", {});
        patchOrReplace(root, "material", {});
        patchOrReplace(root, "pulse", [this](const YamlNode& map) {
            patchList(map, "pulse", "points", listItems(m_scenario, pointsPath));
        });
        if (m_isOfSections) {
            patchOrReplace(root, "hammer", [this](const YamlNode& map) { patchHammer(map); });
            patchString(root);
        }
        patchOrReplace(root, "bit_rock", [this](const YamlNode& map) {
            patchList(map, "bit_rock", "corners", listItems(m_scenario, cornersPath));
        });
        patchOrReplace(root, "drill", {});
        patchDesign(root);
        return edited(m_text, std::move(m_edits));
    }

  private:
    const std::vector<const SavedValue*>& valuesOf(std::string_view section) const {
        static const std::vector<const SavedValue*> none;
        const auto found = m_sections.find(section);
        return found == m_sections.end() ? none : found->second;
    }

    const SavedValue* saved(std::string_view section, std::string_view key) const {
        const std::vector<const SavedValue*>& values = valuesOf(section);
        const auto found = std::ranges::find(values, key, &SavedValue::key);
        return found == values.end() ? nullptr : *found;
    }

    static std::size_t indexOf(const YamlNode& map, std::string_view key) {
        std::size_t at = 0;
        while (at < map.children.size() && map.children[at].text != key) at += 2;
        return at;
    }

    static ScenarioForm formOf(const YamlNode& root) {
        if (indexOf(root, "string") < root.children.size()) return ScenarioForm::string;
        return indexOf(root, "dimensionless") < root.children.size() ? ScenarioForm::dimensionless
                                                                     : ScenarioForm::dimensional;
    }

    /// Patches a file that is one map in braces: replaces values and keys, and rewrites no
    /// section.
    std::string patchedBraces(const YamlNode& root) {
        if (m_scenario.form != formOf(root) || m_isOfSections) throw NotPatchable();
        patchMap(root, "");
        for (const std::string_view section : {"dimensionless", "rod", "pulse", "bit_rock", "drill"}) {
            const std::size_t at = indexOf(root, section);
            const bool isWanted = isSectionWanted(section, at < root.children.size());
            if (isWanted != (at < root.children.size())) throw NotPatchable();
            if (!isWanted) continue;
            patchMap(root.children[at + 1], section);
            for (const auto& [path, key] : {std::pair{pointsPath, "points"}, {cornersPath, "corners"}})
                if (path.starts_with(section))
                    patchList(root.children[at + 1], section, key, listItems(m_scenario, path));
        }
        if (indexOf(root, designKey) < root.children.size() || !m_design.isEmpty()) throw NotPatchable();
        return edited(m_text, std::move(m_edits));
    }

    /// Runs a patch; without effect and false where it cannot be made.
    bool attempt(const std::function<void()>& patch) {
        const std::size_t before = m_edits.size();
        try {
            patch();
            return true;
        } catch (const NotPatchable&) {
            m_edits.resize(before);
            return false;
        }
    }

    /// Whether a section has something to say. One that is absent need not state defaults.
    bool isSectionWanted(std::string_view section, bool isThere) const {
        return std::ranges::any_of(valuesOf(section),
                                   [&](const SavedValue* value) { return isThere || !value->isDefault; });
    }

    /// Patches a section and its lists; where that cannot be done, exchanges the section and nothing else.
    void patchOrReplace(const YamlNode& root, std::string_view section,
                        const std::function<void(const YamlNode& map)>& patchLists) {
        const std::size_t at = indexOf(root, section);
        const bool isThere = at < root.children.size();
        const bool isWanted = isSectionWanted(section, isThere);
        if (!isThere) {
            if (isWanted) append(sectionText(m_scenario, section));
            return;
        }
        const YamlNode& value = root.children[at + 1];
        if (!isWanted && value.kind == YamlKind::null) return;
        const auto patch = [&] {
            if (!isWanted) throw NotPatchable();
            patchMap(value, section);
            if (patchLists) patchLists(value);
        };
        if (!attempt(patch))
            replaceSection(root, at, isWanted ? sectionText(m_scenario, section) : std::string());
    }

    /// Exchanges a section for a text. Lines that are only comments stay, above the text.
    void replaceSection(const YamlNode& root, std::size_t at, const std::string& text) {
        const YamlNode& key = root.children[at];
        const YamlNode& value = root.children[at + 1];
        const bool isNull = value.kind == YamlKind::null;
        const std::size_t end = isNull ? literalExtent(m_text, key).end : endOfValue(value);
        const Extent lines = linesOf(m_text, {literalExtent(m_text, key).begin, end});
        m_edits.push_back({lines.begin, lines.end - lines.begin, commentLines(lines) + inLines(text)});
    }

    std::string commentLines(Extent lines) const {
        std::string comments;
        for (std::size_t at = lines.begin; at < lines.end;) {
            const Extent line = linesOf(m_text, {at, at});
            const std::size_t word = m_text.find_first_not_of(" \t", at);
            if (word < line.end && m_text[word] == '#')
                comments += m_text.substr(line.begin, line.end - line.begin);
            at = line.end;
        }
        return comments;
    }

    void patchHammer(const YamlNode& map) {
        patchSections(valueOf(map, "sections"), hammerSectionsPath,
                      listItems(m_scenario, hammerSectionsPath));
    }

    void patchString(const YamlNode& root) {
        const std::size_t at = indexOf(root, "string");
        const auto patch = [&] {
            patchSections(root.children[at + 1], "string", listItems(m_scenario, "string"));
        };
        if (!attempt(patch)) replaceSection(root, at, sectionText(m_scenario, "string"));
    }

    static const YamlNode& valueOf(const YamlNode& map, std::string_view key) {
        const YamlNode* value = map.valueOf(key);
        if (!value) throw NotPatchable();
        return *value;
    }

    /// Sections and groups of them.
    void patchSections(const YamlNode& list, std::string_view path, const std::vector<std::string>& items) {
        const auto pathOf = [&](std::size_t j) { return std::string(path) + "." + std::to_string(j); };
        patchItems(
            list, items,
            [&](std::size_t i, std::size_t j) { return likenessOf(list.children[i], pathOf(j)); },
            [&](std::size_t i, std::size_t j) {
                const YamlNode& item = list.children[i];
                const YamlNode* group = item.valueOf("of");
                if ((saved(pathOf(j), "repeat") != nullptr) != (group != nullptr)) throw NotPatchable();
                patchMap(item, pathOf(j));
                if (group) patchSections(*group, pathOf(j) + ".of", groupItems(pathOf(j) + ".of"));
            });
    }

    /// The sections of a group, in one line each.
    std::vector<std::string> groupItems(const std::string& path) const {
        std::vector<std::string> items;
        for (std::string at; !valuesOf(at = path + "." + std::to_string(items.size())).empty();)
            items.push_back(sectionItem(m_values, at));
        return items;
    }

    Likeness likenessOf(const YamlNode& map, const std::string& path) const {
        Likeness like{0, true};
        const std::vector<const SavedValue*>& values = valuesOf(path);
        for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) {
            const YamlNode& value = map.children[i + 1];
            if (value.kind == YamlKind::sequence) {
                const std::string of = path + "." + map.children[i].text;
                std::size_t count = 0;
                while (!valuesOf(of + "." + std::to_string(count)).empty()) ++count;
                like.isEqual = like.isEqual && count == value.children.size();
                for (std::size_t k = 0; k < std::min(count, value.children.size()); ++k) {
                    const Likeness item = likenessOf(value.children[k], of + "." + std::to_string(k));
                    like.shared += item.shared;
                    like.isEqual = like.isEqual && item.isEqual;
                }
                continue;
            }
            const SavedValue* now = saved(path, map.children[i].text);
            const bool isSame = now && states(value, *now);
            like.shared += isSame ? 1 : 0;
            like.isEqual = like.isEqual && isSame;
        }
        for (const SavedValue* value : values)
            if (!value->isDefault && indexOf(map, value->key) >= map.children.size()) like.isEqual = false;
        return like;
    }

    /// Whether a value of the file says that already.
    static bool states(const YamlNode& node, const SavedValue& value) {
        if (node.kind != YamlKind::scalar) return false;
        if (!value.unit) return node.text == value.text;
        const TypedQuantity typed = parseQuantity(node.text, value.unit->quantity);
        return typed.valid() && typed.si == value.number;
    }

    /// The list of a section: points, corners, or texts of the design study. No items: none is wanted.
    void patchList(const YamlNode& map, std::string_view section, std::string_view key,
                   const std::vector<std::string>& items) {
        const std::size_t at = indexOf(map, key);
        const bool isThere = at < map.children.size();
        if (items.empty() && !isThere) return;
        if (map.children.empty()) throw NotPatchable();
        if (map.flow) return patchFlowList(map, section, key, items);
        if (!isThere) return insertList(map, key, items);
        const YamlNode& list = map.children[at + 1];
        const auto like = [&](std::size_t i, std::size_t j) {
            return itemLikeness(list.children[i], section, j, items[j]);
        };
        const auto exchange = [&](std::size_t i, std::size_t j) {
            if (section != "bit_rock") throw NotPatchable();
            patchMap(list.children[i], std::string(cornersPath) + "." + std::to_string(j));
        };
        const bool isBlock = list.kind == YamlKind::sequence && !list.flow && !list.children.empty();
        if (!isBlock && isListSame(list, like, items.size())) return;
        if (!isBlock || items.empty()) {
            const Extent lines =
                linesOf(m_text, {literalExtent(m_text, map.children[at]).begin, endOfValue(list)});
            m_edits.push_back({lines.begin, lines.end - lines.begin,
                               commentLines(lines) + (items.empty() ? "" : blockList(map, key, items))});
            return;
        }
        patchItems(list, items, like, exchange);
    }

    template <typename Like>
    static bool isListSame(const YamlNode& list, const Like& like, std::size_t count) {
        if (list.kind != YamlKind::sequence || list.children.size() != count) return false;
        for (std::size_t i = 0; i < count; ++i)
            if (!like(i, i).isEqual) return false;
        return true;
    }

    Likeness itemLikeness(const YamlNode& item, std::string_view section, std::size_t j,
                          const std::string& text) const {
        if (section == "bit_rock")
            return likenessOf(item, std::string(cornersPath) + "." + std::to_string(j));
        if (section == designKey)
            return item.kind == YamlKind::scalar && yamlScalar(item.text) == text ? Likeness{1, true}
                                                                                  : Likeness{};
        const TablePoint& point = m_scenario.pulse.tablePoints[j];
        if (item.children.size() != 2) return {};
        const bool units = hasUnits(m_scenario);
        const auto isSame = [&](const YamlNode& node, double si, Quantity quantity) {
            const TypedQuantity typed = parseQuantity(node.text, units ? quantity : Quantity::ratio);
            return typed.valid() && typed.si == si;
        };
        const bool time = isSame(item.children[0], point.time, Quantity::time);
        const bool force = isSame(item.children[1], point.force, Quantity::force);
        return {(time ? 1 : 0) + (force ? 1 : 0), time && force};
    }

    /// Puts items into a list that has a line or more for each: lines of items that stay do not change, and
    /// so are lines that are only comments. `exchange` changes an item where it stands.
    void patchItems(const YamlNode& list, const std::vector<std::string>& items,
                    const std::function<Likeness(std::size_t, std::size_t)>& likeness,
                    const std::function<void(std::size_t, std::size_t)>& exchange) {
        if (list.kind != YamlKind::sequence || list.children.empty() || items.empty()) throw NotPatchable();
        if (list.flow) {
            if (list.children.size() != items.size()) throw NotPatchable();
            for (std::size_t i = 0; i < items.size(); ++i)
                if (!likeness(i, i).isEqual) exchange(i, i);
            return;
        }
        const auto pairs = listPairs(list.children.size(), items.size(), likeness);
        std::vector<Extent> lines;
        for (const YamlNode& item : list.children) lines.push_back(itemLines(item));
        const std::size_t column = m_text.find('-', lines.front().begin) - lines.front().begin;
        std::size_t next = 0;  // item to be written
        const auto insertUpTo = [&](std::size_t end, std::size_t place) {
            if (next >= end) return;
            const std::vector<std::string> added(items.begin() + static_cast<std::ptrdiff_t>(next),
                                                 items.begin() + static_cast<std::ptrdiff_t>(end));
            insertLines(place, inLines(listText(added, column)));
            next = end;
        };
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Extent line = lines[i];
            if (!pairs[i]) {
                m_edits.push_back({line.begin, line.end - line.begin, commentLines(line)});
                continue;
            }
            insertUpTo(*pairs[i], i == 0 ? line.begin : lines[i - 1].end);
            const Likeness like = likeness(i, next);
            // A comment on an item that shares nothing with this one was about that item.
            if (!like.isEqual && (like.shared == 0 || !attempt([&] { exchange(i, next); })))
                m_edits.push_back({line.begin, line.end - line.begin,
                                   commentLines(line) + inLines(listText({items[next]}, column))});
            ++next;
        }
        insertUpTo(items.size(), lines.back().end);
    }

    /// The lines of an item of a list, which begin with its dash.
    Extent itemLines(const YamlNode& item) const {
        const Extent lines = linesOf(m_text, {item.offset, endOfValue(item)});
        const std::string_view before = m_text.substr(lines.begin, item.offset - lines.begin);
        const std::size_t dash = before.find_first_not_of(' ');
        if (dash == std::string_view::npos || before[dash] != '-' ||
            before.find_first_not_of(' ', dash + 1) != std::string_view::npos)
            throw NotPatchable();
        return lines;
    }

    /// Lines in front of a line, or behind a last line that is open.
    void insertLines(std::size_t place, std::string text) {
        const bool isOpen = place == m_text.size() && !m_text.ends_with('\n');
        if (isOpen) text.insert(0, m_lineEnd);
        m_edits.push_back({place, 0, std::move(text)});
    }

    std::string blockList(const YamlNode& map, std::string_view key,
                          const std::vector<std::string>& items) const {
        const std::size_t column =
            map.children[0].offset - linesOf(m_text, literalExtent(m_text, map.children[0])).begin;
        return inLines(std::string(column, ' ') + std::string(key) + ":\n" + listText(items, column + 2));
    }

    /// A list behind the last entry of a map.
    void insertList(const YamlNode& map, std::string_view key, const std::vector<std::string>& items) {
        insertLines(linesOf(m_text, {map.children[0].offset, endOfValue(map)}).end,
                    blockList(map, key, items));
    }

    void patchFlowList(const YamlNode& map, std::string_view section, std::string_view key,
                       const std::vector<std::string>& items) {
        const std::size_t at = indexOf(map, key);
        // Many points are written one per line, not all in one.
        constexpr std::size_t mostInLine = 20;
        if (section == designKey) throw NotPatchable();
        if (at < map.children.size()) {
            const YamlNode& old = map.children[at + 1];
            const auto like = [&](std::size_t i, std::size_t j) {
                return itemLikeness(old.children[i], section, j, items[j]);
            };
            if (isListSame(old, like, items.size())) return;
        }
        if (items.empty() || items.size() > mostInLine) throw NotPatchable();
        std::string list;
        for (const std::string& item : items) list += (list.empty() ? "" : ", ") + item;
        if (at < map.children.size()) {
            const YamlNode& old = map.children[at + 1];
            m_edits.push_back({old.offset, endOfValue(old) - old.offset, "[" + list + "]"});
        } else {
            m_edits.push_back(
                {endOfValue(map.children.back()), 0, ", " + std::string(key) + ": [" + list + "]"});
        }
    }

    std::size_t endOfValue(const YamlNode& node) const {
        const std::optional<std::size_t> end = endOf(m_text, node);
        if (!end) throw NotPatchable();
        return *end;
    }

    void patchDesign(const YamlNode& root) {
        const std::size_t at = indexOf(root, designKey);
        if (at >= root.children.size()) {
            if (!m_design.isEmpty()) append(designSetupText(m_design));
            return;
        }
        SectionReader reader(m_text);
        const YamlEntries block{{std::string(designKey), {&root.children[at], &root.children[at + 1]}}};
        if (readDesignSetup(reader, block) == m_design) return;
        const YamlNode& map = root.children[at + 1];
        const auto patch = [&] {
            if (m_design.isEmpty() || map.flow) throw NotPatchable();
            patchMap(map, designKey);
            for (const auto& [key, items] : designLists(m_design)) patchList(map, designKey, key, items);
        };
        if (!attempt(patch)) replaceSection(root, at, designSetupText(m_design));
    }

    void append(const std::string& text) { insertLines(m_text.size(), inLines(text)); }

    /// The text with the line ends of the file.
    std::string inLines(std::string text) const {
        if (m_lineEnd == "\r\n")
            for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
                text.replace(at, 1, "\r\n");
        return text;
    }

    void patchMap(const YamlNode& map, std::string_view section) {
        if (map.kind != YamlKind::map || map.children.empty()) throw NotPatchable();
        for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) patchEntry(map, i, section);
        const YamlNode* before = section.empty() ? &map.children.front() : nullptr;
        for (const SavedValue* value : valuesOf(section)) {
            const std::size_t at = indexOf(map, value->key);
            if (at < map.children.size())
                before = &map.children[at];
            else if (!value->isDefault)
                insert(map, before, *value);
        }
    }

    void patchEntry(const YamlNode& map, std::size_t at, std::string_view section) {
        const YamlNode& key = map.children[at];
        const YamlNode& node = map.children[at + 1];
        if (section.empty() && key.text != "title" && key.text != "end_time") return;
        if (section == designKey && node.kind == YamlKind::sequence) return;
        if (isListKey(section, key.text)) return;
        const SavedValue* value = saved(section, key.text);
        if (!value && section.empty() && node.text.empty()) return;
        if (!value) {
            if (map.flow)
                removeFromFlow(map, at);
            else
                removeLine(map, at, section);
            return;
        }
        if (states(node, *value)) return;
        const Unit* unit = value->unit ? parseQuantity(node.text, value->unit->quantity).unit : nullptr;
        replace(valueExtent(section, node), valueText(*value, unit));
    }

    /// Where a value stands; a title may be several lines.
    Extent valueExtent(std::string_view section, const YamlNode& node) const {
        const std::optional<Extent> extent = extentOf(m_text, node);
        if (extent || !section.empty() || node.kind != YamlKind::scalar) return literalExtent(m_text, node);
        Extent lines = linesOf(m_text, {node.offset, node.offset});
        // Lines of the title are indented, or blank between such lines.
        for (std::size_t at = lines.end; at < m_text.size();) {
            const Extent line = linesOf(m_text, {at, at});
            const bool isBlank = m_text.find_first_not_of(" \t\r\n", at) >= line.end;
            if (!isBlank && m_text[at] != ' ') break;
            if (!isBlank) lines.end = line.end;
            at = line.end;
        }
        const std::size_t last = m_text.find_last_not_of("\r\n", lines.end - 1);
        return {node.offset, last + 1};
    }

    /// Exchanges a value. A comment behind it was about the value that was there.
    void replace(Extent extent, std::string text) {
        if (const Extent comment = commentBehind(m_text, extent.end); comment.begin < comment.end)
            extent.end = comment.end;
        m_edits.push_back({extent.begin, extent.end - extent.begin, std::move(text)});
    }

    /// The lines of one entry of a block map that has them to itself.
    Extent entryLines(const YamlNode& map, std::size_t at, std::string_view section) const {
        const Extent key = literalExtent(m_text, map.children[at]);
        const YamlNode& value = map.children[at + 1];
        const Extent lines = linesOf(m_text, value.kind == YamlKind::null ? key
                                             : value.kind == YamlKind::scalar
                                                 ? Extent{key.begin, valueExtent(section, value).end}
                                                 : Extent{key.begin, endOfValue(value)});
        const std::string_view indentation = m_text.substr(lines.begin, key.begin - lines.begin);
        if (indentation.find_first_not_of(' ') != std::string_view::npos) throw NotPatchable();
        return lines;
    }

    void removeLine(const YamlNode& map, std::size_t at, std::string_view section) {
        const Extent lines = entryLines(map, at, section);
        m_edits.push_back({lines.begin, lines.end - lines.begin, commentLines(lines)});
    }

    void removeFromFlow(const YamlNode& map, std::size_t at) {
        const bool first = at == 0;
        if (first && map.children.size() <= 2) throw NotPatchable();
        const std::size_t begin = first ? map.children[0].offset : endOfValue(map.children[at - 1]);
        const std::size_t end = first ? map.children[2].offset : endOfValue(map.children[at + 1]);
        m_edits.push_back({begin, end - begin, ""});
    }

    /// A new entry behind the entry with the key `before`, or in front of all of them.
    void insert(const YamlNode& map, const YamlNode* before, const SavedValue& value) {
        if (map.children.empty()) throw NotPatchable();
        const std::string entry = std::string(value.key) + ": " + valueText(value);
        const std::size_t at = before ? static_cast<std::size_t>(before - map.children.data()) : 0;
        if (map.flow) {
            const std::size_t place = before ? endOfValue(map.children[at + 1]) : map.children[0].offset;
            m_edits.push_back({place, 0, before ? ", " + entry : entry + ", "});
            return;
        }
        // The first entry of an item of a list stands behind its dash.
        const bool behindDash = before && at == 0;
        const Extent lines = behindDash ? linesOf(m_text, literalExtent(m_text, map.children[1]))
                                        : entryLines(map, at, value.section);
        const Extent keyLine = linesOf(m_text, literalExtent(m_text, map.children[at]));
        const std::string text =
            std::string(map.children[at].offset - keyLine.begin, ' ') + entry + std::string(m_lineEnd);
        if (before && m_text[lines.end - 1] != '\n')
            m_edits.push_back(
                {lines.end, 0, std::string(m_lineEnd) + text.substr(0, text.size() - m_lineEnd.size())});
        else
            m_edits.push_back({before ? lines.end : lines.begin, 0, text});
    }

    std::string_view m_text;
    const Scenario& m_scenario;
    const bool m_isOfSections;
    const DesignSetup& m_design;
    std::vector<SavedValue> m_values;
    std::map<std::string, std::vector<const SavedValue*>, std::less<>> m_sections;
    std::string_view m_lineEnd;
    std::vector<TextEdit> m_edits;
};

}  // namespace

std::optional<std::string> patchedText(std::string_view text, const Scenario& scenario,
                                       const DesignSetup& design) {
    const YamlTree tree = parseYaml(text);
    if (!tree.problem.text.isEmpty() || tree.root.kind != YamlKind::map) return std::nullopt;
    try {
        return Patcher(text, scenario, design).patched(tree.root);
    } catch (const NotPatchable&) {
        return std::nullopt;
    }
}

}  // namespace drillwave
