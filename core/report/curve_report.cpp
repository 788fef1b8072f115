// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_report.h"

#include "core/report/goal_report.h"
#include "core/report/json_value.h"
#include "core/report/report_table.h"

namespace drillwave {

std::uint64_t rowCount(const CurveStudy& study) {
    std::uint64_t rows = 0;
    for (const CurveLine& line : study.lines) rows += line.points.size();
    return rows;
}

std::string curveCsv(const CurveStudy& study) {
    const CurveQuestion& question = study.question;
    const RowColumn along = question.along.column();
    std::vector<std::string> headers{along.header};
    if (question.family) headers.insert(headers.begin(), question.family->column().header);
    for (const OutputColumn& column : question.columns) headers.push_back(column.header());
    std::vector<std::pair<const CurveLine*, std::size_t>> points;
    for (const CurveLine& line : study.lines)
        for (std::size_t i = 0; i < line.points.size(); ++i) points.emplace_back(&line, i);
    return csvText({headers, points.size(), [&](std::size_t row) {
                        const auto [line, i] = points[row];
                        Cells cells;
                        if (question.family)
                            cells.push_back(line->family ? question.family->column().cell(*line->family)
                                                         : "");
                        cells.push_back(along.cell(line->points[i]));
                        for (const std::vector<double>& values : line->values) cells.push_back(values[i]);
                        return cells;
                    }});
}

namespace {

JsonObject json(const CurveFeature& feature) {
    JsonObject object{{"kind", name(feature.kind)},   {"shape", name(feature.shape)},
                      {"x", feature.x.value},         {"x_error", feature.x.error},
                      {"value", feature.value.value}, {"value_error", feature.value.error}};
    using Kind = CurveFeature::Kind;
    if (feature.kind == Kind::minimum || feature.kind == Kind::maximum) object["of_all"] = feature.ofAll;
    if (feature.kind == Kind::crossing) {
        object["level"] = feature.level;
        object["rising"] = feature.rising;
    }
    if (feature.kind == Kind::jump) object["value_after"] = feature.valueAfter;
    if (feature.shape == CurveFeature::Shape::cusp) {
        object["slope_before"] = feature.slopeBefore;
        object["slope_after"] = feature.slopeAfter;
    }
    return object;
}

JsonArray json(const std::vector<CurveStretch>& stretches) {
    JsonArray array;
    for (const CurveStretch& stretch : stretches)
        array.emplace_back(
            JsonObject{{"start", stretch.start}, {"stop", stretch.end}, {"reason", stretch.reason.text()}});
    return array;
}

JsonObject json(const CurveOutput& output) {
    JsonArray features;
    for (const CurveFeature& feature : output.features) features.emplace_back(json(feature));
    return {{"features", features}, {"grid", json(output.grid)}, {"unsolved", json(output.unsolved)}};
}

/// Words as they are.
Json familyJson(const SweepAxis& family, double value) {
    if (family.words) return family.words->words()[static_cast<std::size_t>(value)];
    return value;
}

JsonObject json(const CurveLine& line, const CurveQuestion& question) {
    JsonObject outputs;
    for (std::size_t i = 0; i < line.outputs.size(); ++i)
        outputs[question.columns[i].output->name] = json(line.outputs[i]);
    return {{"family", line.family ? familyJson(*question.family, *line.family) : Json()},
            {"points", line.points.size()},
            {"goal", line.goal ? Json(goalJson(*line.goal)) : Json()},
            {"outputs", outputs}};
}

JsonObject unitsJson(const CurveQuestion& question) {
    JsonObject units{{question.along.key(), unitJson(question.along.parameter->quantity)}};
    if (question.family && question.family->parameter)
        units[question.family->key()] = unitJson(question.family->parameter->quantity);
    for (const OutputColumn& column : question.columns)
        units[column.output->name] = unitJson(column.quantity());
    return units;
}

}  // namespace

std::string curveJson(const CurveReport& report) {
    const CurveQuestion& question = report.study.question;
    const CurveRange range = question.range();
    JsonArray lines, levels;
    for (const CurveLine& line : report.study.lines) lines.emplace_back(json(line, question));
    for (const double level : question.levels) levels.emplace_back(level);
    JsonObject object = headJson({.scenario = question.base,
                                  .scenarioText = report.scenarioText,
                                  .method = question.method,
                                  .units = unitsJson(question),
                                  .runTime = report.runTime});
    object["along"] = JsonObject{{"key", question.along.key()},
                                 {"start", range.start},
                                 {"stop", range.stop},
                                 {"log", range.spacing == CurveRange::Spacing::logarithmic}};
    object["family"] = question.family ? Json(question.family->key()) : Json();
    object["levels"] = levels;
    object["goal"] = question.goal ? Json(*question.goal) : Json();
    object["lines"] = lines;
    object["solves"] = report.study.solves;
    return Json(object).text();
}

}  // namespace drillwave
