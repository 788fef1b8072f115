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

/// Menu that sets the units of a document. The choice is kept while a scenario has no physical units.
class UnitsChoice : public QMenu {
    Q_OBJECT

  public:
    /// Makes the menu. `units` must outlive it.
    UnitsChoice(UnitChoice& units, QWidget* window);

    /// Returns the button that shows the chosen system and opens the menu.
    QToolButton* button() const { return m_button; }
    /// Returns the system of units for a scenario: the chosen one, or dimensionless if the scenario has no
    /// physical units.
    UnitSystem of(const Scenario& scenario) const;
    void choose(UnitSystem units);
    /// Enables the systems that a scenario permits, and marks the chosen units.
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
