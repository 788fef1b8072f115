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
    /// Reads the units that the user chose in the last session.
    UnitChoice();

    /// Returns the system of units for results and plots.
    UnitSystem system() const { return m_system; }
    /// Returns the system of units for input fields, SI or US; fields show physical values even if results
    /// are dimensionless.
    UnitSystem physicalSystem() const { return m_physical; }
    /// Returns the units that the user has chosen for single kinds of quantity; they override the system of
    /// units.
    const ChosenUnits& chosen() const { return m_chosen; }
    /// Returns the unit in which the input field of a parameter shows its value.
    const Unit& fieldUnit(const Parameter& parameter) const;
    /// Returns the unit chosen for a kind, or else the unit in which a value of magnitude `size` (SI) is best
    /// read.
    const Unit& unitFor(UnitKind kind, double size) const;
    /// Returns a value, given in SI, in the unit that suits it: "200 µs", "57.3 kip".
    QString text(double si, UnitKind kind, int digits = 3) const;
    /// Returns an upper limit ≥ 0, given in SI, as text with its unit. It is rounded up, so that it remains
    /// an upper limit.
    QString boundText(double si, UnitKind kind) const;

    /// Sets the system of units (SI, US or dimensionless) for all kinds of quantity without a unit chosen by
    /// the user. SI and US also reset the units chosen for single input fields.
    void choose(UnitSystem system);
    /// Sets the unit of a kind, and resets the units of single fields of this kind. nullptr restores the unit
    /// of the system.
    void choose(UnitKind kind, const Unit* unit);
    /// Sets the unit of the input field of one parameter, also for other scenarios. Emits no changed().
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
