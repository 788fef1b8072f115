// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/gap_report.h"

#include <algorithm>
#include <cmath>

#include "core/blow/feed_estimate.h"
#include "core/model/parameter.h"
#include "core/model/scales.h"

namespace drillwave {

namespace {

constexpr double distributionWidth = 0.28;  // over that of the curve

FigureQuantity quantityOf(GapOutput output) {
    if (output == GapOutput::peakForce) return BlowScale::force;
    return PlainNumber::number;
}

Message axisTitle(GapOutput output) {
    return gapStudy().views[static_cast<std::size_t>(output)];
}

/// How the values between points of the curve, joined by straight lines, fall into bands.
struct Histogram {
    static constexpr int bands = 48;
    double low = 0;
    double width = 0;                                         // of a band
    std::vector<double> shares = std::vector<double>(bands);  // [%]

    Histogram(const std::vector<double>& gaps, const std::vector<double>& values,
              const GapDistribution& distribution) {
        const auto [least, largest] = std::ranges::minmax(values);
        low = least;
        width = (largest - least) / bands;
        double sum = 0;
        for (std::size_t i = 1; i < values.size(); ++i) {
            const double share = distribution.cumulative(gaps[i]) - distribution.cumulative(gaps[i - 1]);
            spread(values[i - 1], values[i], share);
            sum += share;
        }
        for (double& share : shares) share *= 100 / sum;
    }

    void spread(double first, double last, double share) {
        const double from = std::min(first, last), to = std::max(first, last);
        // A flat curve is all in one band.
        const double size = std::max(to - from, 1e-12 * std::abs(to));
        for (int band = bandOf(from); band <= bandOf(to); ++band) {
            const double overlap =
                std::min(to, low + (band + 1) * width) - std::max(from, low + band * width);
            shares[static_cast<std::size_t>(band)] +=
                to - from < size ? (band == bandOf(from) ? share : 0) : share * overlap / size;
        }
    }

    int bandOf(double value) const {
        return width > 0 ? std::clamp(static_cast<int>((value - low) / width), 0, bands - 1) : 0;
    }
};

void addDistribution(StudyPanel& panel, const Histogram& histogram) {
    FigureSeries& inBands = panel.series[0];
    FigureSeries& below = panel.series[1];
    const auto add = [](FigureSeries& series, double x, double y) {
        series.x.push_back(x);
        series.y.push_back(y);
    };
    add(inBands, 0, histogram.low);
    add(below, 0, histogram.low);
    double sum = 0;
    for (int band = 0; band < Histogram::bands; ++band) {
        const double share = histogram.shares[static_cast<std::size_t>(band)];
        const double bottom = histogram.low + band * histogram.width;
        const double top = bottom + histogram.width;
        sum += share;
        add(inBands, share, bottom);
        add(inBands, share, top);
        add(below, sum, top);
    }
    add(inBands, 0, histogram.low + Histogram::bands * histogram.width);
}

std::vector<FigureMark> marksOf(const GapStudy& study, GapOutput output) {
    const GapStatistics& statistics = study.statistics;
    const GapOutputStatistics& of = statistics.of(output);
    std::vector<FigureMark> marks;
    if (of.largest.kind != GapExtreme::Kind::everywhere)
        for (const GapExtreme& extreme : {of.largest, of.least})
            marks.push_back({MarkKind::extreme, extreme.gap.value, extreme.value.value});
    if (output == GapOutput::cor)
        for (const GapCrossing& crossing : statistics.crossings)
            marks.push_back({MarkKind::crossing, crossing.gap.value, 1});
    for (const GapKink& kink : statistics.kinks) {
        const double value = study.curve.value(output, kink.gap);
        const auto isThere = [&](const FigureMark& mark) { return mark.x == kink.gap && mark.y == value; };
        if (std::ranges::none_of(marks, isThere)) marks.push_back({MarkKind::kink, kink.gap, value});
    }
    std::ranges::sort(marks, {}, &FigureMark::x);
    return marks;
}

/// Without curve, distribution and statistics.
StudyFigure emptyFigure(const Scenario& scenario, GapOutput output) {
    const bool isDimensional = hasUnits(scenario);
    StudyFigure figure;
    figure.panels.resize(2);
    StudyPanel& curve = figure.panels.front();
    curve.x = {.title = translatable("gap d"), .quantity = BlowScale::penetration};
    curve.x.target = isDimensional
                         ? AxisTarget{*findParameter("bit_rock.gap"), scalesOf(scenario).penetration}
                         : AxisTarget{*findParameter("delta")};
    curve.y = {.title = axisTitle(output), .quantity = quantityOf(output)};
    curve.top = {.title = translatable("δ = gap / d₀")};
    curve.topPerX = 1;
    curve.series = {{.legend = axisTitle(output)}};
    StudyPanel& distribution = figure.panels.back();
    distribution.width = distributionWidth;
    distribution.x = {.title = translatable("per class [%]")};
    distribution.top = {.title = translatable("cumulative [%]"), .range = {{0, 105}}};
    distribution.series = {{.kind = SeriesKind::area, .legend = translatable("share per class")},
                           {.kind = SeriesKind::path,
                            .role = SeriesRole::second,
                            .legend = translatable("cumulative share"),
                            .isOnTop = true}};
    if (output == GapOutput::cor)
        for (StudyPanel& panel : figure.panels) panel.zone = {{}, 1};
    if (output == GapOutput::cor) curve.zone->name = translatable("super rebound, e > 1");
    return figure;
}

}  // namespace

StudyFigure gapFigure(const GapStudy& study, GapOutput output) {
    StudyFigure figure = emptyFigure(study.scenario, output);
    StudyPanel& panel = figure.panels.front();
    FigureSeries& curve = panel.series.front();
    curve.x = sampleGaps(study.curve);
    for (const double gap : curve.x) curve.y.push_back(study.curve.value(output, gap));
    curve.value = [pieces = study.curve, output](double gap) {
        return pieces.value(output, std::max(pieces.start, gap));
    };
    addDistribution(figure.panels.back(),
                    Histogram(curve.x, curve.y,
                              study.normal ? GapDistribution::normal(study.curve, *study.normal)
                                           : GapDistribution::uniform(study.curve)));
    panel.marks = marksOf(study, output);
    const GapSpread& spread = study.spread(output);
    const double low = spread.quantiles.front().value, high = spread.quantiles.back().value;
    figure.levels = {{translatable("5 %"), low},
                     {translatable("mean"), spread.mean.value, true},
                     {translatable("95 %"), high}};
    const FigureQuantity quantity = quantityOf(output);
    figure.caption.push_back({study.normal ? translatable("scattered gap: mean %1, 5–95 % %2…%3")
                                           : translatable("all gaps: mean %1, 5–95 % %2…%3"),
                              {{spread.mean.value, quantity}, {low, quantity}, {high, quantity}}});
    if (output == GapOutput::cor) {
        const Estimate& share =
            study.normal ? *study.statistics.normalShareAboveOne : study.statistics.shareAboveOne;
        figure.caption.push_back(
            {translatable("e > 1 at %1 of gaps"), {{100 * share.value, PlainNumber::percent}}});
    }
    if (const auto thrust = thrustNeeded(study.scenario, study.spread(GapOutput::cor).quantiles.back().value))
        figure.caption.push_back({translatable("feed force enough for 95 % of gaps: %1"),
                                  {{*thrust, SiValues{Quantity::force, *thrust}}}});
    return figure;
}

StudyFigure gapPreviewFigure(const Scenario& scenario, const std::vector<GapSample>& samples,
                             GapOutput output) {
    StudyFigure figure = emptyFigure(scenario, output);
    figure.isPreview = true;
    FigureSeries& curve = figure.panels.front().series.front();
    for (const GapSample& sample : samples) {
        curve.x.push_back(sample.gap);
        curve.y.push_back(sample.values[static_cast<std::size_t>(output)]);
    }
    return figure;
}

}  // namespace drillwave
