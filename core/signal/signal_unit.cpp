// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/signal_unit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text/units.h"

namespace drillwave {
namespace {

constexpr std::array strainUnits{SignalUnit{"microstrain", 1e-6}, SignalUnit{"m/m", 1},
                                 SignalUnit{"mm/m", 1e-3}, SignalUnit{"%", 1e-2}};
constexpr std::array bridgeUnits{SignalUnit{"mV/V", 1e-3}, SignalUnit{"V/V", 1}, SignalUnit{"uV/V", 1e-6}};

/// Other spellings of strains and bridges.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> unitSpellings{{
    {"ustrain", "microstrain"},
    {"um/m", "microstrain"},
    {"µm/m", "microstrain"},
    {"μm/m", "microstrain"},
    {"µε", "microstrain"},
    {"με", "microstrain"},
    {"ue", "microstrain"},
    {"uε", "microstrain"},
    {"µstrain", "microstrain"},
    {"µS", "microstrain"},
    {"uS", "microstrain"},
    {"1e-6", "microstrain"},
    {"Microstrain", "microstrain"},
    {"strain", "m/m"},
    {"ε", "m/m"},
    {"mstrain", "mm/m"},
    {"µV/V", "uV/V"},
    {"μV/V", "uV/V"},
}};

}  // namespace

std::vector<SignalUnit> signalUnits(SignalKind kind) {
    if (kind == SignalKind::strain) return {strainUnits.begin(), strainUnits.end()};
    if (kind == SignalKind::bridge) return {bridgeUnits.begin(), bridgeUnits.end()};
    std::vector<SignalUnit> units;
    for (const Unit& unit : unitsOf(Quantity::force)) units.push_back({unit.name, unit.factor()});
    return units;
}

std::optional<NamedSignalUnit> findSignalUnit(std::string_view name) {
    if (const Unit* unit = findUnit(Quantity::force, name))
        return NamedSignalUnit{SignalKind::force, {unit->name, unit->factor()}};
    const auto spelling = std::ranges::find(unitSpellings, name, &decltype(unitSpellings)::value_type::first);
    if (spelling != unitSpellings.end()) name = spelling->second;
    for (const SignalUnit& unit : strainUnits)
        if (unit.name == name) return NamedSignalUnit{SignalKind::strain, unit};
    for (const SignalUnit& unit : bridgeUnits)
        if (unit.name == name) return NamedSignalUnit{SignalKind::bridge, unit};
    return std::nullopt;
}

double forcePerNumber(SignalKind kind, double unitFactor, const GaugedBar& bar) {
    switch (kind) {
        case SignalKind::force:
            return unitFactor;
        case SignalKind::strain:
            return bar.axialStiffness * unitFactor;
        case SignalKind::bridge:
            return bar.axialStiffness * unitFactor * 4 / (bar.gaugeFactor * bar.activeGauges);
    }
    return unitFactor;
}

}  // namespace drillwave
