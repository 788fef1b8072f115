// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/string_accuracy_report.h"

#include <cmath>

#include "core/model/version.h"
#include "core/report/report_text.h"
#include "core/report/string_accuracy_columns.h"
#include "core/text/csv.h"
#include "core/text/json.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

std::string shown(const StringAccuracyColumn& column, double value) {
    if (std::isnan(value)) return "-";
    if (column.style == NumberStyle::count) return numberText(value, std::chars_format::fixed, 0);
    if (column.style == NumberStyle::time) return inHandyUnit(value, Quantity::time, 3);
    return value == 0 ? "0" : numberText(value, std::chars_format::scientific, 1);
}

}  // namespace

std::string stringAccuracyText(const Scenario& scenario, const StringAccuracy& accuracy) {
    TextGrid grid;
    std::vector<std::string> titles{"method"};
    for (const StringAccuracyColumn& column : stringAccuracyColumns) titles.emplace_back(column.title);
    grid.add(titles);
    for (const StringAccuracyRow& row : accuracy.rows) {
        std::vector<std::string> cells{std::string(name(row.method))};
        for (const StringAccuracyColumn& column : stringAccuracyColumns)
            cells.push_back(shown(column, column.value(row)));
        grid.add(std::move(cells));
    }
    return headingOf(scenario) + "\n" + grid.text() + "\n  error: of the efficiency, against " +
           rounded(accuracy.efficiency, 13) + " (cut cells half as large again, stated error " +
           boundText(accuracy.reference) +
           ")\n  stated: what the method says of it; impulse: error of the impulse on the rock, of the "
           "hammer's\n  cells: polynomial cells, cut at jumps (sweep, map); cells_cut: cut at every corner "
           "of a wave (run);\n  plain: a lattice of constant cells, as others have it\n";
}

std::string stringAccuracyJson(const std::string& scenarioText, const StringAccuracy& accuracy) {
    JsonArray rows;
    for (const StringAccuracyRow& row : accuracy.rows) {
        JsonObject object{{"method", name(row.method)}};
        for (const StringAccuracyColumn& column : stringAccuracyColumns) {
            const double value = column.value(row);
            object[column.key] = std::isnan(value) ? Json() : Json(value);
        }
        rows.emplace_back(object);
    }
    return Json(JsonObject{{"version", versionText},
                           {"efficiency", accuracy.efficiency},
                           {"efficiency_error", accuracy.reference},
                           {"rows", rows},
                           {"scenario", scenarioText}})
        .text();
}

std::string stringAccuracyCsv(const StringAccuracy& accuracy) {
    std::string text = "method";
    for (const StringAccuracyColumn& column : stringAccuracyColumns) text += "," + std::string(column.key);
    text += "\n";
    for (const StringAccuracyRow& row : accuracy.rows) {
        text += name(row.method);
        for (const StringAccuracyColumn& column : stringAccuracyColumns) {
            const double value = column.value(row);
            text += "," + (std::isnan(value) ? std::string() : formatNumber(value));
        }
        text += "\n";
    }
    return text;
}

}  // namespace drillwave
