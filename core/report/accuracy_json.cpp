// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/accuracy_json.h"

#include <cmath>

#include "core/model/version.h"
#include "core/report/accuracy_columns.h"
#include "core/report/json_value.h"
#include "core/text/csv.h"

namespace drillwave {

namespace {

JsonObject rowJson(const AccuracyRow& row) {
    const bool solved = row.outcome == Outcome::rebounded;
    JsonObject object{{"method", name(row.choice.method)},
                      {"outcome", solved ? "rebounded" : "not_solved"},
                      {"cor", row.cor}};
    if (row.choice.method == Method::lattice) {
        object["segments"] = row.choice.lattice.segments;
        object["waves"] = wavesName(row);
        object["same_as_moved"] = row.sameAsMoved;
    }
    if (!solved) object["reason"] = row.reason;
    for (const AccuracyColumn& column : accuracyColumns)
        object[column.key] = solved ? Json(column.value(row)) : Json();
    return object;
}

}  // namespace

std::string accuracyJson(const Scenario& scenario, const std::string& scenarioText,
                         const Accuracy& accuracy) {
    const EquationResiduals& residuals = accuracy.residuals;
    JsonArray rows;
    for (const AccuracyRow& row : accuracy.rows) rows.emplace_back(rowJson(row));
    const JsonObject object{
        {"version", versionText},
        {"title", scenario.title},
        {"scenario", scenarioText},
        {"pulse", name(scenario.pulse.shape)},
        {"groups", groupsJson(accuracy.groups)},
        {"cor", accuracy.exact.cor},
        {"peak_force", accuracy.exact.peakForce},
        {"extended", JsonObject{{"cor", accuracy.extended.cor},
                                {"cor_error", accuracy.extended.corError},
                                {"bits", accuracy.extendedDigits},
                                {"seconds", accuracy.extendedTime}}},
        {"residuals", JsonObject{{"wave", residuals.wave},
                                 {"rate", residuals.rate},
                                 {"law", residuals.law},
                                 {"least_force", residuals.leastForce},
                                 {"points", residuals.points}}},
        {"lattice_order", accuracy.latticeOrder},
        {"rows", rows},
    };
    return Json(object).text();
}

std::string accuracyCsv(const Accuracy& accuracy) {
    std::string csv = "method,waves,segments,outcome,reason,cor";
    for (const AccuracyColumn& column : accuracyColumns) csv += "," + std::string(column.key);
    csv += "\n";
    for (const AccuracyRow& row : accuracy.rows) {
        const bool solved = row.outcome == Outcome::rebounded;
        const auto number = [&](double value) {
            return solved && std::isfinite(value) ? formatNumber(value) : std::string();
        };
        csv += std::string(name(row.choice.method)) + "," + std::string(wavesName(row)) + ",";
        if (row.choice.method == Method::lattice) csv += std::to_string(row.choice.lattice.segments);
        csv += std::string(solved ? ",rebounded," : ",not_solved,") + csvCell(row.reason) + "," +
               number(row.cor);
        for (const AccuracyColumn& column : accuracyColumns) csv += "," + number(column.value(row));
        csv += "\n";
    }
    return csv;
}

}  // namespace drillwave
