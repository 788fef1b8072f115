// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/identify/gauge_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/form_conversion.h"
#include "core/model/scales.h"
#include "core/model/section_pieces.h"

namespace drillwave {

namespace {

/// Pieces of a cone are as long as that: waves in them differ by the square of it [m].
constexpr double coneStep = 0.012;

std::string keyOfSection(const Scenario& scenario, const std::vector<Section>& all, std::size_t index) {
    if (expandedSections(scenario.drillString).empty()) return "rod";
    std::string name = all[index].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    const auto same = std::count_if(all.begin(), all.end(),
                                    [&](const Section& other) { return other.name == all[index].name; });
    return "string." + (name.empty() || same > 1 ? std::to_string(index + 1) : name);
}

SizedSection sizesOf(const Scenario& scenario, const std::vector<Section>& all, std::size_t index) {
    const Section& section = all[index];
    SizedSection sized;
    sized.name = section.name.empty() ? "section " + std::to_string(index + 1) : section.name;
    sized.key = keyOfSection(scenario, all, index);
    sized.length = section.length;
    sized.isGivenByArea = section.area.has_value();
    sized.diameter = outerDiameterAt(section, 0);
    sized.bore = section.area ? 0 : section.bore;
    const Material& material = scenario.drillString.material;
    const double modulus = section.youngsModulus.value_or(material.youngsModulus);
    const double density = section.density.value_or(material.density);
    sized.impedance = meanArea(section) * std::sqrt(modulus * density);
    return sized;
}

void addPieces(RockEnd& end, const Section& section, const Material& material, std::size_t source,
               const EndJoint& before) {
    const int count =
        isUniform(section) ? 1 : std::clamp(static_cast<int>(std::ceil(section.length / coneStep)), 2, 200);
    const double modulus = section.youngsModulus.value_or(material.youngsModulus);
    const double density = section.density.value_or(material.density);
    EndJoint joint = before;
    for (const Section& piece : uniformPieces(section, count, before.passing < 1)) {
        end.sections.push_back({meanArea(piece) * std::sqrt(modulus * density),
                                piece.length / std::sqrt(modulus / density),
                                std::exp(-piece.attenuation * piece.length), source});
        end.joints.push_back(joint);
        joint = {};
    }
}

}  // namespace

std::optional<GaugePlace> gaugePlace(const Scenario& scenario, double distance) {
    if (!(distance > 0) || !hasUnits(scenario)) return std::nullopt;
    std::vector<Section> all;
    const Material& material = scenario.drillString.material;
    for (const Section* section : expandedSections(scenario.drillString)) all.push_back(*section);
    if (all.empty()) all.push_back(sectionOf(scenario.rod, material));
    std::size_t index = all.size();
    double left = distance;
    while (index > 0 && left > all[index - 1].length) left -= all[--index].length;
    if (index == 0) return std::nullopt;
    --index;
    const Section& own = all[index];
    constexpr double rearEnd = 1e-6;  // a gauge at the struck end sees no wave by itself [m]
    if (!isUniform(own) || (index == 0 && left > own.length - rearEnd)) return std::nullopt;
    GaugePlace place;
    place.section = sizesOf(scenario, all, index);
    place.index = index;
    const double modulus = own.youngsModulus.value_or(material.youngsModulus);
    const double density = own.density.value_or(material.density);
    place.waveSpeed = std::sqrt(modulus / density);
    place.youngsModulus = modulus;
    place.axialStiffness = modulus * areaAt(own, 0);
    place.attenuation = own.attenuation;
    place.ahead = left;
    place.behind = own.length - left;
    for (std::size_t i = 0; i < index; ++i) place.fromStruckEnd += all[i].length;
    place.fromStruckEnd += place.behind;
    place.end.impedance = place.section.impedance;
    const bool isLast = index + 1 == all.size();
    EndJoint joint{own.massAfter, std::sqrt(1 - own.loss)};
    if (isLast) place.end.bitMass = own.massAfter;
    for (std::size_t i = index + 1; i < all.size(); ++i) {
        addPieces(place.end, all[i], material, place.towardsBit.size(), joint);
        place.towardsBit.push_back(sizesOf(scenario, all, i));
        joint = {all[i].massAfter, std::sqrt(1 - all[i].loss)};
        if (i + 1 == all.size()) place.end.bitMass = all[i].massAfter;
    }
    return place;
}

}  // namespace drillwave
