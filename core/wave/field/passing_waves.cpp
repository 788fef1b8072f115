// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/field/passing_waves.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "core/numeric/power_series.h"
#include "core/wave/exact/exact_solver.h"
#include "core/wave/field/rod_instants.h"

namespace drillwave {

namespace {

/// As shares of the largest force: what counts as a peak, and what parts two of them.
constexpr double leastPeak = 0.01;
constexpr double leastDip = 1e-9;

/// Bernstein coefficients, no more than a piece has terms.
struct Bernstein {
    static constexpr std::size_t capacity = PowerSeries<double>::capacity;

    std::size_t count = 0;
    std::array<double, capacity> b;

    double& operator[](std::size_t j) { return b[j]; }
    std::span<const double> values() const { return {b.data(), count}; }
};

/// The slope of a piece over its share v of the length, 0 ≤ v ≤ 1, as powers of v.
Bernstein slopeOf(std::span<const double> c, double end) {
    assert(c.size() <= Bernstein::capacity);
    Bernstein slope;
    slope.count = c.size() - 1;
    double power = end;
    for (std::size_t k = 0; k < slope.count; ++k, power *= end) slope[k] = double(k + 1) * c[k + 1] * power;
    return slope;
}

/// Whether a slope, given as powers, has one sign or does not count: enough for it, not needed. No Bernstein
/// coefficient is further from the first power than all others add up to.
bool hardlyTurns(const Bernstein& powers, double negligible) {
    double rest = 0;
    for (std::size_t k = 1; k < powers.count; ++k) rest += std::abs(powers.b[k]);
    const double first = std::abs(powers.b[0]);
    return first >= rest || first + rest <= negligible;
}

/// Without the last powers, which together come to nothing beside what counts.
void trim(Bernstein& powers, double negligible) {
    double rest = 0;
    while (powers.count > 1 && (rest += std::abs(powers.b[powers.count - 1])) <= negligible) --powers.count;
}

/// Powers as Bernstein coefficients: their signs change at least as often as the slope does.
Bernstein fromPowers(Bernstein slope) {
    const std::size_t count = slope.count;  // of degree count − 1
    // a_k / C(n, k), then summed binomially by differences run backwards.
    double binomial = 1;
    for (std::size_t k = 1; k < count; ++k) {
        binomial *= double(count - k) / double(k);
        slope[k] /= binomial;
    }
    for (std::size_t round = 1; round < count; ++round)
        for (std::size_t j = count - 1; j >= round; --j) slope[j] += slope[j - 1];
    return slope;
}

bool keepsItsSign(const Bernstein& slope) {
    const auto [least, most] = std::ranges::minmax_element(slope.values());
    return *least >= 0 || *most <= 0;
}

int changesOfSign(const Bernstein& slope) {
    int changes = 0;
    double before = 0;
    for (const double b : slope.values()) {
        if (b * before < 0) ++changes;
        if (b != 0) before = b > 0 ? 1 : -1;
    }
    return changes;
}

double steepestOf(const Bernstein& slope) {
    double steepest = 0;
    for (const double b : slope.values()) steepest = std::max(steepest, std::abs(b));
    return steepest;
}

/// Where a slope, given as powers and as Bernstein coefficients, changes its sign, which it does once: so
/// closely that what a wave rises or falls from there does not count.
double turnOf(const Bernstein& powers, const Bernstein& slope, double negligible) {
    const double first = *std::ranges::find_if(slope.values(), [](double b) { return b != 0; });
    const double steepest = steepestOf(slope);
    double before = 0, behind = 1;
    while (steepest * (behind - before) > negligible) {
        const double middle = (before + behind) / 2;
        const double there = polynomialValue(powers.b.data(), static_cast<int>(powers.count), middle);
        (there * first > 0 ? before : behind) = middle;
    }
    return behind;
}

/// Halves at v = 1/2, by de Casteljau: the left one; the right one takes the place of `slope`.
Bernstein halve(Bernstein& slope) {
    Bernstein left;
    left.count = slope.count;
    for (std::size_t round = 0; round < slope.count; ++round) {
        left[round] = slope[0];
        for (std::size_t j = 0; j + 1 < slope.count - round; ++j) slope[j] = (slope[j] + slope[j + 1]) / 2;
        // The coefficients that drop out on the right stay in place, as the right half.
    }
    return left;
}

/// Passes the ends of the stretches over which a piece only rises or only falls, but for what is too small to
/// count: the stretch from v to v + width has that slope.
template <class Pass>
void passTurns(Bernstein slope, double v, double width, double negligible, const Pass& pass) {
    if (keepsItsSign(slope) || steepestOf(slope) * width <= negligible) return pass(v + width);
    const Bernstein left = halve(slope);
    passTurns(left, v, width / 2, negligible, pass);
    passTurns(slope, v + width / 2, width / 2, negligible, pass);
}

/// `from` without the pieces before `first`.
PiecewisePolynomial tailOf(const PiecewisePolynomial& from, std::size_t first) {
    PiecewisePolynomial tail;
    const auto pieces = from.pieces();
    tail.clear(first < pieces.size() ? pieces[first].start : from.end());
    for (std::size_t i = first; i < pieces.size(); ++i)
        tail.append(pieces[i].length, pieces[i].scale, from.coefficients(pieces[i]));
    return tail;
}

void keepLarger(RodForce& largest, const RodForce& other) {
    if (other.size > largest.size) largest = other;
}

}  // namespace

ForcePeaks::ForcePeaks(double largest) : m_least(leastPeak * largest), m_dip(leastDip * largest) {}

/// Counts peaks from the rises and falls of a row of values.
void ForcePeaks::pass(double force) {
    m_turn = m_rising ? std::max(m_turn, force) : std::min(m_turn, force);
    if (std::abs(force - m_turn) <= m_dip) return;
    if (m_rising && m_turn > m_least) ++m_peaks;
    m_rising = !m_rising;
    m_turn = force;
}

void ForcePeaks::add(const PiecewisePolynomial& force, const PiecewisePolynomial::Piece& piece) {
    const std::span<const double> c = force.coefficients(piece);
    const auto passAt = [&](double v) { pass(force.value(piece, v * piece.length)); };
    passAt(0);
    if (c.size() <= 1) return passAt(1);
    const double negligible = m_dip / 4;
    Bernstein slope = slopeOf(c, piece.length / piece.scale);
    trim(slope, negligible / 1024);
    if (hardlyTurns(slope, negligible)) return passAt(1);
    const Bernstein control = fromPowers(slope);
    if (changesOfSign(control) != 1) return passTurns(control, 0, 1, negligible, passAt);
    passAt(turnOf(slope, control, negligible));
    passAt(1);
}

int ForcePeaks::count() {
    pass(0);
    return m_peaks;
}

int forcePeaks(const Impact& impact) {
    ForcePeaks peaks(impact.peakForce);
    for (const PiecewisePolynomial::Piece& piece : impact.force.pieces()) peaks.add(impact.force, piece);
    return peaks.count();
}

PassingWaves::PassingWaves(const Impact& solved, const PulseForce& pulse, const RodForceChoice& choice)
    : m_pulse(pulse), m_choice(choice), m_window(solved), m_peaks(solved.peakForce) {}

std::size_t PassingWaves::take(Impact& recording) {
    look(recording, {m_choice.compression, m_choice.tension, false});
    // at the end of the blow waves meet that are up to one and a half round trips apart
    constexpr double roundTripsKept = 2;
    const double from = m_window.incident.end() - roundTripsKept * m_window.roundTrip;
    const std::size_t first = firstPieceUntil(m_window, from);
    recording.incident = tailOf(m_window.incident, first);
    recording.force = tailOf(m_window.force, first);
    m_seen = recording.incident.pieces().size();
    return m_seen + piecesHandedOver;
}

void PassingWaves::takeLast(Impact& recording) {
    look(recording, m_choice);
}

void PassingWaves::look(Impact& recording, const RodForceChoice& choice) {
    m_window.incident = std::move(recording.incident);
    m_window.force = std::move(recording.force);
    m_window.skips = recording.skips;
    const auto pieces = m_window.force.pieces();
    for (std::size_t i = m_seen; i < pieces.size(); ++i) m_peaks.add(m_window.force, pieces[i]);
    const RodForces found = largestRodForces(m_window, m_pulse, choice);
    keepLarger(m_forces.compression, found.compression);
    keepLarger(m_forces.tension, found.tension);
    m_forces.compressionAfter = found.compressionAfter;
    m_forces.tensionAfter = found.tensionAfter;
}

}  // namespace drillwave
