// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/json_value.h"

namespace drillwave {

Json unitJson(Quantity quantity) {
    const std::string_view unit = unitsOf(quantity).front().name;
    return unit.empty() ? "1" : unit;
}

JsonObject groupsJson(const Groups& groups) {
    return {{"beta", groups.beta}, {"gamma", groups.gamma}, {"tau", groups.tau}, {"delta", groups.delta}};
}

}  // namespace drillwave
