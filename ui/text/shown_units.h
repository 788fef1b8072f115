// SPDX-License-Identifier: GPL-3.0-or-later
// The units in which results are shown: dimensionless, or SI units of a handy size.
#pragma once

#include <QString>

#include "core/model/scales.h"
#include "core/model/scenario.h"

namespace drillwave {

enum class UnitSystem { dimensionless, si };

/// SI where a scenario has physical quantities, dimensionless otherwise.
UnitSystem naturalUnits(const Scenario& scenario);

/// One quantity as shown: shown value = dimensionless value · factor, followed by `unit`.
struct ShownUnit {
    double factor = 1;
    QString unit;                ///< "kN" or "t₀"
    bool dimensionless = false;  ///< whether `unit` is a characteristic quantity of the blow
    bool operator==(const ShownUnit&) const = default;

    /// "time t [ms]" or "time t / t₀".
    QString axisLabel(const QString& words) const;
};

/// The units of all that is plotted or listed for one blow.
struct ShownUnits {
    ShownUnit time;
    ShownUnit force;
    ShownUnit impulse;      ///< of impulses and momenta
    ShownUnit penetration;  ///< displacements in d0, twice the displacement unit of Impact
    ShownUnit stiffness;    ///< in k0, as β is
    ShownUnit energy;       ///< in W0; that of Impact is 2τ W0
    bool operator==(const ShownUnits&) const = default;
};

/// Prefixes follow the scales (not the results), so that they do not flicker while a value is dragged.
ShownUnits shownUnits(UnitSystem units, const Scales& scales);

}  // namespace drillwave
