// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensionless or SI: chosen in the menu or in the status bar, kept over the end of the program.
#pragma once

#include <QObject>

#include "ui/text/shown_units.h"

class QAction;
class QActionGroup;
class QMenu;
class QRadioButton;
class QStatusBar;
class QWidget;

namespace drillwave {

/// What is wanted stays while a scenario has no SI.
class UnitsChoice : public QObject {
    Q_OBJECT

  public:
    /// Begins with what was kept.
    explicit UnitsChoice(QWidget* window);

    void addTo(QMenu& menu);
    void addTo(QStatusBar& bar);
    /// The units of a scenario: those wanted, where it has them.
    UnitSystem of(const Scenario& scenario) const;
    void choose(UnitSystem units);
    /// Shows what can be chosen for a scenario, and what is.
    void present(const Scenario& scenario);
    void save() const;

  signals:
    void chosen();

  private:
    struct Control {
        QAction* action;
        QRadioButton* button;
    };
    Control addControl(UnitSystem units, const QString& menuText, const QKeySequence& keys,
                       const QString& buttonText, const QString& buttonName);

    QActionGroup* m_actions;
    Control m_dimensionless;
    Control m_si;
    UnitSystem m_wanted = UnitSystem::si;
};

}  // namespace drillwave
