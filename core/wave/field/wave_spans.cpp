// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {

namespace {

/// One wave, times a sign, over a span: its ends, and the height of the parabola above their chord that
/// bounds it.
struct Bow {
    double begin, end, height;

    double rise() const { return end - begin; }
    /// Whether chord and parabola are highest at an end.
    bool isSteep() const { return std::abs(rise()) >= 4 * height; }
    double most() const {
        const double higher = std::max(begin, end);
        if (isSteep()) return higher;
        const double rest = height - std::abs(rise()) / 4;
        return higher + rest * (rest / height);
    }
};

Bow bowOf(const WaveSpan& span, double sign, double Instant::*wave, const WaveBends& bends) {
    const double share = static_cast<double>(span.last - span.first) / span.bends.parts;
    return {sign * span.begin.*wave, sign * span.end.*wave,
            share * share * (sign > 0 ? bends.above : bends.below)};
}
Bow incidentBow(const WaveSpan& span, double sign) {
    return bowOf(span, sign, &Instant::incident, span.bends.incident);
}
Bow reflectedBow(const WaveSpan& span, double sign) {
    return bowOf(span, sign, &Instant::reflected, span.bends.reflected);
}

Cut cutFor(const WaveSpan& span, const Bow& bow) {
    if (!bow.isSteep()) return Cut::middle;
    if (bow.rise() > 0) return span.last == span.bends.parts ? Cut::back : Cut::middle;
    return span.first == 0 ? Cut::front : Cut::middle;
}

}  // namespace

SpanBound boundOf(const WaveSpan& span, double sign) {
    return {incidentBow(span, sign).most() + span.bends.rounding,
            reflectedBow(span, sign).most() + span.bends.rounding};
}

Cut cutForIncident(const WaveSpan& span, double sign) {
    return cutFor(span, incidentBow(span, sign));
}

Cut cutForReflected(const WaveSpan& span, double sign) {
    return cutFor(span, reflectedBow(span, sign));
}

std::vector<WaveSpan> wholePieces(const Impact& impact, double from, double until) {
    const auto pieces = impact.incident.pieces();
    std::vector<WaveSpan> spans;
    spans.reserve(pieces.size());
    for (std::size_t i = firstPieceUntil(impact, from); i < pieces.size() && pieces[i].start <= until; ++i) {
        const PieceBends bends = bendsOfPiece(impact, i);
        spans.push_back({i, 0, bends.parts, bends, instantIn(impact, i, 0, Side::start),
                         instantIn(impact, i, pieces[i].length, Side::end)});
    }
    return spans;
}

void cut(const Impact& impact, const std::vector<WaveSpan>& spans, std::vector<WaveSpan>& parts) {
    parts.clear();
    parts.reserve(2 * spans.size());
    for (const WaveSpan& span : spans) {
        parts.push_back(span);
        if (span.isOnePart()) continue;
        const int at = span.cut == Cut::front  ? span.first + 1
                       : span.cut == Cut::back ? span.last - 1
                                               : (span.first + span.last) / 2;
        const Instant between =
            instantIn(impact, span.piece, endOfPart(impact, span.piece, at, span.bends.parts), Side::inside);
        parts.back().last = at;
        parts.back().end = between;
        parts.push_back(span);
        parts.back().first = at;
        parts.back().begin = between;
    }
}

void endsOf(const std::vector<WaveSpan>& spans, std::vector<Instant>& instants) {
    instants.clear();
    instants.reserve(2 * spans.size());
    const WaveSpan* before = nullptr;
    for (const WaveSpan& span : spans) {
        if (!before || !follows(*before, span)) instants.push_back(span.begin);
        instants.push_back(span.end);
        before = &span;
    }
}

void RangeMaximum::assign(const std::vector<double>& numbers) {
    m_count = numbers.size();
    m_tree.resize(2 * m_count);
    std::ranges::copy(numbers, m_tree.begin() + static_cast<std::ptrdiff_t>(m_count));
    for (std::size_t i = m_count; i-- > 1;) m_tree[i] = std::max(m_tree[2 * i], m_tree[2 * i + 1]);
}

double RangeMaximum::over(std::size_t first, std::size_t behind) const {
    double most = -std::numeric_limits<double>::infinity();
    for (first += m_count, behind += m_count; first < behind; first /= 2, behind /= 2) {
        if (first % 2) most = std::max(most, m_tree[first++]);
        if (behind % 2) most = std::max(most, m_tree[--behind]);
    }
    return most;
}

}  // namespace drillwave
