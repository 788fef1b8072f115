// SPDX-License-Identifier: GPL-3.0-or-later
// The units in which results are shown: dimensionless, or physical ones of a handy size.
#pragma once

#include <QString>
#include <optional>

#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "ui/text/unit_kind.h"

namespace drillwave {

/// SI where a scenario has physical quantities, dimensionless otherwise.
UnitSystem naturalUnits(const Scenario& scenario);

/// One quantity as shown: shown value = dimensionless value · factor, followed by `unit`.
struct ShownUnit {
    double factor = 1;
    QString unit;                ///< "kN" or "t₀"
    bool dimensionless = false;  ///< whether `unit` is a characteristic quantity of the blow
    /// The unit itself, and the kind and system whose prefixes may take its place where one value is read;
    /// none where the user has chosen the unit.
    struct Prefixes {
        UnitKind kind;
        UnitSystem system;
        const Unit* unit;
        bool operator==(const Prefixes&) const = default;
    };
    std::optional<Prefixes> prefixes = {};
    bool operator==(const ShownUnit&) const = default;

    /// "time t [ms]" or "time t / t₀"; the words alone without a unit.
    QString axisLabel(const QString& words) const;
};

/// Returns the unit for values in SI: shown value = SI value · factor.
ShownUnit shownUnit(const Unit& unit);

/// Returns the unit of the same quantity in which a value (before the factor) is best read: 36.06 N instead
/// of the 0.03606 kN of the plots. A value with one to four digits before the point in `unit` stays in it.
ShownUnit readable(const ShownUnit& unit, double value);

/// The units of all that is plotted or listed for one blow.
struct ShownUnits {
    ShownUnit time;
    ShownUnit force;
    ShownUnit impulse;      ///< of impulses and momenta
    ShownUnit penetration;  ///< displacements in d0, twice the displacement unit of Impact
    ShownUnit stiffness;    ///< in k0, as β is
    ShownUnit energy;       ///< in W0; that of Impact is 2τ W0
    ShownUnit stress;       ///< in F0/A; of forces where all is dimensionless
    ShownUnit length;       ///< places in the rod, in L
    ShownUnit velocity;     ///< of hammer or rod as a whole, in v0
    UnitSystem system = UnitSystem::dimensionless;
    ChosenUnits chosen = {};
    bool operator==(const ShownUnits&) const = default;

    /// Returns the unit for values in SI about as large as `size` without a dimensionless number (thrusts).
    ShownUnit of(UnitKind kind, double size) const;
};

/// Prefixes follow the scales (not the results), so that they do not flicker while a value is dragged.
/// `chosen` are the units of kinds that do not follow the system.
ShownUnits shownUnits(UnitSystem units, const Scales& scales, const ChosenUnits& chosen = {});

}  // namespace drillwave
