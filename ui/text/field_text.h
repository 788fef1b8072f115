// SPDX-License-Identifier: GPL-3.0-or-later
// A quantity as a field for it shows it: all of a short number, six digits of a long one.
#pragma once

#include <QLocale>
#include <QString>

#include "core/text/units.h"

namespace drillwave {

/// Of a value in SI, without the name of the unit.
QString fieldText(double si, Quantity quantity, const Unit& unit, const QLocale& locale);

}  // namespace drillwave
