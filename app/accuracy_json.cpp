// SPDX-License-Identifier: GPL-3.0-or-later
// The machine-readable report.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/accuracy_columns.h"
#include "app/accuracy_report.h"
#include "core/model/version.h"
#include "ui/export/json_value.h"

namespace drillwave {

namespace {

QJsonObject rowJson(const AccuracyRow& row) {
    const bool solved = row.outcome == Outcome::rebounded;
    QJsonObject object{{"method", jsonText(name(row.choice.method))},
                       {"outcome", solved ? "rebounded" : "not_solved"},
                       {"cor", jsonNumber(row.cor)}};
    if (row.choice.method == Method::lattice) {
        object["segments"] = row.choice.lattice.segments;
        object["waves"] = jsonText(wavesName(row));
        object["same_as_moved"] = row.sameAsMoved;
    }
    if (!solved) object["reason"] = jsonText(row.reason);
    for (const AccuracyColumn& column : accuracyColumns)
        object[jsonText(column.key)] = solved ? jsonNumber(column.value(row)) : QJsonValue(QJsonValue::Null);
    return object;
}

}  // namespace

QByteArray accuracyJson(const Scenario& scenario, const std::string& scenarioText, const Accuracy& accuracy) {
    const EquationResiduals& residuals = accuracy.residuals;
    QJsonArray rows;
    for (const AccuracyRow& row : accuracy.rows) rows.append(rowJson(row));
    const QJsonObject object{
        {"version", versionText},
        {"title", jsonText(scenario.title)},
        {"scenario", jsonText(scenarioText)},
        {"pulse", jsonText(name(scenario.pulse.shape))},
        {"groups", groupsJson(accuracy.groups)},
        {"cor", accuracy.exact.cor},
        {"peak_force", accuracy.exact.peakForce},
        {"extended", QJsonObject{{"cor", jsonNumber(accuracy.extended.cor)},
                                 {"cor_error", jsonNumber(accuracy.extended.corError)},
                                 {"bits", accuracy.extendedDigits},
                                 {"seconds", accuracy.extendedTime}}},
        {"residuals", QJsonObject{{"wave", residuals.wave},
                                  {"rate", residuals.rate},
                                  {"law", residuals.law},
                                  {"least_force", residuals.leastForce},
                                  {"points", static_cast<qint64>(residuals.points)}}},
        {"lattice_order", jsonNumber(accuracy.latticeOrder)},
        {"rows", rows},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

}  // namespace drillwave
