// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/string_reader.h"

#include <algorithm>
#include <cstdint>

#include "core/model/parameter.h"
#include "core/model/parameter_text.h"
#include "core/model/section_field.h"
#include "core/text/name_text.h"

namespace drillwave {
namespace {

using Chain = SectionAddress::Chain;

constexpr const char* stringExample =
    translatable("must be a list of sections: `- {name: rod, length: 3660 mm, diameter: 39 mm}`");

constexpr const char* sectionExample = translatable("must be a section: `{length: 300 mm, diameter: 50 mm}`");

/// One section, the place of whose keys is that of `path`: "string.3".
class SectionOfFile {
  public:
    SectionOfFile(SectionReader& reader, std::string path) : m_reader(reader), m_path(std::move(path)) {}

    Section read(const YamlNode& map) {
        m_reader.setPlace(m_path, map.offset);
        std::vector<std::string_view> known{"name", "preset"};
        for (const SectionField& field : sectionFields()) known.push_back(field.key);
        const YamlEntries entries = m_reader.entriesOf(map, m_path, known);
        readName(entries);
        readPreset(entries);
        for (const SectionField& field : sectionFields())
            if (const auto found = entries.find(field.key); found != entries.end())
                readNumber(field, found->second);
        require(entries);
        return std::move(m_section);
    }

  private:
    std::string key(std::string_view local) const { return joinedKey(m_path, local); }

    void readName(const YamlEntries& entries) {
        const auto found = entries.find("name");
        if (found == entries.end() || found->second.value->kind == YamlKind::null) return;
        const YamlEntry& entry = found->second;
        m_reader.setPlace(key("name"), entry.place());
        const Message reason = entry.value->kind != YamlKind::scalar ? translatable("must be text")
                               : entry.value->text.empty()
                                   ? translatable("is empty; leave it out for a section without a name")
                                   : sectionNameProblem(entry.value->text);
        if (reason.isEmpty())
            m_section.name = entry.value->text;
        else
            m_reader.problems().reportValue(entry.place(), key("name"), entry.value->text, reason);
    }

    void readPreset(const YamlEntries& entries) {
        const auto found = entries.find("preset");
        if (found == entries.end()) return;
        const YamlEntry& entry = found->second;
        m_reader.setPlace(key("preset"), entry.place());
        const Message reason = entry.value->kind != YamlKind::scalar ? translatable("must be text")
                               : entry.value->text.empty()
                                   ? translatable("is empty; leave it out for a section without a preset")
                                   : drillwave::nameProblem(entry.value->text);
        if (reason.isEmpty())
            m_section.preset = entry.value->text;
        else
            m_reader.problems().reportValue(entry.place(), key("preset"), entry.value->text, reason);
    }

    void readNumber(const SectionField& field, const YamlEntry& entry) {
        m_reader.setPlace(key(field.key), entry.place());
        const YamlNode& value = *entry.value;
        if (value.kind != YamlKind::scalar) {
            const char* what = value.kind == YamlKind::null ? translatable("has no value")
                                                            : translatable("must be one value");
            m_reader.problems().reportKey(entry.place(), key(field.key), what);
            return;
        }
        const TypedQuantity typed =
            parseQuantity(value.text, field.quantity, BareNumber::refused, &field.displayUnit());
        const Message reason = typed.valid() ? rangeProblem(field, typed.si) : typed.problem;
        if (!reason.isEmpty())
            m_reader.problems().reportValue(entry.place(), key(field.key), value.text, reason);
        else
            field.assign(m_section, typed.si);
    }

    void require(const YamlEntries& entries) {
        if (!m_reader.isThere(entries, m_path, "length"))
            m_reader.reportMissing(m_path, "length",
                                   translatable("is missing: write for example `length: 3660 mm`"));
        m_reader.requireOneOf(entries, m_path, "diameter", "area");
        for (const SectionField& field : sectionFields()) {
            const auto found = entries.find(field.key);
            if (found == entries.end() || field.with == SectionField::With::both) continue;
            const bool ofArea = field.with == SectionField::With::area;
            if (entries.contains("diameter") == ofArea && entries.contains("area") != ofArea)
                m_reader.problems().reportKey(found->second.key->offset, key(field.key),
                                              ofArea
                                                  ? translatable("goes with an area, not with a diameter")
                                                  : translatable("goes with a diameter, not with an area"));
        }
    }

    SectionReader& m_reader;
    std::string m_path;
    Section m_section;
};

bool isRepeat(const YamlNode& item) {
    return item.valueOf("repeat") || item.valueOf("of");
}

/// A list of sections from a place on; stops behind the most that there may be.
std::vector<Section> readSections(SectionReader& reader, const YamlNode& list, Chain chain,
                                  std::uint64_t before) {
    std::vector<Section> sections;
    for (const YamlNode& item : list.children) {
        const std::string path = sectionKey(chain, before + sections.size() + 1);
        if (sections.size() > maximumSections) break;
        if (item.kind != YamlKind::map) {
            reader.problems().reportKey(item.offset, path, sectionExample);
            sections.emplace_back();
        } else if (isRepeat(item)) {
            reader.problems().reportKey(item.offset, path,
                                        chain == Chain::hammer
                                            ? translatable("a hammer has no repeats; write its sections out")
                                            : translatable("a repeat cannot contain another one"));
            sections.emplace_back();
        } else {
            sections.push_back(SectionOfFile(reader, path).read(item));
        }
    }
    return sections;
}

class StringReader {
  public:
    explicit StringReader(SectionReader& reader)
        : m_reader(reader), m_string(reader.scenario().drillString) {}

    void readHammer(const YamlEntries& file) {
        const std::optional<YamlEntries> entries =
            m_reader.section(file, "hammer", "hammer", {"sections", "restrike"});
        // One that cannot be read is no force in its place.
        const auto keep = [this] {
            m_string.hammer.sections.resize(std::max<std::size_t>(1, m_string.hammer.sections.size()));
        };
        if (!entries) return keep();
        readHammerSections(*entries);
        keep();
        m_reader.readParameters(*entries, "hammer", SectionReader::Applicability::checked);
        m_reader.requireParameters(*entries, "hammer");
        readRestrike(*entries);
    }

    void readString(const YamlEntries& file) {
        const auto found = file.find("string");
        if (found == file.end()) {
            if (!m_reader.isThere(file, "", "string"))
                m_reader.reportMissing("", "string", translatable("is missing"));
            return;
        }
        const YamlEntry& entry = found->second;
        m_reader.setPlace("string", entry.key->offset);
        if (entry.value->kind != YamlKind::sequence) {
            m_reader.problems().reportKey(entry.place(), "string", stringExample);
            return;
        }
        if (entry.value->children.empty())
            m_reader.problems().reportKey(entry.place(), "string",
                                          translatable("must have at least one section"));
        for (const YamlNode& item : entry.value->children) {
            if (m_place > maximumSections) break;
            readPart(item);
        }
        if (m_place > maximumSections)
            m_reader.problems().reportKey(entry.key->offset, "string",
                                          {translatable("has more than %1 sections, its repeats written out"),
                                           {std::to_string(maximumSections)}});
    }

  private:
    void readRestrike(const YamlEntries& entries) {
        const auto found = entries.find("restrike");
        if (found == entries.end()) return;
        const YamlEntry& entry = found->second;
        const std::optional<bool> restrike = findTruth(entry.value->text);
        if (restrike)
            m_string.hammer.restrike = *restrike;
        else
            m_reader.problems().reportValue(entry.place(), restrikeKey, entry.value->text,
                                            translatable("must be true or false"));
    }

    void readHammerSections(const YamlEntries& entries) {
        const auto found = entries.find("sections");
        if (found == entries.end()) {
            if (!m_reader.isThere(entries, "hammer", "sections"))
                m_reader.reportMissing("hammer", "sections", translatable("is missing"));
            return;
        }
        const YamlEntry& entry = found->second;
        m_reader.setPlace("hammer.sections", entry.key->offset);
        if (entry.value->kind != YamlKind::sequence)
            m_reader.problems().reportKey(
                entry.place(), "hammer.sections",
                translatable("must be a list of sections: `- {length: 300 mm, diameter: 50 mm}`"));
        else if (entry.value->children.empty())
            m_reader.problems().reportKey(entry.place(), "hammer.sections",
                                          translatable("must have at least one section"));
        else
            m_string.hammer.sections = readSections(m_reader, *entry.value, Chain::hammer, 0);
    }

    void readPart(const YamlNode& item) {
        if (isRepeat(item)) {
            readRepeat(item);
            return;
        }
        const std::string path = sectionKey(Chain::string, m_place + 1);
        StringPart part;
        if (item.kind == YamlKind::map)
            part.sections.push_back(SectionOfFile(m_reader, path).read(item));
        else
            m_reader.problems().reportKey(
                item.offset, path,
                translatable("must be a section, `{name: rod, length: 3660 mm, diameter: 39 mm}`, or "
                             "`{repeat: 3, of: […]}`"));
        part.sections.resize(1);  // those behind it keep their places
        ++m_place;
        m_string.parts.push_back(std::move(part));
    }

    void readRepeat(const YamlNode& map) {
        const std::string path = sectionKey(Chain::string, m_place + 1);
        m_reader.setPlace(path, map.offset);
        const YamlEntries entries = m_reader.entriesOf(map, path, {"repeat", "of"});
        StringPart part;
        part.group = true;
        part.repeat = readCount(entries, path);
        if (const auto found = entries.find("of"); found == entries.end()) {
            if (!m_reader.isThere(entries, path, "of"))
                m_reader.reportMissing(path, "of",
                                       translatable("is missing: give the list of the sections to repeat"));
        } else if (found->second.value->kind != YamlKind::sequence || found->second.value->children.empty()) {
            m_reader.problems().reportKey(found->second.place(), joinedKey(path, "of"),
                                          translatable("must be a list of at least one section"));
        } else {
            part.sections = readSections(m_reader, *found->second.value, Chain::string, m_place);
        }
        m_place += static_cast<std::uint64_t>(part.repeat) * part.sections.size();
        m_string.parts.push_back(std::move(part));
    }

    /// How often; once where that is missing or wrong, which is reported.
    int readCount(const YamlEntries& entries, const std::string& path) {
        const std::string key = joinedKey(path, "repeat");
        const auto found = entries.find("repeat");
        if (found == entries.end()) {
            if (!m_reader.isThere(entries, path, "repeat"))
                m_reader.reportMissing(path, "repeat",
                                       translatable("is missing: write for example `repeat: 3`"));
            return 1;
        }
        const YamlEntry& entry = found->second;
        m_reader.setPlace("string.repeat", entry.place());
        const TypedQuantity typed = parseQuantity(entry.value->text, Quantity::ratio);
        const Message reason =
            typed.valid() ? rangeProblem(*findParameter("string.repeat"), typed.si) : typed.problem;
        if (reason.isEmpty()) return static_cast<int>(typed.si);
        m_reader.problems().reportValue(entry.place(), key, entry.value->text, reason);
        return 1;
    }

    SectionReader& m_reader;
    DrillString& m_string;
    std::uint64_t m_place = 0;  // of the section read last, repeats written out
};

}  // namespace

std::vector<Section> readSectionList(SectionReader& reader, const YamlNode& list, const std::string& key) {
    std::vector<Section> sections;
    for (const YamlNode& item : list.children) {
        const std::string path = joinedKey(key, std::to_string(sections.size() + 1));
        if (item.kind != YamlKind::map)
            reader.problems().reportKey(item.offset, path, sectionExample);
        else
            sections.push_back(SectionOfFile(reader, path).read(item));
        if (sections.size() > maximumSections) break;
    }
    return sections;
}

void readDrillString(SectionReader& reader, const YamlEntries& file) {
    if (file.contains("material"))
        if (const std::optional<YamlEntries> entries = reader.section(file, "material", "material"))
            reader.readParameters(*entries, "material", SectionReader::Applicability::checked);
    StringReader string(reader);
    if (file.contains("hammer") || !file.contains("pulse")) string.readHammer(file);
    if (const auto pulse = file.find("pulse"); pulse != file.end() && file.contains("hammer"))
        reader.problems().reportKey(
            pulse->second.key->offset, "pulse",
            translatable(
                "cannot be combined with `hammer`: keep one, a hammer of sections or a force instead of it"));
    string.readString(file);
    // At the top level, beside the sections.
    reader.readParameters(file, "", SectionReader::Applicability::checked);
}

}  // namespace drillwave
