// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/identify_report.h"

#include <algorithm>
#include <cmath>

#include "core/model/parameter.h"

namespace drillwave {

namespace {

constexpr double residualHeight = 0.55;  // over that of the record
constexpr double rockHeight = 0.95;
constexpr double alongHeight = 0.5;  // plot along several records over the one above it

FigureAxis timeAxis(const RecordAnswer& answer) {
    const MatchCurves& curves = answer.curves;
    const double length = curves.time.empty() ? 1e-3 : curves.time.back() - curves.time.front();
    return {.title = translatable("time t"), .quantity = SiValues{Quantity::time, length / 3}};
}

FigureAxis forceAxis(const RecordAnswer& answer, const char* title) {
    return {.title = title, .quantity = SiValues{Quantity::force, answer.peak}};
}

FigureSeries zeroLine(const RecordAnswer& answer) {
    FigureSeries line{.role = SeriesRole::fourth, .legend = translatable("zero line")};
    const MatchCurves& curves = answer.curves;
    if (answer.match.zero.empty() || curves.time.empty()) return line;
    const ZeroLine95& zero = answer.match.zero.front();
    for (const double time : {curves.front, curves.time.back()}) {
        line.x.push_back(time);
        line.y.push_back(answer.peak * (zero.offset + zero.slope * (time - curves.front) / 1e-3));
    }
    return line;
}

/// The part of a curve from a time on.
FigureSeries fromTime(double begin, const MatchCurves& curves, const std::vector<double>& values,
                      FigureSeries series) {
    for (std::size_t i = 0; i < curves.time.size(); ++i) {
        if (curves.time[i] < begin) continue;
        series.x.push_back(curves.time[i]);
        series.y.push_back(values[i]);
    }
    return series;
}

double returningFrom(const RecordAnswer& answer) {
    return answer.curves.front + answer.match.from;
}

StudyPanel recordPanel(const RecordAnswer& answer) {
    const MatchCurves& curves = answer.curves;
    StudyPanel panel{.x = timeAxis(answer), .y = forceAxis(answer, translatable("force, compression +"))};
    const double begin = returningFrom(answer);
    if (answer.hasTwoGauges()) {
        panel.series.push_back(
            {.legend = translatable("returning wave, measured"), .x = curves.time, .y = curves.measured});
        panel.series.push_back(fromTime(begin, curves, curves.model,
                                        {.role = SeriesRole::second, .legend = translatable("model")}));
        panel.series.push_back({.role = SeriesRole::third,
                                .legend = translatable("incident wave"),
                                .x = curves.time,
                                .y = curves.incident});
    } else {
        panel.series.push_back({.legend = translatable("measured"), .x = curves.time, .y = curves.measured});
        panel.series.push_back(fromTime(begin, curves, curves.model,
                                        {.role = SeriesRole::second, .legend = translatable("model")}));
    }
    panel.series.push_back(zeroLine(answer));
    const bool hasQuiet = !answer.hasTwoGauges() && curves.incidentEnd > curves.quietFrom;
    panel.bands.push_back({translatable("incident"), curves.front,
                           hasQuiet ? curves.quietFrom : std::min(curves.incidentEnd, begin)});
    if (hasQuiet) panel.bands.push_back({translatable("quiet"), curves.quietFrom, curves.incidentEnd});
    panel.bands.push_back({translatable("returning"), begin, curves.front + answer.match.to});
    panel.handle =
        FigureHandle{translatable("arrival by the distance"), curves.front + answer.match.roundTripOfFile,
                     curves.front + answer.match.roundTrip};
    return panel;
}

StudyPanel residualPanel(const RecordAnswer& answer) {
    StudyPanel panel{.row = 1,
                     .height = residualHeight,
                     .sharesX = true,
                     .x = timeAxis(answer),
                     .y = forceAxis(answer, translatable("residual"))};
    panel.series.push_back(fromTime(returningFrom(answer), answer.curves, answer.curves.residual, {}));
    return panel;
}

/// Loading between both ends of the stiffness, or unloading between both ends of gamma, as closed areas.
void addIntervals(const RecordAnswer& answer, double largestForce, StudyPanel& panel) {
    const std::optional<IdentifiedLaw> law = answer.loadingLaw();
    const IdentifiedParameter* stiffness = answer.find("bit_rock.stiffness");
    const IdentifiedParameter* gamma = answer.find("bit_rock.gamma");
    if (answer.model == ModelVerdict::rejected || !law || !(largestForce > 0)) return;
    const auto area = [&](Message legend) {
        panel.series.push_back(
            {.kind = SeriesKind::area, .role = SeriesRole::second, .legend = std::move(legend)});
        return &panel.series.back();
    };
    const auto add = [](FigureSeries& series, double x, double y) {
        series.x.push_back(x);
        series.y.push_back(y);
    };
    if (stiffness->low && stiffness->high) {
        FigureSeries& band = *area(translatable("law, 95 %"));
        IdentifiedLaw soft = *law, stiff = *law;
        soft.stiffness = *stiffness->low;
        stiff.stiffness = *stiffness->high;
        const double corner = std::min(law->cornerForce, largestForce);
        for (const double force : {0.0, corner, largestForce}) add(band, soft.penetrationAt(force), force);
        for (const double force : {largestForce, corner, 0.0}) add(band, stiff.penetrationAt(force), force);
    }
    if (gamma && gamma->low && gamma->high) {
        FigureSeries& band = *area({});
        const double deepest = law->penetrationAt(largestForce);
        add(band, deepest, largestForce);
        for (const double share : {*gamma->low, *gamma->high})
            add(band, deepest - share * largestForce / law->stiffness, 0);
        add(band, deepest, largestForce);
    }
}

StudyPanel rockPanel(const RecordAnswer& answer) {
    const MatchCurves& curves = answer.curves;
    StudyPanel panel{.row = 2,
                     .height = rockHeight,
                     .x = {.title = translatable("penetration U"), .quantity = findParameter("bit_rock.gap")},
                     .y = forceAxis(answer, translatable("force on the rock F"))};
    const double largest =
        curves.modelForce.empty() ? 0 : *std::max_element(curves.modelForce.begin(), curves.modelForce.end());
    addIntervals(answer, largest, panel);
    FigureSeries measured{.kind = SeriesKind::path,
                          .role = SeriesRole::result,
                          .legend = translatable("measured, only a picture"),
                          .isFaint = true};
    FigureSeries model{.kind = SeriesKind::path, .role = SeriesRole::second, .legend = {}};
    const double begin = returningFrom(answer);
    for (std::size_t i = 0; i < curves.time.size(); ++i) {
        if (curves.time[i] < begin) continue;
        measured.x.push_back(curves.penetration[i]);
        measured.y.push_back(curves.force[i]);
        model.x.push_back(curves.penetration[i]);
        model.y.push_back(curves.modelForce[i]);
    }
    if (answer.hasGaugeAtRock()) panel.series.push_back(std::move(measured));
    panel.series.push_back(std::move(model));
    return panel;
}

/// A parameter of every record with its interval as a bar, and the band of the next blow. The record on show
/// stands out.
StudyPanel alongPanel(const IdentifyFindings& findings, const RecordAnswer& shown, std::size_t row,
                      const char* key) {
    constexpr double value = 0.16, cap = 0.06;  // half widths of ticks, in records
    StudyPanel panel{.row = row,
                     .height = alongHeight,
                     .x = {.title = translatable("record"),
                           .range = std::pair(0.5, 0.5 + static_cast<double>(findings.records.size()))},
                     .y = {.quantity = findParameter(key)}};
    const bool isFirst = row == 2;
    const auto name = [&](const char* words) { return isFirst ? Message(words) : Message(); };
    FigureSeries band{
        .kind = SeriesKind::area, .role = SeriesRole::third, .legend = name(translatable("next blow, 95 %"))};
    for (const NextBlowParameter& next : findings.nextBlow) {
        if (next.key != key) continue;
        const auto [from, to] = *panel.x.range;
        band.x = {from, to, to, from};
        band.y = {next.low, next.low, next.high, next.high};
    }
    if (band.x.empty()) band.legend = {};
    FigureSeries bars{.kind = SeriesKind::path, .legend = name(translatable("record, 95 %"))};
    FigureSeries marked{
        .kind = SeriesKind::area, .role = SeriesRole::second, .legend = name(translatable("record on show"))};
    const auto line = [&bars](double x1, double y1, double x2, double y2) {
        bars.x.insert(bars.x.end(), {x1, x2, NAN});
        bars.y.insert(bars.y.end(), {y1, y2, NAN});
    };
    for (std::size_t i = 0; i < findings.records.size(); ++i) {
        const RecordAnswer& record = findings.records[i];
        const IdentifiedParameter* parameter = record.find(key);
        if (!parameter || record.model == ModelVerdict::rejected || !parameter->low || !parameter->high)
            continue;
        const auto x = static_cast<double>(i + 1);
        line(x, *parameter->low, x, *parameter->high);
        line(x - value, parameter->value, x + value, parameter->value);
        for (const double end : {*parameter->low, *parameter->high}) line(x - cap, end, x + cap, end);
        if (&record != &shown) continue;
        marked.x = {x - value, x + value, x + value, x - value, x - value};
        marked.y = {*parameter->low, *parameter->low, *parameter->high, *parameter->high, *parameter->low};
    }
    panel.series = {std::move(band), std::move(bars), std::move(marked)};
    return panel;
}

}  // namespace

StudyFigure identifyFigure(const IdentifyFindings& findings, const RecordAnswer& answer) {
    StudyFigure figure;
    figure.paperHeight = 220;
    figure.panels = {recordPanel(answer), residualPanel(answer)};
    if (findings.records.size() > 1)
        for (const char* key : {"bit_rock.stiffness", "bit_rock.gamma"})
            figure.panels.push_back(alongPanel(findings, answer, figure.panels.size(), key));
    else
        figure.panels.push_back(rockPanel(answer));
    const double noise = 2 * answer.match.noise * answer.peak;
    figure.levels = {{translatable("+2 σ of the noise"), noise, false, 1}, {{}, -noise, false, 1}};
    return figure;
}

}  // namespace drillwave
