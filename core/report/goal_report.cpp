// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/goal_report.h"

#include <algorithm>
#include <span>

#include "core/report/curve_text.h"
#include "core/report/output_words.h"
#include "core/report/parameter_words.h"
#include "core/report/report_table.h"
#include "core/report/report_text.h"
#include "core/text/handy_text.h"

namespace drillwave {

namespace {

using GoalKind = GoalPlace::Kind;

/// Maximum number of printed solutions; JSON and CSV have all of them.
constexpr std::size_t mostPlaces = 40;

const char* what(const GoalPlace& place) {
    switch (place.kind) {
        case GoalKind::crossing:
        case GoalKind::between:
            return place.rising ? translatable("rises through it") : translatable("falls through it");
        case GoalKind::touch:
            return translatable("turns round at it");
        case GoalKind::end:
            return translatable("is there at an end");
        case GoalKind::everywhere:
            return translatable("is it everywhere");
        case GoalKind::jump:
            return translatable("jumps over it");
    }
    return "";
}

/// Without a value of its own: where the output is not solved for, or has none.
bool isOnlyEnclosed(const GoalPlace& place) {
    return place.kind == GoalKind::between || place.kind == GoalKind::jump;
}

Message remarkMessage(const GoalPlace& place, const ReadingStyle& style) {
    if (!isOnlyEnclosed(place)) return {};
    return {place.kind == GoalKind::between ? translatable("between points, from %1 to %2")
                                            : translatable("from %1 to %2"),
            {style.number(place.value.value, goalDigits(style)),
             style.number(place.valueAfter, goalDigits(style))}};
}

std::string placesText(const CurveQuestion& question, const GoalAnswer& answer, const ReadingStyle& style) {
    const SweepAxis& along = question.along;
    TextGrid grid;
    grid.add({"", along.column().header, "+-", question.columns.front().header(), "+-", ""});
    const std::span places(answer.places);
    for (const GoalPlace& place : places.first(std::min(places.size(), mostPlaces))) {
        const bool hasValue = !isOnlyEnclosed(place);
        grid.add({style.said(what(place)), style.number(along.unit->fromSi(place.x.value), goalDigits(style)),
                  style.bound(along.unit->fromSi(place.x.error)),
                  hasValue ? style.number(place.value.value, goalDigits(style)) : std::string(),
                  hasValue ? style.bound(place.value.error) : std::string(),
                  style.said(remarkMessage(place, style))});
    }
    return grid.text() + leftOutText(places.size(), mostPlaces, style);
}

/// Where others may be.
const char* whereUnknown(const CurveLine& line) {
    const CurveOutput& output = line.outputs.front();
    if (output.unsolved.empty()) return translatable("where the output is known only at single points");
    return output.grid.empty()
               ? translatable("where it has no answer")
               : translatable("where the output is known only at single points or has no value");
}

Message rangeMessage(const CurveQuestion& question, const ReadingStyle& style) {
    const CurveRange range = question.range();
    return {translatable("%1 from %2 to %3"),
            {fieldMessage(*question.along.parameter, style),
             valueText(question.along, range.start, valueDigits, style),
             valueText(question.along, range.stop, valueDigits, style)}};
}

/// "no beta from 0.1 to 10 gives cor = 2", and where it is jumped over.
Message noneMessage(const CurveQuestion& question, const GoalAnswer& answer, const ReadingStyle& style) {
    const Message range = rangeMessage(question, style);
    const std::string goal = goalTitle(question, style);
    if (answer.places.empty()) return {translatable("no %1 gives %2"), {range, goal}};
    return {
        translatable("no %1 gives %2, which it jumps over at %3"),
        {range, goal, valueText(question.along, answer.places.front().x.value, goalDigits(style), style)}};
}

}  // namespace

int goalDigits(const ReadingStyle& style) {
    return style.isPrinted() ? 5 : 8;
}

std::string goalValue(const CurveQuestion& question, double value, const ReadingStyle& style) {
    return style.quantity(value, question.columns.front().quantity(), goalDigits(style));
}

std::string goalTitle(const CurveQuestion& question, const ReadingStyle& style) {
    const Output& output = *question.columns.front().output;
    const std::string name = style.isPrinted() ? style.said(outputMessage(output)) : std::string(output.name);
    return name + " = " + goalValue(question, *question.goal, style);
}

Message missMessage(const CurveQuestion& question, const CurveLine& line, const ReadingStyle& style) {
    const GoalAnswer& answer = *line.goal;
    const Message none = noneMessage(question, answer, style);
    if (!answer.nearest) return {translatable("%1: there is no answer anywhere"), {none}};
    const std::string value = goalValue(question, answer.nearest->value.value, style);
    const std::string at = valueText(question.along, answer.nearest->x.value, goalDigits(style), style);
    if (answer.isComplete) return {translatable("%1: the nearest is %2, at %3"), {none, value, at}};
    return {translatable("%1: the nearest is %2, at %3; there may be one %4"),
            {none, value, at, whereUnknown(line)}};
}

std::string goalText(const CurveQuestion& question, const CurveLine& line, const ReadingStyle& style) {
    const auto lineOf = [&](const Message& words) { return "  " + style.said(words) + "\n"; };
    const GoalAnswer& answer = *line.goal;
    std::string text = lineOf({translatable("Goal: %1"), {goalTitle(question, style)}});
    if (!answer.places.empty()) text += placesText(question, answer, style);
    if (!answer.isReached())
        return text +
               paragraph(style.said({translatable("None: %1."), {missMessage(question, line, style)}}));
    if (!answer.isComplete)
        return text + lineOf({translatable("There may be others %1."), {whereUnknown(line)}});
    return text + lineOf({translatable("There are no others from %1 to %2."),
                          {valueText(question.along, line.range.start, valueDigits, style),
                           valueText(question.along, line.range.stop, valueDigits, style)}});
}

std::vector<Message> goalProblems(const CurveStudy& study, const ReadingStyle& style) {
    std::vector<Message> problems;
    for (const CurveLine& line : study.lines) {
        if (!line.goal || line.goal->isReached()) continue;
        const Message miss = missMessage(study.question, line, style);
        problems.push_back(line.family ? about(familyText(*study.question.family, *line.family, style), miss)
                                       : miss);
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
    std::vector<std::string> headers{"goal", "kind", "direction"};  // goalCsvBegin
    if (question.family) headers.push_back(question.family->column().header);
    append(headers,
           {along.header, "place_error", question.columns.front().header(), "value_error", "value_after"});
    std::vector<std::pair<const CurveLine*, const GoalPlace*>> places;
    for (const CurveLine& line : study.lines)
        for (const GoalPlace& place : line.goal->places) places.emplace_back(&line, &place);
    return csvText({headers, places.size(), [&](std::size_t row) {
                        const auto& [line, place] = places[row];
                        Cells cells{*question.goal, name(place->kind),
                                    !place->isPassed() ? ""
                                    : place->rising    ? "rising"
                                                       : "falling"};
                        if (line->family) cells.push_back(question.family->column().cell(*line->family));
                        append(cells,
                               {along.cell(place->x.value), question.along.unit->fromSi(place->x.error),
                                place->value.value, place->value.error,
                                isOnlyEnclosed(*place) ? Cell(place->valueAfter) : Cell()});
                        return cells;
                    }});
}

}  // namespace drillwave
