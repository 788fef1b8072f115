// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/blow_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/blow/outputs.h"
#include "core/model/version.h"
#include "core/report/blow_csv.h"
#include "ui/export/json_value.h"

namespace drillwave {

namespace {

/// null where there is no result.
QJsonValue outputJson(const Blow& blow, const Output& output, const Scales& scales) {
    const std::optional<double> value =
        blow.isSolved() ? output.value({blow.summary, blow.scenario}) : std::nullopt;
    return value ? QJsonValue(*value * output.scale(scales)) : QJsonValue(QJsonValue::Null);
}

QJsonObject dimensionlessJson(const Blow& blow) {
    QJsonObject object;
    for (const Output& output : outputs())
        if (output.measure != Measure::newton) object[jsonText(output.name)] = outputJson(blow, output, {});
    return object;
}

/// All that the scenario has, and the SI unit of each, "1" for what has none.
void addSi(QJsonObject& report, const Blow& blow) {
    QJsonObject si, units;
    for (const Output& output : outputs()) {
        if (!output.problem(blow.scenario).empty()) continue;
        si[jsonText(output.name)] = outputJson(blow, output, blow.scales);
        units[jsonText(output.name)] = unitJson(output.quantity());
    }
    report["si"] = si;
    report["units"] = units;
}

QJsonArray eventsJson(const Impact& impact) {
    QJsonArray array;
    for (const ImpactEvent& event : impact.events)
        array.append(QJsonObject{{"kind", jsonText(name(event.kind))}, {"time", event.time}});
    return array;
}

QJsonArray alertsJson(const std::vector<Alert>& alerts) {
    QJsonArray array;
    for (const Alert& alert : alerts)
        array.append(QJsonObject{{"level", alert.level == AlertLevel::warning ? "warning" : "information"},
                                 {"code", jsonText(alert.code)},
                                 {"parameter", jsonText(alert.parameter)},
                                 {"text", jsonText(alert.text)}});
    return array;
}

}  // namespace

QByteArray reportJson(const Blow& blow, const std::string& scenarioText) {
    const Impact& impact = blow.impact;
    QJsonObject object{
        {"version", versionText},
        {"title", jsonText(blow.scenario.title)},
        {"method", jsonText(name(blow.method.method))},
        {"outcome", blow.isSolved() ? "rebounded" : "not_solved"},
        {"run_time", blow.runTime},
        {"groups", groupsJson(blow.groups)},
        {"dimensionless", dimensionlessJson(blow)},
        {"events", eventsJson(impact)},
        {"contacts", impact.contacts},
        {"pieces", static_cast<qint64>(impact.pieces)},
        {"alerts", alertsJson(blow.alerts)},
    };
    if (blow.method.method == Method::lattice) object["segments"] = blow.method.lattice.segments;
    if (!blow.isSolved()) object["reason"] = jsonText(impact.reason);
    object["scenario"] = jsonText(scenarioText);
    if (blow.scenario.form == ScenarioForm::dimensional) addSi(object, blow);
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

}  // namespace drillwave
