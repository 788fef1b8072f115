// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/rod_instants.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/wave/field/bit_history.h"
#include "core/wave/field/history_reader.h"

namespace drillwave {

namespace {

/// How far a wave may bend off the chord between two instants, as a share of the peak force.
constexpr double tolerance = 1e-4;

/// k(k − 1), what the second derivative makes of the coefficient of u^k.
constexpr auto bendFactors = [] {
    std::array<double, 256> f{};
    for (std::size_t i = 2; i < f.size(); ++i) f[i] = double(i * (i - 1));
    return f;
}();

/// Upper bounds of the second derivative over u of a piece, and of its values.
struct Sizes {
    double bend = 0, value = 0;

    void add(double coefficient, double bent) {
        value += std::abs(coefficient);
        bend += std::abs(bent);
    }
};

/// The second derivative over u, 0 ≤ u ≤ 1, lies between the least and the largest partial sum of its
/// coefficients: as 1 ≥ u ≥ u² ≥ … it is a mean of them.
struct PartialSums {
    double sum = 0, least = 0, most = 0;

    void add(double coefficient) {
        sum += coefficient;
        least = std::min(least, sum);
        most = std::max(most, sum);
    }
    /// A wave that bends downwards by c at most is above its chord by c/8 in the middle.
    WaveBends bends() const { return {-least / 8, most / 8}; }
};

/// Into how many parts a piece is cut so that no extremum between them is missed by more than `tolerance`.
int partsOf(double bend, double peak) {
    constexpr double most = 64;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance * peak))), 1.0, most));
}

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

PieceBends bendsOfPiece(const Impact& impact, std::size_t index) {
    const double peak = std::max(impact.peakForce, std::numeric_limits<double>::min());
    const std::span<const double> g = impact.incident.coefficients(impact.incident.pieces()[index]);
    const std::span<const double> F = impact.force.coefficients(impact.force.pieces()[index]);
    // what is constant neither bends nor has any rounding
    if (g.size() <= 1 && F.size() <= 1) return {};
    const std::size_t common = std::min(g.size(), F.size());
    assert(std::max(g.size(), F.size()) <= bendFactors.size());
    Sizes incident, force;
    PartialSums ofIncident, ofReflected;
    std::size_t k = 0;
    for (; k < common; ++k) {
        const double bentG = bendFactors[k] * g[k], bentF = bendFactors[k] * F[k];
        incident.add(g[k], bentG);
        force.add(F[k], bentF);
        ofIncident.add(bentG);
        ofReflected.add(bentF - bentG);
    }
    for (; k < g.size(); ++k) {
        const double bent = bendFactors[k] * g[k];
        incident.add(g[k], bent);
        ofIncident.add(bent);
        ofReflected.add(-bent);
    }
    for (; k < F.size(); ++k) {
        const double bent = bendFactors[k] * F[k];
        force.add(F[k], bent);
        ofReflected.add(bent);
    }
    constexpr double ofSum = 64 * std::numeric_limits<double>::epsilon();  // of 30 terms
    return {ofIncident.bends(), ofReflected.bends(),
            ofSum * (incident.value + force.value + (incident.bend + force.bend) / 8),
            std::max(partsOf(incident.bend, peak), partsOf(force.bend, peak))};
}

Instant instantIn(const Impact& impact, std::size_t index, double x, Side side) {
    const PiecewisePolynomial::Piece& piece = impact.incident.pieces()[index];
    const PiecewisePolynomial::Piece& force = impact.force.pieces()[index];
    const double g = impact.incident.value(piece, x);
    const double F = force.count > 0 ? impact.force.value(force, x) : 0;
    return {piece.start + x, side, g, F - g};
}

std::size_t firstPieceUntil(const Impact& impact, double from) {
    const auto pieces = impact.incident.pieces();
    const auto found = std::ranges::partition_point(
        pieces, [from](const auto& piece) { return piece.start + piece.length < from; });
    return static_cast<std::size_t>(found - pieces.begin());
}

double recordedEndOfBlow(const Impact& impact) {
    const double blowEnd = impact.separationTime + impact.roundTrip / 2;
    return blowEnd - impact.frontArrival - unrecordedBefore(impact, impact.incident.end());
}

std::vector<double> counterparts(const Impact& impact, double end, double first, double last) {
    const double half = impact.roundTrip / 2;
    // a little more than is asked for: what lies at a limit but for rounding is among it
    const double rounding = roundingOfTrip(end, impact.roundTrip);
    const double from = std::max(end - half, 2 * end - last - rounding);
    const double until = std::min(end + half, 2 * end - first + rounding);
    std::vector<double> times;
    forEachPoint(impact, from, until, {}, [&](std::size_t piece, double x, Side) {
        const double time = impact.incident.pieces()[piece].start + x;
        if (time >= from && time <= until) times.push_back(2 * end - time);
    });
    std::ranges::sort(times);
    times.erase(std::ranges::unique(times).begin(), times.end());
    return times;
}

std::vector<double> counterparts(const Impact& impact, double end) {
    const double half = impact.roundTrip / 2;
    return counterparts(impact, end, end - half, end + half);
}

Instant instantBeforeFront(const Impact& impact, double time) {
    const double before = incidentWave(impact, -impact.roundTrip / 2);
    return {time, Side::end, before, -before};
}

std::vector<Instant> lastPeriod(const Impact& impact) {
    const double from = impact.incident.end() - impact.roundTrip;
    std::vector<Instant> instants;
    forEachInstant(impact, from, {from}, [&](const Instant& now) {
        if (now.time >= from) instants.push_back(now);
    });
    return instants;
}

double roundingOfTrip(double time, double roundTrip) {
    return 8 * std::numeric_limits<double>::epsilon() * (time + roundTrip);
}

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
