// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_basis.h"

#include "core/contact/bilinear_law.h"
#include "core/wave/exact/exponential_stretches.h"

namespace drillwave {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Where a blow is left to power series from the start. Elsewhere the basis may still fail and be replaced,
// but mostly it solves what series solve, several times as fast; the numbers are where that ends.

/// γ < 1: terms of the other rate are divided by 1 − γ at every reflection. From 0.9 on none is solved.
constexpr double largestGamma = 0.7;

/// Nearer to 1 where contact ends within a round trip, so that few reflections divide by 1 − γ.
constexpr double largestStiffGamma = 0.9, leastStiffDecay = 3;

/// βτ and β below which a growing share fails, loses more digits than series do, or takes longer. Contact
/// lasts about 1.6/√(βτ) round trips, each of which needs another of the few terms; and rounding persists for
/// the 1/β that the force takes to decay.
struct Stiffness {
    double decay, beta;
};
constexpr Stiffness leastForSteps{0.3, 0.02}, leastForCurves{0.3, 0.15}, leastForRamps{1, 0.4};
constexpr Stiffness leastForTables{3, 1.5};  ///< dozens of ramps, many of them steep

/// Pulses of fewer linear pieces are those of a formula.
constexpr std::size_t leastTable = 12;

Stiffness leastFor(const PulseForce& hammer) {
    using Kind = PulseSegment::Kind;
    const auto& segments = hammer.segments;
    if (segments.empty()) return leastForSteps;
    if (segments.front().kind != Kind::linear) return leastForCurves;
    const bool isSteps = std::all_of(segments.begin(), segments.end(),
                                     [](const PulseSegment& segment) { return segment.slope == 0; });
    if (isSteps) return leastForSteps;
    return segments.size() < leastTable ? leastForRamps : leastForTables;
}

/// Each is a piece that all reflections repeat, and most of them are short where there are many.
constexpr std::size_t mostSegments = 1000;

/// β and β/γ beside the rate of an exponential blow, 1/t0: the response is divided by the difference.
constexpr double leastDetuning = 0.1;

/// A sum of terms so much larger than any wave force cancels, and loses as many digits.
constexpr double mostCancellation = 1024;

/// Of the roundings that could be seen: terms of less are dropped.
constexpr int negligibleExponent = -62;

/// F' + aF = 2a g for the terms of the same rate: F_{m+1} = 2 g_m; F_0 is left to the initial condition.
bool resonant(const Coefficients& g, Coefficients& force) {
    if (g.count + 1 > Coefficients::capacity) return false;
    force.count = g.count + 1;
    for (int m = 0; m < g.count; ++m) force.c[m + 1] = 2 * g.c[m];
    return true;
}

/// The same for terms of another rate λ: (a − λ) F_m + λ F_{m+1} = 2a g_m.
void nonResonant(const Coefficients& g, double a, double lambda, Coefficients& force) {
    force.count = g.count;
    double next = 0;
    for (int m = g.count - 1; m >= 0; --m) {
        next = (2 * a * g.c[m] - lambda * next) / (a - lambda);
        force.c[m] = next;
    }
}

HammerTerms combine(double p, const HammerTerms& g, double q, const HammerTerms& f) {
    return {p * g.sine + q * f.sine, p * g.cosine + q * f.cosine, p * g.decay + q * f.decay, true};
}

/// out = p·g + q·f
void combine(double p, const Coefficients& g, double q, const Coefficients& f, Coefficients& out) {
    out.count = std::max(g.count, f.count);
    for (int m = 0; m < out.count; ++m)
        out.c[m] = (m < g.count ? p * g.c[m] : 0) + (m < f.count ? q * f.c[m] : 0);
}

void combine(double p, const ExponentialSum& g, double q, const ExponentialSum& f, ExponentialSum& out) {
    out.length = g.length;
    out.c0 = p * g.c0 + q * f.c0;
    out.c1 = p * g.c1 + q * f.c1;
    combine(p, g.primary.decays, q, f.primary.decays, out.primary.decays);
    combine(p, g.elastic.decays, q, f.elastic.decays, out.elastic.decays);
    combine(p, g.primary.rises, q, f.primary.rises, out.primary.rises);
    combine(p, g.elastic.rises, q, f.elastic.rises, out.elastic.rises);
    if (g.hammer.present || f.hammer.present)
        out.hammer = combine(p, g.hammer, q, f.hammer);
    else
        out.hammer = {};
    out.primaryDecay = g.primaryDecay;
    out.elasticDecay = g.elasticDecay;
    out.rates = g.rates;
}

/// The forced responses, which begin anywhere: 2a (a + d/dx)^{-1} of a sine and of e^{−x}.
HammerTerms forced(const HammerTerms& g, double a) {
    constexpr double pi = HammerTerms::pi;
    HammerTerms force;
    force.present = g.present;
    if (g.hasSine()) {
        const double factor = 2 * a / (a * a + pi * pi);
        force.sine = factor * (a * g.sine + pi * g.cosine);
        force.cosine = factor * (a * g.cosine - pi * g.sine);
    }
    if (g.decay != 0) force.decay = 2 * a / (a - 1) * g.decay;
    return force;
}

/// ∫ e^{−x} f over [0, length], of a sum without sine and rises, which an exponential blow leaves: e^{−x}
/// φ_m(λx) = (λ/μ)^m φ_m(μx), μ = λ + 1.
double decayingIntegral(const ExponentialSum& f, double length) {
    const auto of = [length](Coefficients terms, double rate) {
        const double together = rate + 1;
        double power = 1;
        for (int m = 0; m < terms.count; ++m, power *= rate / together) terms.c[m] *= power;
        const double y = together * length;
        return terms.rises(y, std::exp(-y)) / together;
    };
    const double decayed = -std::expm1(-length);
    double sum = f.c0 * decayed + f.c1 * (decayed - length * std::exp(-length));
    sum -= f.hammer.decay * std::expm1(-2 * length) / 2;
    if (f.primary.decays.count) sum += of(f.primary.decays, f.rates->primary);
    if (f.elastic.decays.count) sum += of(f.elastic.decays, f.rates->elastic);
    return sum;
}

/// An upper bound of ∫f over [0, x] for every x up to the length.
double mostIntegral(const RateTerms& f, double rate, double length) {
    return f.decays.positivePart() / rate + f.rises.positivePart() * std::min(rate * length, 1.0) * length;
}

}  // namespace

bool ExponentialBasis::suits(const Problem& problem) {
    const auto [beta, gamma] = problem.law;
    const double decay = beta * problem.transitTime;
    if (decay < leastForSteps.decay || beta < leastForSteps.beta) return false;
    if (gamma < 1 && gamma > (decay < leastStiffDecay ? largestGamma : largestStiffGamma)) return false;
    if (problem.hammer.segments.size() > mostSegments) return false;
    const Stiffness least = leastFor(problem.hammer);
    if (decay < least.decay || beta < least.beta) return false;
    if (problem.hammer.shape == PulseShape::exponential) {
        const auto isDetuned = [](double rate) { return std::abs(rate - 1) > leastDetuning; };
        return isDetuned(beta) && isDetuned(beta / gamma);
    }
    return true;
}

void ExponentialBasis::begin(const Problem& problem, ContactRates<double> rates) {
    m_failed = false;
    m_count = {};
    m_rates = rates;
    m_scale = std::max(problem.hammer.peak, problem.transitTime < 0.5 || problem.hammer.isRigidBody()
                                                ? 1 / (2 * problem.transitTime)
                                                : 0.0);
    m_negligible = std::ldexp(m_scale, negligibleExponent);
}

ExponentialSum ExponentialBasis::constant(double length, double value) const {
    Piece f = Piece::zero(length);
    f.c0 = value;
    return f;
}

void ExponentialBasis::addHammer(const PulseSegment& segment, double into, double length, Piece& g) const {
    g.shorten(length);
    switch (segment.kind) {
        case PulseSegment::Kind::linear:
            g.c0 += segment.value + segment.slope * into;
            g.c1 += segment.slope;
            break;
        case PulseSegment::Kind::sine: {
            const double phase = HammerTerms::pi * (segment.start + into);
            g.hammer.sine += segment.value * std::cos(phase);
            g.hammer.cosine += segment.value * std::sin(phase);
            g.hammer.present = true;
            break;
        }
        case PulseSegment::Kind::exponential:
            g.hammer.decay += segment.value * std::exp(-into);
            g.hammer.present = true;
            break;
    }
}

double ExponentialBasis::hammerProduct(const PulseSegment& segment, double into, const Piece& g,
                                       double length) const {
    const bool isConstant = segment.kind == PulseSegment::Kind::linear && segment.slope == 0;
    if (isConstant) return segment.value * g.integral(length);
    if (segment.kind == PulseSegment::Kind::exponential && !g.hammer.hasSine())
        return segment.value * std::exp(-into) * decayingIntegral(g, length);
    Piece hammer = Piece::zero(length);
    addHammer(segment, into, length, hammer);
    return productIntegral(hammer, g, length);
}

ExponentialBasis::Response& ExponentialBasis::respond(Piece& g, double rate, double force) {
    Response& r = m_response;
    g.rates = &m_rates;
    r.incident = &g;
    r.length = g.length;
    r.rate = rate;
    const bool primary = rate == m_rates.primary;
    const double other = primary ? m_rates.elastic : m_rates.primary;
    const RateTerms& same = primary ? g.primary : g.elastic;
    const RateTerms& different = primary ? g.elastic : g.primary;
    RateTerms& forceSame = primary ? r.force.primary : r.force.elastic;
    RateTerms& forceDifferent = primary ? r.force.elastic : r.force.primary;

    r.force.length = g.length;
    r.force.rates = &m_rates;
    r.force.c1 = 2 * g.c1;
    r.force.c0 = 2 * g.c0;
    nonResonant(different.decays, rate, other, forceDifferent.decays);
    if (!resonant(same.decays, forceSame.decays)) {
        m_failed = true;
        return r;
    }
    if (g.c1 == 0 && same.rises.count == 0 && different.rises.count == 0) {
        forceSame.rises.count = forceDifferent.rises.count = 0;
    } else {
        // F' = 0 at the start for all that begins at zero: 2x − 2ω_0(ax)/a for a ramp, −(λ/a) F_0 ω_0(ax) for
        // rises of another rate
        nonResonant(different.rises, rate, other, forceDifferent.rises);
        if (!resonant(same.rises, forceSame.rises)) {
            m_failed = true;
            return r;
        }
        forceSame.rises.c[0] = -(r.force.c1 + other * forceDifferent.rises[0]) / rate;
    }
    r.force.hammer = g.hammer.present ? forced(g.hammer, rate) : HammerTerms{};
    // the layer in which the force joins the slow solution; on stiff rock its rounding would seem an event
    const double slow = r.force.c0 + forceDifferent.start() + r.force.hammer.startValue();
    const double layer = force - slow;
    const bool isRounding = std::abs(layer) <= 4 * epsilon * (std::abs(force) + std::abs(r.force.c0));
    forceSame.decays.c[0] = isRounding ? 0 : layer;
    // the decays over the whole piece serve all functions of this piece
    if (g.primaryDecay < 0 && !r.force.primary.isZero())
        g.primaryDecay = std::exp(-m_rates.primary * g.length);
    if (g.elasticDecay < 0 && !r.force.elastic.isZero())
        g.elasticDecay = std::exp(-m_rates.elastic * g.length);
    r.force.primaryDecay = g.primaryDecay;
    r.force.elasticDecay = g.elasticDecay;
    r.size = r.force.magnitude();
    if (r.size > mostCancellation * m_scale) m_failed = true;
    return r;
}

void ExponentialBasis::reflect(const Response& r, Piece& reflected) const {
    combine(1, *r.incident, -1, r.force, reflected);
    reflected.length = r.length;
    reflected.primaryDecay = r.force.primaryDecay;
    reflected.elasticDecay = r.force.elasticDecay;
}

/// 2g − F; where both nearly cancel on stiff rock, term by term as F'/a.
const ExponentialSum& ExponentialBasis::drive(const Response& r) {
    combine(2, *r.incident, -1, r.force, m_drive);
    const bool primary = r.rate == m_rates.primary;
    const Coefficients& slow = primary ? r.force.elastic.decays : r.force.primary.decays;
    Coefficients& drive = primary ? m_drive.elastic.decays : m_drive.primary.decays;
    const double share = (primary ? m_rates.elastic : m_rates.primary) / r.rate;
    for (int m = 0; m < slow.count; ++m) drive.c[m] = share * (slow[m + 1] - slow.c[m]);
    if (const HammerTerms& force = r.force.hammer; force.present)
        m_drive.hammer = {-HammerTerms::pi / r.rate * force.cosine, HammerTerms::pi / r.rate * force.sine,
                          -force.decay / r.rate, true};
    return m_drive;
}

/// The decays up to the end serve every function of this stretch.
void ExponentialBasis::endAt(Response& r, double length) {
    if (length == r.length) return;
    r.length = length;
    r.force.shorten(length);
    if (!r.force.primary.isZero()) r.force.primaryDecay = std::exp(-m_rates.primary * length);
    if (!r.force.elastic.isZero()) r.force.elasticDecay = std::exp(-m_rates.elastic * length);
}

void ExponentialBasis::dropFront(Piece& g, const Response& r) const {
    g.rates = &m_rates;
    g.dropFront(r.length, r.force.primaryDecay, r.force.elasticDecay);
}

double ExponentialBasis::mostIntegral(const Piece& g) const {
    double most = std::max({0.0, g.c0, g.c0 + g.c1 * g.length}) * g.length;
    if (!g.primary.isZero()) most += drillwave::mostIntegral(g.primary, m_rates.primary, g.length);
    if (!g.elastic.isZero()) most += drillwave::mostIntegral(g.elastic, m_rates.elastic, g.length);
    if (g.hammer.present)
        most += g.hammer.amplitude() * g.length + std::max(g.hammer.decay, 0.0) * std::min(g.length, 1.0);
    return most;
}

Zero<double> ExponentialBasis::gapClosure(const Piece& g, double gap) {
    if (g.allAtMostZero()) return gap < 0 ? Zero<double>::at(0) : Zero<double>{};
    if (gap > 2 * mostIntegral(g)) return {};
    const bool isConstant = g.primary.isZero() && g.elastic.isZero() && g.c1 == 0 && !g.hammer.present;
    if (isConstant) {
        const double x = gap / (2 * g.c0);
        return x <= g.length ? Zero<double>::at(x) : Zero<double>{};
    }
    // gap − 2∫g: ∫φ_m = ω_m/λ, and ∫ω_m = x − Σ_{k≤m} ω_k/λ
    Piece& f = m_searched;
    f = Piece::zero(g.length);
    f.rates = &m_rates;
    f.c0 = gap;
    f.c1 = -2 * g.c0;
    const auto integrate = [&f](const RateTerms& terms, double rate, RateTerms& out) {
        const Coefficients sums = RateTerms::sumsFromEach(terms.rises);
        combine(-2 / rate, terms.decays, 2 / rate, sums, out.rises);
        f.c1 -= 2 * sums[0];
    };
    integrate(g.primary, m_rates.primary, f.primary);
    integrate(g.elastic, m_rates.elastic, f.elastic);
    if (g.hammer.present) {
        constexpr double pi = HammerTerms::pi;
        f.hammer = {-2 * g.hammer.cosine / pi, 2 * g.hammer.sine / pi, 2 * g.hammer.decay, true};
        f.c0 -= f.hammer.startValue();
    }
    return decided(firstZero(f, -g.c1, {.startsAtZero = gap == 0}, m_count));
}

Zero<double> ExponentialBasis::forceVanishes(Response& r) {
    // a compressive wave cannot pull the rod off: F is a positive mean of 2g and of what it was
    if (r.incident->allAtLeastZero()) return {};
    return decided(firstZero(r.force, 0, {.negligible = m_negligible}, m_count));
}

Zero<double> ExponentialBasis::driveVanishes(Response& r) {
    return decided(firstZero(drive(r), 0, {.negligible = m_negligible}, m_count));
}

Zero<double> ExponentialBasis::forceReaches(Response& r, double peak, bool tangential) {
    Piece& f = m_searched;
    double start = 0;
    if (tangential) {  // no return before the force has turned: F' = a·drive changes sign
        const Piece& falling = drive(r);
        combine(-1, falling, 0, falling, f);
        const auto turn =
            decided(firstZero(f, 0, {.startsAtZero = true, .negligible = m_negligible}, m_count));
        if (!turn.found || m_failed) return {};
        start = turn.u;
        if (start == 0) return Zero<double>::at(0);
    }
    if (start == 0 && 2 * r.incident->mostValue() <= peak) return {};  // F ≤ max(F(0), 2 max g)
    combine(0, r.force, -1, r.force, f);
    f.c0 += peak;
    return decided(firstZero(f, 0, {.start = start, .negligible = m_negligible}, m_count));
}

double ExponentialBasis::largestIntegral(const Piece& g) {
    const double whole = g.integral(g.length);
    if (g.allAtLeastZero()) return whole;
    double most = std::max(whole, 0.0), before = 0;
    ExponentialStretches(std::array{&g}, g.length, m_negligible).forEach([&](double, const auto& series) {
        const PowerSeries<double>& f = series[0];
        const auto look = [&](double x) { most = std::max(most, before + f.integral(x)); };
        if (!forEachMaximum(f, f.length, look)) m_failed = true;
        before += f.integral(f.length);
    });
    return most;
}

double ExponentialBasis::roundingError(const Response& r, double length) const {
    const auto lasting = [length](const RateTerms& terms, double rate) {
        return terms.decays.magnitude() * std::min(length, Coefficients::capacity / rate) +
               terms.rises.magnitude() * std::min(rate * length, 1.0) * length;
    };
    const double weighted =
        (std::abs(r.force.c0) + std::abs(r.force.c1) * length + r.force.hammer.magnitude()) * length +
        lasting(r.force.primary, m_rates.primary) + lasting(r.force.elastic, m_rates.elastic);
    const double persisting =
        r.size * epsilon / m_rates.primary;  // decays only as slowly as the contact force
    return 4 * (epsilon * weighted + persisting + m_negligible * length);
}

void ExponentialBasis::tidy(Piece& piece) const {
    piece.rates = &m_rates;
    piece.primary.trim(m_negligible);
    piece.elastic.trim(m_negligible);
    if (piece.hammer.present) piece.hammer.trim(m_negligible);
    if (std::abs(piece.c0) + std::abs(piece.c1) * piece.length <= m_negligible) piece.c0 = piece.c1 = 0;
}

double ExponentialBasis::largest(const Response& r, double length, double before) {
    if (2 * r.incident->mostValue() <= before) return before;  // F ≤ max(F(0), 2 max g)
    double most = before;
    const Piece& slope = drive(r);
    if (slope.allAtLeastZero() || slope.allAtMostZero()) return most;
    // F turns where the drive changes its sign, at most once more for each of its terms
    Piece& turning = m_searched;
    turning = slope;
    turning.shorten(length);
    bool isRising = turning.startValue() > 0;
    if (!isRising) combine(-1, turning, 0, turning, turning);
    double start = 0;
    for (int turn = 0; turn < 2 * Coefficients::capacity; ++turn) {
        const auto zero =
            decided(firstZero(turning, 0, {.start = start, .negligible = m_negligible}, m_count));
        if (!zero.found || m_failed) break;
        if (isRising) most = std::max(most, r.force.value(zero.u));
        isRising = !isRising;
        combine(-1, turning, 0, turning, turning);
        start = zero.u;
    }
    return most;
}

double ExponentialBasis::productIntegral(const Piece& f, const Piece& g, double length) const {
    double sum = 0;
    ExponentialStretches(std::array{&f, &g}, length, m_negligible).forEach([&](double, const auto& series) {
        sum += PowerSeries<double>::productIntegral(series[0], series[1], series[0].length);
    });
    return sum;
}

void ExponentialBasis::record(const Piece& incident, const Piece* force, double length,
                              Impact& impact) const {
    const auto used = [](const PowerSeries<double>& f) {
        return std::span<const double>(f.c.data(), static_cast<std::size_t>(f.count));
    };
    const Piece none;
    const std::array functions{&incident, force ? force : &none};
    ExponentialStretches(functions, length, m_negligible).forEach([&](double, const auto& series) {
        const auto& [g, F] = series;
        impact.incident.append(g.length, g.scale, used(g));
        impact.force.append(g.length, g.scale, used(F));
    });
}

}  // namespace drillwave
