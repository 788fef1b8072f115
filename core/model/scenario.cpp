// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/scenario.h"

#include "core/text/enum_names.h"

namespace drillwave {

namespace {

constexpr EnumNames<PulseShape> shapeNames{{{PulseShape::rectangular, "rectangular"},
                                            {PulseShape::triangular, "triangular"},
                                            {PulseShape::halfSine, "half_sine"},
                                            {PulseShape::trapezoid, "trapezoid"},
                                            {PulseShape::exponential, "exponential"},
                                            {PulseShape::piston, "piston"},
                                            {PulseShape::table, "table"},
                                            {PulseShape::rigidBody, "rigid_body"}}};

constexpr EnumNames<RockIndexing> indexingNames{
    {{RockIndexing::fresh, "fresh"}, {RockIndexing::same, "same"}}};

constexpr EnumNames<RockLaw> lawNames{
    {{RockLaw::bilinear, "bilinear"}, {RockLaw::corners, "corners"}, {RockLaw::power, "power"}}};

constexpr EnumNames<RockLaw> lawPhrases{{{RockLaw::bilinear, "a law of one line"},
                                         {RockLaw::corners, "a law with corners"},
                                         {RockLaw::power, "a power law"}}};

}  // namespace

std::string_view name(PulseShape shape) {
    return shapeNames[shape];
}

std::optional<PulseShape> findPulseShape(std::string_view name) {
    return shapeNames.find(name);
}

std::span<const std::string_view> pulseShapeNames() {
    return shapeNames.all();
}

std::string_view name(RockLaw law) {
    return lawNames[law];
}

std::string_view phrase(RockLaw law) {
    return lawPhrases[law];
}

std::optional<RockLaw> findRockLaw(std::string_view name) {
    return lawNames.find(name);
}

std::span<const std::string_view> rockLawNames() {
    return lawNames.all();
}

std::string_view name(RockIndexing indexing) {
    return indexingNames[indexing];
}

std::optional<RockIndexing> findRockIndexing(std::string_view name) {
    return indexingNames.find(name);
}

std::span<const std::string_view> rockIndexingNames() {
    return indexingNames.all();
}

}  // namespace drillwave
