// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/text/units.h"

namespace drillwave {
namespace {

/// The second of fewer pieces could be left without any mass, where the section ends in a point.
constexpr int fewestWithEndArea = 4;

/// Diameters of what fills a section at its ends, and of the hole in it.
struct Frustum {
    double rear, end, bore;
};

double barOf(double area) {
    return 2 * std::sqrt(area / std::numbers::pi);
}

Frustum frustumOf(const Section& section) {
    if (!section.area)
        return {section.diameter, section.endDiameter.value_or(section.diameter), section.bore};
    return {barOf(*section.area), barOf(section.endArea.value_or(*section.area)), 0};
}

double ringArea(double outer, double inner) {
    return std::numbers::pi / 4 * (outer - inner) * (outer + inner);
}

std::string millimetres(double si) {
    static const Unit& unit = *findUnit(Quantity::length, "mm");
    return formatQuantity(si, Quantity::length, unit);
}

}  // namespace

bool isUniform(const Section& section) {
    return section.area ? section.endArea.value_or(*section.area) == *section.area
                        : section.endDiameter.value_or(section.diameter) == section.diameter;
}

bool hasUniformSections(const DrillString& drillString) {
    return std::ranges::all_of(allSections(drillString),
                               [](const Section* section) { return isUniform(*section); });
}

double areaAt(const Section& section, double share) {
    if (section.area && isUniform(section)) return *section.area;
    const Frustum cone = frustumOf(section);
    return ringArea(std::lerp(cone.rear, cone.end, share), cone.bore);
}

double outerDiameterAt(const Section& section, double share) {
    const Frustum cone = frustumOf(section);
    return std::lerp(cone.rear, cone.end, share);
}

double largestDiameter(const Section& section) {
    return std::max(outerDiameterAt(section, 0), outerDiameterAt(section, 1));
}

double meanArea(const Section& section, double from, double to) {
    if (isUniform(section)) return areaAt(section, from);
    const Frustum cone = frustumOf(section);
    const double first = std::lerp(cone.rear, cone.end, from), last = std::lerp(cone.rear, cone.end, to);
    // the mean square of what is linear
    const double meanSquare = (first * first + first * last + last * last) / 3;
    return std::numbers::pi / 4 * (meanSquare - cone.bore * cone.bore);
}

std::string_view endKey(const Section& section) {
    return section.area ? "end_area" : "end_diameter";
}

std::vector<ShapeProblem> shapeProblems(const Section& section) {
    std::vector<ShapeProblem> problems;
    if (section.area) return problems;
    if (section.bore >= section.diameter && section.diameter > 0)
        problems.push_back(
            {"bore",
             {translatable("must be less than the diameter of %1"), {millimetres(section.diameter)}}});
    if (section.endDiameter && *section.endDiameter <= section.bore)
        problems.push_back(
            {endKey(section),
             {translatable("must be larger than the bore of %1"), {millimetres(section.bore)}}});
    return problems;
}

std::string sizeText(const Section& section) {
    std::string text = millimetres(section.length) + " × ";
    if (section.area) {
        const Unit& unit = *findUnit(Quantity::area, "mm^2");
        text += formatQuantity(*section.area, Quantity::area, unit);
        return section.endArea ? text + " … " + formatQuantity(*section.endArea, Quantity::area, unit) : text;
    }
    text += millimetres(section.diameter);
    if (section.endDiameter) text += " … " + millimetres(*section.endDiameter);
    return section.bore > 0 ? text + " / " + millimetres(section.bore) : text;
}

std::vector<Section> uniformPieces(const Section& section, int count, bool behindLoss) {
    assert(count > 0);
    if (count == 1 && isUniform(section)) return {section};
    Section piece = section;
    piece.length = section.length / count;
    piece.endDiameter.reset();
    piece.endArea.reset();
    piece.massAfter = piece.loss = 0;
    std::vector<Section> pieces(static_cast<std::size_t>(count), piece);
    for (int i = 0; i < count; ++i)
        pieces[static_cast<std::size_t>(i)].area =
            meanArea(section, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    if (behindLoss && count >= fewestWithEndArea) {
        const double rear = areaAt(section, 0);
        *pieces[1].area += *pieces[0].area - rear;
        pieces[0].area = rear;
    }
    pieces.back().massAfter = section.massAfter;
    pieces.back().loss = section.loss;
    return pieces;
}

}  // namespace drillwave
