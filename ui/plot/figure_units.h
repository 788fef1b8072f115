// SPDX-License-Identifier: GPL-3.0-or-later
// Units in which figures are shown.
#pragma once

#include <functional>

#include "core/report/figure.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Units in which one user reads figures. `units` is for multiples of the blow's scales and for SI values;
/// `unitFor` is for parameters.
struct FigureUnits {
    ShownUnits units;
    std::function<const Unit&(const Parameter&)> unitFor;

    /// Returns the unit of a quantity: shown value = value of the figure · factor.
    ShownUnit of(const FigureQuantity& quantity) const;
};

}  // namespace drillwave
