// SPDX-License-Identifier: GPL-3.0-or-later
// The machine-readable report, and the curve as CSV.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/gap_report.h"
#include "core/model/scales.h"
#include "core/model/version.h"
#include "core/text/row_text.h"
#include "ui/export/json_value.h"

namespace drillwave {

namespace {

struct NamedOutput {
    const char* name;
    GapOutput output;
    double plus;  ///< the impulse is 1 + e
};
constexpr NamedOutput namedOutputs[] = {{"cor", GapOutput::cor, 0},
                                        {"impulse", GapOutput::cor, 1},
                                        {"peak_force", GapOutput::peakForce, 0},
                                        {"efficiency", GapOutput::efficiency, 0}};

QJsonObject json(const Estimate& estimate, double plus = 0) {
    return {{"value", estimate.value + plus}, {"error", estimate.error}};
}

QJsonObject json(const GapExtreme& extreme, double plus) {
    constexpr const char* kinds[] = {"smooth", "kink", "everywhere"};
    QJsonObject object = json(extreme.value, plus);
    object["gap"] = extreme.gap.value;
    object["gap_error"] = extreme.gap.error;
    object["kind"] = kinds[static_cast<std::size_t>(extreme.kind)];
    return object;
}

QJsonObject json(const GapSpread& spread, double plus) {
    QJsonObject quantiles;
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i)
        quantiles[QString::number(gapQuantiles[i] * 100)] = json(spread.quantiles[i], plus);
    return {{"mean", json(spread.mean, plus)}, {"quantiles", quantiles}};
}

QJsonObject uniformJson(const GapStatistics& statistics) {
    QJsonObject object{{"share_above_one", json(statistics.shareAboveOne)}};
    for (const NamedOutput& named : namedOutputs) {
        const GapOutputStatistics& output = statistics.of(named.output);
        QJsonObject entry = json(output.uniform, named.plus);
        entry["min"] = json(output.least, named.plus);
        entry["max"] = json(output.largest, named.plus);
        object[named.name] = entry;
    }
    return object;
}

QJsonValue normalJson(const GapReport& report) {
    if (!report.normal) return QJsonValue::Null;
    QJsonObject object{{"mean", report.normal->mean},
                       {"deviation", report.normal->deviation},
                       {"cut_off_below", 0},
                       {"share_above_one", json(*report.statistics.normalShareAboveOne)}};
    for (const NamedOutput& named : namedOutputs)
        object[named.name] = json(*report.statistics.of(named.output).normal, named.plus);
    return object;
}

QJsonArray crossingsJson(const GapStatistics& statistics) {
    QJsonArray array;
    for (const GapCrossing& crossing : statistics.crossings)
        array.append(QJsonObject{
            {"gap", crossing.gap.value}, {"gap_error", crossing.gap.error}, {"rising", crossing.rising}});
    return array;
}

QJsonArray kinksJson(const GapStatistics& statistics) {
    QJsonArray array;
    for (const GapKink& kink : statistics.kinks)
        array.append(QJsonObject{{"gap", kink.gap},
                                 {"cor", kink.cor},
                                 {"slope_before", kink.slopeBefore},
                                 {"slope_after", kink.slopeAfter},
                                 {"contacts_before", kink.contactsBefore},
                                 {"contacts_after", kink.contactsAfter}});
    return array;
}

}  // namespace

QByteArray gapJson(const GapReport& report) {
    QJsonObject object{
        {"version", versionText},
        {"title", jsonText(report.scenario.title)},
        {"scenario", jsonText(report.scenarioText)},
        {"groups", groupsJson(groupsOf(report.scenario))},
        {"depends_on_gap", report.curve.dependsOnGap},
        {"period", QJsonObject{{"start", report.curve.periodStart}, {"end", report.curve.end}}},
        {"remark", jsonText(report.periodRemark())},
        {"uniform", uniformJson(report.statistics)},
        {"normal", normalJson(report)},
        {"crossings", crossingsJson(report.statistics)},
        {"kinks", kinksJson(report.statistics)},
        {"solves", static_cast<qint64>(report.curve.solves)},
        {"solver_error", report.curve.solverError},
        {"unsolved", report.curve.unsolved},
        {"run_time", report.runTime},
    };
    if (report.scenario.form == ScenarioForm::dimensional) {
        const Scales scales = scalesOf(report.scenario);
        object["si_scales"] = QJsonObject{
            {"gap", scales.penetration}, {"impulse", scales.impulse}, {"peak_force", scales.force}};
        object["units"] = QJsonObject{{"gap", unitJson(Quantity::length)},
                                      {"impulse", unitJson(Quantity::impulse)},
                                      {"peak_force", unitJson(Quantity::force)}};
    }
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

std::string gapCsv(const GapReport& report, OutputUnits units) {
    const bool si = units == OutputUnits::si;
    const Scales scales = si ? scalesOf(report.scenario) : Scales{};
    std::string csv = si ? "bit_rock.gap [m]" : "delta";
    for (const NamedOutput& named : namedOutputs)
        csv += "," + OutputColumn{findOutput(named.name), units}.header();
    csv += '\n';
    for (const double gap : sampleGaps(report.curve)) {
        appendNumber(csv, gap * scales.penetration);
        for (const NamedOutput& named : namedOutputs) {
            csv += ',';
            const double scale = findOutput(named.name)->scale(scales);
            appendNumber(csv, (report.curve.value(named.output, gap) + named.plus) * scale);
        }
        csv += '\n';
    }
    return csv;
}

}  // namespace drillwave
