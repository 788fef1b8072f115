// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/units_choice.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QToolButton>

#include "ui/form/quantity_field.h"
#include "ui/text/shown_text.h"
#include "ui/text/typed_text.h"
#include "ui/text/unit_choice.h"

namespace drillwave {
namespace {

QString shortName(UnitSystem system) {
    switch (system) {
        case UnitSystem::dimensionless:
            return UnitsChoice::tr("dimensionless");
        case UnitSystem::us:
            return UnitsChoice::tr("US");
        case UnitSystem::si:
            break;
    }
    return UnitsChoice::tr("SI");
}

}  // namespace

UnitsChoice::UnitsChoice(UnitChoice& units, QWidget* window)
    : QMenu(tr("&Units"), window),
      m_units(units),
      m_systems(new QActionGroup(this)),
      m_button(new UnitButton(window)) {
    setToolTipsVisible(true);
    addSystem(UnitSystem::si, tr("&SI"), QKeySequence(Qt::CTRL | Qt::Key_I));
    addSystem(UnitSystem::us, tr("&US customary"), QKeySequence(Qt::CTRL | Qt::Key_U));
    addSystem(UnitSystem::dimensionless, tr("&Dimensionless"), QKeySequence(Qt::CTRL | Qt::Key_L));
    addSeparator();
    for (const UnitKindRow& row : unitKinds()) addKind(row);
    m_button->setObjectName(QStringLiteral("units"));
    m_button->setMenu(this);
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setToolTip(tr("Units of fields, results and plots"));
    connect(&m_units, &UnitChoice::changed, this, &UnitsChoice::chosen);
}

QAction* UnitsChoice::addSystem(UnitSystem system, const QString& text, const QKeySequence& keys) {
    QAction* action = m_systems->addAction(text);
    action->setShortcut(keys);
    action->setCheckable(true);
    action->setData(static_cast<int>(system));
    connect(action, &QAction::triggered, this, [this, system] { choose(system); });
    addAction(action);
    return action;
}

void UnitsChoice::addKind(const UnitKindRow& row) {
    QMenu* menu = addMenu(QCoreApplication::translate("UnitKind", row.label));
    auto* group = new QActionGroup(menu);
    const auto add = [&](const QString& text, const Unit* unit) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        action->setData(QVariant::fromValue(static_cast<const void*>(unit)));
        connect(action, &QAction::triggered, this,
                [this, kind = row.kind, unit] { m_units.choose(kind, unit); });
        menu->addAction(action);
    };
    add(tr("as in the system selected"), nullptr);
    menu->addSeparator();
    for (const Unit& unit : unitsOf(row.quantity)) add(shownUnitName(unit.name), &unit);
    m_kinds.append(group);
}

UnitSystem UnitsChoice::of(const Scenario& scenario) const {
    return naturalUnits(scenario) == UnitSystem::dimensionless ? UnitSystem::dimensionless : m_units.system();
}

void UnitsChoice::choose(UnitSystem units) {
    m_units.choose(units);
}

void UnitsChoice::present(const Scenario& scenario) {
    const bool physical = naturalUnits(scenario) != UnitSystem::dimensionless;
    const UnitSystem shown = of(scenario);
    for (QAction* action : m_systems->actions()) {
        const bool isDimensionless = action->data().toInt() == static_cast<int>(UnitSystem::dimensionless);
        action->setEnabled(physical || isDimensionless);
        action->setToolTip(action->isEnabled()
                               ? QString()
                               : tr("This scenario is dimensionless: it has no physical values."));
        action->setChecked(action->data().toInt() == static_cast<int>(shown));
    }
    const ChosenUnits& chosen = m_units.chosen();
    for (qsizetype i = 0; i < m_kinds.size(); ++i) {
        const auto own = chosen.find(unitKinds()[static_cast<std::size_t>(i)].kind);
        const void* unit = own == chosen.end() ? nullptr : own->second;
        for (QAction* action : m_kinds[i]->actions())
            action->setChecked(action->data().value<const void*>() == unit);
    }
    m_button->setText(shortName(shown));
    m_button->setAccessibleName(tr("Units: %1").arg(m_button->text()));
}

}  // namespace drillwave
