// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_patch.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <vector>

#include "core/yaml/design_setup_text.h"
#include "core/yaml/list_pairs.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_edits.h"

namespace drillwave {
namespace {

/// The keys of lists, which are no values of a map.
bool isListKey(std::string_view section, std::string_view key) {
    if (section == "pulse") return key == "points";
    if (section == "bit_rock") return key == "corners";
    return key == "sections" || key == "of";
}

/// Finds what a scenario changes in the text of another one.
class Patcher {
  public:
    Patcher(std::string_view text, const Scenario& scenario, const DesignSetup& design)
        : m_text(text),
          m_edits(text),
          m_scenario(scenario),
          m_parts(listItems(scenario, "string")),
          m_design(design),
          m_values(savedValues(scenario)) {
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
        if (!m_parts.empty()) {
            patchOrReplace(root, "hammer", [this](const YamlNode& map) { patchHammer(map); });
            patchString(root);
        }
        patchOrReplace(root, "bit_rock", [this](const YamlNode& map) {
            patchList(map, "bit_rock", "corners", listItems(m_scenario, cornersPath));
        });
        patchOrReplace(root, "drill", {});
        patchDesign(root);
        return std::move(m_edits).edited();
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
        if (m_scenario.form != formOf(root) || !m_parts.empty()) throw NotPatchable();
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
        return std::move(m_edits).edited();
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
            if (isWanted) m_edits.append(sectionText(m_scenario, section));
            return;
        }
        const YamlNode& value = root.children[at + 1];
        if (!isWanted && value.kind == YamlKind::null) return;
        const auto patch = [&] {
            if (!isWanted) throw NotPatchable();
            patchMap(value, section);
            if (patchLists) patchLists(value);
        };
        if (!m_edits.attempt(patch))
            m_edits.replaceEntry(root, at, isWanted ? sectionText(m_scenario, section) : std::string());
    }

    void patchHammer(const YamlNode& map) {
        patchSections(valueOf(map, "sections"), hammerSectionsPath,
                      listItems(m_scenario, hammerSectionsPath));
    }

    void patchString(const YamlNode& root) {
        const std::size_t at = indexOf(root, "string");
        const auto patch = [&] { patchSections(root.children[at + 1], "string", m_parts); };
        if (!m_edits.attempt(patch)) m_edits.replaceEntry(root, at, sectionText(m_scenario, "string"));
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
        if (!isThere) return m_edits.addList(map, key, items);
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
        if (!isBlock || items.empty()) return m_edits.replaceList(map, at, items);
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
        std::vector<TextExtent> lines;
        for (const YamlNode& item : list.children) lines.push_back(m_edits.itemLines(item));
        const std::size_t column = m_edits.dashColumn(lines.front());
        std::size_t next = 0;  // item to be written
        const auto insertUpTo = [&](std::size_t end, std::size_t place) {
            if (next >= end) return;
            m_edits.addItems(place,
                             {items.begin() + static_cast<std::ptrdiff_t>(next),
                              items.begin() + static_cast<std::ptrdiff_t>(end)},
                             column);
            next = end;
        };
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (!pairs[i]) {
                m_edits.replaceItem(lines[i], {}, column);
                continue;
            }
            insertUpTo(*pairs[i], i == 0 ? lines[i].begin : lines[i - 1].end);
            const Likeness like = likeness(i, next);
            // A comment on an item that shares nothing with this one was about that item.
            if (!like.isEqual && (like.shared == 0 || !m_edits.attempt([&] { exchange(i, next); })))
                m_edits.replaceItem(lines[i], {items[next]}, column);
            ++next;
        }
        insertUpTo(items.size(), lines.back().end);
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
        m_edits.writeFlowList(map, at, key, items);
    }

    void patchDesign(const YamlNode& root) {
        const std::size_t at = indexOf(root, designKey);
        if (at >= root.children.size()) {
            if (!m_design.isEmpty()) m_edits.append(designSetupText(m_design));
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
        if (!m_edits.attempt(patch)) m_edits.replaceEntry(root, at, designSetupText(m_design));
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
                m_edits.addEntry(map, before, std::string(value->key) + ": " + valueText(*value));
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
        if (!value) return m_edits.removeEntry(map, at);
        if (states(node, *value)) return;
        const Unit* unit = value->unit ? parseQuantity(node.text, value->unit->quantity).unit : nullptr;
        m_edits.replaceValue(key, node, valueText(*value, unit));
    }

    std::string_view m_text;
    YamlEdits m_edits;
    const Scenario& m_scenario;
    const std::vector<std::string> m_parts;  ///< of a string
    const DesignSetup& m_design;
    std::vector<SavedValue> m_values;
    std::map<std::string, std::vector<const SavedValue*>, std::less<>> m_sections;
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
