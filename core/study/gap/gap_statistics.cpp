// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gap/gap_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/numeric/brent.h"
#include "core/numeric/fit_features.h"
#include "core/numeric/gauss_rule.h"

namespace drillwave {

namespace {

using Segments = std::span<const MonotoneSegment>;

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

/// One output under one distribution of the gap, as a distribution of values.
class ValueDistribution {
  public:
    ValueDistribution(Segments segments, const GapDistribution& gaps) : m_segments(segments), m_gaps(gaps) {
        for (const MonotoneSegment& segment : segments) {
            const double mass = gaps.cumulative(segment.end) - gaps.cumulative(segment.start);
            m_masses.push_back(mass);
            m_total += mass;
            if (!segment.piece->resolved)
                m_unresolved += mass;
            else if (mass > 0)
                m_error = std::max(m_error, segment.error());
        }
    }

    /// Probability of a value of at most `value`.
    double cumulative(double value) const {
        double sum = 0;
        for (std::size_t i = 0; i < m_segments.size(); ++i) {
            const MonotoneSegment& segment = m_segments[i];
            if (m_masses[i] <= 0 || segment.lower() > value) continue;
            if (segment.upper() <= value) {
                sum += m_masses[i];
                continue;
            }
            const double gap = segment.placeOf(value);
            sum += segment.first <= value ? m_gaps.cumulative(gap) - m_gaps.cumulative(segment.start)
                                          : m_gaps.cumulative(segment.end) - m_gaps.cumulative(gap);
        }
        return sum / m_total;
    }

    /// Values move by at most the error of the curve, and probabilities by what is unresolved.
    Estimate quantile(double share) const {
        const double value = valueAt(share);
        double error = m_error + rounding * std::abs(value);
        if (m_unresolved > 0)
            error += std::max(std::abs(valueAt(share - m_unresolved) - value),
                              std::abs(valueAt(share + m_unresolved) - value));
        return {value, error};
    }

    Estimate shareAbove(double value) const {
        const double share = 1 - cumulative(value);
        const double error = m_error + rounding * std::abs(value);
        const double least = 1 - cumulative(value + error), most = 1 - cumulative(value - error);
        double unresolved = 0;
        for (std::size_t i = 0; i < m_segments.size(); ++i) {
            const MonotoneSegment& segment = m_segments[i];
            const bool mayBeEither =
                segment.lower() - segment.error() <= value && segment.upper() + segment.error() >= value;
            if (!segment.piece->resolved && mayBeEither) unresolved += m_masses[i] / m_total;
        }
        return {share, std::max(most - share, share - least) + unresolved + rounding};
    }

  private:
    double valueAt(double share) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < m_segments.size(); ++i) {
            if (m_masses[i] <= 0) continue;
            low = std::min(low, m_segments[i].lower());
            high = std::max(high, m_segments[i].upper());
        }
        const auto excess = [&](double value) { return cumulative(value) - share; };
        const double atLow = excess(low), atHigh = excess(high);
        if (atLow >= 0) return low;
        if (atHigh <= 0) return high;
        return brentRoot(excess, low, atLow, high, atHigh);
    }

    Segments m_segments;
    const GapDistribution& m_gaps;
    std::vector<double> m_masses;
    double m_total = 0;
    double m_unresolved = 0;
    double m_error = 0;
};

/// ∫ output · density over the pieces, each cut where the density is not smooth on its scale.
Estimate meanOf(const GapCurve& curve, std::size_t output, const GapDistribution& gaps) {
    const GaussRule& rule = gaussRule();
    double sum = 0, weights = 0, error = 0;
    for (const GapPiece& piece : curve.pieces) {
        if (!piece.solved) continue;
        auto cut = std::ranges::upper_bound(gaps.cuts(), piece.start);
        double pieceWeight = 0;
        for (double from = piece.start; from < piece.end;) {
            const double to = cut == gaps.cuts().end() ? piece.end : std::min(*cut++, piece.end);
            for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
                const double gap = from + (to - from) * rule.nodes[j];
                const double weight = gaps.density(gap) * (to - from) * rule.weights[j];
                sum += weight * piece.outputs[output](gap);
                pieceWeight += weight;
            }
            from = to;
        }
        weights += pieceWeight;
        error += pieceWeight * piece.error[output];
    }
    const double mean = sum / weights;
    return {mean, error / weights + 16 * rounding * std::abs(mean)};
}

GapSpread spreadOf(const GapCurve& curve, std::size_t output, const ValueDistribution& values,
                   const GapDistribution& gaps) {
    GapSpread spread{.mean = meanOf(curve, output, gaps), .quantiles = {}};
    for (std::size_t i = 0; i < gapQuantiles.size(); ++i)
        spread.quantiles[i] = values.quantile(gapQuantiles[i]);
    return spread;
}

GapExtreme gapExtremeOf(const GapCurve& curve, Segments segments, Extreme which) {
    const FitExtreme found = extremeOf(segments, which);
    GapExtreme extreme{.value = found.value, .gap = found.place};
    const auto output = static_cast<GapOutput>(segments.front().output);
    if (found.everywhere)
        extreme.kind = GapExtreme::Kind::everywhere;
    else if (isKink(curve, output, found.place.value, std::abs(found.value.value)))
        extreme.kind = GapExtreme::Kind::kink;
    return extreme;
}

/// Where e passes 1.
std::vector<GapCrossing> crossingsOfOne(Segments segments) {
    std::vector<GapCrossing> crossings;
    for (const FitCrossing& crossing : crossingsOf(segments, 1))
        crossings.push_back({crossing.place, crossing.rising});
    return crossings;
}

/// Returns those of ascending segments that are inside the period.
Segments inPeriod(const std::vector<MonotoneSegment>& segments, const GapCurve& curve) {
    const auto first = std::ranges::lower_bound(segments, curve.periodStart, {}, &MonotoneSegment::start);
    return {first, segments.end()};
}

}  // namespace

GapStatistics gapStatistics(const GapCurve& curve, const std::optional<NormalGap>& normal) {
    assert(curve.usable());
    GapStatistics statistics;
    statistics.kinks = kinksOf(curve);
    const GapDistribution alike = GapDistribution::uniform(curve);
    std::optional<GapDistribution> scattered;
    if (normal) scattered = GapDistribution::normal(curve, *normal);
    for (std::size_t i = 0; i < curve.outputCount; ++i) {
        const std::vector<MonotoneSegment> segments = segmentsOf(curve.pieces, i);
        const Segments period = inPeriod(segments, curve);
        const ValueDistribution values(period, alike);
        GapOutputStatistics output{.least = gapExtremeOf(curve, period, Extreme::least),
                                   .largest = gapExtremeOf(curve, period, Extreme::largest),
                                   .uniform = spreadOf(curve, i, values, alike),
                                   .normal = {}};
        if (i == 0) statistics.shareAboveOne = values.shareAbove(1);
        if (i == 0) statistics.crossings = crossingsOfOne(period);
        if (scattered) {
            const ValueDistribution scatteredValues(segments, *scattered);
            output.normal = spreadOf(curve, i, scatteredValues, *scattered);
            if (i == 0) statistics.normalShareAboveOne = scatteredValues.shareAbove(1);
        }
        statistics.outputs.push_back(output);
    }
    return statistics;
}

Estimate shareAbove(const GapCurve& curve, double cor) {
    const std::vector<MonotoneSegment> segments = segmentsOf(curve.pieces, 0);
    const GapDistribution alike = GapDistribution::uniform(curve);
    return ValueDistribution(inPeriod(segments, curve), alike).shareAbove(cor);
}

Estimate largestCor(const GapCurve& curve) {
    const std::vector<MonotoneSegment> segments = segmentsOf(curve.pieces, 0);
    return extremeOf(segments, Extreme::largest).value;
}

}  // namespace drillwave
