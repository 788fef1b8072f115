// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/design/design_picture.h"

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/report/design_words.h"
#include "ui/job/output_text.h"
#include "ui/pages/design/aim_rows.h"
#include "ui/pages/design/design_map.h"
#include "ui/pages/study/output_box.h"
#include "ui/pages/study/parameter_names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

/// The statistics of an answer, as numbers.
class AnswerReader {
  public:
    explicit AnswerReader(const DesignReport& report) : m_report(report) {}

    double value(std::uint64_t design, const Output& output, const Statistic& statistic) const {
        return aimedValue(m_report, {Sense::largest, &output, statistic}, design).value;
    }
    double nominal(std::uint64_t design, const Output& output) const {
        return m_report.findings.designs[design].nominal[m_report.study.placeOf(output, {}).output];
    }
    double aimed(std::uint64_t design, const DesignAim& aim) const {
        return aimedValue(m_report, aim, design).value;
    }

  private:
    const DesignReport& m_report;
};

double largestAimed(const AnswerReader& read, const DesignReport& report, const DesignAim& aim) {
    double largest = 0;
    for (std::uint64_t d = 0; d < report.findings.designs.size(); ++d)
        if (const double value = std::abs(read.aimed(d, aim)); std::isfinite(value))
            largest = std::max(largest, value);
    return largest;
}

void addSeries(DesignPicture& picture, const DesignReport& report, const DesignUnits& units) {
    const DesignStudy& study = report.study;
    const AnswerReader read(report);
    const DesignAim& aim = study.aims.front();
    const Output& output = *aim.output;
    const std::uint64_t each = study.choices.empty() ? 1 : study.choices.back().count;
    for (std::uint64_t d = 0; d < study.designCount(); ++d) {
        if (d % each == 0) {
            DesignSeries series;
            const std::vector<double> values = study.choice(d);
            for (std::size_t c = 0; c + 1 < values.size(); ++c)
                series.name +=
                    (c == 0 ? QString() : QStringLiteral(", ")) + units.text(study.choices[c], values[c]);
            picture.series.append(series);
        }
        DesignSeries& series = picture.series.last();
        const double x = study.choices.empty()     ? 0
                         : picture.words.isEmpty() ? study.choice(d).back() * picture.x.factor
                                                   : static_cast<double>(d % each);
        const auto point = [&](double value) { return QPointF(x, value * picture.value.factor); };
        const Statistic low{Statistic::Kind::quantile, 5}, high{Statistic::Kind::quantile, 95};
        series.designs.append(d);
        series.aim.append(point(read.aimed(d, aim)));
        series.low.append(point(read.value(d, output, low)));
        series.high.append(point(read.value(d, output, high)));
        series.mean.append(point(read.value(d, output, {Statistic::Kind::mean})));
        series.nominal.append(point(read.nominal(d, output)));
    }
    const BestDesigns& best = report.findings.best;
    const auto placeOf = [&](std::size_t design) {
        const DesignSeries& series = picture.series[static_cast<qsizetype>(design / each)];
        return std::pair(&series, static_cast<qsizetype>(design % each));
    };
    if (best.robust) {
        const auto [series, i] = placeOf(*best.robust);
        picture.robust = series->aim[i];
        picture.marked = static_cast<int>(*best.robust / each);
    }
    if (best.nominal) {
        const auto [series, i] = placeOf(*best.nominal);
        picture.nominal = series->nominal[i];
    }
    for (const std::size_t tie : best.ties) {
        const auto [series, i] = placeOf(tie);
        picture.ties.append(series->aim[i]);
    }
}

void addMap(DesignPicture& picture, const DesignReport& report, const DesignUnits& units) {
    picture.map = designMap(report, units, picture.value);
    const BestDesigns& best = report.findings.best;
    if (best.robust) picture.robust = placeOnMap(*picture.map, *best.robust);
    if (best.nominal) picture.nominal = placeOnMap(*picture.map, *best.nominal);
    for (const std::size_t tie : best.ties) picture.ties.append(placeOnMap(*picture.map, tie));
}

void addPareto(DesignPicture& picture, const DesignReport& report, const DesignUnits& units) {
    const std::vector<DesignAim>& aims = report.study.aims;
    if (aims.size() < 2) return;
    const AnswerReader read(report);
    const AimedOutput second = units.of(*aims[1].output, largestAimed(read, report, aims[1]));
    picture.firstAim = picture.value.unit.axisLabel(picture.aimName);
    picture.secondAim = second.unit.axisLabel(outputName(*aims[1].output));
    for (std::uint64_t d = 0; d < report.findings.designs.size(); ++d) {
        picture.designs.append(
            {read.aimed(d, aims[0]) * picture.value.factor, read.aimed(d, aims[1]) * second.factor});
        picture.pareto.append(report.findings.best.pareto[d]);
    }
    picture.robustNumber = static_cast<int>(*report.findings.best.robust);
}

void addBars(DesignPicture& picture, const DesignReport& report) {
    const DesignStudy& study = report.study;
    if (study.dimensions() < 2 || !carriesShares(study)) return;
    const Sensitivity& sensitivity = report.findings.sensitivity;
    for (std::size_t o = 0; o < sensitivity.outputs.size(); ++o) {
        DesignPicture::Bars bars{outputName(*report.findings.aimed[o]), {}};
        const OutputSensitivity& output = sensitivity.outputs[o];
        for (std::size_t i = 0; i < output.indices.size(); ++i) {
            const bool isInput = i < study.uncertain.size();
            const SobolIndex& index = output.indices[i];
            bars.bars.append({isInput ? parameterName(*study.uncertain[i].parameter) : drillwave::tr("draws"),
                              std::clamp(index.first.value, 0.0, 1.0),
                              std::clamp(index.total.value, 0.0, 1.0)});
        }
        picture.bars.append(bars);
    }
}

}  // namespace

AimedOutput DesignUnits::of(const Output& output, double size) const {
    AimedOutput shown{&output, outputUnit(output, m_units, size), 1};
    const bool isScaled = hasUnits(m_study->base) && !output.isOnlySi();
    shown.factor = shown.unit.factor / (isScaled ? output.scale(scalesOf(m_study->base)) : 1);
    return shown;
}

ShownUnit DesignUnits::of(const Parameter& parameter) const {
    return shownUnit(m_fieldUnit(parameter));
}

QString DesignUnits::text(const Parameter& parameter, double si) const {
    const ShownUnit unit = of(parameter);
    QString text = numberText(si * unit.factor, 4, m_locale);
    if (!unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + unit.unit;
    return text;
}

QString DesignUnits::text(const SweepAxis& choice, double value) const {
    if (choice.parameter) return text(*choice.parameter, value);
    std::string word;
    choice.column().appendText(word, value);
    return choice.words ? coreName(word) : coreText(word);
}

QString DesignUnits::text(const AimedOutput& output, double value, int digits) const {
    QString text = numberText(value * output.factor, digits, m_locale);
    if (!output.unit.unit.isEmpty()) text += QChar(QChar::Nbsp) + output.unit.unit;
    return text;
}

QString DesignUnits::designName(std::uint64_t design) const {
    QStringList names;
    const std::vector<double> values = m_study->choice(design);
    for (std::size_t i = 0; i < values.size(); ++i) names << text(m_study->choices[i], values[i]);
    return names.isEmpty() ? drillwave::tr("this scenario") : names.join(QStringLiteral(", "));
}

QString aimName(const DesignAim& aim) {
    return outputName(*aim.output) + QLatin1Char(' ') + statisticWords(aim.statistic, aim.sense);
}

QString choiceName(const SweepAxis& choice) {
    return choice.parameter ? parameterName(*choice.parameter) : coreName(choice.key());
}

QString aimWords(const DesignAim& aim) {
    return (aim.sense == Sense::largest ? AimRow::tr("largest %1") : AimRow::tr("smallest %1"))
        .arg(aimName(aim));
}

DesignPicture designPicture(const DesignReport& report, const DesignUnits& units) {
    const DesignStudy& study = report.study;
    const AnswerReader read(report);
    DesignPicture picture;
    if (!study.choices.empty()) {
        const SweepAxis& axis = study.choices.back();
        picture.xName = choiceName(axis);
        if (axis.parameter) picture.x = units.of(*axis.parameter);
        for (std::uint64_t i = 0; !axis.parameter && i < axis.count; ++i)
            picture.words.append(units.text(axis, axis.value(i)));
        picture.isLogarithmic = axis.kind == SweepAxis::Kind::logarithmic;
    }
    if (study.choices.empty()) picture.words.append(units.designName(0));
    picture.value = units.of(*study.aims.front().output, largestAimed(read, report, study.aims.front()));
    picture.aimName = aimName(study.aims.front());
    picture.statisticName = statisticWords(study.aims.front().statistic, study.aims.front().sense);
    if (hasMap(study))
        addMap(picture, report, units);
    else
        addSeries(picture, report, units);
    const BestDesigns& best = report.findings.best;
    picture.robustName = units.designName(*best.robust);
    if (best.nominal) picture.nominalName = units.designName(*best.nominal);
    if (const auto present = presentDesign(study); present && report.findings.designs.size() > 1)
        picture.presentName = units.designName(*present);
    addPareto(picture, report, units);
    addBars(picture, report);
    picture.summary = drillwave::tr("%1 of %2 designs, best for uncertain rock %3")
                          .arg(picture.aimName, QString::number(study.designCount()), picture.robustName);
    return picture;
}

}  // namespace drillwave
