// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/scenario_patch.h"

#include <algorithm>
#include <vector>

#include "core/model/blow_traits.h"
#include "core/text/text_edit.h"
#include "core/yaml/design_setup_text.h"
#include "core/yaml/scenario_text.h"
#include "core/yaml/yaml_extent.h"

namespace drillwave {
namespace {

using Extent = TextExtent;

/// Thrown inside this file where the text would have to be written anew.
struct NotPatchable {};

/// Where a scalar stands, with its quotes. Only scalars that stand there literally.
Extent literalExtent(std::string_view text, const YamlNode& scalar) {
    const std::optional<Extent> extent = extentOf(text, scalar);
    if (!extent) throw NotPatchable();
    return *extent;
}

class Patcher {
  public:
    Patcher(std::string_view text, const Scenario& scenario, const DesignSetup& design)
        : m_text(text), m_scenario(scenario), m_design(design), m_values(savedValues(scenario)) {
        m_lineEnd = text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
    }

    std::string patched(const YamlNode& root) {
        // In another form little of the file stays: its sections are better put in order again.
        if (m_scenario.form != formOf(root)) throw NotPatchable();
        patchMap(root, "");
        for (const std::string_view section :
             {"dimensionless", "rod", "pulse", "material", "bit_rock", "drill"})
            patchSection(root, section);
        if (hasSections(m_scenario)) patchDrillString(root);
        patchCorners(root);
        patchDesign(root);
        patchPoints(root);
        return edited(m_text, std::move(m_edits));
    }

  private:
    const SavedValue* saved(std::string_view section, std::string_view key) const {
        const auto same = [&](const SavedValue& value) {
            return value.section == section && value.key == key;
        };
        const auto found = std::ranges::find_if(m_values, same);
        return found == m_values.end() ? nullptr : &*found;
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

    /// The value of a key, which must be there and of that kind.
    static const YamlNode& valueOf(const YamlNode& map, std::string_view key, YamlKind kind) {
        const std::size_t at = indexOf(map, key);
        if (at >= map.children.size() || map.children[at + 1].kind != kind) throw NotPatchable();
        return map.children[at + 1];
    }

    /// Numbers and names in sections that stay where they are: with one more or less the list is written
    /// anew.
    void patchDrillString(const YamlNode& root) {
        const DrillString& drillString = m_scenario.drillString;
        if (isForced(m_scenario) != (indexOf(root, "pulse") < root.children.size())) throw NotPatchable();
        if (!isForced(m_scenario)) {
            const YamlNode& hammer = valueOf(root, "hammer", YamlKind::map);
            patchMap(hammer, "hammer");
            patchList(valueOf(hammer, "sections", YamlKind::sequence), "hammer.sections",
                      drillString.hammer.sections.size());
        }
        const YamlNode& parts = valueOf(root, "string", YamlKind::sequence);
        if (parts.children.size() != drillString.parts.size()) throw NotPatchable();
        for (std::size_t i = 0; i < drillString.parts.size(); ++i) {
            const StringPart& part = drillString.parts[i];
            const YamlNode& map = parts.children[i];
            const std::string path = "string." + std::to_string(i);
            if (part.group != (indexOf(map, "of") < map.children.size())) throw NotPatchable();
            patchMap(map, path);
            if (part.group)
                patchList(valueOf(map, "of", YamlKind::sequence), path + ".of", part.sections.size());
        }
    }

    void patchList(const YamlNode& list, const std::string& path, std::size_t count) {
        if (list.children.size() != count) throw NotPatchable();
        for (std::size_t i = 0; i < count; ++i) patchMap(list.children[i], path + "." + std::to_string(i));
    }

    void patchCorners(const YamlNode& root) {
        const std::size_t count = m_scenario.bitRock.corners.size();
        const YamlNode* map = sectionMap(root, "bit_rock");
        if (!map) {
            if (count > 0 && indexOf(root, "bit_rock") < root.children.size()) throw NotPatchable();
            return;
        }
        const std::size_t at = indexOf(*map, "corners");
        const bool there = at < map->children.size();
        const bool same = there && map->children[at + 1].kind == YamlKind::sequence &&
                          map->children[at + 1].children.size() == count;
        if (same && count > 0)
            patchList(map->children[at + 1], "bit_rock.corners", count);
        else
            patchLines(*map, "bit_rock", "corners", count > 0);
    }

    /// The points of a table that stand in the file itself.
    void patchPoints(const YamlNode& root) {
        const bool wanted = isForced(m_scenario) && m_scenario.pulse.shape == PulseShape::table &&
                            m_scenario.pulse.tableFile.empty();
        const YamlNode* map = sectionMap(root, "pulse");
        if (!map) {
            if (wanted && indexOf(root, "pulse") < root.children.size()) throw NotPatchable();
            return;
        }
        const std::size_t at = indexOf(*map, "points");
        if (wanted && at < map->children.size() &&
            pointsOf(map->children[at + 1]) == m_scenario.pulse.tablePoints)
            return;
        patchLines(*map, "pulse", "points", wanted);
    }

    static const YamlNode* sectionMap(const YamlNode& root, std::string_view section) {
        const std::size_t at = indexOf(root, section);
        const bool isMap = at < root.children.size() && root.children[at + 1].kind == YamlKind::map;
        return isMap ? &root.children[at + 1] : nullptr;
    }

    TablePoints pointsOf(const YamlNode& list) const {
        std::vector<TablePoint> points;
        for (const YamlNode& item : list.children) {
            if (item.children.size() != 2) return {};
            const bool units = hasUnits(m_scenario);
            const auto value = [](const YamlNode& node, Quantity quantity) {
                return parseQuantity(node.text, quantity).si;
            };
            points.push_back({value(item.children[0], units ? Quantity::time : Quantity::ratio),
                              value(item.children[1], units ? Quantity::force : Quantity::ratio)});
        }
        return points;
    }

    /// Returns the items of a list of a section as a new file has them, one per line, without indentation.
    std::vector<std::string> listItems(std::string_view section, std::string_view key) const {
        const std::string text = sectionText(m_scenario, section);
        const std::string heading = "  " + std::string(key) + ":\n";
        std::size_t at = text.find(heading);
        std::vector<std::string> items;
        if (at == std::string::npos) return items;
        for (at += heading.size(); at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::size_t dash = text.find_first_not_of(' ', at);
            if (dash >= end || text[dash] != '-') break;
            items.push_back(text.substr(dash, end - dash));
            at = end + 1;
        }
        return items;
    }

    /// Puts a list into the map of a section as lines of its own, and removes the old one.
    void patchLines(const YamlNode& map, std::string_view section, std::string_view key, bool wanted) {
        const std::size_t at = indexOf(map, key);
        const bool there = at < map.children.size();
        if (!wanted && !there) return;
        if (map.children.empty()) throw NotPatchable();
        if (map.flow) return patchFlowList(map, section, key, wanted);
        const std::size_t column =
            map.children[0].offset - lineOf(literalExtent(m_text, map.children[0])).begin;
        std::string text;
        if (wanted) {
            text = std::string(column, ' ') + std::string(key) + ":" + std::string(m_lineEnd);
            const std::vector<std::string> items = listItems(section, key);
            if (items.empty()) throw NotPatchable();
            for (const std::string& item : items)
                text += std::string(column + 2, ' ') + item + std::string(m_lineEnd);
        }
        if (there) {
            const Extent begin = lineOf(literalExtent(m_text, map.children[at]));
            const Extent end = lineOf({begin.begin, lastOf(map.children[at + 1])});
            m_edits.push_back({begin.begin, end.end - begin.begin, std::move(text)});
            return;
        }
        // Behind the last entry of the map.
        const Extent end = lineOf({map.children[0].offset, lastOf(map)});
        const bool isOpen = m_text.substr(0, end.end).find_last_of('\n') + 1 != end.end;
        m_edits.push_back({end.end, 0, (isOpen ? std::string(m_lineEnd) : std::string()) + text});
    }

    void patchFlowList(const YamlNode& map, std::string_view section, std::string_view key, bool wanted) {
        const std::size_t at = indexOf(map, key);
        const std::vector<std::string> items = listItems(section, key);
        // Many points are written one per line, not all in one.
        constexpr std::size_t mostInLine = 20;
        if (items.size() > mostInLine) throw NotPatchable();
        std::string list;
        for (const std::string& item : items) list += (list.empty() ? "" : ", ") + item.substr(2);
        if (at < map.children.size()) {
            if (!wanted || map.children[at + 1].children.empty()) throw NotPatchable();
            const YamlNode& old = map.children[at + 1];
            m_edits.push_back({old.offset, behindBrackets(old) - old.offset, "[" + list + "]"});
        } else {
            m_edits.push_back(
                {behindBrackets(map.children.back()), 0, ", " + std::string(key) + ": [" + list + "]"});
        }
    }

    /// The byte behind a value, with the brackets that close it.
    std::size_t behindBrackets(const YamlNode& node) const {
        if (node.kind == YamlKind::scalar) return literalExtent(m_text, node).end;
        if (!node.flow || node.children.empty()) throw NotPatchable();
        const std::size_t end = m_text.find_first_of("]}", behindBrackets(node.children.back()));
        if (end == std::string_view::npos) throw NotPatchable();
        return end + 1;
    }

    /// The byte behind the last scalar of a value.
    std::size_t lastOf(const YamlNode& node) const {
        if (node.kind == YamlKind::scalar) return literalExtent(m_text, node).end;
        if (node.children.empty()) throw NotPatchable();
        return lastOf(node.children.back());
    }

    /// The block of the design study, which is exchanged as a whole.
    void patchDesign(const YamlNode& root) {
        const std::size_t at = indexOf(root, designKey);
        if (at >= root.children.size()) {
            if (!m_design.isEmpty()) append(designSetupText(m_design));
            return;
        }
        SectionReader reader(m_text);
        const YamlEntries block{{std::string(designKey), {&root.children[at], &root.children[at + 1]}}};
        if (readDesignSetup(reader, block) == m_design) return;
        const YamlNode& last = lastScalarOf(root.children[at], root.children[at + 1]);
        const Extent key = lineOf(literalExtent(m_text, root.children[at]));
        const Extent end = lineOf(literalExtent(m_text, last));
        m_edits.push_back({key.begin, end.end - key.begin, inLines(designSetupText(m_design))});
    }

    /// The last value of a block that is written line by line, or its key where it has none.
    static const YamlNode& lastScalarOf(const YamlNode& key, const YamlNode& value) {
        if (value.flow) throw NotPatchable();
        if (value.kind == YamlKind::null) return key;
        if (value.kind == YamlKind::scalar || value.children.empty()) return value;
        const std::size_t count = value.children.size();
        return lastScalarOf(value.kind == YamlKind::map ? value.children[count - 2] : value.children.back(),
                            value.children.back());
    }

    void patchSection(const YamlNode& root, std::string_view section) {
        const std::size_t at = indexOf(root, section);
        const bool there = at < root.children.size();
        // A section that is not there need not tell what its absence says.
        const bool wanted = std::ranges::any_of(
            m_values, [&](const SavedValue& v) { return v.section == section && (there || !v.isDefault); });
        if (there && wanted && root.children[at + 1].kind == YamlKind::map)
            patchMap(root.children[at + 1], section);
        else if (there && (wanted || root.children[at + 1].kind != YamlKind::null))
            removeSection(root, at, wanted);
        else if (wanted)
            appendSection(section);
    }

    /// A section of which nothing is left, as long as it is one line or a few.
    void removeSection(const YamlNode& root, std::size_t at, bool wanted) {
        const YamlNode& map = root.children[at + 1];
        if (wanted || root.flow || map.kind != YamlKind::map) throw NotPatchable();
        if (!map.flow)
            for (std::size_t i = 0; i + 1 < map.children.size(); i += 2) removeLine(map, i);
        const Extent key = lineOf(literalExtent(m_text, root.children[at]));
        const std::size_t end = map.flow ? lineOf({map.offset, flowEnd(map)}).end : key.end;
        m_edits.push_back({key.begin, end - key.begin, ""});
    }

    void appendSection(std::string_view section) { append(sectionText(m_scenario, section)); }

    void append(const std::string& text) {
        const bool open = !m_text.ends_with('\n');
        m_edits.push_back({m_text.size(), 0, (open ? std::string(m_lineEnd) : "") + inLines(text)});
    }

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
        for (const SavedValue& value : m_values) {
            if (value.section != section) continue;
            const std::size_t at = indexOf(map, value.key);
            if (at < map.children.size())
                before = &map.children[at];
            else if (!value.isDefault)
                insert(map, before, value);
        }
    }

    void patchEntry(const YamlNode& map, std::size_t at, std::string_view section) {
        const YamlNode& key = map.children[at];
        const YamlNode& node = map.children[at + 1];
        if (section.empty() && key.text != "title" && key.text != "end_time") return;
        if (section == "pulse" && key.text == "points") return;
        if (node.kind == YamlKind::sequence &&
            (key.text == "sections" || key.text == "of" || key.text == "corners"))
            return;
        const SavedValue* value = saved(section, key.text);
        if (!value && section.empty() && node.text.empty()) return;
        if (!value) {
            if (map.flow)
                removeFromFlow(map, at);
            else
                removeLine(map, at);
            return;
        }
        const Unit* unit = nullptr;
        if (value->unit) {
            const TypedQuantity old = parseQuantity(node.text, value->unit->quantity);
            if (old.valid() && old.si == value->number) return;
            unit = old.unit;
        } else if (node.text == value->text && node.kind == YamlKind::scalar) {
            return;
        }
        replace(literalExtent(m_text, node), valueText(*value, unit));
    }

    /// Exchanges a value. A comment behind it was about the value that was there.
    void replace(Extent extent, std::string text) {
        if (const Extent comment = commentBehind(m_text, extent.end); comment.begin < comment.end)
            extent.end = comment.end;
        m_edits.push_back({extent.begin, extent.end - extent.begin, std::move(text)});
    }

    /// The line(s) of an extent, from the first byte to behind the line end.
    Extent lineOf(Extent extent) const {
        const std::size_t before =
            extent.begin == 0 ? std::string_view::npos : m_text.rfind('\n', extent.begin - 1);
        const std::size_t after = m_text.find('\n', extent.end);
        return {before == std::string_view::npos ? 0 : before + 1,
                after == std::string_view::npos ? m_text.size() : after + 1};
    }

    /// The line of one entry of a block map that has it to itself.
    Extent entryLine(const YamlNode& map, std::size_t at) const {
        const Extent key = literalExtent(m_text, map.children[at]);
        const YamlNode& value = map.children[at + 1];
        const Extent line =
            lineOf(value.kind == YamlKind::null ? key : Extent{key.begin, literalExtent(m_text, value).end});
        const std::string_view indentation = m_text.substr(line.begin, key.begin - line.begin);
        const bool oneLine =
            m_text.substr(key.begin, line.end - key.begin).find('\n') + 1 == line.end - key.begin ||
            line.end == m_text.size();
        if (!oneLine || indentation.find_first_not_of(' ') != std::string_view::npos) throw NotPatchable();
        return line;
    }

    void removeLine(const YamlNode& map, std::size_t at) {
        const Extent line = entryLine(map, at);
        m_edits.push_back({line.begin, line.end - line.begin, ""});
    }

    void removeFromFlow(const YamlNode& map, std::size_t at) {
        const bool first = at == 0;
        if (first && map.children.size() <= 2) throw NotPatchable();
        const std::size_t begin =
            first ? map.children[0].offset : literalExtent(m_text, map.children[at - 1]).end;
        const std::size_t end =
            first ? map.children[2].offset : literalExtent(m_text, map.children[at + 1]).end;
        m_edits.push_back({begin, end - begin, ""});
    }

    std::size_t flowEnd(const YamlNode& map) const {
        const std::size_t last =
            map.children.empty() ? map.offset : literalExtent(m_text, map.children.back()).end;
        const std::size_t brace = m_text.find('}', last);
        if (brace == std::string_view::npos) throw NotPatchable();
        return brace;
    }

    /// A new entry behind the entry with the key `before`, or in front of all of them.
    void insert(const YamlNode& map, const YamlNode* before, const SavedValue& value) {
        if (map.children.empty()) throw NotPatchable();
        const std::string entry = std::string(value.key) + ": " + valueText(value);
        const std::size_t at = before ? static_cast<std::size_t>(before - map.children.data()) : 0;
        if (map.flow) {
            const std::size_t place =
                before ? literalExtent(m_text, map.children[at + 1]).end : map.children[0].offset;
            m_edits.push_back({place, 0, before ? ", " + entry : entry + ", "});
            return;
        }
        // The first entry of an item of a list stands behind its dash.
        const bool behindDash = before && at == 0;
        const Extent line = behindDash ? lineOf(literalExtent(m_text, map.children[1])) : entryLine(map, at);
        const Extent keyLine = lineOf(literalExtent(m_text, map.children[at]));  // its value may stand below
        const std::string indentation(map.children[at].offset - keyLine.begin, ' ');
        const bool open = before && m_text[line.end - 1] != '\n';
        const std::string text = open ? std::string(m_lineEnd) + indentation + entry
                                      : indentation + entry + std::string(m_lineEnd);
        m_edits.push_back({before ? line.end : line.begin, 0, text});
    }

    std::string_view m_text;
    const Scenario& m_scenario;
    const DesignSetup& m_design;
    std::vector<SavedValue> m_values;
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
