// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/goal_report.h"

#include <algorithm>
#include <span>

#include "core/report/curve_text.h"
#include "core/report/report_text.h"
#include "core/text/number_text.h"

namespace drillwave {

namespace {

using GoalKind = GoalPlace::Kind;

constexpr int goalDigits = 8;
/// Told one by one; JSON and CSV have all of them.
constexpr std::size_t mostPlaces = 40;

std::string what(const GoalPlace& place) {
    switch (place.kind) {
        case GoalKind::crossing:
        case GoalKind::between:
            return place.rising ? "rises through it" : "falls through it";
        case GoalKind::touch:
            return "turns round at it";
        case GoalKind::end:
            return "is there at an end";
        case GoalKind::everywhere:
            return "is it everywhere";
        case GoalKind::jump:
            return "jumps over it";
    }
    return {};
}

/// Without a value of its own: where the output is not solved for, or has none.
bool isOnlyEnclosed(const GoalPlace& place) {
    return place.kind == GoalKind::between || place.kind == GoalKind::jump;
}

std::string leapText(const GoalPlace& place) {
    return "from " + rounded(place.value.value, goalDigits) + " to " + rounded(place.valueAfter, goalDigits);
}

std::string remark(const GoalPlace& place) {
    if (place.kind == GoalKind::between) return "between points, " + leapText(place);
    return place.kind == GoalKind::jump ? leapText(place) : std::string();
}

std::string placesText(const CurveQuestion& question, const GoalAnswer& answer) {
    const SweepAxis& along = question.along;
    TextGrid grid;
    grid.add({"", along.column().header, "+-", question.columns.front().header(), "+-", ""});
    const std::span places(answer.places);
    for (const GoalPlace& place : places.first(std::min(places.size(), mostPlaces))) {
        const bool hasValue = !isOnlyEnclosed(place);
        grid.add({what(place), rounded(along.unit->fromSi(place.x.value), goalDigits),
                  boundText(along.unit->fromSi(place.x.error)),
                  hasValue ? rounded(place.value.value, goalDigits) : std::string(),
                  hasValue ? boundText(place.value.error) : std::string(), remark(place)});
    }
    std::string text = grid.text();
    if (places.size() > mostPlaces)
        text += "  and " + std::to_string(places.size() - mostPlaces) + " more; --json has all\n";
    return text;
}

/// Where others may be.
std::string whereUnknown(const CurveLine& line) {
    const CurveOutput& output = line.outputs.front();
    if (output.unsolved.empty()) return "where it is known by points alone";
    return output.grid.empty() ? "where it has no answer"
                               : "where it is known by points alone or has no answer";
}

std::string rangeText(const CurveQuestion& question) {
    const CurveRange range = question.range();
    return std::string(question.along.key()) + " from " + valueText(question.along, range.start) + " to " +
           valueText(question.along, range.stop);
}

/// "no beta from 0.1 to 10 gives cor = 2: the nearest is 1.4140683, at 0.29982658".
std::string missText(const CurveQuestion& question, const CurveLine& line) {
    const OutputColumn& column = question.columns.front();
    const GoalAnswer& answer = *line.goal;
    const auto shown = [&](double value) {
        const Quantity quantity = column.hasUnit() ? column.output->quantity() : Quantity::ratio;
        return inHandyUnit(value, quantity, goalDigits);
    };
    std::string text = "no " + rangeText(question) + " gives " + goalTitle(question);
    if (!answer.places.empty()) {
        const GoalPlace& jump = answer.places.front();
        text += ", which it jumps over at " + valueText(question.along, jump.x.value, goalDigits);
    }
    if (!answer.nearest) return text + ": there is no answer anywhere";
    text += ": the nearest is " + shown(answer.nearest->value.value) + ", at " +
            valueText(question.along, answer.nearest->x.value, goalDigits);
    if (!answer.isComplete) text += "; there may be one " + whereUnknown(line);
    return text;
}

}  // namespace

std::string goalTitle(const CurveQuestion& question) {
    const OutputColumn& column = question.columns.front();
    const Quantity quantity = column.hasUnit() ? column.output->quantity() : Quantity::ratio;
    return std::string(column.output->name) + " = " + inHandyUnit(*question.goal, quantity, goalDigits);
}

std::string goalText(const CurveQuestion& question, const CurveLine& line) {
    const GoalAnswer& answer = *line.goal;
    std::string text = "  Goal: " + goalTitle(question) + "\n";
    if (!answer.places.empty()) text += placesText(question, answer);
    if (!answer.isReached()) return text + paragraph("None: " + missText(question, line) + ".");
    if (!answer.isComplete) return text + "  There may be others " + whereUnknown(line) + ".\n";
    return text + "  There are no others from " + valueText(question.along, line.range.start) + " to " +
           valueText(question.along, line.range.stop) + ".\n";
}

std::vector<std::string> goalProblems(const CurveStudy& study) {
    std::vector<std::string> problems;
    for (const CurveLine& line : study.lines) {
        if (!line.goal || line.goal->isReached()) continue;
        const std::string family =
            line.family ? familyText(*study.question.family, *line.family) + ": " : std::string();
        problems.push_back(family + missText(study.question, line));
    }
    return problems;
}

JsonObject goalJson(const GoalAnswer& answer) {
    JsonArray places;
    for (const GoalPlace& place : answer.places) {
        JsonObject object{{"kind", name(place.kind)},
                          {"x", place.x.value},
                          {"x_error", place.x.error},
                          {"value", place.value.value},
                          {"value_error", place.value.error}};
        if (isOnlyEnclosed(place)) object["value_after"] = place.valueAfter;
        if (place.isPassed()) object["rising"] = place.rising;
        places.emplace_back(object);
    }
    Json nearest;
    if (answer.nearest)
        nearest = JsonObject{{"x", answer.nearest->x.value},
                             {"x_error", answer.nearest->x.error},
                             {"value", answer.nearest->value.value},
                             {"value_error", answer.nearest->value.error}};
    return {{"reached", answer.isReached()},
            {"complete", answer.isComplete},
            {"places", places},
            {"nearest", nearest}};
}

std::string goalCsv(const CurveStudy& study) {
    const CurveQuestion& question = study.question;
    const RowColumn along = question.along.column();
    std::string csv(goalCsvBegin);
    if (question.family) csv += question.family->column().header + ",";
    csv += along.header + ",place_error," + question.columns.front().header() + ",value_error,value_after\n";
    for (const CurveLine& line : study.lines)
        for (const GoalPlace& place : line.goal->places) {
            appendNumber(csv, *question.goal);
            csv += "," + std::string(name(place.kind)) + ",";
            if (place.isPassed()) csv += place.rising ? "rising" : "falling";
            csv += ',';
            if (line.family) {
                question.family->column().appendText(csv, *line.family);
                csv += ',';
            }
            along.appendText(csv, place.x.value);
            csv += ',';
            appendNumber(csv, question.along.unit->fromSi(place.x.error));
            csv += ',';
            appendNumber(csv, place.value.value);
            csv += ',';
            appendNumber(csv, place.value.error);
            csv += ',';
            if (isOnlyEnclosed(place)) appendNumber(csv, place.valueAfter);
            csv += '\n';
        }
    return csv;
}

}  // namespace drillwave
