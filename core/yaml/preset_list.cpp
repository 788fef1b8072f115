// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/preset_list.h"

#include "core/text/name_text.h"

namespace drillwave {

void PresetList::readItems(const YamlNode& list, const std::function<void(const YamlNode&)>& read) {
    if (list.kind != YamlKind::sequence) {
        if (list.kind != YamlKind::null)
            m_reader.problems().reportKey(list.offset, m_key,
                                          translatable("must be a list of presets, `- name: …`"));
        return;
    }
    for (const YamlNode& item : list.children)
        if (item.kind == YamlKind::map)
            read(item);
        else
            m_reader.problems().reportKey(item.offset, m_key,
                                          translatable("each preset must begin with `name: …`"));
}

std::string PresetList::textOf(const YamlEntries& entries, const YamlNode& item, std::string_view key,
                               const char* missing) {
    const std::string path = joinedKey(m_key, key);
    const auto found = entries.find(key);
    if (found == entries.end()) {
        m_reader.problems().reportKey(item.offset, path, missing);
        return {};
    }
    const YamlNode& value = *found->second.value;
    if (value.kind != YamlKind::scalar || value.text.empty()) {
        m_reader.problems().reportKey(found->second.place(), path, translatable("must be text"));
        return {};
    }
    const Message problem = nameProblem(value.text);
    if (problem.isEmpty()) return value.text;
    m_reader.problems().reportValue(value.offset, path, value.text, problem);
    return {};
}

std::string PresetList::nameOf(const YamlEntries& entries, const YamlNode& item) {
    std::string name = textOf(entries, item, "name");
    if (!name.empty() && !m_names.insert(name).second)
        m_reader.problems().reportValue(entries.at("name").place(), joinedKey(m_key, "name"), name,
                                        translatable("is the name of another preset too"));
    return name;
}

}  // namespace drillwave
