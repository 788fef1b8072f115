// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/wave_spans.h"

#include <algorithm>
#include <limits>

namespace drillwave {

SpanBound boundOf(const WaveSpan& span, double sign) {
    const PieceBends& bends = span.bends;
    const double share = static_cast<double>(span.last - span.first) / bends.parts, square = share * share;
    return {std::max(sign * span.begin.incident, sign * span.end.incident) + square * bends.incident +
                bends.rounding,
            std::max(sign * span.begin.reflected, sign * span.end.reflected) + square * bends.reflected +
                bends.rounding};
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

void halve(const Impact& impact, std::vector<WaveSpan>& spans) {
    std::vector<WaveSpan> halves;
    halves.reserve(2 * spans.size());
    for (const WaveSpan& span : spans) {
        if (span.isOnePart()) {
            halves.push_back(span);
            continue;
        }
        const int middle = (span.first + span.last) / 2;
        const Instant between = instantIn(
            impact, span.piece, endOfPart(impact, span.piece, middle, span.bends.parts), Side::inside);
        halves.push_back({span.piece, span.first, middle, span.bends, span.begin, between});
        halves.push_back({span.piece, middle, span.last, span.bends, between, span.end});
    }
    spans = std::move(halves);
}

std::vector<Instant> endsOf(const std::vector<WaveSpan>& spans) {
    std::vector<Instant> instants;
    instants.reserve(2 * spans.size());
    const WaveSpan* before = nullptr;
    for (const WaveSpan& span : spans) {
        if (!before || before->piece != span.piece || before->last != span.first)
            instants.push_back(span.begin);
        instants.push_back(span.end);
        before = &span;
    }
    return instants;
}

RangeMaximum::RangeMaximum(const std::vector<double>& numbers)
    : m_count(numbers.size()), m_tree(2 * m_count) {
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
