// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/curve/curve_picture.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "ui/job/output_text.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/pages/study/preset_places.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

double largestOf(const CurveStudy& study) {
    double largest = 0;
    for (const CurveLine& line : study.lines)
        for (const double value : line.values.front())
            if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

/// Adds the axis above for a group that changes with the parameter.
void addAbove(CurvePicture& picture, const CurveQuestion& question) {
    if (!hasUnits(question.base)) return;
    const Scales scales = scalesOf(question.base);
    const auto show = [&](const char* group, double perSi) {
        const Parameter& parameter = *findParameter(group);
        picture.aboveName = shownSymbol(parameter.symbol);
        picture.aboveFactor = perSi / picture.x.factor;
    };
    const std::string_view key = question.along.key();
    if (key == "bit_rock.stiffness") show("beta", 1 / scales.stiffness);
    if (key == "bit_rock.gap") show("delta", 1 / scales.penetration);
    if (key == "rod.length") show("tau", groupsOf(question.base).tau / question.base.rod.length);
}

QString familyName(const CurveStudy& study, const CurveLine& line, const QLocale& locale) {
    if (!line.family) return {};
    if (!study.question.family->parameter) return coreName(name(static_cast<PulseShape>(*line.family)));
    const Parameter& parameter = *study.question.family->parameter;
    const Unit& unit = parameter.displayUnit();
    const QString symbol =
        parameter.symbol.empty() ? parameterLabel(parameter) : shownSymbol(parameter.symbol);
    QString text = symbol + QStringLiteral(" = ") + numberText(unit.fromSi(*line.family), 4, locale);
    if (!unit.name.empty()) text += QChar(QChar::Nbsp) + fromView(unit.name);
    return text;
}

QString nameOf(DrawnCurve::Kind kind, const QString& family, bool isHere) {
    switch (kind) {
        case DrawnCurve::Kind::curve:
            if (family.isEmpty()) return tr("this scenario");
            return isHere ? tr("%1, this scenario").arg(family) : family;
        case DrawnCurve::Kind::reference:
            return family.isEmpty() ? tr("rod without waves") : tr("%1, no waves").arg(family);
        case DrawnCurve::Kind::closedForm:
            return family.isEmpty() ? tr("closed form") : tr("%1, closed form").arg(family);
    }
    return {};
}

CurveMark markOf(const CurveFeature& feature, double xFactor, double valueFactor) {
    using Kind = CurveFeature::Kind;
    CurveMark mark;
    if (feature.kind == Kind::minimum || feature.kind == Kind::maximum) mark.kind = CurveMark::Kind::extreme;
    if (feature.kind == Kind::crossing) mark.kind = CurveMark::Kind::crossing;
    mark.at = {feature.x.value * xFactor, feature.value.value * valueFactor};
    return mark;
}

/// Whether a feature gets a mark: ends of the range and features present everywhere do not.
bool isMarked(const CurveFeature& feature) {
    return feature.shape != CurveFeature::Shape::end && feature.shape != CurveFeature::Shape::everywhere;
}

/// Returns the marks where the goal is reached; crossings at these places get no further mark.
QVector<CurveMark> goalMarks(const CurveLine& line, double goal, double xFactor) {
    QVector<CurveMark> marks;
    if (!line.goal) return marks;
    for (const GoalPlace& place : line.goal->places)
        if (place.isGiven() && place.kind != GoalPlace::Kind::everywhere)
            marks.append({CurveMark::Kind::goal, {place.x.value * xFactor, goal}});
    return marks;
}

void addLines(CurvePicture& picture, const CurveStudy& study, DrawnCurve::Kind kind, double xFactor,
              std::optional<double> here, const QLocale& locale) {
    for (std::size_t i = 0; i < study.lines.size(); ++i) {
        const CurveLine& from = study.lines[i];
        const bool isHere = !from.family || from.family == here;
        GraphData points = linePoints(from, xFactor, picture.valueFactor);
        if (!points) continue;
        picture.lines.append({kind, nameOf(kind, familyName(study, from, locale), isHere), points,
                              static_cast<int>(i), isHere && kind == DrawnCurve::Kind::curve});
    }
}

void addMarks(CurvePicture& picture, const CurvePageStudy& study) {
    for (int i = 0; i < picture.lines.size(); ++i)
        if (picture.lines[i].kind == DrawnCurve::Kind::curve &&
            (picture.lines[i].isHere || picture.marked < 0 || !picture.lines[picture.marked].isHere))
            picture.marked = i;
    for (std::size_t i = 0; i < study.curve.lines.size(); ++i) {
        const bool isNamed = picture.marked >= 0 && picture.lines[picture.marked].number == int(i);
        for (const CurveFeature& feature : study.curve.lines[i].outputs.front().features) {
            if (!isMarked(feature)) continue;
            const CurveMark mark = markOf(feature, picture.x.factor, picture.valueFactor);
            if (isNamed)
                picture.marks.append(mark);
            else if (mark.kind != CurveMark::Kind::kink)
                picture.extremes.append(mark.at);
        }
        if (!picture.goal) continue;
        for (const CurveMark& mark : goalMarks(study.curve.lines[i], *picture.goal, picture.x.factor))
            if (isNamed)
                picture.marks.append(mark);
            else
                picture.extremes.append(mark.at);
    }
}

/// Around the value of each preset, as wide as can be seen, but no further than halfway to the next.
void addBands(CurvePicture& picture, const CurveQuestion& question, std::span<const Preset> presets) {
    constexpr double halfWidth = 0.012;  // of the range
    const CurveRange range{picture.from, picture.to, question.range().spacing};
    const std::vector<PresetPlace> places = presetPlaces(presets, *question.along.parameter, question.base);
    const auto shareOf = [&](const PresetPlace& place) { return range.shareOf(place.si * picture.x.factor); };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double at = places[i].si * picture.x.factor;
        if (at < picture.from || at > picture.to) continue;
        const double share = shareOf(places[i]);
        const double before = i == 0 ? 1 : (share - shareOf(places[i - 1])) / 2;
        const double after = i + 1 == places.size() ? 1 : (shareOf(places[i + 1]) - share) / 2;
        picture.bands.append({places[i].name, range.at(share - std::min(halfWidth, before)),
                              range.at(share + std::min(halfWidth, after)), at});
    }
}

/// A number as the summary shows it.
QString shownText(double value, const ShownUnit& unit, const QLocale& locale) {
    const QString number = numberText(value, 5, locale);
    return unit.unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit.unit;
}

/// Describes where a line reaches the goal, how well that is known, and whether there may be others.
QString goalWords(const CurvePicture& picture, const CurveLine& line, const QLocale& locale) {
    const QString goal = QStringLiteral("%1 = %2").arg(outputName(*picture.output),
                                                       shownText(*picture.goal, picture.value, locale));
    const GoalAnswer& answer = *line.goal;
    QStringList places;
    for (const GoalPlace& place : answer.places) {
        if (!place.isGiven()) continue;
        if (place.kind == GoalPlace::Kind::everywhere) return tr("%1 everywhere").arg(goal);
        const QString at = shownText(place.x.value * picture.x.factor, picture.x, locale);
        places << tr("%1 ± %2").arg(at, boundText(place.x.error * picture.x.factor, locale));
    }
    const bool isWhole = answer.isComplete;
    if (places.isEmpty() && !answer.nearest) return tr("nothing gives %1").arg(goal);
    if (places.isEmpty()) {
        const QString value =
            shownText(answer.nearest->value.value * picture.valueFactor, picture.value, locale);
        const QString at = shownText(answer.nearest->x.value * picture.x.factor, picture.x, locale);
        if (!isWhole) return tr("no known value gives %1: the nearest is %2 at %3").arg(goal, value, at);
        return tr("no %1 from %2 to %3 gives %4: the nearest is %5 at %6")
            .arg(picture.xName, shownText(picture.from, picture.x, locale),
                 shownText(picture.to, picture.x, locale), goal, value, at);
    }
    constexpr int mostTold = 6;
    if (places.size() > mostTold) return tr("%1 at %2 places").arg(goal).arg(places.size());
    return (isWhole ? tr("%1 at %2, nowhere else in this range") : tr("%1 at %2, perhaps elsewhere too"))
        .arg(goal, places.join(QStringLiteral("; ")));
}

/// Describes where another line reaches a goal that the marked one does not: "γ = 0.3 does at 140 MN/m", "γ =
/// 1 is above it everywhere". Empty if that is not known.
QString otherGoalWords(const CurvePicture& picture, const DrawnCurve& drawn, const CurveLine& line,
                       const QLocale& locale) {
    for (const GoalPlace& place : line.goal->places)
        if (place.isGiven() && place.kind != GoalPlace::Kind::everywhere)
            return tr("%1 does at %2")
                .arg(drawn.name, shownText(place.x.value * picture.x.factor, picture.x, locale));
    const CurveFeature* least = line.outputs.front().extreme(CurveFeature::Kind::minimum);
    const CurveFeature* most = line.outputs.front().extreme(CurveFeature::Kind::maximum);
    if (!line.goal->isComplete || !least || !most) return {};
    if (least->value.value * picture.valueFactor > *picture.goal)
        return tr("%1 is above it everywhere").arg(drawn.name);
    return most->value.value * picture.valueFactor < *picture.goal
               ? tr("%1 is below it everywhere").arg(drawn.name)
               : QString();
}

/// Describes all other lines in the same way, if the marked one does not reach the goal.
QStringList otherGoals(const CurvePicture& picture, const CurvePageStudy& study, const CurveLine& marked,
                       const QLocale& locale) {
    QStringList words;
    if (!marked.goal || marked.goal->isReached()) return words;
    for (const DrawnCurve& drawn : picture.lines) {
        if (drawn.kind != DrawnCurve::Kind::curve) continue;
        const CurveLine& line = study.curve.lines[static_cast<std::size_t>(drawn.number)];
        if (&line == &marked || !line.goal) continue;
        if (const QString other = otherGoalWords(picture, drawn, line, locale); !other.isEmpty())
            words << other;
    }
    return words;
}

/// Summary of the marked line.
QString summaryOf(const CurvePicture& picture, const CurvePageStudy& study, const QLocale& locale) {
    const DrawnCurve* line = picture.markedLine();
    if (!line) return tr("There is no answer anywhere in this range.");
    const CurveLine& marked = study.curve.lines[static_cast<std::size_t>(line->number)];
    const CurveOutput& output = marked.outputs.front();
    const auto shown = [&](double value, const ShownUnit& unit) { return shownText(value, unit, locale); };
    QStringList parts;
    if (marked.goal) parts << goalWords(picture, marked, locale);
    parts << otherGoals(picture, study, marked, locale);
    const auto extreme = [&](CurveFeature::Kind kind) {
        const CurveFeature* found = output.extreme(kind);
        return found && found->shape != CurveFeature::Shape::everywhere ? found : nullptr;
    };
    const auto placed = [&](const CurveFeature& feature, const QString& words) {
        const QString text = words.arg(shown(feature.value.value * picture.valueFactor, picture.value),
                                       shown(feature.x.value * picture.x.factor, picture.x));
        return feature.shape == CurveFeature::Shape::end ? tr("%1 (end of the range)").arg(text) : text;
    };
    const CurveFeature* least = extreme(CurveFeature::Kind::minimum);
    const CurveFeature* most = extreme(CurveFeature::Kind::maximum);
    if (least && most)
        parts << tr("%1 is between %2 and %3")
                     .arg(outputName(*picture.output), placed(*least, tr("%1 at %2")),
                          placed(*most, tr("%1 at %2")));
    else if (most)
        parts << placed(*most, tr("largest %1 at %2"));
    else if (least)
        parts << placed(*least, tr("least %1 at %2"));
    QStringList crossings;
    for (const CurveFeature& feature : output.features)
        if (feature.kind == CurveFeature::Kind::crossing)
            crossings << shown(feature.x.value * picture.x.factor, picture.x);
    constexpr int mostTold = 6;
    if (crossings.size() > mostTold)
        parts << tr("1 is crossed %1 times").arg(crossings.size());
    else if (!crossings.isEmpty())
        parts << tr("1 at %1").arg(crossings.join(QStringLiteral("; ")));
    QString text = line->name + QStringLiteral(": ") + parts.join(QStringLiteral(" · "));
    if (study.question.isSampled())
        text += tr(" · %1 points").arg(study.curve.lines.front().points.size());
    else if (!output.grid.empty())
        text += tr(" · only points known in a part of the range");
    if (!output.unsolved.empty())
        text += tr(" · no answer in a part of the range: %1").arg(translated(output.unsolved.front().reason));
    return text;
}

}  // namespace

GraphData linePoints(const CurveLine& line, double xFactor, double valueFactor) {
    QVector<QCPGraphData> points;
    bool any = false;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double value = line.values.front()[i] * valueFactor;
        any |= std::isfinite(value);
        points.append({line.points[i] * xFactor, value});
    }
    return any ? graphData(points) : GraphData();
}

CurvePicture curvePicture(const CurvePageStudy& study, const ShownUnits& units, const Unit& xUnit,
                          std::optional<double> here, std::span<const Preset> presets,
                          const QLocale& locale) {
    const CurveQuestion& question = study.question.curve;
    const OutputColumn& column = question.columns.front();
    CurvePicture picture;
    picture.xName = parameterName(*question.along.parameter);
    picture.x = shownUnit(xUnit);
    picture.from = question.along.start * picture.x.factor;
    picture.to = question.along.stop * picture.x.factor;
    picture.logarithmic = question.along.kind == SweepAxis::Kind::logarithmic;
    picture.output = column.output;
    picture.value = columnUnit(column, units, largestOf(study.curve));
    // Columns in SI were scaled by the study, in which the scales may change along the parameter.
    const bool isScaled = !column.output->isOnlySi();
    picture.valueFactor = picture.value.factor / (isScaled ? column.scale(scalesOf(question.base)) : 1);
    if (question.goal) picture.goal = *question.goal * picture.valueFactor;
    addAbove(picture, question);
    addLines(picture, study.curve, DrawnCurve::Kind::curve, picture.x.factor, here, locale);
    addMarks(picture, study);
    if (study.reference) {
        const bool isStiffness = question.along.key() == "bit_rock.stiffness";
        const double perBeta = isStiffness ? scalesOf(question.base).stiffness : 1;
        addLines(picture, *study.reference, DrawnCurve::Kind::reference, perBeta * picture.x.factor, here,
                 locale);
    }
    if (study.closedForm)
        addLines(picture, *study.closedForm, DrawnCurve::Kind::closedForm, picture.x.factor, here, locale);
    addBands(picture, question, presets);
    picture.summary = summaryOf(picture, study, locale);
    return picture;
}

}  // namespace drillwave
