// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/design_figure.h"

#include <algorithm>
#include <cmath>

#include "core/model/scales.h"
#include "core/report/output_words.h"
#include "core/report/parameter_words.h"
#include "core/text/printed_text.h"

namespace drillwave {
namespace {

constexpr double heightBelow = 0.8;     // ratio of the heights of a lower panel and the first one
constexpr std::size_t mostBeads = 40;   // beyond, they would be a line
constexpr std::uint64_t leastRows = 4;  // fewer rows are drawn as curves with a band
constexpr double barHalfWidth = 0.4;

FigureAxis axisOf(const DesignReport& report, const DesignAim& aim, Message title) {
    double largest = 0;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d)
        if (const double value = std::abs(aimedValue(report, aim, d).value); std::isfinite(value))
            largest = std::max(largest, value);
    return {.title = std::move(title), .quantity = figureQuantity({aim.output}, largest)};
}

FigureAxis axisOf(const SweepAxis& choice, const DesignNames& names, double room) {
    if (choice.parameter)
        return {.quantity = choice.parameter,
                .isLogarithmic = choice.isLogarithmic(),
                .range = choice.range(room)};
    FigureAxis axis{.title = names.choice(choice), .range = std::pair(-0.5, double(choice.count) - 0.5)};
    for (std::uint64_t i = 0; i < choice.count; ++i)
        axis.names.push_back({"%1", {{.words = names.choiceValue(choice, choice.value(i))}}});
    return axis;
}

bool hasField(const DesignStudy& study) {
    const auto isRange = [](const SweepAxis& axis) {
        return axis.kind == SweepAxis::Kind::linear || axis.kind == SweepAxis::Kind::logarithmic;
    };
    return study.choices.size() == 2 && isRange(study.choices[0]) && isRange(study.choices[1]) &&
           study.choices[0].count >= leastRows && study.choices[1].count >= 2;
}

/// The upper panel of a study.
class ObjectivePanel {
  public:
    ObjectivePanel(const DesignReport& report, const DesignNames& names, DesignMarks marks)
        : m_report(report),
          m_study(report.study),
          m_aim(report.study.aims.front()),
          m_names(names),
          m_each(m_study.choices.empty() ? 1 : m_study.choices.back().count),
          m_isField(hasField(m_study)),
          m_marks(marks) {}

    StudyPanel panel() {
        const FigureAxis values = axisOf(m_report, m_aim, outputMessage(*m_aim.output));
        constexpr double room = 0.03;
        m_panel.y = values;
        m_panel.x = m_study.choices.empty() ? FigureAxis{.range = std::pair(-0.5, 0.5),
                                                         .names = {{translatable("this scenario")}}}
                                            : axisOf(m_study.choices.back(), m_names, room);
        if (m_isField) addField(values.quantity);
        addBand();
        addMarks();
        addObjectives();
        return std::move(m_panel);
    }

  private:
    double objective(std::size_t design) const { return ordinate(aimedValue(m_report, m_aim, design).value); }
    double statistic(std::size_t design, const Statistic& statistic) const {
        return ordinate(aimedValue(m_report, {Sense::largest, m_aim.output, statistic}, design).value);
    }
    double nominal(std::size_t design) const {
        const std::size_t output = m_study.placeOf(*m_aim.output, {}).output;
        return ordinate(m_report.findings.designs[design].nominal[output]);
    }
    double ordinate(double value) const { return designOrdinate(m_study, *m_aim.output, value); }
    double along(std::size_t design) const {
        const bool isNumber = !m_study.choices.empty() && m_study.choices.back().parameter;
        return isNumber ? m_study.choice(design).back() : double(design % m_each);
    }

    /// Returns a series as a curve over the last design variable, from the design `first` on. It is empty
    /// where the panel has a field.
    FigureSeries over(std::size_t first, FigureSeries series, auto value) const {
        for (std::size_t d = first; !m_isField && d < first + m_each; ++d) {
            series.x.push_back(along(d));
            series.y.push_back(value(d));
        }
        return series;
    }

    void addBand() {
        const std::size_t family = *m_report.findings.best.robust / m_each, first = family * m_each;
        const auto legend = [&](const char* words) { return m_isField ? Message() : Message(words); };
        using Kind = Statistic::Kind;
        FigureSeries band = over(first,
                                 {.role = static_cast<SeriesRole>(family),
                                  .stroke = SeriesStroke::none,
                                  .legend = legend(translatable("5 % to 95 %")),
                                  .isFilled = true},
                                 [&](std::size_t d) {
                                     return statistic(d, {Kind::quantile, 95});
                                 });
        band.upper = over(first, {}, [&](std::size_t d) { return statistic(d, {Kind::quantile, 5}); }).y;
        m_panel.series.push_back(std::move(band));
        m_panel.series.push_back(
            over(first, {.stroke = SeriesStroke::dashed, .legend = legend(translatable("mean"))},
                 [&](std::size_t d) { return statistic(d, {Kind::mean}); }));
        m_panel.series.push_back(over(
            first,
            {.stroke = SeriesStroke::shortDashed, .legend = legend(translatable("with the values entered"))},
            [&](std::size_t d) { return nominal(d); }));
    }

    void addMark(FigureSeries& series, std::size_t design, double value) const {
        series.x.push_back(along(design));
        series.y.push_back(m_isField ? m_study.choice(design).front() : value);
    }

    /// Each mark is named with its design.
    void addMarks() {
        const BestDesigns& best = m_report.findings.best;
        const auto named = [&](const char* words, std::size_t design) {
            return about(words, m_names.design(design));
        };
        FigureSeries present{.points = SeriesPoints::here};
        if (const auto design = presentDesign(m_study); design && m_report.findings.designs.size() > 1) {
            present.legend = {translatable("present design: %1"), {m_names.design(*design)}};
            if (m_marks == DesignMarks::all) addMark(present, *design, nominal(*design));
        }
        const char* robustName = best.ties.empty() ? translatable("best for uncertain rock")
                                                   : translatable("best, by less than the error");
        FigureSeries robust{.legend = named(robustName, *best.robust), .points = SeriesPoints::diamonds};
        addMark(robust, *best.robust, objective(*best.robust));
        FigureSeries ties{.points = SeriesPoints::circles};
        if (!best.ties.empty()) ties.legend = translatable("equally good");
        for (const std::size_t tie : best.ties) addMark(ties, tie, objective(tie));
        FigureSeries entered{.points = SeriesPoints::openDiamonds};
        if (best.nominal) {
            entered.legend = named(translatable("best for the values entered"), *best.nominal);
            addMark(entered, *best.nominal, nominal(*best.nominal));
        }
        for (FigureSeries* each : {&present, &ties, &entered, &robust})
            m_panel.series.push_back(std::move(*each));
    }

    /// Adds a curve of the objective for each combination of the other design variables.
    void addObjectives() {
        if (m_isField) return;
        const std::size_t count = m_report.findings.designs.size();
        m_panel.hasRowsAlongX = count == m_each;
        m_panel.marked = m_panel.series.size() + *m_report.findings.best.robust / m_each;
        for (std::size_t first = 0; first < count; first += m_each) {
            FigureSeries series{.role = static_cast<SeriesRole>(first / m_each),
                                .legend = statisticMessage(m_aim.statistic, m_aim.sense),
                                .points = m_each <= mostBeads ? SeriesPoints::beads : SeriesPoints::none};
            if (m_panel.series.size() == m_panel.marked) series.stroke = SeriesStroke::wide;
            const std::vector<double> values = m_study.choice(first);
            std::string name;
            for (std::size_t c = 0; c + 1 < values.size(); ++c)
                name += (c == 0 ? "" : ", ") + m_names.choiceValue(m_study.choices[c], values[c]);
            if (!name.empty()) series.legend = name;
            for (std::size_t i = 0; i < m_each; ++i) series.rows.push_back(first + i);
            m_panel.series.push_back(
                over(first, std::move(series), [&](std::size_t d) { return objective(d); }));
        }
    }

    /// The last design variable is along x, the first along y.
    void addField(const FigureQuantity& quantity) {
        const SweepAxis &x = m_study.choices.back(), &y = m_study.choices.front();
        std::vector<double> xs, ys;
        for (std::uint64_t i = 0; i < x.count; ++i) xs.push_back(x.value(i));
        for (std::uint64_t i = 0; i < y.count; ++i) ys.push_back(y.value(i));
        auto grid = std::make_shared<MapGrid>(std::move(xs), std::move(ys));
        for (std::size_t d = 0; d < m_report.findings.designs.size(); ++d) {
            const double value = objective(d);
            const Message& reason = m_report.findings.designs[d].reason;
            if (std::isfinite(value))
                grid->set(d % m_each, d / m_each, value);
            else if (!reason.isEmpty())
                grid->fail(d % m_each, d / m_each, reason);
        }
        m_panel.x = axisOf(x, m_names, 0.5 / double(x.count - 1));  // half a step
        m_panel.y = axisOf(y, m_names, 0.5 / double(y.count - 1));
        m_panel.field = FigureField{.grid = std::move(grid),
                                    .scale = {.title = m_names.aim(m_aim), .quantity = quantity},
                                    .hasRows = true};
    }

    const DesignReport& m_report;
    const DesignStudy& m_study;
    const DesignAim& m_aim;
    const DesignNames& m_names;
    const std::size_t m_each;  // designs that differ in the last design variable only
    const bool m_isField;
    const DesignMarks m_marks;
    StudyPanel m_panel;
};

/// Returns the range of all values with room at both ends; empty without any.
std::optional<std::pair<double, double>> rangeAround(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    const auto [low, high] = std::ranges::minmax(values);
    const double room = std::max(0.08 * (high - low), 0.005 * std::abs(low + high));
    return std::pair(low - room, high + room);
}

StudyPanel tradeOffPanel(const DesignReport& report, const DesignNames& names) {
    const std::vector<DesignAim>& aims = report.study.aims;
    FigureSeries all{.points = SeriesPoints::rings}, pareto{.points = SeriesPoints::discs},
        best{.points = SeriesPoints::diamonds};
    std::vector<double> xs, ys;
    for (std::size_t d = 0; d < report.findings.designs.size(); ++d) {
        const auto value = [&](const DesignAim& aim) {
            return designOrdinate(report.study, *aim.output, aimedValue(report, aim, d).value);
        };
        const double x = value(aims[0]), y = value(aims[1]);
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        xs.push_back(x);
        ys.push_back(y);
        const auto add = [&](FigureSeries& series) {
            series.x.push_back(x);
            series.y.push_back(y);
            series.rows.push_back(d);
        };
        add(report.findings.best.pareto[d] ? pareto : all);
        if (d == *report.findings.best.robust) add(best);
    }
    StudyPanel panel{.x = axisOf(report, aims[0],
                                 {translatable("%1\n(filled dots: no other design is better in both)"),
                                  {names.aim(aims[0])}}),
                     .y = axisOf(report, aims[1], outputMessage(*aims[1].output)),
                     .series = {std::move(all), std::move(pareto), std::move(best)}};
    panel.x.range = rangeAround(xs);
    panel.y.range = rangeAround(ys);
    return panel;
}

void addBar(FigureSeries& bars, double place, double length) {
    const double low = place - barHalfWidth, high = place + barHalfWidth, end = std::clamp(length, 0.0, 1.0);
    bars.x.insert(bars.x.end(), {0, end, end, 0});
    bars.y.insert(bars.y.end(), {low, low, high, high});
}

/// A group of bars for each output, below its name: the shares with interactions, and filled those without.
StudyPanel causesPanel(const DesignReport& report) {
    const DesignStudy& study = report.study;
    const std::vector<OutputSensitivity>& outputs = report.findings.sensitivity.outputs;
    StudyPanel panel{.x = {.title = translatable("share of the scatter\n(filled: without interactions)"),
                           .range = std::pair(0.0, 1.02)},
                     .series = {{.stroke = SeriesStroke::none}}};
    std::vector<FigureText>& names = panel.y.names;  // from the lowest to the top
    for (std::size_t o = outputs.size(); o-- > 0;) {
        const std::vector<SobolIndex>& indices = outputs[o].indices;
        FigureSeries total{.kind = SeriesKind::area, .role = static_cast<SeriesRole>(o)}, first = total;
        first.stroke = SeriesStroke::strong;
        for (std::size_t i = indices.size(); i-- > 0;) {
            addBar(total, double(names.size()), indices[i].total.value);
            addBar(first, double(names.size()), indices[i].first.value);
            names.push_back({translatable("draws")});
            if (i >= study.uncertain.size()) continue;
            const Parameter& parameter = *study.uncertain[i].parameter;
            names.back() = {"%1", {{.words = titleMessage(parameter, printedWords(parameter.symbol))}}};
        }
        FigureSeries& titles = panel.series.front();
        titles.x.push_back(0);
        titles.y.push_back(double(names.size()) - barHalfWidth);
        titles.texts.push_back({indices.empty() ? translatable("%1: no scatter") : "%1",
                                {{.words = outputMessage(*report.findings.aimed[o])}}});
        names.emplace_back();
        panel.series.push_back(std::move(total));
        panel.series.push_back(std::move(first));
    }
    panel.y.range = std::pair(-0.6, double(names.size()) - 0.4);
    return panel;
}

}  // namespace

double designOrdinate(const DesignStudy& study, const Output& output, double value) {
    return hasUnits(study.base) && !output.isOnlySi() ? value / output.scale(scalesOf(study.base)) : value;
}

StudyFigure designFigure(const DesignReport& report, const DesignNames& names, DesignMarks marks) {
    const DesignStudy& study = report.study;
    StudyFigure figure{.paperHeight = 180};
    figure.panels = {ObjectivePanel(report, names, marks).panel(), {.isHidden = true}, {.isHidden = true}};
    if (study.aims.size() > 1) figure.panels[1] = tradeOffPanel(report, names);
    if (study.dimensions() > 1 && carriesShares(study)) figure.panels[2] = causesPanel(report);
    for (const std::size_t i : {1, 2}) {
        figure.panels[i].row = 1;
        figure.panels[i].height = heightBelow;
        figure.panels[i].hasOwnY = true;
    }
    figure.summary = {{translatable("%1 of %2 designs, best for uncertain rock %3"),
                       {{.words = names.aim(study.aims.front())},
                        {.words = std::to_string(study.designCount())},
                        {.words = names.design(*report.findings.best.robust)}}}};
    return figure;
}

}  // namespace drillwave
