// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/blow_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/blow/impact_summary.h"
#include "core/blow/result_alerts.h"
#include "core/blow/thrust.h"
#include "core/model/alerts.h"
#include "core/model/version.h"
#include "core/report/blow_csv.h"
#include "ui/export/json_value.h"

namespace drillwave {

namespace {

/// Every output times its scale; null where there is no result.
QJsonObject outputsJson(const BlowReport& report, const Scales& scales) {
    const bool solved = report.impact.outcome == Outcome::rebounded;
    const ImpactSummary summary =
        solved ? summarize(report.impact, groupsOf(report.scenario)) : ImpactSummary{};
    QJsonObject object;
    for (const Output& output : outputs())
        object[jsonText(output.name)] =
            solved ? QJsonValue(output.value(summary) * output.scale(scales)) : QJsonValue(QJsonValue::Null);
    return object;
}

QJsonObject siJson(const BlowReport& report) {
    QJsonObject object = outputsJson(report, scalesOf(report.scenario));
    const bool solved = report.impact.outcome == Outcome::rebounded;
    if (const std::optional<double> thrust = thrustNeeded(report.scenario, report.impact.cor))
        object["thrust"] = solved ? QJsonValue(*thrust) : QJsonValue(QJsonValue::Null);
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

std::vector<Alert> BlowReport::alerts() const {
    std::vector<Alert> all = alertsFor(scenario);
    if (impact.outcome != Outcome::rebounded) return all;
    for (Alert& alert : resultAlerts(scenario, summarize(impact, groupsOf(scenario))))
        all.push_back(std::move(alert));
    if (hasStrength(scenario.rod) && !impact.incident.empty())
        for (Alert& alert : stressAlerts(scenario, largestRodForces(impact, pulseForceOf(scenario))))
            all.push_back(std::move(alert));
    return all;
}

QByteArray reportJson(const BlowReport& report, const std::string& scenarioText) {
    const Impact& impact = report.impact;
    const bool solved = impact.outcome == Outcome::rebounded;
    QJsonObject object{
        {"version", versionText},
        {"title", jsonText(report.scenario.title)},
        {"method", jsonText(name(report.choice.method))},
        {"outcome", solved ? "rebounded" : "not_solved"},
        {"run_time", report.runTime},
        {"groups", groupsJson(groupsOf(report.scenario))},
        {"dimensionless", outputsJson(report, Scales{})},
        {"events", eventsJson(impact)},
        {"contacts", impact.contacts},
        {"pieces", static_cast<qint64>(impact.pieces)},
        {"alerts", alertsJson(report.alerts())},
    };
    if (report.choice.method == Method::lattice) object["segments"] = report.choice.lattice.segments;
    if (!solved) object["reason"] = jsonText(impact.reason);
    object["scenario"] = jsonText(scenarioText);
    if (report.scenario.form == ScenarioForm::dimensional) {
        const QJsonObject si = siJson(report);
        object["si"] = si;
        object["units"] = unitsJson(si);
    }
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

}  // namespace drillwave
