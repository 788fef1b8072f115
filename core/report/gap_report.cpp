// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include "core/model/scales.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"
#include "core/text/number_text.h"

namespace drillwave {

Message GapReport::periodRemark(const ReadingStyle& style) const {
    if (!curve.dependsOnGap)
        return translatable(
            "The reference case does not depend on the gap: it only shifts the time of contact.");
    if (curve.periodStart == 0) return {};
    return {translatable("The hammer still pushes when its first reflection is back: results have a period "
                         "in the gap only from a gap of %1 d0 on, and the statistics are over the period "
                         "that begins there."),
            {style.number(curve.periodStart)}};
}

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

JsonObject json(const Estimate& estimate, double plus = 0) {
    return {{"value", estimate.value + plus}, {"error", estimate.error}};
}

JsonObject json(const GapExtreme& extreme, double plus) {
    using enum GapExtreme::Kind;
    static constexpr EnumNames<GapExtreme::Kind> kinds{
        {{smooth, "smooth"}, {kink, "kink"}, {everywhere, "everywhere"}}};
    JsonObject object = json(extreme.value, plus);
    object["gap"] = extreme.gap.value;
    object["gap_error"] = extreme.gap.error;
    object["kind"] = kinds[extreme.kind];
    return object;
}

JsonObject json(const GapSpread& spread, double plus) {
    JsonObject quantiles;
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i)
        quantiles[rounded(gapQuantiles[i] * 100)] = json(spread.quantiles[i], plus);
    return {{"mean", json(spread.mean, plus)}, {"quantiles", quantiles}};
}

JsonObject uniformJson(const GapStatistics& statistics) {
    JsonObject object{{"share_above_one", json(statistics.shareAboveOne)}};
    for (const NamedOutput& named : namedOutputs) {
        const GapOutputStatistics& output = statistics.of(named.output);
        JsonObject entry = json(output.uniform, named.plus);
        entry["min"] = json(output.least, named.plus);
        entry["max"] = json(output.largest, named.plus);
        object[named.name] = entry;
    }
    return object;
}

Json normalJson(const GapReport& report) {
    if (!report.normal) return Json();
    JsonObject object{{"mean", report.normal->mean},
                      {"deviation", report.normal->deviation},
                      {"cut_off_below", 0},
                      {"share_above_one", json(*report.statistics.normalShareAboveOne)}};
    for (const NamedOutput& named : namedOutputs)
        object[named.name] = json(*report.statistics.of(named.output).normal, named.plus);
    return object;
}

JsonArray crossingsJson(const GapStatistics& statistics) {
    JsonArray array;
    for (const GapCrossing& crossing : statistics.crossings)
        array.emplace_back(JsonObject{
            {"gap", crossing.gap.value}, {"gap_error", crossing.gap.error}, {"rising", crossing.rising}});
    return array;
}

JsonArray kinksJson(const GapStatistics& statistics) {
    JsonArray array;
    for (const GapKink& kink : statistics.kinks)
        array.emplace_back(JsonObject{{"gap", kink.gap},
                                      {"cor", kink.cor},
                                      {"slope_before", kink.slopeBefore},
                                      {"slope_after", kink.slopeAfter},
                                      {"contacts_before", kink.contactsBefore},
                                      {"contacts_after", kink.contactsAfter}});
    return array;
}

}  // namespace

std::string gapJson(const GapReport& report) {
    JsonObject units;
    if (hasUnits(report.scenario))
        units = {{"gap", unitJson(Quantity::length)},
                 {"impulse", unitJson(Quantity::impulse)},
                 {"peak_force", unitJson(Quantity::force)}};
    JsonObject object = headJson({.scenario = report.scenario,
                                  .scenarioText = report.scenarioText,
                                  .method = MethodChoice{},
                                  .units = units,
                                  .runTime = report.runTime});
    object["depends_on_gap"] = report.curve.dependsOnGap;
    object["period"] = JsonObject{{"start", report.curve.periodStart}, {"end", report.curve.end}};
    object["remark"] = report.periodRemark().text();
    object["uniform"] = uniformJson(report.statistics);
    object["normal"] = normalJson(report);
    object["crossings"] = crossingsJson(report.statistics);
    object["kinks"] = kinksJson(report.statistics);
    object["solves"] = report.curve.solves;
    object["solver_error"] = report.curve.solverError;
    object["unsolved"] = report.curve.unsolved;
    if (hasUnits(report.scenario)) {
        const Scales scales = scalesOf(report.scenario);
        object["si_scales"] = JsonObject{
            {"gap", scales.penetration}, {"impulse", scales.impulse}, {"peak_force", scales.force}};
    }
    return Json(object).text();
}

std::string gapCsv(const GapReport& report, OutputUnits units) {
    const bool si = units == OutputUnits::si;
    const Scales scales = si ? scalesOf(report.scenario) : Scales{};
    const std::vector<double> gaps = sampleGaps(report.curve);
    ReportTable table{
        .headers = {si ? "bit_rock.gap [m]" : "delta"}, .rows = gaps.size(), .cellsOf = [&](std::size_t row) {
            Cells cells{gaps[row] * scales.penetration};
            for (const NamedOutput& named : namedOutputs)
                cells.push_back((report.curve.value(named.output, gaps[row]) + named.plus) *
                                findOutput(named.name)->scale(scales));
            return cells;
        }};
    for (const NamedOutput& named : namedOutputs)
        table.headers.push_back(OutputColumn{findOutput(named.name), units}.header());
    return csvText(table);
}

}  // namespace drillwave
