// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/law_reader.h"

#include "core/model/law_parameter.h"
#include "core/model/parameter_text.h"

namespace drillwave {
namespace {

constexpr const char* cornersExample =
    translatable("must be a list of corners: `- {force: 90 kN, slope: 0.35}`");

/// "bit_rock.corners.2", from 1 as in keys.
std::string pathOf(std::size_t place) {
    return "bit_rock.corners." + std::to_string(place);
}

void readCorner(SectionReader& reader, const YamlNode& item, std::size_t place) {
    const std::string path = pathOf(place);
    reader.scenario().bitRock.corners.resize(place);
    reader.setPlace(path, item.offset);
    if (item.kind != YamlKind::map) {
        reader.problems().reportKey(item.offset, path, cornersExample);
        return;
    }
    const YamlEntries entries = reader.entriesOf(item, path, {"force", "slope"});
    for (const std::string_view field : {"force", "slope"}) {
        const auto found = entries.find(field);
        if (found == entries.end()) {
            if (!reader.isThere(entries, path, field))
                reader.reportMissing(path, field,
                                     translatable("is missing: a corner has a force and a slope"));
            continue;
        }
        reader.setPlace(joinedKey(path, field), found->second.place());
        reader.readNumber(*inFormOf(reader.scenario(), *findParameter(cornerKey(place, field))),
                          found->second, joinedKey(path, field));
    }
}

}  // namespace

bool readLaw(SectionReader& reader, const YamlEntries& entries) {
    const auto found = entries.find(lawKey);
    if (found == entries.end()) return true;
    const YamlEntry& entry = found->second;
    reader.setPlace(rockLawKey, entry.place());
    const std::optional<RockLaw> law = findRockLaw(entry.value->text);
    if (law)
        reader.scenario().bitRock.law = *law;
    else
        reader.problems().reportValue(
            entry.place(), rockLawKey, entry.value->text,
            {translatable("must be one of %1"), {findWordParameter(rockLawKey)->list()}});
    return law.has_value();
}

void readCorners(SectionReader& reader, const YamlEntries& entries) {
    const bool has = reader.scenario().bitRock.law == RockLaw::corners;
    const auto found = entries.find(cornersKey);
    if (found == entries.end()) {
        if (has && !reader.isThere(entries, "bit_rock", cornersKey))
            reader.reportMissing(
                "bit_rock", cornersKey,
                translatable("is missing: write for example `corners: [{force: 90 kN, slope: 0.35}]`"));
        return;
    }
    const YamlEntry& entry = found->second;
    const std::string path = joinedKey("bit_rock", cornersKey);
    reader.setPlace(path, entry.place());
    if (!has) {
        reader.problems().reportKey(entry.key->offset, path,
                                    translatable("only for a law with corners; write `law: corners`"));
        return;
    }
    if (entry.value->kind != YamlKind::sequence || entry.value->children.empty()) {
        reader.problems().reportKey(entry.place(), path, cornersExample);
        return;
    }
    const std::vector<YamlNode>& items = entry.value->children;
    if (items.size() > mostRockCorners) {
        reader.problems().reportKey(entry.place(), path,
                                    {translatable("has %1 corners, at most %2 are possible"),
                                     {std::to_string(items.size()), std::to_string(mostRockCorners)}});
        return;
    }
    for (std::size_t i = 0; i < items.size(); ++i) readCorner(reader, items[i], i + 1);
}

}  // namespace drillwave
