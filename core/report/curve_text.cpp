// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_text.h"

#include <algorithm>
#include <span>

#include "core/report/goal_report.h"
#include "core/report/report_text.h"

namespace drillwave {

namespace {

constexpr int curveDigits = 8;
/// Maximum number of features printed for each output; JSON has all of them.
constexpr std::size_t mostFeatures = 40;
constexpr std::size_t mostStretches = 5;

Message whatMessage(const CurveFeature& feature, const ReadingStyle& style) {
    using Kind = CurveFeature::Kind;
    switch (feature.kind) {
        case Kind::minimum:
            return feature.ofAll ? translatable("least") : translatable("minimum");
        case Kind::maximum:
            return feature.ofAll ? translatable("largest") : translatable("maximum");
        case Kind::kink:
            return translatable("kink");
        case Kind::jump:
            return translatable("jump");
        case Kind::crossing:
            return {feature.rising ? translatable("rises above %1") : translatable("falls below %1"),
                    {style.number(feature.level)}};
    }
    return {};
}

Message remarkMessage(const CurveFeature& feature, const ReadingStyle& style) {
    using Shape = CurveFeature::Shape;
    if (feature.kind == CurveFeature::Kind::jump)
        return {translatable("to %1"), {style.number(feature.valueAfter, curveDigits)}};
    switch (feature.shape) {
        case Shape::smooth:
            return {};
        case Shape::cusp:
            return {translatable("slope %1 to %2"),
                    {style.number(feature.slopeBefore, 3), style.number(feature.slopeAfter, 3)}};
        case Shape::end:
            return translatable("end of the range");
        case Shape::grid:
            return translatable("between points");
        case Shape::everywhere:
            return translatable("everywhere");
    }
    return {};
}

/// The end of the range matters only where the curve is least or largest there; slopes are per SI unit,
/// places in the unit that the heading has.
std::string featureTable(const CurveQuestion& question, const OutputColumn& column,
                         const std::vector<CurveFeature>& features, const ReadingStyle& style) {
    const Unit& unit = *question.along.unit;
    TextGrid grid;
    grid.add({"", question.along.column().header, "+-", column.header(), "+-", ""});
    for (const CurveFeature& feature : std::span(features).first(std::min(features.size(), mostFeatures)))
        grid.add({style.said(whatMessage(feature, style)),
                  style.number(unit.fromSi(feature.x.value), curveDigits),
                  style.bound(unit.fromSi(feature.x.error)), style.number(feature.value.value, curveDigits),
                  style.bound(feature.value.error), style.said(remarkMessage(feature, style))});
    return grid.text() + leftOutText(features.size(), mostFeatures, style);
}

/// `what` has places for the ends and the reason.
std::string stretchesText(const CurveQuestion& question, const std::vector<CurveStretch>& stretches,
                          const char* what, const ReadingStyle& style) {
    std::string text;
    for (const CurveStretch& stretch : std::span(stretches).first(std::min(stretches.size(), mostStretches)))
        text += "  " +
                style.said({what,
                            {valueText(question.along, stretch.start, valueDigits, style),
                             valueText(question.along, stretch.end, valueDigits, style), stretch.reason}}) +
                "\n";
    if (stretches.size() > mostStretches)
        text += "  " +
                style.said({translatable("and %1 more such stretches"),
                            {std::to_string(stretches.size() - mostStretches)}}) +
                "\n";
    return text;
}

Message alongMessage(const CurveQuestion& question, const ReadingStyle& style) {
    const CurveRange range = question.range();
    return {range.spacing == CurveRange::Spacing::logarithmic
                ? translatable("Along %1 from %2 to %3, by its logarithm.")
                : translatable("Along %1 from %2 to %3."),
            {std::string(question.along.key()), valueText(question.along, range.start, valueDigits, style),
             valueText(question.along, range.stop, valueDigits, style)}};
}

}  // namespace

std::string leftOutText(std::size_t count, std::size_t most, const ReadingStyle& style) {
    if (count <= most) return {};
    return "  " + style.said({translatable("and %1 more; --json has all"), {std::to_string(count - most)}}) +
           "\n";
}

std::string familyText(const SweepAxis& family, double value, const ReadingStyle& style) {
    return std::string(family.key()) + " = " + valueText(family, value, valueDigits, style);
}

std::string valueText(const SweepAxis& axis, double value, int ofDigits, const ReadingStyle& style) {
    if (axis.words) return std::string(axis.words->words()[static_cast<std::size_t>(value)]);
    if (!style.keepsUnitsOfFile() && axis.parameter)
        return style.quantity(value, axis.parameter->quantity, ofDigits);
    const std::string number = style.number(axis.unit ? axis.unit->fromSi(value) : value, ofDigits);
    return !axis.unit || axis.unit->name.empty() ? number : number + " " + std::string(axis.unit->name);
}

std::string curveText(const CurveReport& report, const ReadingStyle& style) {
    const CurveQuestion& question = report.study.question;
    std::string text =
        headingOf(question.base, style) + "  " + style.said(alongMessage(question, style)) + "\n";
    for (const CurveLine& line : report.study.lines) {
        if (line.family) text += "\n" + familyText(*question.family, *line.family, style) + "\n";
        if (line.goal) text += "\n" + goalText(question, line, style);
        for (std::size_t i = 0; i < line.outputs.size(); ++i) {
            const CurveOutput& output = line.outputs[i];
            text +=
                "\n" + featureTable(question, question.columns[i], output.features, style) +
                stretchesText(question, output.grid,
                              translatable("known only at grid points from %1 to %2: %3"), style) +
                stretchesText(question, output.unsolved, translatable("no answer from %1 to %2: %3"), style);
        }
    }
    return text + "\n  " +
           style.said(
               {translatable("%1 blows solved in %2."),
                {std::to_string(report.study.solves), style.quantity(report.runTime, Quantity::time, 3)}}) +
           "\n";
}

}  // namespace drillwave
