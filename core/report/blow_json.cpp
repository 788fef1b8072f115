// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_json.h"

#include "core/blow/outputs.h"
#include "core/model/version.h"
#include "core/report/alert_words.h"
#include "core/report/blow_csv.h"
#include "core/report/json_value.h"

namespace drillwave {

namespace {

/// null where there is no result.
Json outputJson(const Blow& blow, const Output& output, const Scales& scales) {
    const std::optional<double> value =
        blow.isSolved() ? output.value({blow.summary, blow.scenario, blow.thrustMargin}) : std::nullopt;
    return value ? Json(*value * output.scale(scales)) : Json();
}

JsonObject dimensionlessJson(const Blow& blow) {
    JsonObject object;
    for (const Output& output : outputs())
        if (!output.isOnlySi() && output.problem(blow.scenario).empty())
            object[output.name] = outputJson(blow, output, {});
    return object;
}

/// All that the scenario has, and the SI unit of each, "1" for what has none.
void addSi(JsonObject& report, const Blow& blow) {
    JsonObject si, units;
    for (const Output& output : outputs()) {
        if (!output.problem(blow.scenario).empty()) continue;
        si[output.name] = outputJson(blow, output, blow.scales);
        units[output.name] = unitJson(output.quantity());
    }
    report["si"] = si;
    report["units"] = units;
}

JsonArray eventsJson(const Impact& impact) {
    JsonArray array;
    for (const ImpactEvent& event : impact.events)
        array.emplace_back(JsonObject{{"kind", name(event.kind)}, {"time", event.time}});
    return array;
}

JsonArray alertsJson(const std::vector<Alert>& alerts) {
    JsonArray array;
    for (const Alert& alert : alerts)
        array.emplace_back(
            JsonObject{{"level", alert.level == AlertLevel::warning ? "warning" : "information"},
                       {"code", name(alert.code)},
                       {"parameter", alert.parameter},
                       {"text", alertText(alert)}});
    return array;
}

}  // namespace

std::string blowJson(const Blow& blow, const std::string& scenarioText) {
    const Impact& impact = blow.impact;
    JsonObject object{
        {"version", versionText},
        {"title", blow.scenario.title},
        {"method", name(blow.method.method)},
        {"outcome", blow.isSolved() ? "rebounded" : "not_solved"},
        {"run_time", blow.runTime},
        {"groups", groupsJson(blow.groups)},
        {"dimensionless", dimensionlessJson(blow)},
        {"events", eventsJson(impact)},
        {"contacts", impact.contacts},
        {"pieces", impact.pieces},
        {"alerts", alertsJson(blow.alerts)},
    };
    if (blow.method.method == Method::lattice) object["segments"] = blow.method.lattice.segments;
    if (!blow.isSolved()) object["reason"] = impact.reason;
    object["scenario"] = scenarioText;
    if (hasUnits(blow.scenario)) addSi(object, blow);
    return Json(object).text();
}

}  // namespace drillwave
