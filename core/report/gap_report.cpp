// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include "core/model/scales.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"
#include "core/text/enum_names.h"
#include "core/text/handy_text.h"

namespace drillwave {

Message periodRemark(const GapStudy& study, const ReadingStyle& style) {
    const GapCurve& curve = study.curve;
    if (!curve.dependsOnGap)
        return translatable(
            "The reference case does not depend on the gap, which only shifts the time of contact.");
    if (curve.periodStart == 0) return {};
    return {translatable("The hammer still pushes when its first reflection returns: results are periodic "
                         "only for gaps above %1 d0, and the statistics cover the first period above it."),
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

Json normalJson(const GapStudy& study) {
    if (!study.normal) return Json();
    JsonObject object{{"mean", study.normal->mean},
                      {"deviation", study.normal->deviation},
                      {"cut_off_below", 0},
                      {"share_above_one", json(*study.statistics.normalShareAboveOne)}};
    for (const NamedOutput& named : namedOutputs)
        object[named.name] = json(*study.statistics.of(named.output).normal, named.plus);
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

std::string gapJson(const GapStudy& study, const std::string& scenarioText) {
    JsonObject units;
    if (hasUnits(study.scenario))
        units = {{"gap", unitJson(Quantity::length)},
                 {"impulse", unitJson(Quantity::impulse)},
                 {"peak_force", unitJson(Quantity::force)}};
    JsonObject object = headJson({.scenario = study.scenario,
                                  .scenarioText = scenarioText,
                                  .method = MethodChoice{},
                                  .units = units,
                                  .runTime = study.runTime});
    object["depends_on_gap"] = study.curve.dependsOnGap;
    object["period"] = JsonObject{{"start", study.curve.periodStart}, {"end", study.curve.end}};
    object["remark"] = periodRemark(study).text();
    object["uniform"] = uniformJson(study.statistics);
    object["normal"] = normalJson(study);
    object["crossings"] = crossingsJson(study.statistics);
    object["kinks"] = kinksJson(study.statistics);
    object["solves"] = study.curve.solves;
    object["solver_error"] = study.curve.solverError;
    object["unsolved"] = study.curve.unsolved;
    if (hasUnits(study.scenario)) {
        const Scales scales = scalesOf(study.scenario);
        object["si_scales"] = JsonObject{
            {"gap", scales.penetration}, {"impulse", scales.impulse}, {"peak_force", scales.force}};
    }
    return Json(object).text();
}

std::string gapCsv(const GapStudy& study, OutputUnits units) {
    const bool si = units == OutputUnits::si;
    const Scales scales = si ? scalesOf(study.scenario) : Scales{};
    const std::vector<double> gaps = sampleGaps(study.curve);
    ReportTable table{
        .headers = {si ? "bit_rock.gap [m]" : "delta"}, .rows = gaps.size(), .cellsOf = [&](std::size_t row) {
            Cells cells{gaps[row] * scales.penetration};
            for (const NamedOutput& named : namedOutputs)
                cells.push_back((study.curve.value(named.output, gaps[row]) + named.plus) *
                                findOutput(named.name)->scale(scales));
            return cells;
        }};
    for (const NamedOutput& named : namedOutputs)
        table.headers.push_back(OutputColumn{findOutput(named.name), units}.header());
    return csvText(table);
}

}  // namespace drillwave
