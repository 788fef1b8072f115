// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/blow_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/blow/thrust.h"
#include "core/model/version.h"
#include "core/report/blow_csv.h"
#include "ui/export/json_value.h"

namespace drillwave {

namespace {

/// Every output times its scale; null where there is no result.
QJsonObject outputsJson(const Blow& blow, const Scales& scales) {
    QJsonObject object;
    for (const Output& output : outputs())
        object[jsonText(output.name)] = blow.isSolved()
                                            ? QJsonValue(output.value(blow.summary) * output.scale(scales))
                                            : QJsonValue(QJsonValue::Null);
    return object;
}

QJsonObject siJson(const Blow& blow) {
    QJsonObject object = outputsJson(blow, blow.scales);
    if (thrustProblem(blow.scenario).empty())
        object["thrust"] = blow.isSolved() ? QJsonValue(blow.feed->fullRate) : QJsonValue(QJsonValue::Null);
    return object;
}

/// The SI unit of each number of siJson(), "1" for what has none.
QJsonObject unitsJson(const QJsonObject& si) {
    QJsonObject units;
    for (const QString& name : si.keys()) {
        const Output* output = findOutput(name.toStdString());
        const Quantity quantity = output ? output->quantity : Quantity::force;  // the thrust is no Output
        units[name] = unitJson(quantity);
    }
    return units;
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
        {"dimensionless", outputsJson(blow, Scales{})},
        {"events", eventsJson(impact)},
        {"contacts", impact.contacts},
        {"pieces", static_cast<qint64>(impact.pieces)},
        {"alerts", alertsJson(blow.alerts)},
    };
    if (blow.method.method == Method::lattice) object["segments"] = blow.method.lattice.segments;
    if (!blow.isSolved()) object["reason"] = jsonText(impact.reason);
    object["scenario"] = jsonText(scenarioText);
    if (blow.scenario.form == ScenarioForm::dimensional) {
        const QJsonObject si = siJson(blow);
        object["si"] = si;
        object["units"] = unitsJson(si);
    }
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

}  // namespace drillwave
