// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/gap/gap_picture.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "core/blow/thrust.h"
#include "ui/text/translation.h"

namespace drillwave {
namespace {

constexpr int bands = 48;  // of values, for the distribution

ShownUnit unitOf(GapOutput output, const ShownUnits& units) {
    return output == GapOutput::peakForce ? units.force : ShownUnit{};
}

// The share of gaps between neighbouring points of the curve, all gaps of the distribution together 1.
std::vector<double> sharesBetween(const std::vector<double>& gaps, const GapDistribution& distribution) {
    std::vector<double> shares;
    double sum = 0;
    for (std::size_t i = 1; i < gaps.size(); ++i) {
        shares.push_back(distribution.cumulative(gaps[i]) - distribution.cumulative(gaps[i - 1]));
        sum += shares.back();
    }
    for (double& share : shares) share /= sum;
    return shares;
}

// How the values between points of the curve, joined by straight lines, fall into bands.
struct Histogram {
    double low = 0;
    double width = 0;  // of a band
    std::vector<double> shares;

    Histogram(const std::vector<double>& values, const std::vector<double>& between) : shares(bands) {
        const auto [least, largest] = std::ranges::minmax(values);
        low = least;
        width = (largest - least) / bands;
        for (std::size_t i = 1; i < values.size(); ++i) spread(values[i - 1], values[i], between[i - 1]);
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

void addDistribution(GapPicture& picture, const Histogram& histogram) {
    picture.shares.append({0, histogram.low});
    picture.below.append({0, histogram.low});
    double below = 0;
    for (int band = 0; band < bands; ++band) {
        const double share = 100 * histogram.shares[static_cast<std::size_t>(band)];
        const double bottom = histogram.low + band * histogram.width;
        const double top = bottom + histogram.width;
        below += share;
        picture.shares << QPointF(share, bottom) << QPointF(share, top);
        picture.below << QPointF(below, top);
    }
    picture.shares.append({0, histogram.low + bands * histogram.width});
}

void addMarks(GapPicture& picture, const GapReport& report) {
    const GapStatistics& statistics = report.statistics;
    const auto place = [&](double gap, double value) {
        return QPointF(gap * picture.gap.factor, value * picture.value.factor);
    };
    const GapOutputStatistics& output = statistics.of(picture.output);
    if (output.largest.kind != GapExtreme::Kind::everywhere)
        for (const GapExtreme& extreme : {output.largest, output.least})
            picture.marks.append({CurveMark::Kind::extreme, place(extreme.gap.value, extreme.value.value)});
    if (picture.output == GapOutput::cor)
        for (const GapCrossing& crossing : statistics.crossings)
            picture.marks.append({CurveMark::Kind::crossing, place(crossing.gap.value, 1)});
    for (const GapKink& kink : statistics.kinks) {
        const CurveMark mark{CurveMark::Kind::kink,
                             place(kink.gap, report.curve.value(picture.output, kink.gap))};
        const auto isNamed = [&](const CurveMark& other) { return other.at == mark.at; };
        if (std::ranges::none_of(picture.marks, isNamed)) picture.marks.append(mark);
    }
    std::ranges::sort(picture.marks, {}, [](const CurveMark& mark) { return mark.at.x(); });
}

GapPicture emptyPicture(GapOutput output, const ShownUnits& units) {
    GapPicture picture;
    picture.output = output;
    picture.gap = units.penetration;
    picture.value = unitOf(output, units);
    return picture;
}

}  // namespace

QString gapOutputName(GapOutput output) {
    switch (output) {
        case GapOutput::cor:
            return tr("COR e");
        case GapOutput::peakForce:
            return tr("peak force Fm");
        case GapOutput::efficiency:
            break;
    }
    return tr("efficiency");
}

GapPicture gapPicture(const GapReport& report, GapOutput output, const ShownUnits& units) {
    const GapCurve& curve = report.curve;
    GapPicture picture = emptyPicture(output, units);
    picture.from = curve.start * picture.gap.factor;
    picture.to = curve.end * picture.gap.factor;
    const std::vector<double> gaps = sampleGaps(curve);
    std::vector<double> values;
    QVector<QCPGraphData> points;
    for (const double gap : gaps) {
        values.push_back(curve.value(output, gap) * picture.value.factor);
        appendFinite(points, gap * picture.gap.factor, values.back());
    }
    picture.curve = graphData(points);
    picture.isScattered = report.normal.has_value();
    const GapDistribution distribution = picture.isScattered ? GapDistribution::normal(curve, *report.normal)
                                                             : GapDistribution::uniform(curve);
    addDistribution(picture, Histogram(values, sharesBetween(gaps, distribution)));
    addMarks(picture, report);
    const GapStatistics& statistics = report.statistics;
    const GapOutputStatistics& of = statistics.of(output);
    picture.spread = picture.isScattered ? *of.normal : of.uniform;
    if (output == GapOutput::cor)
        picture.shareAboveOne =
            (picture.isScattered ? *statistics.normalShareAboveOne : statistics.shareAboveOne).value;
    const GapOutputStatistics& cor = statistics.of(GapOutput::cor);
    const GapSpread& spread = picture.isScattered ? *cor.normal : cor.uniform;
    if (const auto thrust = thrustNeeded(report.scenario, spread.quantiles.back().value)) {
        picture.thrustUnit = units.of(UnitKind::force, *thrust);
        picture.thrust = *thrust * picture.thrustUnit.factor;
    }
    return picture;
}

GapPicture gapPreview(const std::vector<GapSample>& samples, GapOutput output, const ShownUnits& units) {
    GapPicture picture = emptyPicture(output, units);
    QVector<QCPGraphData> points;
    for (const GapSample& sample : samples)
        appendFinite(points, sample.gap * picture.gap.factor,
                     sample.values[static_cast<std::size_t>(output)] * picture.value.factor);
    picture.curve = graphData(points);
    if (points.isEmpty()) return picture;
    picture.from = points.first().key;
    picture.to = points.last().key;
    return picture;
}

}  // namespace drillwave
