// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/string_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

namespace drillwave {

namespace {

using Offset = std::ptrdiff_t;

StringPart alone(Section section) {
    StringPart part;
    part.sections.push_back(std::move(section));
    return part;
}

std::vector<Section>& listOf(DrillString& drillString, const SectionSpot& spot) {
    return spot.inHammer ? drillString.hammer.sections : drillString.parts[spot.part].sections;
}

/// Within its list, where there is room.
bool moveInList(std::vector<Section>& list, SectionSpot& spot, MoveTo direction) {
    if (direction == MoveTo::rear ? spot.index == 0 : spot.index + 1 == list.size()) return false;
    const std::size_t to = direction == MoveTo::rear ? spot.index - 1 : spot.index + 1;
    std::swap(list[spot.index], list[to]);
    spot.index = to;
    return true;
}

/// Out of a repeat of several, to stand alone beside it.
SectionSpot leaveRepeat(DrillString& drillString, const SectionSpot& spot, MoveTo direction) {
    std::vector<Section>& list = drillString.parts[spot.part].sections;
    StringPart part = alone(std::move(list[spot.index]));
    list.erase(list.begin() + Offset(spot.index));
    const std::size_t at = direction == MoveTo::rear ? spot.part : spot.part + 1;
    drillString.parts.insert(drillString.parts.begin() + Offset(at), std::move(part));
    return {.part = at};
}

/// Into the repeat beside it, at the end that it comes from.
SectionSpot enterRepeat(DrillString& drillString, const SectionSpot& spot, std::size_t repeat) {
    std::vector<StringPart>& parts = drillString.parts;
    std::vector<Section>& list = parts[repeat].sections;
    const std::size_t index = repeat < spot.part ? list.size() : 0;
    list.insert(list.begin() + Offset(index), std::move(parts[spot.part].sections.front()));
    parts.erase(parts.begin() + Offset(spot.part));
    return {.part = repeat < spot.part ? repeat : repeat - 1, .index = index};
}

void roundLength(Section& section) {
    const double length = roundedLength(section.length);
    if (length == section.length) return;
    section.length = length;
    section.preset.clear();
}

}  // namespace

std::vector<SectionSpot> sectionSpots(const DrillString& drillString) {
    std::vector<SectionSpot> spots;
    for (std::size_t i = 0; i < drillString.hammer.sections.size(); ++i)
        spots.push_back({.inHammer = true, .index = i});
    for (std::size_t part = 0; part < drillString.parts.size(); ++part)
        for (std::size_t i = 0; i < drillString.parts[part].sections.size(); ++i)
            spots.push_back({.part = part, .index = i});
    return spots;
}

const Section& sectionAt(const DrillString& drillString, const SectionSpot& spot) {
    return spot.inHammer ? drillString.hammer.sections[spot.index]
                         : drillString.parts[spot.part].sections[spot.index];
}

Section& sectionAt(DrillString& drillString, const SectionSpot& spot) {
    return listOf(drillString, spot)[spot.index];
}

std::uint64_t placeOf(const DrillString& drillString, const SectionSpot& spot) {
    std::uint64_t place = spot.index + 1;
    if (!spot.inHammer)
        for (std::size_t part = 0; part < spot.part; ++part)
            place += static_cast<std::uint64_t>(std::max(drillString.parts[part].repeat, 0)) *
                     drillString.parts[part].sections.size();
    return place;
}

SectionSpot insertAfter(DrillString& drillString, const SectionSpot& spot, Section section) {
    if (spot.inHammer || drillString.parts[spot.part].group) {
        std::vector<Section>& list = listOf(drillString, spot);
        list.insert(list.begin() + Offset(spot.index) + 1, std::move(section));
        return {spot.inHammer, spot.part, spot.index + 1};
    }
    drillString.parts.insert(drillString.parts.begin() + Offset(spot.part) + 1, alone(std::move(section)));
    return {.part = spot.part + 1};
}

SectionSpot insertBehind(DrillString& drillString, const SectionSpot& spot,
                         const std::vector<Section>& sections) {
    assert(!sections.empty());
    SectionSpot last = spot;
    auto section = sections.begin();
    const bool endsRepeat = !spot.inHammer && drillString.parts[spot.part].group &&
                            spot.index + 1 == drillString.parts[spot.part].sections.size();
    if (endsRepeat) {
        last = {.part = spot.part + 1};
        drillString.parts.insert(drillString.parts.begin() + Offset(last.part), alone(*section++));
    }
    for (; section != sections.end(); ++section) last = insertAfter(drillString, last, *section);
    return last;
}

namespace {

/// Returns whether a section stands beside others in the hammer or in a repeat, not as a part of its own.
bool isInList(const DrillString& drillString, const SectionSpot& spot) {
    return spot.inHammer || drillString.parts[spot.part].group;
}

}  // namespace

bool canReplace(const DrillString& drillString, const std::vector<SectionSpot>& spots) {
    if (spots.empty()) return false;
    const SectionSpot& first = spots.front();
    if (!isInList(drillString, first)) return canRepeat(drillString, spots);
    for (std::size_t i = 0; i < spots.size(); ++i)
        if (spots[i] != SectionSpot{first.inHammer, first.part, first.index + i}) return false;
    return true;
}

SectionSpot replaceSections(DrillString& drillString, const std::vector<SectionSpot>& spots,
                            const std::vector<Section>& sections) {
    assert(canReplace(drillString, spots) && !sections.empty());
    SectionSpot last = spots.back();
    for (const Section& section : sections) last = insertAfter(drillString, last, section);
    for (auto spot = spots.rbegin(); spot != spots.rend(); ++spot) removeSection(drillString, *spot);
    (isInList(drillString, spots.front()) ? last.index : last.part) -= spots.size();
    return last;
}

SectionSpot insertAt(DrillString& drillString, StringEnd end, const std::vector<Section>& sections) {
    std::vector<StringPart>& parts = drillString.parts;
    std::size_t at = end == StringEnd::shank ? 0 : parts.size();
    for (const Section& section : sections) parts.insert(parts.begin() + Offset(at++), alone(section));
    return {.part = at - 1};
}

bool canRemove(const DrillString& drillString, const SectionSpot& spot) {
    if (spot.inHammer) return drillString.hammer.sections.size() > 1;
    return drillString.parts.size() > 1 || drillString.parts[spot.part].sections.size() > 1;
}

void removeSection(DrillString& drillString, const SectionSpot& spot) {
    assert(canRemove(drillString, spot));
    std::vector<Section>& list = listOf(drillString, spot);
    list.erase(list.begin() + Offset(spot.index));
    if (list.empty()) drillString.parts.erase(drillString.parts.begin() + Offset(spot.part));
}

std::optional<SectionSpot> moveSection(DrillString& drillString, const SectionSpot& spot, MoveTo direction) {
    SectionSpot to = spot;
    if (moveInList(listOf(drillString, spot), to, direction)) return to;
    if (spot.inHammer) return std::nullopt;
    std::vector<StringPart>& parts = drillString.parts;
    if (parts[spot.part].sections.size() > 1) return leaveRepeat(drillString, spot, direction);
    if (direction == MoveTo::rear ? spot.part == 0 : spot.part + 1 == parts.size()) return std::nullopt;
    const std::size_t next = direction == MoveTo::rear ? spot.part - 1 : spot.part + 1;
    if (parts[next].group && !parts[spot.part].group) return enterRepeat(drillString, spot, next);
    std::swap(parts[spot.part], parts[next]);
    return SectionSpot{.part = next};
}

bool canRepeat(const DrillString& drillString, const std::vector<SectionSpot>& spots) {
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (spots[i].inHammer || drillString.parts[spots[i].part].group) return false;
        if (spots[i].part != spots.front().part + i) return false;
    }
    return !spots.empty();
}

void repeatSections(DrillString& drillString, const std::vector<SectionSpot>& spots, int times) {
    assert(canRepeat(drillString, spots) && times >= 1);
    std::vector<StringPart>& parts = drillString.parts;
    StringPart repeat;
    repeat.repeat = times;
    repeat.group = true;
    const auto first = parts.begin() + Offset(spots.front().part);
    const auto last = first + Offset(spots.size());
    for (auto each = first; each != last; ++each)
        repeat.sections.push_back(std::move(each->sections.front()));
    *first = std::move(repeat);
    parts.erase(first + 1, last);
}

void setRepeat(DrillString& drillString, std::size_t part, int times) {
    std::vector<StringPart>& parts = drillString.parts;
    assert(parts[part].group);
    if (times != 1) {
        parts[part].repeat = times;
        return;
    }
    std::vector<StringPart> members;
    for (Section& section : parts[part].sections) members.push_back(alone(std::move(section)));
    const auto at = parts.erase(parts.begin() + Offset(part));
    parts.insert(at, std::make_move_iterator(members.begin()), std::make_move_iterator(members.end()));
}

double roundedLength(double length) {
    const double millimetres = length * 1000;
    const double step = millimetres >= 50 ? 10 : millimetres >= 20 ? 5 : 1;
    const double rounded = std::max(1.0, std::round(millimetres / step)) * step / 1000;
    return std::abs(rounded - length) <= 1e-12 * length ? length : rounded;
}

DrillString withRoundedLengths(DrillString drillString) {
    for (Section& section : drillString.hammer.sections) roundLength(section);
    for (StringPart& part : drillString.parts)
        for (Section& section : part.sections) roundLength(section);
    return drillString;
}

}  // namespace drillwave
