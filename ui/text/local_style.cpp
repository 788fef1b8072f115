// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/local_style.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

// What a sentence tells is of one quantity; people measure a rod and what the bit does in other units.
std::optional<UnitKind> kindOf(double si, Quantity quantity) {
    constexpr double leastOfRods = 0.3;   // [m]
    constexpr double leastModulus = 5e9;  // [Pa]
    switch (quantity) {
        case Quantity::length:
            return std::abs(si) < leastOfRods ? UnitKind::penetration : UnitKind::length;
        case Quantity::stress:
            return std::abs(si) < leastModulus ? UnitKind::stress : UnitKind::modulus;
        default:
            break;
    }
    const auto found = std::ranges::find(unitKinds(), quantity, &UnitKindRow::quantity);
    return found == unitKinds().end() ? std::nullopt : std::optional(found->kind);
}

}  // namespace

LocalStyle::LocalStyle(const QLocale& locale, UnitSystem system, ChosenUnits chosen)
    : m_locale(locale), m_system(system), m_chosen(std::move(chosen)) {}

LocalStyle LocalStyle::of(const UnitChoice& units) {
    return {QLocale(), units.physicalSystem(), units.chosen()};
}

std::string LocalStyle::number(double value, int digits) const {
    return numberText(value, digits, m_locale).toStdString();
}

ReadUnit LocalStyle::unitFor(double si, Quantity quantity) const {
    return unitOf(kindOf(si, quantity), si, quantity);
}

ReadUnit LocalStyle::rateUnit(double si) const {
    ReadUnit read = unitOf(UnitKind::rate, si, Quantity::velocity);
    if (m_chosen.contains(UnitKind::rate) || m_system == UnitSystem::us) return read;
    read.unit = &handyUnit(UnitKind::rate, std::abs(si), UnitSystem::si);
    read.name = shownUnitName(read.unit->name).toStdString();
    return read;
}

ReadUnit LocalStyle::unitOf(std::optional<UnitKind> kind, double si, Quantity quantity) const {
    ReadUnit read = ReadingStyle::unitFor(si, quantity);
    if (kind) {
        const auto own = m_chosen.find(*kind);
        if (own != m_chosen.end())
            read.unit = own->second;
        else if (m_system == UnitSystem::us)
            read.unit = &handyUnit(*kind, std::abs(si), m_system);
    }
    read.name = shownUnitName(read.unit->name).toStdString();
    return read;
}

Message LocalStyle::unitsTitle() const {
    if (!m_chosen.empty()) return translatable("with its unit");
    if (m_system == UnitSystem::us) return translatable("in US units");
    return ReadingStyle::unitsTitle();
}

std::string LocalStyle::patternFor(const std::string& english) const {
    return translatedPattern(english);
}

std::string LocalStyle::language() const {
    return std::string(spokenLanguage().code);
}

}  // namespace drillwave
