// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/handy_text.h"

#include <array>
#include <cmath>
#include <string_view>

namespace drillwave {

std::string inHandyUnit(double si, Quantity quantity, int digits) {
    // Of each quantity from the smallest on.
    constexpr std::array<std::string_view, 20> handy{"us",  "ms",  "s",   "um",   "mm",   "m",   "N s",
                                                     "N",   "kN",  "J",   "kJ",   "W",    "kW",  "kg",
                                                     "MPa", "GPa", "N/m", "kN/m", "MN/m", "GN/m"};
    const Unit* chosen = nullptr;
    for (const std::string_view name : handy) {
        const Unit* unit = findUnit(quantity, name);
        if (!unit) continue;
        const bool fits =
            si == 0 ? unit->fromSi(1) == 1 : std::abs(unit->fromSi(si)) >= 1;  // zero has no prefix
        if (!chosen || fits) chosen = unit;
    }
    if (!chosen) chosen = &unitsOf(quantity).front();
    const std::string number = rounded(chosen->fromSi(si), digits);
    return chosen->name.empty() ? number : number + " " + std::string(chosen->name);
}

}  // namespace drillwave
