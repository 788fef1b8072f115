// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/model/string_ranges.h"
#include "core/model/usual_ranges.h"

namespace drillwave {
namespace {

using Value = std::optional<double>;
using With = SectionField::With;
using enum SliderScale;
namespace ranges = string_ranges;

Value diameter(const Section& s) {
    return s.area ? std::nullopt : Value(s.diameter);
}
void assignDiameter(Section& s, double value) {
    s.area.reset();
    s.endArea.reset();
    s.diameter = value;
}

// clang-format off
constexpr std::array fieldTable{
    SectionField{"length", "length", "L", "Length of the section",
                 Quantity::length, "mm", ranges::length, {0.01, 10}, logarithmic, Presence::required,
                 [](const Section& s) { return Value(s.length); }, [](Section& s, double v) { s.length = v; }},
    SectionField{"diameter", "diameter", "", "Outer diameter of the section",
                 Quantity::length, "mm", ranges::diameter, {0.015, 0.25}, linear, Presence::either, diameter, assignDiameter},
    SectionField{"area", "area", "A", "Cross-section, in place of diameter and bore",
                 Quantity::area, "mm^2", ranges::area, {1e-4, 5e-2}, logarithmic, Presence::optional,
                 [](const Section& s) { return s.area; }, [](Section& s, double v) { s.area = v; },
                 [](Section& s) { s.area.reset(); s.endArea.reset(); }},
    SectionField{"bore", "bore", "", "Diameter of the flushing hole, less than the outer diameter",
                 Quantity::length, "mm", ranges::bore, {0, 0.1}, linear, Presence::unusual,
                 [](const Section& s) { return s.area ? std::nullopt : Value(s.bore); }, [](Section& s, double v) { s.bore = v; },
                 nullptr, With::diameter},
    SectionField{"end_diameter", "end diameter", "", "Outer diameter at the end towards the rock of a cone, whose `diameter` is that of its rear end; the bore is constant",
                 Quantity::length, "mm", ranges::diameter, {0.015, 0.25}, linear, Presence::optional,
                 [](const Section& s) { return s.area ? std::nullopt : s.endDiameter; }, [](Section& s, double v) { s.endDiameter = v; },
                 [](Section& s) { s.endDiameter.reset(); }, With::diameter},
    SectionField{"end_area", "end area", "", "Cross-section at the end towards the rock of a cone, whose `area` is that of its rear end",
                 Quantity::area, "mm^2", ranges::area, {1e-4, 5e-2}, logarithmic, Presence::optional,
                 [](const Section& s) { return s.area ? s.endArea : std::nullopt; }, [](Section& s, double v) { s.endArea = v; },
                 [](Section& s) { s.endArea.reset(); }, With::area},
    SectionField{"youngs_modulus", "Young's modulus", "E", "Young's modulus, that of the material if not given",
                 Quantity::stress, "GPa", ranges::modulus, usual_ranges::modulus, linear, Presence::optional,
                 [](const Section& s) { return s.youngsModulus; }, [](Section& s, double v) { s.youngsModulus = v; },
                 [](Section& s) { s.youngsModulus.reset(); }},
    SectionField{"density", "density", "ρ", "Density, that of the material if not given",
                 Quantity::density, "kg/m^3", ranges::density, usual_ranges::density, linear, Presence::optional,
                 [](const Section& s) { return s.density; }, [](Section& s, double v) { s.density = v; },
                 [](Section& s) { s.density.reset(); }},
    SectionField{"mass_after", "attached mass", "M", "Mass lumped at the end towards the rock; of the last section of a string a mass of the bit",
                 Quantity::mass, "kg", ranges::mass, {0, 50}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.massAfter); }, [](Section& s, double v) { s.massAfter = v; }},
    SectionField{"loss", "loss", "η", "Share of the energy of a wave that is lost in the joint at the end towards the rock: 3 to 6 % tight, 6 to 10 % worn (trade texts, from memory)",
                 Quantity::share, "%", ranges::share, {0, 0.3}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.loss); }, [](Section& s, double v) { s.loss = v; }},
    SectionField{"attenuation", "attenuation", "α", "Decay of the amplitude of a wave per length",
                 Quantity::attenuation, "1/m", ranges::attenuation, {0, 0.1}, linear, Presence::unusual,
                 [](const Section& s) { return Value(s.attenuation); }, [](Section& s, double v) { s.attenuation = v; }},
    SectionField{"yield_strength", "yield strength", "", "Stress up to which the section is elastic; a blow that exceeds it raises a warning",
                 Quantity::stress, "MPa", ranges::strength, usual_ranges::yieldStrength, linear, Presence::optional,
                 [](const Section& s) { return s.yieldStrength; }, [](Section& s, double v) { s.yieldStrength = v; },
                 [](Section& s) { s.yieldStrength.reset(); }},
    SectionField{"fatigue_strength", "fatigue strength", "", "Tensile stress that the section bears in blow after blow; more raises a warning",
                 Quantity::stress, "MPa", ranges::strength, usual_ranges::fatigueStrength, linear, Presence::optional,
                 [](const Section& s) { return s.fatigueStrength; }, [](Section& s, double v) { s.fatigueStrength = v; },
                 [](Section& s) { s.fatigueStrength.reset(); }},
};
// clang-format on

}  // namespace

const Unit& SectionField::displayUnit() const {
    const Unit* found = findUnit(quantity, unit);
    assert(found);
    return *found;
}

std::span<const SectionField> sectionFields() {
    return fieldTable;
}

const SectionField* findSectionField(std::string_view key) {
    const auto found = std::ranges::find(fieldTable, key, &SectionField::key);
    return found == fieldTable.end() ? nullptr : &*found;
}

bool areRivals(const SectionField& a, const SectionField& b) {
    const auto isOf = [](const SectionField& field, With with, std::string_view start) {
        return field.with == with || field.key == start;
    };
    const auto replaces = [&](const SectionField& one, const SectionField& other) {
        return isOf(one, With::area, "area") && isOf(other, With::diameter, "diameter");
    };
    return &a == &b || replaces(a, b) || replaces(b, a);
}

Message rangeProblem(const SectionField& field, double value) {
    return field.hard.problem(value, unitsOf(field.quantity).front());
}

}  // namespace drillwave
