// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/curve_text.h"

#include <algorithm>
#include <span>

#include "core/report/goal_report.h"
#include "core/report/report_text.h"

namespace drillwave {

namespace {

constexpr int curveDigits = 8;
/// Features of an output of a line that are told one by one; JSON has all of them.
constexpr std::size_t mostFeatures = 40;
constexpr std::size_t mostStretches = 5;

/// "0.29982658", in the unit that the heading has.
std::string placeText(const SweepAxis& axis, double value) {
    return rounded(axis.unit->fromSi(value), curveDigits);
}

std::string what(const CurveFeature& feature) {
    using Kind = CurveFeature::Kind;
    switch (feature.kind) {
        case Kind::minimum:
            return feature.ofAll ? "least" : "minimum";
        case Kind::maximum:
            return feature.ofAll ? "largest" : "maximum";
        case Kind::kink:
            return "kink";
        case Kind::jump:
            return "jump";
        case Kind::crossing:
            return feature.rising ? "rises above " + rounded(feature.level)
                                  : "falls below " + rounded(feature.level);
    }
    return {};
}

std::string remark(const CurveFeature& feature) {
    using Shape = CurveFeature::Shape;
    if (feature.kind == CurveFeature::Kind::jump) return "to " + rounded(feature.valueAfter, curveDigits);
    switch (feature.shape) {
        case Shape::smooth:
            return "";
        case Shape::cusp:
            return "slope " + rounded(feature.slopeBefore, 3) + " to " + rounded(feature.slopeAfter, 3);
        case Shape::end:
            return "end of the range";
        case Shape::grid:
            return "between points";
        case Shape::everywhere:
            return "everywhere";
    }
    return {};
}

/// The end of the range matters only where the curve is least or largest there; slopes are per SI unit.
std::string featureTable(const CurveQuestion& question, const OutputColumn& column,
                         const std::vector<CurveFeature>& features) {
    TextGrid grid;
    grid.add({"", question.along.column().header, "+-", column.header(), "+-", ""});
    for (const CurveFeature& feature : std::span(features).first(std::min(features.size(), mostFeatures)))
        grid.add({what(feature), placeText(question.along, feature.x.value),
                  boundText(question.along.unit->fromSi(feature.x.error)),
                  rounded(feature.value.value, curveDigits), boundText(feature.value.error),
                  remark(feature)});
    std::string text = grid.text();
    if (features.size() > mostFeatures)
        text += "  and " + std::to_string(features.size() - mostFeatures) + " more; --json has all\n";
    return text;
}

std::string stretchesText(const CurveQuestion& question, const std::vector<CurveStretch>& stretches,
                          const std::string& what) {
    std::string text;
    for (const CurveStretch& stretch : std::span(stretches).first(std::min(stretches.size(), mostStretches)))
        text += "  " + what + " from " + valueText(question.along, stretch.start) + " to " +
                valueText(question.along, stretch.end) + ": " + stretch.reason + "\n";
    if (stretches.size() > mostStretches)
        text += "  and " + std::to_string(stretches.size() - mostStretches) + " more such stretches\n";
    return text;
}

}  // namespace

std::string familyText(const SweepAxis& family, double value) {
    return std::string(family.key()) + " = " +
           (family.words ? std::string(family.words->words()[static_cast<std::size_t>(value)])
                         : valueText(family, value));
}

std::string valueText(const SweepAxis& axis, double value, int ofDigits) {
    const std::string number = rounded(axis.unit->fromSi(value), ofDigits);
    return axis.unit->name.empty() ? number : number + " " + std::string(axis.unit->name);
}

std::string curveText(const CurveReport& report) {
    const CurveQuestion& question = report.study.question;
    const CurveRange range = question.range();
    std::string text =
        headingOf(question.base) + "  Along " + std::string(question.along.key()) + " from " +
        valueText(question.along, range.start) + " to " + valueText(question.along, range.stop) +
        (range.spacing == CurveRange::Spacing::logarithmic ? ", by its logarithm" : "") + ".\n";
    for (const CurveLine& line : report.study.lines) {
        if (line.family) text += "\n" + familyText(*question.family, *line.family) + "\n";
        if (line.goal) text += "\n" + goalText(question, line);
        for (std::size_t i = 0; i < line.outputs.size(); ++i) {
            const CurveOutput& output = line.outputs[i];
            text += "\n" + featureTable(question, question.columns[i], output.features) +
                    stretchesText(question, output.grid, "known by points alone") +
                    stretchesText(question, output.unsolved, "no answer");
        }
    }
    return text + "\n  From " + std::to_string(report.study.solves) + " blows in " +
           inHandyUnit(report.runTime, Quantity::time, 3) + ".\n";
}

}  // namespace drillwave
