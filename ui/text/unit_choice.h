// SPDX-License-Identifier: GPL-3.0-or-later
// The units that the user wants everywhere: a system, single kinds in other units, single fields in others
// again; kept over the end of the program.
#pragma once

#include <QObject>
#include <QString>

#include "ui/text/unit_kind.h"

namespace drillwave {

/// One for each document: its fields and results follow it wherever they are, those of others do not.
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
    /// In which the field of a parameter shows it.
    const Unit& fieldUnit(const Parameter& parameter) const;
    /// In which values of that size (SI) are best read, or the one chosen for their kind.
    const Unit& unitFor(UnitKind kind, double size) const;
    /// A value (SI) in the unit for its own size: "200 µs", "57.3 kip".
    QString text(double si, UnitKind kind, int digits = 3) const;
    /// The same of a bound ≥ 0, never smaller than it is.
    QString boundText(double si, UnitKind kind) const;

    /// All that is not chosen by kind follows, fields with a unit of their own too.
    void choose(UnitSystem system);
    /// All of that kind follow, fields with a unit of their own too. nullptr: as the system has it.
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
