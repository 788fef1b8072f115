// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/design_setup_text.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/text/decimal_text.h"
#include "core/yaml/scenario_text.h"

namespace drillwave {
namespace {

constexpr std::string_view energyKey = "keep_energy", samplesKey = "samples", seedKey = "seed";

struct ListKey {
    std::string_view key;
    std::vector<std::string> DesignSetup::*texts;
};
constexpr std::array listKeys{ListKey{"uncertain", &DesignSetup::uncertain},
                              ListKey{"choose", &DesignSetup::choose}, ListKey{"aims", &DesignSetup::aims},
                              ListKey{"at_most", &DesignSetup::atMost},
                              ListKey{"at_least", &DesignSetup::atLeast}};

std::string pathOf(std::string_view key) {
    return joinedKey(designKey, key);
}

void readTexts(SectionReader& reader, const YamlEntry& entry, std::string_view key,
               std::vector<std::string>& texts) {
    if (entry.value->kind != YamlKind::sequence)
        return reader.problems().reportKey(entry.place(), pathOf(key),
                                           translatable("must be a list of texts, each after a `-`"));
    for (const YamlNode& item : entry.value->children) {
        if (item.kind == YamlKind::scalar && !item.text.empty())
            texts.push_back(item.text);
        else
            reader.problems().reportKey(item.offset, pathOf(key),
                                        translatable("has an item that is not text"));
    }
}

void readTruth(SectionReader& reader, const YamlEntry& entry, std::string_view key, bool& value) {
    const std::string& text = entry.value->text;
    if (text == "true" || text == "false")
        value = text == "true";
    else
        reader.problems().reportValue(entry.place(), pathOf(key), text,
                                      translatable("must be true or false"));
}

void readCount(SectionReader& reader, const YamlEntry& entry, std::string_view key, std::uint64_t least,
               std::uint64_t most, std::optional<std::uint64_t>& value) {
    const std::string& text = entry.value->text;
    value = wholeNumberIn<std::uint64_t>(text);
    if (value && *value >= least && *value <= most) return;
    value.reset();
    reader.problems().reportValue(entry.place(), pathOf(key), text,
                                  {translatable("must be a whole number from %1 to %2"),
                                   {std::to_string(least), std::to_string(most)}});
}

}  // namespace

DesignSetup readDesignSetup(SectionReader& reader, const YamlEntries& file) {
    DesignSetup setup;
    if (!file.contains(designKey)) return setup;
    std::vector<std::string_view> known{energyKey, samplesKey, seedKey};
    for (const ListKey& list : listKeys) known.push_back(list.key);
    const std::optional<YamlEntries> entries = reader.section(file, designKey, designKey, known);
    if (!entries) return setup;
    for (const ListKey& list : listKeys)
        if (const auto found = entries->find(list.key); found != entries->end())
            readTexts(reader, found->second, list.key, setup.*list.texts);
    if (const auto found = entries->find(energyKey); found != entries->end())
        readTruth(reader, found->second, energyKey, setup.keepEnergy);
    constexpr std::uint64_t mostSamples = std::uint64_t{1} << 20;  // of a study
    if (const auto found = entries->find(samplesKey); found != entries->end())
        readCount(reader, found->second, samplesKey, 1, mostSamples, setup.samples);
    if (const auto found = entries->find(seedKey); found != entries->end())
        readCount(reader, found->second, seedKey, 0,
                  static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()), setup.seed);
    return setup;
}

std::vector<SavedValue> savedDesignValues(const DesignSetup& setup) {
    if (setup.isEmpty()) return {};
    const auto saved = [](std::string_view key, std::string text, bool isDefault) {
        SavedValue value;
        value.section = designKey;
        value.key = key;
        value.text = std::move(text);
        value.isDefault = isDefault;
        return value;
    };
    std::vector<SavedValue> values{saved(energyKey, setup.keepEnergy ? "true" : "false", !setup.keepEnergy)};
    if (setup.samples) values.push_back(saved(samplesKey, std::to_string(*setup.samples), false));
    if (setup.seed) values.push_back(saved(seedKey, std::to_string(*setup.seed), false));
    return values;
}

std::vector<std::pair<std::string_view, std::vector<std::string>>> designLists(const DesignSetup& setup) {
    std::vector<std::pair<std::string_view, std::vector<std::string>>> lists;
    for (const ListKey& list : listKeys) {
        std::vector<std::string>& items = lists.emplace_back(list.key, std::vector<std::string>()).second;
        for (const std::string& item : setup.*list.texts) items.push_back(yamlScalar(item));
    }
    return lists;
}

std::string designSetupText(const DesignSetup& setup) {
    if (setup.isEmpty()) return {};
    std::string text = std::string(designKey) + ":\n";
    for (const auto& [key, items] : designLists(setup))
        if (!items.empty()) text += "  " + std::string(key) + ":\n" + listText(items, 4);
    for (const SavedValue& value : savedDesignValues(setup))
        if (!value.isDefault) text += "  " + std::string(value.key) + ": " + value.text + "\n";
    return text;
}

}  // namespace drillwave
