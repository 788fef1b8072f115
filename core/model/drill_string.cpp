// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/drill_string.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace drillwave {
namespace {

std::uint64_t repeatsOf(const StringPart& part) {
    return part.repeat > 0 ? static_cast<std::uint64_t>(part.repeat) : 0;
}

}  // namespace

std::uint64_t sectionCount(const DrillString& drillString) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / 2;
    std::uint64_t count = 0;
    for (const StringPart& part : drillString.parts) {
        const std::uint64_t sections = part.sections.size();
        if (sections > 0 && repeatsOf(part) > (most - count) / sections) return most;
        count += repeatsOf(part) * sections;
    }
    return count;
}

std::vector<const Section*> expandedSections(const DrillString& drillString) {
    assert(sectionCount(drillString) <= maximumSections);
    std::vector<const Section*> sections;
    for (const StringPart& part : drillString.parts)
        for (int n = 0; n < part.repeat; ++n)
            for (const Section& section : part.sections) sections.push_back(&section);
    return sections;
}

std::vector<const Section*> allSections(const DrillString& drillString) {
    std::vector<const Section*> sections;
    for (const Section& section : drillString.hammer.sections) sections.push_back(&section);
    const std::vector<const Section*> ofString = expandedSections(drillString);
    sections.insert(sections.end(), ofString.begin(), ofString.end());
    return sections;
}

std::vector<PlacedSection> placedSections(const DrillString& drillString) {
    std::vector<PlacedSection> placed;
    std::uint64_t before = 0;
    for (const StringPart& part : drillString.parts) {
        for (std::size_t i = 0; i < part.sections.size(); ++i)
            placed.push_back({&part.sections[i], before + i + 1});
        before += repeatsOf(part) * part.sections.size();
    }
    return placed;
}

const Section* sectionAt(const DrillString& drillString, std::uint64_t place) {
    assert(place >= 1);
    std::uint64_t left = place - 1;
    for (const StringPart& part : drillString.parts) {
        const std::uint64_t count = repeatsOf(part) * part.sections.size();
        if (left < count) return &part.sections[left % part.sections.size()];
        left -= count;
    }
    return nullptr;
}

const StringPart* firstRepeat(const DrillString& drillString) {
    const auto found = std::ranges::find(drillString.parts, true, &StringPart::group);
    return found == drillString.parts.end() ? nullptr : &*found;
}

const Section* ruleSection(const DrillString& drillString) {
    const Section* longest = nullptr;
    for (const StringPart& part : drillString.parts) {
        for (const Section& section : part.sections) {
            if (section.name == "rod") return &section;
            if (!longest || section.length > longest->length) longest = &section;
        }
    }
    return longest;
}

}  // namespace drillwave
