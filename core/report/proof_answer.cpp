// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/proof_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/model/blow_traits.h"
#include "core/numeric/run_time.h"
#include "core/report/accuracy_columns.h"
#include "core/report/accuracy_report.h"
#include "core/report/stability_report.h"

namespace drillwave {

namespace {

constexpr double leastError = 1e-17;  // below, a double cannot show e
constexpr double leastRatio = 1e-6;   // farther from a limit is all the same

// Parts of figures and tables.

FigureNumber magnitude(double value) {
    return {.value = value, .quantity = PlainNumber::magnitude};
}

FigureNumber seconds(double value) {
    return {.value = value, .quantity = PlainNumber::runTime};
}

FigureNumber wholeNumber(std::size_t value) {
    constexpr int all = 15;  // digits
    return {.value = double(value), .digits = all};
}

FigureNumber words(Message message) {
    return {.words = std::move(message)};
}

FigureAxis decades(const char* title) {
    return {.title = title, .quantity = PlainNumber::magnitude, .isLogarithmic = true};
}

void addPoint(FigureSeries& series, double x, double y, std::size_t row) {
    series.x.push_back(x);
    series.y.push_back(y);
    series.rows.push_back(row);
}

StudyTable tableWith(const auto& columns) {
    StudyTable table;
    for (const auto& column : columns)
        if (!column.title.empty()) table.columns.push_back({Message::ofTable(column.title), {}});
    return table;
}

/// The first cell is the name of the row.
void addRow(StudyTable& table, const std::vector<std::string>& cells) {
    table.rows.push_back({cells.front(), {}});
    table.cells.emplace_back();
    for (std::size_t i = 1; i < cells.size(); ++i) table.cells.back().push_back({cells[i]});
}

// A uniform rod.

bool isLattice(const AccuracyRow& row, LatticeWaves waves) {
    return row.choice.method == Method::lattice && row.choice.lattice.waves == waves;
}

Message rowName(const AccuracyRow& row) {
    if (row.choice.method == Method::exact) return translatable("exact");
    if (row.choice.method == Method::closedForm) return translatable("closed form");
    return {isLattice(row, LatticeWaves::moved) ? translatable("lattice, moved waves, %1")
                                                : translatable("lattice, ring buffer, %1"),
            {std::to_string(row.choice.lattice.segments)}};
}

/// Decades and the paper's own choice.
FigureText segmentsLabel(const AccuracyRow& row) {
    const int segments = row.choice.lattice.segments;
    if (segments == paperSegments && isLattice(row, LatticeWaves::moved))
        return {translatable("%1, the paper's choice"), {wholeNumber(paperSegments)}};
    const bool isDecade = segments == 100 || segments == 1'000 || segments == 10'000;
    return isDecade ? FigureText{"%1", {wholeNumber(std::size_t(segments))}} : FigureText();
}

std::vector<FigureText> captionOf(const Accuracy& accuracy) {
    if (accuracy.rows.empty()) return {};
    const AccuracyRow& exact = accuracy.rows.front();
    if (std::isnan(exact.corError))
        return {{translatable("The exact solution has nothing to compare with: %1"),
                 {words(accuracy.extended.reason)}}};
    std::vector<FigureText> caption{
        {translatable("e is right to %1 in %2"), {magnitude(exact.corError), seconds(exact.time.median)}}};
    for (const AccuracyRow& row : accuracy.rows)
        if (isLattice(row, LatticeWaves::moved) && row.choice.lattice.segments == paperSegments &&
            row.outcome == Outcome::rebounded)
            caption.push_back(
                {translatable("the paper's %1 segments give %2 in %3"),
                 {wholeNumber(paperSegments), magnitude(row.corError), seconds(row.time.median)}});
    return caption;
}

StudyFigure figureOf(const Accuracy& accuracy) {
    StudyPanel panel{.x = decades(translatable("processor time of a solve for e [s]")),
                     .y = decades(translatable("error of e"))};
    const auto add = [&](FigureSeries series, const auto& belongs) {
        for (std::size_t i = 0; i < accuracy.rows.size(); ++i) {
            const AccuracyRow& row = accuracy.rows[i];
            if (row.outcome != Outcome::rebounded || !belongs(row) || !(row.time.median > 0)) continue;
            addPoint(series, row.time.median, std::max(row.corError, leastError), i);
            series.texts.push_back(row.choice.method == Method::lattice ? segmentsLabel(row) : FigureText());
        }
        if (!series.x.empty()) panel.series.push_back(std::move(series));
    };
    add({.legend = translatable("exact"), .points = SeriesPoints::stars},
        [](const AccuracyRow& row) { return row.choice.method == Method::exact; });
    add({.role = SeriesRole::second,
         .legend = translatable("lattice, moved waves"),
         .points = SeriesPoints::joined},
        [](const AccuracyRow& row) { return isLattice(row, LatticeWaves::moved); });
    add({.role = SeriesRole::third,
         .legend = translatable("lattice, ring buffer"),
         .points = SeriesPoints::joined,
         .textSide = TextSide::below},
        [](const AccuracyRow& row) { return isLattice(row, LatticeWaves::ring); });
    add({.role = SeriesRole::fourth, .legend = translatable("closed form"), .points = SeriesPoints::apart},
        [](const AccuracyRow& row) { return row.choice.method == Method::closedForm; });
    return {.caption = captionOf(accuracy), .panels = {panel}};
}

StudyTable tableOf(const Accuracy& accuracy, const ReadingStyle& style) {
    StudyTable table = tableWith(accuracyColumns);
    for (AccuracyRow row : accuracy.rows) {
        // These two follow from all rows, so they come last.
        if (!accuracy.isRelated) row.observedOrder = row.speed = std::nan("");
        const std::string name = style.said(rowName(row));
        addRow(table, row.outcome == Outcome::rebounded
                          ? withCells(name, accuracyColumns, row, style)
                          : std::vector<std::string>{name, style.said(row.reason)});
    }
    return table;
}

// A drill string.

Message rowName(const StringAccuracyRow& row) {
    if (row.method == StringMethod::quick) return translatable("polynomial cells (studies)");
    return row.method == StringMethod::sure ? translatable("cut cells (a blow)")
                                            : translatable("plain lattice");
}

std::vector<FigureText> captionOf(const StringAccuracy& accuracy) {
    std::vector<FigureText> caption;
    const auto add = [&](const StringAccuracyRow& row, const char* pattern) {
        caption.push_back({pattern, {magnitude(row.error), seconds(row.time.median)}});
    };
    // The cells that are usual come first of their method, the finest lattice last.
    const auto sure = std::ranges::find(accuracy.rows, StringMethod::sure, &StringAccuracyRow::method);
    const auto quick = std::ranges::find(accuracy.rows, StringMethod::quick, &StringAccuracyRow::method);
    if (sure == accuracy.rows.end()) return {};
    add(*sure, translatable("efficiency right to %1 in %2"));
    if (quick != accuracy.rows.end()) add(*quick, translatable("in studies to %1 in %2"));
    if (accuracy.rows.back().method == StringMethod::plain)
        add(accuracy.rows.back(), translatable("plain lattice %1 in %2"));
    return caption;
}

StudyFigure figureOf(const StringAccuracy& accuracy) {
    StudyPanel panel{.x = decades(translatable("processor time of a solve [s]")),
                     .y = decades(translatable("error of the efficiency"))};
    for (std::size_t i = 0; i < accuracy.rows.size(); ++i) {
        const StringAccuracyRow& row = accuracy.rows[i];
        if (!(row.time.median > 0)) continue;
        if (panel.series.empty() || panel.series.back().legend != rowName(row))
            panel.series.push_back(
                {.role = static_cast<SeriesRole>(row.method),
                 .legend = rowName(row),
                 .points = SeriesPoints::joined,
                 .textSide = row.method == StringMethod::sure ? TextSide::above : TextSide::below});
        FigureSeries& series = panel.series.back();
        addPoint(series, row.time.median, std::max(row.error, leastError), i);
        // Only the finest: the table shows the others.
        series.texts.assign(series.x.size(), {});
        series.texts.back() = {translatable("cells of %1"), {seconds(row.cell)}};
    }
    return {.caption = captionOf(accuracy), .panels = {panel}};
}

StudyTable tableOf(const StringAccuracy& accuracy, const ReadingStyle& style) {
    StudyTable table = tableWith(stringAccuracyColumns);
    for (const StringAccuracyRow& row : accuracy.rows)
        addRow(table, withCells(style.said(rowName(row)), stringAccuracyColumns, row, style));
    return table;
}

Message reasonOf(const Accuracy& accuracy) {
    return accuracy.exact.reason;
}

Message reasonOf(const StringAccuracy& accuracy) {
    return accuracy.reason;
}

Message gapOf(const Message& reason, bool isStopped) {
    if (isStopped) return translatable("it was stopped");
    return reason.isEmpty() ? Message() : Message(translatable("could not be solved: %1"), {reason});
}

template <class Result>
class AccuracyAnswer : public StudyAnswer {
  public:
    AccuracyAnswer(const Scenario& scenario, const Result& result, double runTime)
        : StudyAnswer(scenario), m_result(result), m_runTime(runTime) {}

    Message gap() const override { return gapOf(reasonOf(m_result), m_result.isStopped); }
    bool hasRows() const override { return !m_result.rows.empty(); }
    StudyFigure figure(std::size_t /*view*/) const override { return figureOf(m_result); }
    StudyTable table(const ReadingStyle& style) const override { return tableOf(m_result, style); }
    std::string text(const ReadingStyle& style) const override {
        return accuracyText(scenario(), m_result, style);
    }
    std::string json(const std::string& scenarioText) const override {
        return accuracyJson({.scenario = scenario(), .scenarioText = scenarioText, .runTime = m_runTime},
                            m_result);
    }
    std::string csv(OutputUnits /*units*/) const override { return accuracyCsv(m_result); }

  private:
    Result m_result;
    double m_runTime;
};

class StabilityAnswer : public StudyAnswer {
  public:
    StabilityAnswer(const StabilityReport& report, double runTime)
        : StudyAnswer({}), m_report(report), m_runTime(runTime), m_order(report.rows.size()) {
        std::vector<double> ratios;
        for (const StabilityRow& row : report.rows) ratios.push_back(worstOf(row).ratio);
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        std::ranges::stable_sort(m_order, std::ranges::greater(), [&](std::size_t i) { return ratios[i]; });
    }

    Message gap() const override { return gapOf({}, m_report.stopped); }
    bool hasRows() const override { return !m_order.empty(); }
    StudyFigure figure(std::size_t view) const override;
    StudyTable table(const ReadingStyle& style) const override;
    std::optional<Scenario> scenarioOfRow(std::size_t row) const override {
        return drillwave::scenarioOf(rowAt(row).stabilityCase);
    }
    std::string text(const ReadingStyle& style) const override { return stabilityText(m_report, style); }
    std::string json(const std::string& /*scenarioText*/) const override {
        return stabilityJson(m_report, m_runTime);
    }
    std::string csv(OutputUnits /*units*/) const override { return stabilityCsv(m_report); }

  private:
    const StabilityRow& rowAt(std::size_t row) const { return m_report.rows[m_order[row]]; }
    std::vector<FigureText> caption() const;

    StabilityReport m_report;
    double m_runTime;
    std::vector<std::size_t> m_order;  // rows of the report, the worst first
};

std::vector<FigureText> StabilityAnswer::caption() const {
    if (m_order.empty()) return {};
    const std::size_t bad = m_report.failed() + m_report.notSolved();
    std::vector<FigureText> caption{
        bad == 0 ? FigureText{translatable("%1 cases, all passed"), {wholeNumber(m_order.size())}}
                 : FigureText{translatable("%1 of %2 cases failed"),
                              {wholeNumber(bad), wholeNumber(m_order.size())}}};
    const StabilityWorst worst = worstOf(rowAt(0));
    const FigureNumber name = words(rowAt(0).stabilityCase.name);
    if (std::isfinite(worst.ratio))
        caption.push_back(
            {translatable("the worst: %1, %2 at %3 of its limit"),
             {name, words(Message::ofTable(worst.measure)), {.value = worst.ratio, .digits = 2}}});
    else
        caption.push_back({translatable("not solved: %1"), {name}});
    return caption;
}

StudyFigure StabilityAnswer::figure(std::size_t /*view*/) const {
    constexpr auto measures = std::to_array<std::string_view>(
        {translatable("momentum"), translatable("energy"), translatable("continuity"), translatable("limit"),
         translatable("lattice"), translatable("pull"), translatable("stated error"),
         translatable("return")});
    constexpr std::size_t colours = 4;
    StudyPanel panel{.x = decades(translatable("stiffness over elasticity β/γ, the stiffest rate [1/t₀]")),
                     .y = decades(translatable("worst check over its limit"))};
    for (const std::string_view measure : measures) {
        FigureSeries series{.role = static_cast<SeriesRole>(panel.series.size() % colours),
                            .legend = Message::ofTable(measure),
                            .points = SeriesPoints::apart};
        for (std::size_t i = 0; i < m_order.size(); ++i) {
            const StabilityWorst worst = worstOf(rowAt(i));
            const Groups& groups = rowAt(i).stabilityCase.groups;
            if (worst.measure == measure)
                addPoint(series, groups.beta / groups.gamma, std::max(worst.ratio, leastRatio), i);
        }
        if (!series.x.empty()) panel.series.push_back(std::move(series));
    }
    return {.caption = caption(),
            .panels = {panel},
            .levels = {{.name = translatable("a case above has failed"), .y = 1}},
            .paperHeight = 120};
}

StudyTable StabilityAnswer::table(const ReadingStyle& style) const {
    StudyTable table{.columns = {{translatable("worst check"), {}},
                                 {translatable("of its limit"), {}},
                                 {translatable("shape"), {}},
                                 {std::string("β"), {}},
                                 {std::string("γ"), {}},
                                 {std::string("τ"), {}},
                                 {std::string("δ"), {}},
                                 {std::string("e"), {}},
                                 {translatable("error of e"), {}},
                                 {translatable("pieces"), {}}}};
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const StabilityRow& row = rowAt(i);
        const Groups& groups = row.stabilityCase.groups;
        const bool isSolved = row.outcome == Outcome::rebounded;
        const StabilityWorst worst = worstOf(row);
        const double none = std::nan("");
        addRow(table,
               {row.stabilityCase.name, style.said(Message::ofTable(worst.measure)),
                isSolved ? style.number(100 * worst.ratio, 2) + " %" : style.said(row.reason),
                style.name(name(row.stabilityCase.shape)), style.number(groups.beta, 4),
                style.number(groups.gamma, 4), style.number(groups.tau, 4), style.number(groups.delta, 4),
                isSolved ? style.number(row.cor, 4) : shownNumber(none, NumberStyle::error, style),
                shownNumber(isSolved ? row.corError : none, NumberStyle::error, style),
                shownNumber(double(row.pieces), NumberStyle::count, style)});
    }
    return table;
}

}  // namespace

StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const Accuracy& accuracy, double runTime) {
    return std::make_shared<const AccuracyAnswer<Accuracy>>(scenario, accuracy, runTime);
}

StudyAnswerPtr accuracyAnswer(const Scenario& scenario, const StringAccuracy& accuracy, double runTime) {
    return std::make_shared<const AccuracyAnswer<StringAccuracy>>(scenario, accuracy, runTime);
}

StudyAnswerPtr stabilityAnswer(const StabilityReport& report, double runTime) {
    return std::make_shared<const StabilityAnswer>(report, runTime);
}

StudyAnswerPtr studyAccuracy(const Scenario& scenario, const std::vector<int>& ladder,
                             const StudyWork& work) {
    const Stopwatch watch;
    const auto show = [&](auto soFar) {
        soFar.isStopped = true;  // rows are missing
        if (work.show) work.show(accuracyAnswer(scenario, soFar, watch.seconds()));
    };
    if (isFollowedByEvents(scenario)) {
        const Accuracy accuracy = measureAccuracy(scenario, ladder, work.stop, work.progress, show);
        return accuracyAnswer(scenario, accuracy, watch.seconds());
    }
    const StringAccuracy accuracy =
        measureStringAccuracy(scenario, work.stop, [&](const StringAccuracy& soFar, double done) {
            work.progress(done);
            show(soFar);
        });
    return accuracyAnswer(scenario, accuracy, watch.seconds());
}

}  // namespace drillwave
