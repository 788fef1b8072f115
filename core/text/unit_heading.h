// SPDX-License-Identifier: GPL-3.0-or-later
// Headings of columns with their unit in brackets: "rod.length [mm]".
#pragma once

#include <string>
#include <string_view>

#include "core/text/units.h"

namespace drillwave {

/// "rod.length [mm]"; the name alone without a unit, or with one that has no name.
std::string withUnit(std::string_view name, const Unit* unit);

/// A heading in its parts, without blanks around them; `unit` is empty without brackets at the end.
struct UnitHeading {
    std::string_view name;
    std::string_view unit;
};
UnitHeading splitHeading(std::string_view heading);

}  // namespace drillwave
