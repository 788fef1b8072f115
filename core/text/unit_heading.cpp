// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/unit_heading.h"

#include "core/text/decimal_text.h"

namespace drillwave {

std::string withUnit(std::string_view name, const Unit* unit) {
    if (!unit || unit->name.empty()) return std::string(name);
    return std::string(name) + " [" + std::string(unit->name) + "]";
}

UnitHeading splitHeading(std::string_view heading) {
    heading = trimmed(heading);
    const std::size_t bracket = heading.find('[');
    if (bracket == std::string_view::npos || !heading.ends_with(']')) return {heading, {}};
    return {trimmed(heading.substr(0, bracket)),
            trimmed(heading.substr(bracket + 1, heading.size() - bracket - 2))};
}

}  // namespace drillwave
