// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/message.h"

namespace drillwave {
namespace {

Message ordinal(std::uint64_t number) {
    const std::uint64_t tens = number % 100;
    const bool isTeen = tens >= 11 && tens <= 13;
    const char* pattern = translatable("%1th");
    if (!isTeen && number % 10 == 1) pattern = translatable("%1st");
    if (!isTeen && number % 10 == 2) pattern = translatable("%1nd");
    if (!isTeen && number % 10 == 3) pattern = translatable("%1rd");
    return {pattern, {std::to_string(number)}};
}

/// The numbers of the sections of the string among those of the same name, from 1.
struct NumberedNames {
    std::vector<std::uint64_t> numbers;
    std::map<std::string_view, std::uint64_t> counts;

    explicit NumberedNames(const std::vector<const Section*>& sections) {
        for (const Section* section : sections) numbers.push_back(++counts[section->name]);
    }
};

Message placeWords(const Section& section, std::uint64_t place, const NumberedNames& names) {
    if (section.name.empty()) return {translatable("section %1"), {std::to_string(place)}};
    if (names.counts.at(section.name) == 1) return sectionNameMessage(section.name);
    return {translatable("%1 %2"), {ordinal(names.numbers[place - 1]), sectionNameMessage(section.name)}};
}

/// A section that has several places.
Message repeatWords(const Section& section, const std::vector<std::uint64_t>& numbers) {
    const std::uint64_t first = numbers.front(), second = numbers[1], last = numbers.back();
    const bool follow = last - first + 1 == numbers.size();
    if (section.name.empty()) {
        std::vector<Message> ends{std::to_string(first), std::to_string(last)};
        if (follow) return {translatable("sections %1 to %2"), std::move(ends)};
        if (numbers.size() == 2) return {translatable("sections %1 and %2"), std::move(ends)};
        return {translatable("sections %1, %2 … %3"),
                {std::to_string(first), std::to_string(second), std::to_string(last)}};
    }
    if (numbers.size() == 2)
        return {translatable("%1 and %2 %3"),
                {ordinal(first), ordinal(last), sectionNameMessage(section.name)}};
    if (follow)
        return {translatable("%1 to %2 %3"),
                {ordinal(first), ordinal(last), sectionNameMessage(section.name)}};
    return {translatable("%1, %2 … %3 %4"),
            {ordinal(first), ordinal(second), ordinal(last), sectionNameMessage(section.name)}};
}

}  // namespace

std::span<const std::string_view> customarySectionNames() {
    static constexpr std::array<std::string_view, 6> names{"adapter",   "rod",      "coupling",
                                                           "bit skirt", "bit head", "bit"};
    return names;
}

Message sectionNameMessage(const std::string& name) {
    const auto names = customarySectionNames();
    return std::ranges::find(names, name) == names.end() ? Message(name) : Message::ofTable(name);
}

std::vector<Message> stringSectionWords(const DrillString& drillString) {
    const std::vector<const Section*> sections = expandedSections(drillString);
    const NumberedNames names(sections);
    std::vector<Message> words;
    for (std::size_t i = 0; i < sections.size(); ++i) words.push_back(placeWords(*sections[i], i + 1, names));
    return words;
}

Message hammerSectionWords(const DrillString& drillString, std::size_t place) {
    const std::string& name = drillString.hammer.sections[place - 1].name;
    return {translatable("hammer %1"), {std::to_string(place) + (name.empty() ? "" : " (" + name + ")")}};
}

namespace {

std::vector<Message> hammerWords(const DrillString& drillString) {
    std::vector<Message> words;
    for (std::size_t place = 1; place <= drillString.hammer.sections.size(); ++place)
        words.push_back(hammerSectionWords(drillString, place));
    return words;
}

}  // namespace

std::vector<Message> sectionWords(const DrillString& drillString) {
    std::vector<Message> words = hammerWords(drillString);
    for (Message& each : stringSectionWords(drillString)) words.push_back(std::move(each));
    return words;
}

std::vector<Message> rowWords(const DrillString& drillString) {
    const std::vector<const Section*> sections = expandedSections(drillString);
    const NumberedNames names(sections);
    std::vector<Message> words = hammerWords(drillString);
    std::uint64_t before = 0;
    for (const StringPart& part : drillString.parts) {
        const std::uint64_t size = part.sections.size();
        const auto repeat = static_cast<std::uint64_t>(std::max(part.repeat, 0));
        for (std::uint64_t i = 0; i < size; ++i) {
            const Section& section = part.sections[i];
            std::vector<std::uint64_t> numbers;
            for (std::uint64_t n = 0; n < repeat; ++n) {
                const std::uint64_t place = before + n * size + i + 1;
                numbers.push_back(section.name.empty() ? place : names.numbers[place - 1]);
            }
            words.push_back(numbers.size() > 1 ? repeatWords(section, numbers)
                                               : placeWords(section, before + i + 1, names));
        }
        before += repeat * size;
    }
    return words;
}

Message addressedWords(const SectionAddress& address, const DrillString& drillString) {
    const bool ofHammer = address.chain == SectionAddress::Chain::hammer;
    if (address.place == 0) {
        const Message name = sectionNameMessage(address.name);
        return ofHammer ? Message(translatable("hammer %1"), {name}) : name;
    }
    std::optional<std::size_t> row;
    visitNumberedSections(address, drillString, [&](const Section&, std::size_t at) { row = at; });
    if (!row)
        return {ofHammer ? translatable("hammer %1") : translatable("section %1"),
                {std::to_string(address.place)}};
    return rowWords(drillString)[ofHammer ? *row : *row + drillString.hammer.sections.size()];
}

Message stringWords(const DrillString& drillString) {
    std::size_t rods = 0, couplings = 0, others = 0;
    for (const Section* section : expandedSections(drillString))
        ++(section->name == "rod" ? rods : section->name == "coupling" ? couplings : others);
    if (rods + couplings == 0)
        return counted(others, translatable("%1 section"), translatable("%1 sections"));
    Message all;
    const auto add = [&all](Message more) {
        all = all.isEmpty() ? std::move(more)
                            : Message(translatable("%1, %2"), {std::move(all), std::move(more)});
    };
    if (rods > 0) add(counted(rods, translatable("%1 rod"), translatable("%1 rods")));
    if (couplings > 0) add(counted(couplings, translatable("%1 coupling"), translatable("%1 couplings")));
    if (others > 0) add(counted(others, translatable("%1 other section"), translatable("%1 other sections")));
    return all;
}

}  // namespace drillwave
