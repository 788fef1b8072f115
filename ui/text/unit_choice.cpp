// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/unit_choice.h"

#include <QLocale>
#include <cmath>

#include "core/text/handy_text.h"
#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/shown_text.h"
#include "ui/text/shown_units.h"

namespace drillwave {
namespace {

const QString systemKey = QStringLiteral("window/units");
const QString physicalKey = QStringLiteral("window/physicalUnits");

QString nameOf(UnitSystem system) {
    switch (system) {
        case UnitSystem::dimensionless:
            return QStringLiteral("dimensionless");
        case UnitSystem::us:
            return QStringLiteral("us");
        case UnitSystem::si:
            break;
    }
    return QStringLiteral("si");
}

// SI where the settings have no such name.
UnitSystem keptSystem(const QString& key) {
    const QString kept = Settings().value(key).toString();
    for (const UnitSystem system : {UnitSystem::dimensionless, UnitSystem::us})
        if (kept == nameOf(system)) return system;
    return UnitSystem::si;
}

QString keyOf(const UnitKindRow& row) {
    return QStringLiteral("unitKinds/") + QLatin1String(row.name);
}

QString keyOf(std::string_view parameter) {
    return QStringLiteral("units/") + fromView(parameter);
}

const Unit* keptUnit(Quantity quantity, const QString& key) {
    const std::string name = Settings().value(key).toString().toStdString();
    return name.empty() ? nullptr : findUnit(quantity, name);
}

}  // namespace

UnitChoice::UnitChoice()
    : m_system(keptSystem(systemKey)),
      m_physical(keptSystem(physicalKey) == UnitSystem::us ? UnitSystem::us : UnitSystem::si) {
    for (const UnitKindRow& row : unitKinds())
        if (const Unit* unit = keptUnit(row.quantity, keyOf(row))) m_chosen[row.kind] = unit;
    for (const Parameter& parameter : parameters())
        if (const Unit* unit = keptUnit(parameter.quantity, keyOf(parameter.key)))
            m_ofFields[std::string(parameter.key)] = unit;
}

const Unit& UnitChoice::fieldUnit(const Parameter& parameter) const {
    const auto own = m_ofFields.find(parameter.key);
    // in a dimensionless scenario the same key may be a ratio
    if (own != m_ofFields.end() && findUnit(parameter.quantity, own->second->name)) return *own->second;
    if (const std::optional<UnitKind> kind = kindOf(parameter)) {
        const auto chosen = m_chosen.find(*kind);
        if (chosen != m_chosen.end()) return *chosen->second;
    }
    return customaryUnit(parameter, m_physical);
}

const Unit& UnitChoice::unitFor(UnitKind kind, double size) const {
    const auto own = m_chosen.find(kind);
    return own != m_chosen.end() ? *own->second : handyUnit(kind, size, m_physical);
}

QString UnitChoice::text(double si, UnitKind kind, int digits) const {
    const ShownUnit unit = shownUnit(unitFor(kind, std::abs(si)));
    return numberText(si * unit.factor, digits, QLocale()) + QChar(QChar::Nbsp) + unit.unit;
}

QString UnitChoice::boundText(double si, UnitKind kind) const {
    constexpr int digits = 3;
    const ShownUnit unit = shownUnit(unitFor(kind, si));
    return numberText(roundedTo(si * unit.factor, digits, Rounding::up), digits, QLocale()) +
           QChar(QChar::Nbsp) + unit.unit;
}

void UnitChoice::choose(UnitSystem system) {
    Settings settings;
    m_system = system;
    settings.setValue(systemKey, nameOf(system));
    if (system != UnitSystem::dimensionless) {
        m_physical = system;
        settings.setValue(physicalKey, nameOf(system));
        for (const auto& [key, unit] : std::exchange(m_ofFields, {})) settings.remove(keyOf(key));
    }
    emit changed();
}

void UnitChoice::choose(UnitKind kind, const Unit* unit) {
    Settings settings;
    if (unit) {
        m_chosen[kind] = unit;
        settings.setValue(keyOf(rowOf(kind)), fromView(unit->name));
    } else {
        m_chosen.erase(kind);
        settings.remove(keyOf(rowOf(kind)));
    }
    for (const Parameter& parameter : parameters())
        if (const auto own = m_ofFields.find(parameter.key);
            own != m_ofFields.end() && kindOf(parameter) == kind) {
            m_ofFields.erase(own);
            settings.remove(keyOf(parameter.key));
        }
    emit changed();
}

void UnitChoice::chooseForField(const Parameter& parameter, const Unit& unit) {
    m_ofFields[std::string(parameter.key)] = &unit;
    Settings().setValue(keyOf(parameter.key), fromView(unit.name));
}

}  // namespace drillwave
