// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/units_choice.h"

#include <QActionGroup>
#include <QKeySequence>
#include <QMenu>
#include <QRadioButton>
#include <QStatusBar>

#include "ui/text/settings.h"

namespace drillwave {
namespace {

const QString unitsKey = QStringLiteral("window/units");
const QString siName = QStringLiteral("si");
const QString dimensionlessName = QStringLiteral("dimensionless");

}  // namespace

UnitsChoice::UnitsChoice(QWidget* window)
    : QObject(window),
      m_actions(new QActionGroup(this)),
      m_dimensionless(addControl(UnitSystem::dimensionless, tr("&Dimensionless"),
                                 QKeySequence(Qt::CTRL | Qt::Key_D), tr("dimensionless"),
                                 tr("Show results dimensionless"))),
      m_si(addControl(UnitSystem::si, tr("&SI units"), QKeySequence(Qt::CTRL | Qt::Key_I), tr("SI"),
                      tr("Show results in SI units"))) {
    if (Settings().value(unitsKey).toString() == dimensionlessName) m_wanted = UnitSystem::dimensionless;
}

UnitsChoice::Control UnitsChoice::addControl(UnitSystem units, const QString& menuText,
                                             const QKeySequence& keys, const QString& buttonText,
                                             const QString& buttonName) {
    QAction* action = m_actions->addAction(menuText);
    action->setShortcut(keys);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, units] { choose(units); });
    auto* button = new QRadioButton(buttonText, static_cast<QWidget*>(parent()));
    button->setAccessibleName(buttonName);
    connect(button, &QRadioButton::clicked, this, [this, units] { choose(units); });
    return {action, button};
}

void UnitsChoice::addTo(QMenu& menu) {
    menu.addActions(m_actions->actions());
}

void UnitsChoice::addTo(QStatusBar& bar) {
    for (QRadioButton* button : {m_dimensionless.button, m_si.button}) bar.addPermanentWidget(button);
}

UnitSystem UnitsChoice::of(const Scenario& scenario) const {
    return naturalUnits(scenario) == UnitSystem::si ? m_wanted : UnitSystem::dimensionless;
}

void UnitsChoice::choose(UnitSystem units) {
    m_wanted = units;
    emit chosen();
}

void UnitsChoice::present(const Scenario& scenario) {
    const bool hasSi = naturalUnits(scenario) == UnitSystem::si;
    m_si.button->setEnabled(hasSi);
    m_si.action->setEnabled(hasSi);
    m_si.button->setToolTip(hasSi ? QString() : tr("This scenario is dimensionless: it has no SI values."));
    const Control& control = of(scenario) == UnitSystem::si ? m_si : m_dimensionless;
    control.button->setChecked(true);
    control.action->setChecked(true);
}

void UnitsChoice::save() const {
    Settings().setValue(unitsKey, m_wanted == UnitSystem::si ? siName : dimensionlessName);
}

}  // namespace drillwave
