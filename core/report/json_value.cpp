// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/json_value.h"

#include "core/blow/blow.h"
#include "core/model/scales.h"
#include "core/model/version.h"

namespace drillwave {

Json unitJson(Quantity quantity) {
    const std::string_view unit = unitsOf(quantity).front().name;
    return unit.empty() ? "1" : unit;
}

JsonObject groupsJson(const Groups& groups) {
    return {{"beta", groups.beta}, {"gamma", groups.gamma}, {"tau", groups.tau}, {"delta", groups.delta}};
}

JsonObject headJson(const JsonHead& head) {
    JsonObject object{{"version", versionText},
                      {"outputs", outputsVersion},
                      {"title", head.scenario.title},
                      {"scenario", head.scenarioText},
                      {"groups", groupsJson(groupsOf(head.scenario))}};
    if (head.method) {
        object["method"] = methodKey(head.scenario, head.method->method);
        if (head.method->method == Method::lattice) object["segments"] = head.method->lattice.segments;
    }
    if (!head.units.members().empty()) object["units"] = head.units;
    if (head.runTime) object["run_time"] = *head.runTime;
    return object;
}

}  // namespace drillwave
