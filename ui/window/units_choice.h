// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of units: a system, and for each kind of value another unit; in View and at a button.
#pragma once

#include <QMenu>

#include "ui/text/shown_units.h"

class QActionGroup;
class QToolButton;

namespace drillwave {

class UnitChoice;

/// Sets the units of a document. The choice stays while a scenario has no physical units.
class UnitsChoice : public QMenu {
    Q_OBJECT

  public:
    /// The units must outlive the menu.
    UnitsChoice(UnitChoice& units, QWidget* window);

    /// Shows the system chosen, and opens the menu.
    QToolButton* button() const { return m_button; }
    /// The units of a scenario: those wanted, where it has them.
    UnitSystem of(const Scenario& scenario) const;
    void choose(UnitSystem units);
    /// Shows what can be chosen for a scenario, and what is.
    void present(const Scenario& scenario);

  signals:
    void chosen();

  private:
    QAction* addSystem(UnitSystem system, const QString& text, const QKeySequence& keys);
    void addKind(const UnitKindRow& row);

    UnitChoice& m_units;
    QActionGroup* m_systems;
    QList<QActionGroup*> m_kinds;  // as in unitKinds()
    QToolButton* m_button;
};

}  // namespace drillwave
