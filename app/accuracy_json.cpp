// The machine-readable report.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>

#include "app/accuracy_columns.h"
#include "app/accuracy_report.h"
#include "core/model/version.h"

namespace drillwave {

namespace {

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

QJsonValue number(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

QJsonObject rowJson(const AccuracyRow& row) {
    const bool solved = row.outcome == Outcome::rebounded;
    QJsonObject object{{"method", text(name(row.choice.method))},
                       {"outcome", solved ? "rebounded" : "not_solved"},
                       {"cor", number(row.cor)}};
    if (row.choice.method == Method::lattice) {
        object["segments"] = row.choice.lattice.segments;
        object["waves"] = text(wavesName(row));
        object["same_as_moved"] = row.sameAsMoved;
    }
    if (!solved) object["reason"] = text(row.reason);
    for (const AccuracyColumn& column : accuracyColumns)
        object[text(column.key)] = solved ? number(column.value(row)) : QJsonValue(QJsonValue::Null);
    return object;
}

}  // namespace

QByteArray accuracyJson(const Scenario& scenario, const Accuracy& accuracy) {
    const Groups& groups = accuracy.groups;
    const EquationResiduals& residuals = accuracy.residuals;
    QJsonArray rows;
    for (const AccuracyRow& row : accuracy.rows) rows.append(rowJson(row));
    const QJsonObject object{
        {"version", versionText},
        {"title", text(scenario.title)},
        {"pulse", text(name(scenario.pulse.shape))},
        {"groups",
         QJsonObject{
             {"beta", groups.beta}, {"gamma", groups.gamma}, {"tau", groups.tau}, {"delta", groups.delta}}},
        {"cor", accuracy.exact.cor},
        {"peak_force", accuracy.exact.peakForce},
        {"extended", QJsonObject{{"cor", number(accuracy.extended.cor)},
                                 {"bits", accuracy.extendedDigits},
                                 {"seconds", accuracy.extendedTime}}},
        {"residuals", QJsonObject{{"wave", residuals.wave},
                                  {"rate", residuals.rate},
                                  {"law", residuals.law},
                                  {"least_force", residuals.leastForce},
                                  {"points", static_cast<qint64>(residuals.points)}}},
        {"lattice_order", number(accuracy.latticeOrder)},
        {"rows", rows},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

}  // namespace drillwave
