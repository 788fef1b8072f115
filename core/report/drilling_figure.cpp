// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/drilling_figure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/blow/blow.h"
#include "core/blow/feed_estimate.h"
#include "core/report/parameter_words.h"

namespace drillwave {
namespace {

constexpr std::size_t joinedReturns = 20;
constexpr int gapsOfPeriod = 40;
constexpr double energyWidth = 1.5;  // names need room

FigureQuantity lengthsOf(const Scenario& scenario) {
    return SiValues{Quantity::length, scalesOf(scenario).penetration, "penetration"};
}

void append(FigureSeries& series, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
}

void addBar(std::vector<double>& along, std::vector<double>& up, double from, double to, double height) {
    along.insert(along.end(), {from, from, to, to});
    up.insert(up.end(), {0, height, height, 0});
}

FigureSeries ofBlows(const ShownSequence* sequence, double DrillingBlow::*value, SeriesRole role) {
    FigureSeries series{.role = role, .points = SeriesPoints::dots};
    if (!sequence) return series;
    const double unit = drillingUnitsOf(sequence->scenario).length();
    for (const DrillingBlow& blow : sequence->blows)
        append(series, double(series.x.size() + 1), blow.*value * unit);
    return series;
}

StudyPanel blowPanel(const ShownSequence& sequence, Message title, double DrillingBlow::*value,
                     SeriesRole role) {
    const auto blows = double(sequence.settings.blows);
    StudyPanel panel{
        .x = {.title = translatable("blow"), .range = std::pair(0.0, blows + 1)},
        .y = {.title = std::move(title), .quantity = lengthsOf(sequence.scenario), .isFromZero = true},
        .series = {ofBlows(sequence.before, value, role), ofBlows(&sequence, value, role)},
        .bands = {{{}, double(sequence.settings.settle) + 0.5, blows + 0.5}}};
    panel.series.front().isFaint = true;
    return panel;
}

StudyPanel phasePanel(const ShownSequence& sequence) {
    StudyPanel panel{
        .x = {.title = translatable("gap modulo d₀, in d₀"), .range = std::pair(0.0, 1.0)},
        .y = {.title = translatable("blows"), .quantity = PlainNumber::percent, .isFromZero = true},
        .series = {{.kind = SeriesKind::area}, sequence.corOverGap}};
    if (!sequence.corOverGap.x.empty()) panel.right = FigureAxis{.title = translatable("e at this gap")};
    if (!sequence.result || !sequence.result->statistics) return panel;
    const auto& counts = sequence.result->statistics->gapParts;
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    const auto parts = double(counts.size());
    for (std::size_t i = 0; sum > 0 && i < counts.size(); ++i)
        addBar(panel.series[0].x, panel.series[0].y, double(i) / parts, double(i + 1) / parts,
               100 * counts[i] / sum);
    return panel;
}

StudyPanel returnsPanel(const ShownSequence& sequence) {
    const std::vector<double> gaps = ofBlows(&sequence, &DrillingBlow::gap, {}).y;
    FigureSeries points{.points = SeriesPoints::dots};
    FigureSeries last{.kind = SeriesKind::path, .role = SeriesRole::third, .isFaint = true};
    for (auto i = static_cast<std::size_t>(sequence.settings.settle); i + 1 < gaps.size(); ++i)
        append(points, gaps[i], gaps[i + 1]);
    const auto joined = static_cast<std::ptrdiff_t>(std::min(joinedReturns, points.x.size()));
    last.x.assign(points.x.end() - joined, points.x.end());
    last.y.assign(points.y.end() - joined, points.y.end());
    const double least = points.y.empty() ? 0 : *std::ranges::min_element(points.y);
    const double most = points.y.empty() ? 0 : *std::ranges::max_element(points.y);
    const double top = most > 0 ? most : scalesOf(sequence.scenario).penetration;
    constexpr double leastRange = 0.1;  // ticks of less have too many digits
    const double room = std::max(0.06 * (top - least), (leastRange * top - (top - least)) / 2);
    const FigureAxis axis{.quantity = lengthsOf(sequence.scenario),
                          .range = std::pair(least - room, top + room)};
    StudyPanel panel{.x = axis, .y = axis, .series = {std::move(points), std::move(last)}};
    panel.x.title = translatable("gap");
    panel.y.title = translatable("next gap");
    return panel;
}

StudyPanel energyPanel(const DrillingLedger& ledger) {
    const std::pair<const char*, double> parts[] = {{translatable("remaining energy %1"), ledger.stored},
                                                    {translatable("new rock faces %1"), ledger.faces},
                                                    {translatable("lost waves %1"), ledger.waves},
                                                    {translatable("damper %1"), ledger.damper},
                                                    {translatable("rock %1"), ledger.rock}};
    FigureSeries bars{.kind = SeriesKind::area};
    std::vector<FigureText> names;
    const double given = ledger.hammer + ledger.feed;  // 0 while the sequence grows
    for (const auto& [name, energy] : parts) {
        const double share = 100 * energy / given, place = double(names.size());
        if (given > 0) addBar(bars.y, bars.x, place - 0.35, place + 0.35, share);
        names.push_back(given > 0 ? FigureText{name, {{std::round(10 * share) / 10, PlainNumber::percent, 3}}}
                                  : FigureText());
    }
    return {.width = energyWidth,
            .x = {.title = translatable("share of the energy"), .quantity = PlainNumber::percent},
            .y = {.range = std::pair(-0.6, double(names.size()) - 0.4), .names = std::move(names)},
            .series = {std::move(bars)}};
}

struct ScanCurves {
    FigureSeries rate, bouncing, contact, error, gaps, bouncingGaps;
};

/// A point without an answer does not interrupt the lines: its neighbours are joined.
ScanCurves curvesOf(const DrillingScan& scan) {
    constexpr std::size_t penetration = quantityPlace(&DrillingBlow::penetration);
    ScanCurves curves;
    std::vector<const DrillingScanPoint*> points;
    for (const DrillingScanPoint& point : scan.points)
        if (point.result.statistics) points.push_back(&point);
    std::ranges::stable_sort(points, {}, &DrillingScanPoint::value);
    for (const DrillingScanPoint* point : points) {
        const DrillingResult& result = point->result;
        const double x = point->value, length = result.units.length();
        const double rate = result.spread(penetration).mean * length * result.frequencyUsed;
        const bool isFromRest = point->start == DrillingStart::rest;
        append(isFromRest ? curves.rate : curves.bouncing, x, rate);
        for (auto i = static_cast<std::size_t>(result.settings.settle); i < result.blows.size(); ++i)
            append(isFromRest ? curves.gaps : curves.bouncingGaps, x, result.blows[i].gap * length);
        if (!isFromRest) continue;
        const double error = result.meanError(penetration).value_or(0) * length * result.frequencyUsed;
        // Closed: the lower edge to the right, the upper one back.
        const auto middle = static_cast<std::ptrdiff_t>(curves.error.x.size() / 2);
        curves.error.x.insert(curves.error.x.begin() + middle, {x, x});
        curves.error.y.insert(curves.error.y.begin() + middle, {rate - error, rate + error});
        append(curves.contact, x, 100 * result.statistics->contactShare);
    }
    return curves;
}

/// The weight along the hole is in the feed, too: what is left to the thrust.
std::vector<FigureBand> requiredFeeds(const DrillingScan& scan) {
    const auto found = std::ranges::find_if(
        scan.points, [](const DrillingScanPoint& point) { return point.result.statistics.has_value(); });
    if (scan.axis.key() != "drill.thrust" || found == scan.points.end() || !scan.cor) return {};
    const DrillingResult& result = found->result;
    const double needed = result.meanImpulse * result.units.impulse() * result.frequencyUsed;
    const double weight =
        feedForceOf(result.scenario)->effective() - result.scenario.drill.thrust.value_or(0);
    std::vector<FigureBand> lines;
    for (const auto& [times, words] : {std::pair(1.0, "f I₀"), std::pair(1 + *scan.cor, "f I₀(1+e)"),
                                       std::pair(1 + 2 * *scan.cor, "f I₀(1+2e)")})
        lines.push_back({std::string(words), times * needed - weight, times * needed - weight});
    return lines;
}

std::pair<StudyPanel, StudyPanel> scanPanels(const ShownScan& shown) {
    const DrillingScan& scan = shown.scan;
    ScanCurves curves = curvesOf(scan);
    const auto drawn = [&](FigureSeries series, const char* legend, SeriesRole role,
                           SeriesPoints points = SeriesPoints::none) {
        if (!series.x.empty()) series.legend = legend;  // the legend has what is there
        series.role = role;
        series.points = points;
        series.isFaint = shown.isOld;
        return series;
    };
    const auto rateOf = [](const DrillingScan* other) {
        return other ? curvesOf(*other).rate : FigureSeries();
    };
    const double first = scan.axis.value(0), last = scan.axis.value(scan.axis.count - 1);
    const FigureAxis along{.title = labelMessage(*scan.axis.parameter),
                           .quantity = scan.axis.parameter,
                           .isLogarithmic = scan.axis.kind == SweepAxis::Kind::logarithmic,
                           .range = std::pair(std::min(first, last), std::max(first, last)),
                           .target = AxisTarget{scan.axis.parameter}};
    const double size = scalesOf(scan.base).penetration * scan.base.drill.blowFrequency.value_or(1);
    StudyPanel rates{
        .x = along,
        .y = {.title = translatable("penetration rate"),
              .quantity = SiValues{Quantity::velocity, size, "rate"},
              .isFromZero = true},
        .series = {drawn(curves.rate, translatable("penetration rate"), SeriesRole::result,
                         SeriesPoints::joined),
                   drawn(curves.bouncing, translatable("rod bouncing at the start"), SeriesRole::result,
                         SeriesPoints::apart),
                   drawn(curves.contact, translatable("blows in contact"), SeriesRole::second),
                   drawn(rateOf(shown.constantForce), translatable("constant force"), SeriesRole::third),
                   drawn(rateOf(shown.strongDamper), translatable("dashpot of half the impedance"),
                         SeriesRole::fourth)},
        .bands = requiredFeeds(scan),
        .right = FigureAxis{.title = translatable("blows in contact"),
                            .quantity = PlainNumber::percent,
                            .range = std::pair(0.0, 106.0)}};
    rates.series[2].isOnRight = true;
    if (shown.isOld) curves.error = {};
    rates.series.push_back(
        {.kind = SeriesKind::area, .x = curves.error.x, .y = curves.error.y, .isFaint = true});
    StudyPanel gaps{
        .x = along,
        .y = {.title = translatable("gap at the blow"), .quantity = lengthsOf(scan.base), .isFromZero = true},
        .series = {drawn(curves.gaps, "", SeriesRole::result, SeriesPoints::dots),
                   drawn(curves.bouncingGaps, "", SeriesRole::result, SeriesPoints::apart)}};
    return {std::move(rates), std::move(gaps)};
}

}  // namespace

StudyFigure drillingFigure(const ShownSequence* sequence, const ShownScan* scan, bool isDetailed) {
    StudyFigure figure{.paperHeight = sequence ? 130 : 120};
    if (scan)
        figure.caption.push_back(
            {scan->isOld ? translatable("scan of an earlier scenario: scan again")
                         : translatable("strip: 95 % confidence interval of the penetration rate")});
    if (sequence) figure.caption.push_back({translatable("mean: over the shaded blows")});
    if (sequence && isDetailed)
        figure.caption.push_back({translatable("gap and next gap: a projection from more dimensions")});
    std::optional<std::pair<StudyPanel, StudyPanel>> scanned;
    if (scan) scanned = scanPanels(*scan);
    if (scanned && !scanned->first.bands.empty())
        figure.caption.push_back(
            {translatable("feeds: f I₀ mean blow force, f I₀(1+e) required, f I₀(1+2e) returns an undamped "
                          "rod before the next blow")});
    for (const std::size_t row : {0, 0, 1, 1, 2, 2, 2})
        figure.panels.push_back({.row = row, .hasOwnY = true, .isHidden = true});
    const auto show = [&](DrillingPanel which, StudyPanel panel) {
        StudyPanel& place = figure.panels[static_cast<std::size_t>(which)];
        panel.row = place.row;
        panel.hasOwnY = true;
        place = std::move(panel);
    };
    const auto summarise = [&](Message sentence) {
        figure.summary.push_back({"%1", {{.words = std::move(sentence)}}});
    };
    if (sequence) {
        show(DrillingPanel::penetration, blowPanel(*sequence, translatable("penetration"),
                                                   &DrillingBlow::penetration, SeriesRole::second));
        summarise(
            {translatable("Gap and penetration of %1 of %2 blows; the first %3 are transient and excluded."),
             {std::to_string(sequence->blows.size()), std::to_string(sequence->settings.blows),
              std::to_string(sequence->settings.settle)}});
    }
    if (sequence && isDetailed) {
        show(DrillingPanel::gap,
             blowPanel(*sequence, translatable("gap at the blow"), &DrillingBlow::gap, SeriesRole::result));
        show(DrillingPanel::phase, phasePanel(*sequence));
        show(DrillingPanel::returns, returnsPanel(*sequence));
        show(DrillingPanel::energy,
             energyPanel(sequence->result ? sequence->result->ledger : DrillingLedger{}));
    }
    if (scanned) {
        auto& [rates, gaps] = *scanned;
        show(DrillingPanel::rate, std::move(rates));
        if (isDetailed) show(DrillingPanel::scannedGap, std::move(gaps));
        summarise({translatable("Penetration rate, contact share and gaps over %1."),
                   {labelMessage(*scan->scan.axis.parameter)}});
    }
    return figure;
}

FigureSeries corOverPeriod(const Scenario& scenario, const std::stop_token& stop) {
    FigureSeries curve{.role = SeriesRole::second, .isOnRight = true};
    const std::optional<double> period = gapPeriod(scenario);
    Scenario at = scenario;
    for (int i = 0; period && i <= gapsOfPeriod && !stop.stop_requested(); ++i) {
        const double share = double(i) / gapsOfPeriod;
        at.bitRock.gap = share * *period;
        const Blow blow = solveBlow(at, {}, Detail::cor, stop);
        if (blow.isSolved()) append(curve, share, blow.summary.cor);
    }
    return curve;
}

}  // namespace drillwave
