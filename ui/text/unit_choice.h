// SPDX-License-Identifier: GPL-3.0-or-later
// The units that the user wants everywhere: a system, single kinds in other units, single fields in others
// again; kept over the end of the program.
#pragma once

#include <QObject>
#include <QString>

#include "ui/text/unit_kind.h"

namespace drillwave {

/// One for each document: all its fields and results follow it, those of others do not.
class UnitChoice : public QObject {
    Q_OBJECT

  public:
    /// Begins with what was kept last.
    UnitChoice();

    /// The units of results and plots.
    UnitSystem system() const { return m_system; }
    /// SI or US: of fields, whose values always are physical, also while results are dimensionless.
    UnitSystem physicalSystem() const { return m_physical; }
    /// The units of kinds that do not follow the system.
    const ChosenUnits& chosen() const { return m_chosen; }
    /// Returns the unit of the field of a parameter.
    const Unit& fieldUnit(const Parameter& parameter) const;
    /// Returns the unit chosen for a kind, or the one in which values of that size (SI) are best read.
    const Unit& unitFor(UnitKind kind, double size) const;
    /// A value (SI) in the unit for its own size: "200 µs", "57.3 kip".
    QString text(double si, UnitKind kind, int digits = 3) const;
    /// Formats a bound ≥ 0, never smaller than it is.
    QString boundText(double si, UnitKind kind) const;

    /// Sets the system of all kinds without a unit of their own, also of fields with one.
    void choose(UnitSystem system);
    /// Sets the unit of a kind, also of fields with a unit of their own. nullptr: that of the system.
    void choose(UnitKind kind, const Unit* unit);
    /// Sets the unit of one field, in every scenario, without changed().
    void chooseForField(const Parameter& parameter, const Unit& unit);

  signals:
    void changed();

  private:
    UnitSystem m_system;
    UnitSystem m_physical;
    ChosenUnits m_chosen;
    std::map<std::string, const Unit*, std::less<>> m_ofFields;  // by key of the parameter
};

}  // namespace drillwave
