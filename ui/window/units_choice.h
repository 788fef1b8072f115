// SPDX-License-Identifier: GPL-3.0-or-later
// Menu of units: a system of units, and another unit for each kind of quantity. It is in the menu View and at
// a button.
#pragma once

#include <QMenu>

#include "ui/text/shown_units.h"

class QActionGroup;
class QToolButton;

namespace drillwave {

class UnitChoice;

/// Menu in which the user chooses the units of the window. A dimensionless scenario is always shown in
/// dimensionless units, but the choice is remembered for later scenarios.
class UnitsChoice : public QMenu {
    Q_OBJECT

  public:
    /// Creates the menu. `units`, which stores the choice of the user, must outlive it.
    UnitsChoice(UnitChoice& units, QWidget* window);

    /// Returns a button that shows the chosen system of units, such as "SI", and opens this menu.
    QToolButton* button() const { return m_button; }
    /// Returns the system of units for a scenario: the chosen one, or dimensionless if the scenario has no
    /// physical units.
    UnitSystem of(const Scenario& scenario) const;
    void choose(UnitSystem units);
    /// Enables the systems of units that a scenario permits (a dimensionless one only its own), and marks the
    /// chosen units.
    void present(const Scenario& scenario);

  signals:
    void chosen();

  private:
    QAction* addSystem(UnitSystem system, const QString& text, const QKeySequence& keys);
    void addKind(const UnitKindRow& row);

    UnitChoice& m_units;
    QActionGroup* m_systems;
    QList<QActionGroup*> m_kinds;  // actions for the units of each kind, in the order of unitKinds()
    QToolButton* m_button;
};

}  // namespace drillwave
