// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/blow_json.h"

#include "core/blow/thrust.h"
#include "core/model/version.h"
#include "core/report/blow_csv.h"
#include "core/report/json_value.h"

namespace drillwave {

namespace {

/// Every output times its scale; null where there is no result.
JsonObject outputsJson(const Blow& blow, const Scales& scales) {
    JsonObject object;
    for (const Output& output : outputs())
        object[output.name] =
            blow.isSolved() ? Json(output.value(blow.summary) * output.scale(scales)) : Json();
    return object;
}

JsonObject siJson(const Blow& blow) {
    JsonObject object = outputsJson(blow, blow.scales);
    if (thrustProblem(blow.scenario).empty())
        object["thrust"] = blow.isSolved() ? Json(blow.feed->fullRate) : Json();
    return object;
}

/// The SI unit of each number of siJson(), "1" for what has none.
JsonObject unitsJson(const JsonObject& si) {
    JsonObject units;
    for (const JsonMember& member : si.members()) {
        const Output* output = findOutput(member.key);
        const Quantity quantity = output ? output->quantity : Quantity::force;  // the thrust is no Output
        units[member.key] = unitJson(quantity);
    }
    return units;
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
                       {"code", alert.code},
                       {"parameter", alert.parameter},
                       {"text", alert.text}});
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
        {"dimensionless", outputsJson(blow, Scales{})},
        {"events", eventsJson(impact)},
        {"contacts", impact.contacts},
        {"pieces", impact.pieces},
        {"alerts", alertsJson(blow.alerts)},
    };
    if (blow.method.method == Method::lattice) object["segments"] = blow.method.lattice.segments;
    if (!blow.isSolved()) object["reason"] = impact.reason;
    object["scenario"] = scenarioText;
    if (blow.scenario.form == ScenarioForm::dimensional) {
        const JsonObject si = siJson(blow);
        object["si"] = si;
        object["units"] = unitsJson(si);
    }
    return Json(object).text();
}

}  // namespace drillwave
