// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_figure.h"

#include <algorithm>
#include <cmath>

#include "core/model/preset_places.h"
#include "core/model/scales.h"
#include "core/report/curve_text.h"
#include "core/report/goal_report.h"
#include "core/report/output_words.h"
#include "core/report/parameter_words.h"
#include "core/text/printed_text.h"

namespace drillwave {

namespace {

/// Maximum number of places named in a sentence.
constexpr std::size_t maxNamedPlaces = 6;

constexpr double roomOfCurves = 0.02;  // at both ends of the axis, of its range

enum class CurveKind { curve, reference, closedForm };

bool hasAnswer(const CurveLine& line) {
    return std::ranges::any_of(line.values.front(), [](double value) { return std::isfinite(value); });
}

bool isOf(const CurveLine& line, std::optional<double> here) {
    return !line.family || line.family == here;
}

/// Returns what a value of the first column is divided by: columns in SI were scaled by the study.
double columnScale(const CurveQuestion& question) {
    const OutputColumn& column = question.columns.front();
    return column.output->isOnlySi() ? 1 : column.scale(scalesOf(question.base));
}

double largestOf(const CurveStudy& study) {
    double largest = 0;
    for (const CurveLine& line : study.lines)
        for (const double value : line.values.front())
            if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

FigureAxis valueAxis(const CurveStudy& study) {
    const OutputColumn& column = study.question.columns.front();
    return {.title = outputMessage(*column.output), .quantity = figureQuantity(column, largestOf(study))};
}

Message familyMessage(const SweepAxis& family, double value, const ReadingStyle& style) {
    if (!family.parameter)
        return Message::ofTable(style.name(family.words->words()[static_cast<std::size_t>(value)]));
    const Parameter& parameter = *family.parameter;
    const Message symbol =
        parameter.symbol.empty() ? labelMessage(parameter) : Message(printedWords(parameter.symbol));
    return {"%1 = %2", {symbol, style.quantity(value, parameter.quantity, 4)}};
}

Message lineName(const CurveStudy& study, const CurveLine& line, CurveKind kind, bool isHere,
                 const ReadingStyle& style) {
    const Message family =
        line.family ? familyMessage(*study.question.family, *line.family, style) : Message();
    const auto named = [&](const char* alone, const char* ofFamily) {
        return line.family ? Message(ofFamily, {family}) : Message(alone);
    };
    switch (kind) {
        case CurveKind::curve:
            if (line.family && !isHere) return family;
            return named(translatable("this scenario"), translatable("%1, this scenario"));
        case CurveKind::reference:
            return named(translatable("rod without waves"), translatable("%1, no waves"));
        case CurveKind::closedForm:
            return named(translatable("closed form"), translatable("%1, closed form"));
    }
    return {};
}

/// Adds the second axis, above, for a group that changes with the parameter.
void addGroupAxis(StudyPanel& panel, const CurveQuestion& question) {
    if (!hasUnits(question.base)) return;
    const Scales scales = scalesOf(question.base);
    const auto show = [&](const char* formula, double perSi) {
        panel.top = FigureAxis{.title = formula};
        panel.topPerX = perSi;
    };
    const std::string_view key = question.along.key();
    if (key == "bit_rock.stiffness") show("β = k t₀ / Z", 1 / scales.stiffness);
    if (key == "bit_rock.gap") show("δ = d Z / (2 I₀)", 1 / scales.penetration);
    if (key == "rod.length") show("τ = L / (c t₀)", groupsOf(question.base).tau / question.base.rod.length);
}

void addLines(StudyPanel& panel, const CurveStudy& study, CurveKind kind, double perX,
              std::optional<double> here, const CurveQuestion& asked, const ReadingStyle& style) {
    for (std::size_t i = 0; i < study.lines.size(); ++i) {
        const CurveLine& line = study.lines[i];
        FigureSeries series = curveSeries(line, asked);
        if (series.x.empty()) continue;
        for (double& x : series.x) x *= perX;
        const bool isHere = isOf(line, here);
        series.legend = lineName(study, line, kind, isHere, style);
        series.role = static_cast<SeriesRole>(i);
        if (kind == CurveKind::curve && isHere) series.stroke = SeriesStroke::wide;
        if (kind == CurveKind::reference) series.stroke = SeriesStroke::dotted;
        if (kind == CurveKind::closedForm) series.stroke = SeriesStroke::dashed;
        if (kind == CurveKind::curve && &line == markedLine(study, here)) panel.marked = panel.series.size();
        if (kind == CurveKind::curve)
            series.target =
                SeriesTarget{line.family && !isHere ? study.question.family->parameter : KeptParameter(),
                             line.family.value_or(0)};
        panel.series.push_back(std::move(series));
    }
}

/// Returns marks at features; ends of the range and features that are present everywhere get none.
std::vector<FigureMark> marksOf(const CurveLine& line, const CurveQuestion& question) {
    using Kind = CurveFeature::Kind;
    using Shape = CurveFeature::Shape;
    std::vector<FigureMark> marks;
    for (const CurveFeature& feature : line.outputs.front().features) {
        if (feature.shape == Shape::end || feature.shape == Shape::everywhere) continue;
        FigureMark mark{MarkKind::kink, feature.x.value, curveOrdinate(question, feature.value.value)};
        if (feature.kind == Kind::minimum || feature.kind == Kind::maximum) mark.kind = MarkKind::extreme;
        if (feature.kind == Kind::crossing) mark.kind = MarkKind::crossing;
        marks.push_back(mark);
    }
    if (!line.goal) return marks;
    for (const GoalPlace& place : line.goal->places)
        if (place.isGiven() && place.kind != GoalPlace::Kind::everywhere)
            marks.push_back({MarkKind::goal, place.x.value, curveOrdinate(question, *question.goal)});
    return marks;
}

/// Adds all marks of the marked line, and rings at those of the others that are more than kinks.
void addMarks(StudyPanel& panel, const CurveStudy& study, std::optional<double> here) {
    FigureSeries rings{.points = SeriesPoints::rings};
    const CurveLine* marked = markedLine(study, here);
    for (const CurveLine& line : study.lines)
        for (const FigureMark& mark : marksOf(line, study.question)) {
            if (&line == marked) panel.marks.push_back(mark);
            if (&line == marked || mark.kind == MarkKind::kink) continue;
            rings.x.push_back(mark.x);
            rings.y.push_back(mark.y);
        }
    if (!rings.x.empty()) panel.series.push_back(std::move(rings));
}

/// Adds a band around the value of each preset, as wide as can be seen, but not beyond halfway to the next.
void addBands(StudyPanel& panel, const CurveQuestion& question, std::span<const Preset> presets) {
    constexpr double halfWidth = 0.012;  // of the range
    const CurveRange range = question.range();
    const std::vector<PresetPlace> places = presetPlaces(presets, *question.along.parameter, question.base);
    const auto shareOf = [&](const PresetPlace& place) { return range.shareOf(place.si); };
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].si < range.start || places[i].si > range.stop) continue;
        const double share = shareOf(places[i]);
        const double before = i == 0 ? 1 : (share - shareOf(places[i - 1])) / 2;
        const double after = i + 1 == places.size() ? 1 : (shareOf(places[i + 1]) - share) / 2;
        panel.bands.push_back({places[i].name, range.at(share - std::min(halfWidth, before)),
                               range.at(share + std::min(halfWidth, after)), places[i].si});
    }
}

/// Returns "29.98 ± 0.01 MN/m".
std::string placeText(const SweepAxis& along, const Estimate& place, const ReadingStyle& style) {
    const ReadUnit read = style.unitFor(place.value, along.parameter->quantity);
    return style.number(read.unit->fromSi(place.value), goalDigits(style)) + " ± " +
           style.bound(read.unit->fromSi(place.error)) + (read.name.empty() ? "" : " " + read.name);
}

/// Returns where a line reaches the goal, how well the places are known, and whether there may be others.
Message goalMessage(const CurveQuestion& question, const CurveLine& line, const ReadingStyle& style) {
    const GoalAnswer& answer = *line.goal;
    if (!answer.isReached()) return missMessage(question, line, style);
    const std::string goal = goalTitle(question, style);
    Message list;
    std::size_t count = 0;
    for (const GoalPlace& place : answer.places) {
        if (!place.isGiven()) continue;
        if (place.kind == GoalPlace::Kind::everywhere) return {translatable("%1 everywhere"), {goal}};
        ++count;
        list = joined(std::move(list), "%1; %2", placeText(question.along, place.x, style));
    }
    if (count > maxNamedPlaces) return {translatable("%1 at %2 places"), {goal, std::to_string(count)}};
    return {answer.isComplete ? translatable("%1 at %2, nowhere else in this range")
                              : translatable("%1 at %2, perhaps elsewhere too"),
            {goal, list}};
}

/// Returns where another line reaches a goal that the marked line does not reach: "γ = 0.3 reaches it at 140
/// MN/m", "γ = 1 is above it everywhere". Empty if that is not known.
Message otherGoalMessage(const CurveStudy& study, const CurveLine& line, const ReadingStyle& style) {
    const CurveQuestion& question = study.question;
    const Message name = lineName(study, line, CurveKind::curve, false, style);
    for (const GoalPlace& place : line.goal->places)
        if (place.isGiven() && place.kind != GoalPlace::Kind::everywhere)
            return {translatable("%1 reaches it at %2"),
                    {name, valueText(question.along, place.x.value, goalDigits(style), style)}};
    const CurveFeature* least = line.outputs.front().extreme(CurveFeature::Kind::minimum);
    const CurveFeature* most = line.outputs.front().extreme(CurveFeature::Kind::maximum);
    if (!line.goal->isComplete || !least || !most) return {};
    if (least->value.value > *question.goal) return {translatable("%1 is above it everywhere"), {name}};
    if (most->value.value < *question.goal) return {translatable("%1 is below it everywhere"), {name}};
    return {};
}

/// Returns least and largest value with their places; empty without them.
Message extremesMessage(const CurveQuestion& question, const CurveOutput& output, const ReadingStyle& style) {
    const auto extreme = [&](CurveFeature::Kind kind) {
        const CurveFeature* found = output.extreme(kind);
        return found && found->shape != CurveFeature::Shape::everywhere ? found : nullptr;
    };
    const auto placed = [&](const CurveFeature& feature) -> Message {
        const Message text{translatable("%1 at %2"),
                           {goalValue(question, feature.value.value, style),
                            valueText(question.along, feature.x.value, goalDigits(style), style)}};
        return feature.shape == CurveFeature::Shape::end
                   ? Message(translatable("%1, the end of the range"), {text})
                   : text;
    };
    const Message name = outputMessage(*question.columns.front().output);
    const CurveFeature* least = extreme(CurveFeature::Kind::minimum);
    const CurveFeature* most = extreme(CurveFeature::Kind::maximum);
    if (least && most)
        return {translatable("%1 ranges from %2 to %3"), {name, placed(*least), placed(*most)}};
    if (most) return {translatable("the largest %1 is %2"), {name, placed(*most)}};
    if (least) return {translatable("the smallest %1 is %2"), {name, placed(*least)}};
    return {};
}

/// Returns where the line is 1, a level of e; empty where it is not.
Message crossingsMessage(const CurveQuestion& question, const CurveOutput& output,
                         const ReadingStyle& style) {
    Message list;
    std::size_t count = 0;
    for (const CurveFeature& feature : output.features)
        if (feature.kind == CurveFeature::Kind::crossing) {
            ++count;
            list = joined(std::move(list), "%1; %2",
                          valueText(question.along, feature.x.value, goalDigits(style), style));
        }
    if (count == 0) return {};
    if (count > maxNamedPlaces) return {translatable("e = 1 at %1 places"), {std::to_string(count)}};
    return {translatable("e = 1 at %1"), {list}};
}

}  // namespace

const CurveLine* markedLine(const CurveStudy& study, std::optional<double> here) {
    const CurveLine* marked = nullptr;
    for (const CurveLine& line : study.lines)
        if (hasAnswer(line) && (isOf(line, here) || !marked || !isOf(*marked, here))) marked = &line;
    return marked;
}

double curveOrdinate(const CurveQuestion& question, double value) {
    return value / columnScale(question);
}

FigureSeries curveSeries(const CurveLine& line, const CurveQuestion& question) {
    if (!hasAnswer(line)) return {};
    FigureSeries series{.x = line.points, .y = line.values.front()};
    for (double& y : series.y) y = curveOrdinate(question, y);
    return series;
}

StudyFigure curveFigure(const ComparedCurve& study, std::optional<double> here,
                        std::span<const Preset> presets, const ReadingStyle& style) {
    const CurveQuestion& question = study.question.curve;
    StudyFigure figure;
    figure.paperHeight = 120;
    StudyPanel& panel = figure.panels.emplace_back();
    panel.x = {.quantity = question.along.parameter,
               .isLogarithmic = question.along.isLogarithmic(),
               .range = question.along.range(roomOfCurves),
               .target = AxisTarget{question.along.parameter}};
    panel.y = valueAxis(study.curve);
    addGroupAxis(panel, question);
    addLines(panel, study.curve, CurveKind::curve, 1, here, question, style);
    if (study.reference) {
        const bool isStiffness = question.along.key() == "bit_rock.stiffness";
        addLines(panel, *study.reference, CurveKind::reference,
                 isStiffness ? scalesOf(question.base).stiffness : 1, here, question, style);
    }
    if (study.closedForm) addLines(panel, *study.closedForm, CurveKind::closedForm, 1, here, question, style);
    addMarks(panel, study.curve, here);
    addBands(panel, question, presets);
    if (question.columns.front().output->name == "cor")
        figure.levels.push_back({.name = {}, .y = 1, .isMain = true, .isInView = false});
    if (question.goal)
        figure.levels.push_back({.name = translatable("goal"),
                                 .y = curveOrdinate(question, *question.goal),
                                 .isMain = true,
                                 .isInView = false});
    return figure;
}

std::vector<Message> curveSentences(const ComparedCurve& study, std::optional<double> here,
                                    const ReadingStyle& style) {
    const CurveLine* marked = markedLine(study.curve, here);
    if (!marked) return {translatable("There is no answer anywhere in this range.")};
    const CurveQuestion& question = study.question.curve;
    const CurveOutput& output = marked->outputs.front();
    std::vector<Message> parts;
    if (marked->goal) parts.push_back(goalMessage(question, *marked, style));
    if (marked->goal && !marked->goal->isReached())
        for (const CurveLine& line : study.curve.lines)
            if (&line != marked && line.goal) parts.push_back(otherGoalMessage(study.curve, line, style));
    parts.push_back(extremesMessage(question, output, style));
    parts.push_back(crossingsMessage(question, output, style));
    if (study.question.isSampled())
        parts.push_back({translatable("the curve has %1 points"), {std::to_string(marked->points.size())}});
    else if (!output.grid.empty())
        parts.emplace_back(translatable("only points are known in a part of the range"));
    if (!output.unsolved.empty())
        parts.push_back({translatable("there is no answer in a part of the range: %1"),
                         {output.unsolved.front().reason}});
    std::erase_if(parts, [](const Message& part) { return part.isEmpty(); });
    if (parts.empty())
        parts.push_back({translatable("%1 has no extremes in this range"),
                         {outputMessage(*question.columns.front().output)}});
    std::vector<Message> sentences{
        {translatable("%1 (%2)."),
         {parts.front(), lineName(study.curve, *marked, CurveKind::curve, isOf(*marked, here), style)}}};
    Message details;
    for (std::size_t i = 1; i < parts.size(); ++i) details = joined(std::move(details), "%1 · %2", parts[i]);
    if (!details.isEmpty()) sentences.push_back(std::move(details));
    if (!question.goal)
        sentences.push_back({translatable("Enter a goal for %1 to find where it is reached."),
                             {outputMessage(*question.columns.front().output)}});
    return sentences;
}

}  // namespace drillwave
