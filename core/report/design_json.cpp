// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_report.h"

#include <cmath>

#include "core/model/parameter.h"
#include "core/report/blow_json.h"
#include "core/report/design_words.h"
#include "core/report/json_value.h"

namespace drillwave {

namespace {

const char* name(Sense sense) {
    return sense == Sense::largest ? "max" : "min";
}

Json unitOf(const DesignStudy& study, const Output& output) {
    return unitJson(hasUnits(study.base) || output.isOnlySi() ? output.quantity() : Quantity::ratio);
}

Json choiceValue(const SweepAxis& axis, double value) {
    if (axis.parameter) return value;
    std::string text;
    axis.column().appendText(text, value);
    return text;
}

JsonArray uncertainJson(const DesignStudy& study) {
    JsonArray array;
    for (const UncertainInput& input : study.uncertain) {
        JsonObject object{{"key", input.parameter->key},
                          {"kind", name(input.kind)},
                          {"low", input.low},
                          {"high", input.high},
                          {"unit", unitJson(input.parameter->quantity)}};
        if (input.kind == DistributionKind::percent) {
            object["low"] = -input.percent;
            object["high"] = input.percent;
            object["unit"] = "%";
        }
        array.emplace_back(object);
    }
    if (!study.draws) return array;
    JsonArray keys;
    for (const KeptParameter& parameter : study.draws->parameters) keys.emplace_back(parameter->key);
    array.emplace_back(
        JsonObject{{"kind", name(DistributionKind::draws)}, {"keys", keys}, {"rows", study.draws->rows()}});
    return array;
}

JsonArray chooseJson(const DesignStudy& study) {
    JsonArray array;
    for (const SweepAxis& axis : study.choices) {
        JsonArray values;
        for (std::uint64_t i = 0; i < axis.count; ++i) values.push_back(choiceValue(axis, axis.value(i)));
        array.emplace_back(
            JsonObject{{"key", axis.key()},
                       {"unit", unitJson(axis.parameter ? axis.parameter->quantity : Quantity::ratio)},
                       {"values", values}});
    }
    return array;
}

JsonArray aimsJson(const DesignStudy& study) {
    JsonArray array;
    for (const DesignAim& aim : study.aims)
        array.emplace_back(JsonObject{{"name", aim.name()},
                                      {"sense", name(aim.sense)},
                                      {"output", aim.output->name},
                                      {"statistic", aim.statistic.name()},
                                      {"unit", unitOf(study, *aim.output)}});
    return array;
}

JsonArray limitsJson(const DesignStudy& study) {
    JsonArray array;
    for (const DesignLimit& limit : study.limits)
        array.emplace_back(JsonObject{{"name", limit.name()},
                                      {"sense", limit.atMost ? "at_most" : "at_least"},
                                      {"value", limit.bound}});
    return array;
}

JsonObject designJson(const DesignReport& report, std::size_t number, std::optional<std::size_t> present) {
    const DesignStudy& study = report.study;
    const DesignSamples& design = report.findings.designs[number];
    JsonObject choice, nominal, statistics;
    JsonArray marks;
    for (const std::string_view mark : marksOf(report, number, present))
        marks.emplace_back(std::string(mark));
    const std::vector<double> values = study.choice(number);
    for (std::size_t i = 0; i < values.size(); ++i)
        choice[study.choices[i].key()] = choiceValue(study.choices[i], values[i]);
    const std::vector<OutputColumn> columns = study.columns();
    for (std::size_t c = 0; c < columns.size(); ++c) {
        nominal[columns[c].output->name] = design.nominal[c];
        const std::vector<Statistic> asked = study.statisticsOf(*columns[c].output);
        for (std::size_t s = 0; s < asked.size(); ++s) {
            const SampledValue& value = design.statistics[c][s];
            statistics[std::string(columns[c].output->name) + "_" + asked[s].name()] = JsonObject{
                {"value", value.value}, {"error", asked[s].hasError() ? Json(value.error()) : Json()}};
        }
    }
    return {{"number", number + 1},
            {"choice", choice},
            {"feasible", report.findings.feasibility[number].feasible},
            {"marginal", report.findings.feasibility[number].marginal},
            {"unsolved", design.unsolved},
            {"uncertain_share", design.uncertainShare},
            {"nominal", nominal},
            {"statistics", statistics},
            {"pareto", bool(report.findings.best.pareto[number])},
            {"marks", marks}};
}

JsonArray sensitivityJson(const DesignReport& report) {
    JsonArray array;
    for (std::size_t o = 0; o < report.findings.sensitivity.outputs.size(); ++o) {
        const OutputSensitivity& output = report.findings.sensitivity.outputs[o];
        for (std::size_t i = 0; i < report.study.dimensions(); ++i) {
            JsonObject object{
                {"output", report.findings.aimed[o]->name},
                {"key", i < report.study.uncertain.size() ? report.study.uncertain[i].parameter->key
                                                          : std::string_view("draws")}};
            const auto number = [&](double value) { return output.isConstant ? Json() : Json(value); };
            const SobolIndex index = output.isConstant ? SobolIndex{} : output.indices[i];
            object["first"] = number(index.first.value);
            object["first_error"] = number(index.first.error);
            object["total"] = number(index.total.value);
            object["total_error"] = number(index.total.error);
            if (output.isConstant) object["remark"] = "constant";
            array.emplace_back(object);
        }
    }
    return array;
}

JsonArray worstJson(const DesignReport& report) {
    const DesignStudy& study = report.study;
    JsonArray array;
    for (std::size_t a = 0; a < report.findings.worst.size(); ++a) {
        const std::optional<WorstCase>& worst = report.findings.worst[a];
        if (!worst) continue;
        JsonObject at;
        for (std::size_t i = 0; i < study.uncertain.size(); ++i)
            at[study.uncertain[i].parameter->key] = worst->at[i];
        if (study.draws)
            for (std::size_t i = 0; i < study.draws->parameters.size(); ++i)
                at[study.draws->parameters[i]->key] =
                    study.draws->columns[i][static_cast<std::size_t>(worst->at.back())];
        const bool isLargest = study.aims[a].sense == Sense::largest;
        array.emplace_back(JsonObject{{"output", study.aims[a].output->name},
                                      {"sense", isLargest ? "min" : "max"},
                                      {"value", worst->value},
                                      {"sampled", worst->sampled},
                                      {"at", at},
                                      {"searches", worst->searches},
                                      {"agreeing", worst->agreeing}});
    }
    return array;
}

/// Units of the parameters and outputs that stand in the object under their names.
JsonObject unitsJson(const DesignStudy& study) {
    JsonObject units;
    for (const KeptParameter& parameter : study.scattered())
        units[parameter->key] = unitJson(parameter->quantity);
    for (const SweepAxis& axis : study.choices)
        if (axis.parameter) units[axis.key()] = unitJson(axis.parameter->quantity);
    for (const OutputColumn& column : study.columns())
        units[column.output->name] = unitOf(study, *column.output);
    return units;
}

}  // namespace

std::string designJson(const DesignReport& report) {
    const DesignStudy& study = report.study;
    const BestDesigns& best = report.findings.best;
    JsonArray designs, ties, remarks;
    const std::optional<std::size_t> present = presentDesign(study);
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d)
        designs.emplace_back(designJson(report, d, present));
    for (const std::size_t tie : best.ties) ties.emplace_back(tie + 1);
    for (const DesignRemark& remark : remarksOn(report))
        remarks.emplace_back(JsonObject{{"code", remark.code},
                                        {"level", remark.isWarning ? "warning" : "information"},
                                        {"text", remark.text.text()}});
    const auto number = [](const std::optional<std::size_t>& design) {
        return design ? Json(*design + 1) : Json();
    };
    JsonObject object = headJson({.scenario = study.base,
                                  .scenarioText = report.scenarioText,
                                  .method = MethodChoice{},
                                  .units = unitsJson(study),
                                  .runTime = report.runTime});
    object["samples"] = study.samples;
    object["replicates"] = replicateCount;
    object["seed"] = study.seed;
    object["keep_energy"] = study.keepsEnergy;
    object["uncertain"] = uncertainJson(study);
    object["choose"] = chooseJson(study);
    object["aims"] = aimsJson(study);
    object["limits"] = limitsJson(study);
    object["designs"] = designs;
    const std::optional<DesignHeadline> headline = headlineOf(report);
    object["headline"] = headline ? Json(std::string(name(*headline))) : Json();
    object["headline_text"] = headlineMessage(report).text();
    object["recommended"] = number(report.findings.recommended);
    object["alerts"] = alertsJson(report.findings.alerts);
    object["nominal_best"] = number(best.nominal);
    object["robust_best"] = number(best.robust);
    object["ties"] = ties;
    object["sensitivity"] = sensitivityJson(report);
    object["worst"] = worstJson(report);
    object["remarks"] = remarks;
    return Json(object).text();
}

}  // namespace drillwave
