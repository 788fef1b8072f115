// SPDX-License-Identifier: GPL-3.0-or-later
// Units in which results are shown: dimensionless, or physical units with a suitable prefix.
#pragma once

#include <QString>
#include <optional>

#include "core/model/scales.h"
#include "core/model/scenario.h"
#include "ui/text/unit_kind.h"

namespace drillwave {

/// Returns SI for a scenario in physical units, else dimensionless.
UnitSystem naturalUnits(const Scenario& scenario);

/// Unit of one quantity as shown: shown value = dimensionless value · factor, followed by `unit`.
struct ShownUnit {
    double factor = 1;
    QString unit;                ///< name of the unit, "kN" or "t₀"
    bool dimensionless = false;  ///< true if `unit` is a scale of the blow, such as t₀
    /// Data for choosing another prefix when a single value is shown, such as N instead of kN: kind, system
    /// and unit. Empty if the user has chosen the unit.
    struct Prefixes {
        UnitKind kind;
        UnitSystem system;
        const Unit* unit;
        bool operator==(const Prefixes&) const = default;
    };
    std::optional<Prefixes> prefixes = {};
    bool operator==(const ShownUnit&) const = default;

    /// Returns the label of an axis, made of `words` and the unit: "time t [ms]" or "time t / t₀". It is only
    /// `words` if there is no unit.
    QString axisLabel(const QString& words) const;
};

/// Returns a unit with the factor that converts from SI: shown value = SI value · factor.
ShownUnit shownUnit(const Unit& unit);

/// Returns the unit with the prefix that suits `value`, which is not yet multiplied by the factor: 36.06 N
/// instead of 0.03606 kN. If the shown value is 0.1 to below 10⁴, it returns `unit`.
ShownUnit readable(const ShownUnit& unit, double value);

/// Units of all values that are plotted or listed for one blow.
struct ShownUnits {
    ShownUnit time;
    ShownUnit force;
    ShownUnit impulse;      ///< unit of impulses and momenta, for multiples of I0
    ShownUnit penetration;  ///< unit of displacements, for multiples of d0 (in Impact: of d0/2)
    ShownUnit stiffness;    ///< unit of stiffnesses, for multiples of k0, as β is
    ShownUnit energy;  ///< unit of energies, for multiples of W0; energies of Impact are multiples of 2τ W0
    ShownUnit stress;  ///< unit of stresses, for multiples of F0/A; if dimensionless, that of forces
    ShownUnit length;  ///< unit of positions in the rod, for multiples of L
    ShownUnit velocity;  ///< unit of the velocity of a whole hammer or rod, for multiples of v0
    UnitSystem system = UnitSystem::dimensionless;
    ChosenUnits chosen = {};
    bool operator==(const ShownUnits&) const = default;

    /// Returns the unit for a quantity without a dimensionless form, such as a feed force. Its values are in
    /// SI; `size` is their typical magnitude, which decides the prefix.
    ShownUnit of(UnitKind kind, double size) const;
};

/// Returns the units in which the results of a blow are shown. Prefixes depend on the scales, not on the
/// results, so that they do not change while a value is dragged. `chosen` are units for single kinds, which
/// override `units`.
ShownUnits shownUnits(UnitSystem units, const Scales& scales, const ChosenUnits& chosen = {});

}  // namespace drillwave
