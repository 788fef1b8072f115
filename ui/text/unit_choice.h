// SPDX-License-Identifier: GPL-3.0-or-later
// Units chosen by the user: a system, other units for single kinds of quantity, and others again for single
// fields. They are stored for later sessions.
#pragma once

#include <QObject>
#include <QString>

#include "ui/text/unit_kind.h"

namespace drillwave {

/// Chosen units of one document, which apply to all its fields and results.
class UnitChoice : public QObject {
    Q_OBJECT

  public:
    /// Reads the units stored last.
    UnitChoice();

    /// Returns the system of units for results and plots.
    UnitSystem system() const { return m_system; }
    /// Returns the system of units for input fields, SI or US; fields show physical values even if results
    /// are dimensionless.
    UnitSystem physicalSystem() const { return m_physical; }
    /// Returns the units of the kinds that have one of their own, which overrides the system.
    const ChosenUnits& chosen() const { return m_chosen; }
    /// Returns the unit in which the input field of a parameter shows its value.
    const Unit& fieldUnit(const Parameter& parameter) const;
    /// Returns the unit chosen for a kind, or else the unit in which a value of magnitude `size` (SI) is best
    /// read.
    const Unit& unitFor(UnitKind kind, double size) const;
    /// Returns a value, given in SI, in the unit that suits it: "200 µs", "57.3 kip".
    QString text(double si, UnitKind kind, int digits = 3) const;
    /// Returns a bound ≥ 0, given in SI, with its unit, rounded up.
    QString boundText(double si, UnitKind kind) const;

    /// Sets the system of units for all kinds that have no unit of their own. Physical systems also reset the
    /// units of single fields.
    void choose(UnitSystem system);
    /// Sets the unit of a kind, and resets the units of single fields of this kind. nullptr restores the unit
    /// of the system.
    void choose(UnitKind kind, const Unit* unit);
    /// Sets the unit of one parameter's field in every scenario, without emitting changed().
    void chooseForField(const Parameter& parameter, const Unit& unit);

  signals:
    void changed();

  private:
    UnitSystem m_system;
    UnitSystem m_physical;
    ChosenUnits m_chosen;
    // Unit chosen for a single field, by the parameter's key.
    std::map<std::string, const Unit*, std::less<>> m_ofFields;
};

}  // namespace drillwave
