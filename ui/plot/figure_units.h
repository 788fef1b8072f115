// SPDX-License-Identifier: GPL-3.0-or-later
// Units in which figures are shown.
#pragma once

#include <functional>

#include "core/report/figure.h"
#include "ui/text/shown_units.h"

namespace drillwave {

/// Units in which figures are shown to the user. `units` applies to multiples of the scales of the blow, such
/// as t0, and to SI values. `unitFor` returns the unit of a parameter.
struct FigureUnits {
    ShownUnits units;
    std::function<const Unit&(const Parameter&)> unitFor;

    /// Returns the unit in which a quantity of a figure is shown: shown value = value of the figure · factor.
    ShownUnit of(const FigureQuantity& quantity) const;
};

}  // namespace drillwave
