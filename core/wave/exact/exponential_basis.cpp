// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_basis.h"

#include "core/contact/bilinear_law.h"
#include "core/wave/exact/exponential_stretches.h"

namespace drillwave {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Where a blow is left to power series from the start. Elsewhere the basis may still fail and be replaced,
// but mostly it solves what series solve, several times as fast; the numbers are where that ends.

/// β/γ: one decade below what ContactMarch takes for a layer without thickness.
constexpr double largestRate = 1e14;

/// γ < 1: terms of the other rate are divided by 1 − γ at every reflection. From 0.9 on none is solved.
constexpr double largestGamma = 0.7;

/// βτ: contact lasts about 1.6/√(βτ) round trips, and each needs another of the few terms. Below, a growing
/// share fails, and what is solved takes longer than series.
constexpr double leastContactDecay = 1.5;

/// β: rounding persists for the 1/β that the force takes to decay, and e errs by as much.
constexpr double leastBeta = 0.02;

/// Each is a piece that all reflections repeat: with more, series are as fast.
constexpr std::size_t mostSegments = 12;

/// A sum of terms so much larger than any wave force cancels, and loses as many digits.
constexpr double mostCancellation = 64;

/// Of the roundings that could be seen: terms of less are dropped.
constexpr int negligibleExponent = -62;

// A zero is near beyond doubt where the function falls, is hardly bent on the way to it, and no exponential
// of it changes much: then Halley's method converges.
constexpr double nearInDecays = 0.25;
constexpr double nearInBend = 0.4;

/// A last step so small, in units of the fastest change, leaves an error of its third power: rounding.
constexpr double lastHalleyStep = 1e-5;

/// F' + aF = 2a g for the terms of the same rate: F_{m+1} = 2 g_m; F_0 is left to the initial condition.
bool resonant(const DecayTerms& g, DecayTerms& force) {
    if (g.count + 1 > DecayTerms::capacity) return false;
    force.count = g.count + 1;
    for (int m = 0; m < g.count; ++m) force.c[m + 1] = 2 * g.c[m];
    return true;
}

/// The same for terms of another rate λ: (a − λ) F_m + λ F_{m+1} = 2a g_m.
void nonResonant(const DecayTerms& g, double a, double lambda, DecayTerms& force) {
    force.count = g.count;
    double next = 0;
    for (int m = g.count - 1; m >= 0; --m) {
        next = (2 * a * g.c[m] - lambda * next) / (a - lambda);
        force.c[m] = next;
    }
}

/// out = p·g + q·f
void combine(double p, const DecayTerms& g, double q, const DecayTerms& f, DecayTerms& out) {
    out.count = std::max(g.count, f.count);
    for (int m = 0; m < out.count; ++m)
        out.c[m] = (m < g.count ? p * g.c[m] : 0) + (m < f.count ? q * f.c[m] : 0);
}

void combine(double p, const ExponentialSum& g, double q, const ExponentialSum& f, ExponentialSum& out) {
    out.length = g.length;
    out.c0 = p * g.c0 + q * f.c0;
    out.c1 = p * g.c1 + q * f.c1;
    combine(p, g.primary, q, f.primary, out.primary);
    combine(p, g.elastic, q, f.elastic, out.elastic);
    out.primaryDecay = g.primaryDecay;
    out.elasticDecay = g.elasticDecay;
    out.rates = g.rates;
}

/// The zero at x unless it lies beyond the end.
Zero<double> zeroUpTo(double end, double x) {
    return x <= end ? Zero<double>::at(x) : Zero<double>{};
}

/// Value, slope/rate, curvature/rate² at y, and a lower bound of the latter over [y, ∞), of Σ c_m φ_m.
struct Local {
    double value = 0, slope = 0, curvature = 0, leastCurvature = 0, size = 0;
};
Local localOf(const DecayTerms& f, double y, double decay) {
    // largest values of φ_m, at y = m
    static constexpr double peak[] = {1,
                                      0.36787944117144233,
                                      0.27067056647322538,
                                      0.22404180765538775,
                                      0.19536681481316454,
                                      0.17546736976785068};
    Local local;
    double phi = decay;
    for (int m = 0; m < f.count; ++m) {
        const double a = f.c[m];
        const double b = m + 1 < f.count ? f.c[m + 1] : 0;
        const double c = m + 2 < f.count ? f.c[m + 2] : 0;
        local.value += a * phi;
        local.slope += (b - a) * phi;
        local.size += std::abs(a) * phi;
        const double curvature = a - 2 * b + c;
        local.curvature += curvature * phi;
        if (curvature < 0) local.leastCurvature += curvature * (y >= m ? phi : peak[m]);
        phi *= y / (m + 1);
    }
    return local;
}

}  // namespace

bool ExponentialBasis::suits(const Problem& problem) {
    if (BilinearLaw<>(problem.law).slopes().elastic > largestRate) return false;
    if (problem.law.gamma > largestGamma && problem.law.gamma < 1) return false;
    if (problem.law.beta * problem.transitTime < leastContactDecay || problem.law.beta < leastBeta)
        return false;
    if (problem.hammer.segments.size() > mostSegments) return false;
    for (const PulseSegment& segment : problem.hammer.segments)
        if (segment.kind != PulseSegment::Kind::linear) return false;
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

const ExponentialSum& ExponentialBasis::addHammer(const PulseSegment& segment, double into, double length,
                                                  Piece& g) {
    m_hammer.length = length;
    m_hammer.c0 = segment.value + segment.slope * into;
    m_hammer.c1 = segment.slope;
    g.shorten(length);
    g.c0 += m_hammer.c0;
    g.c1 += m_hammer.c1;
    return m_hammer;
}

ExponentialBasis::Response& ExponentialBasis::respond(const Piece& g, double rate, double force) {
    Response& r = m_response;
    r.incident = g;
    r.incident.rates = &m_rates;
    r.length = g.length;
    r.rate = rate;
    const bool primary = rate == m_rates.primary;
    const double other = primary ? m_rates.elastic : m_rates.primary;
    const DecayTerms& same = primary ? r.incident.primary : r.incident.elastic;
    const DecayTerms& different = primary ? r.incident.elastic : r.incident.primary;
    DecayTerms& forceSame = primary ? r.force.primary : r.force.elastic;
    DecayTerms& forceDifferent = primary ? r.force.elastic : r.force.primary;

    r.force.length = g.length;
    r.force.rates = &m_rates;
    r.force.c1 = 2 * g.c1;
    r.force.c0 = 2 * g.c0 - r.force.c1 / rate;
    nonResonant(different, rate, other, forceDifferent);
    if (!resonant(same, forceSame)) {
        m_failed = true;
        return r;
    }
    forceSame.c[0] = force - r.force.c0 - forceDifferent.start();
    // the decays over the whole piece serve all functions of this piece
    if (r.incident.primaryDecay < 0 && r.force.primary.count)
        r.incident.primaryDecay = std::exp(-m_rates.primary * g.length);
    if (r.incident.elasticDecay < 0 && r.force.elastic.count)
        r.incident.elasticDecay = std::exp(-m_rates.elastic * g.length);
    r.force.primaryDecay = r.incident.primaryDecay;
    r.force.elasticDecay = r.incident.elasticDecay;
    r.size = r.force.magnitude();
    if (r.size > mostCancellation * m_scale) {
        m_failed = true;
        return r;
    }
    combine(1, r.incident, -1, r.force, r.reflected);
    return r;
}

const ExponentialSum& ExponentialBasis::drive(const Response& r) {
    combine(2, r.incident, -1, r.force, m_drive);
    return m_drive;
}

/// The decays up to the end serve every function of this stretch.
void ExponentialBasis::endAt(Response& r, double length) {
    if (length == r.length) return;
    r.length = length;
    r.force.shorten(length);
    if (r.force.primary.count) r.force.primaryDecay = std::exp(-m_rates.primary * length);
    if (r.force.elastic.count) r.force.elasticDecay = std::exp(-m_rates.elastic * length);
    r.reflected.length = length;
    r.reflected.primaryDecay = r.force.primaryDecay;
    r.reflected.elasticDecay = r.force.elasticDecay;
}

void ExponentialBasis::dropFront(Piece& g, const Response& r) const {
    g.rates = &m_rates;
    g.dropFront(r.length, r.force.primaryDecay, r.force.elasticDecay);
}

ExponentialBasis::Sample ExponentialBasis::sample(const Piece& f, double c2, double x) const {
    Sample s;
    s.value = f.c0 + x * (f.c1 + x * c2);
    s.slope = f.c1 + 2 * c2 * x;
    s.curvature = s.leastCurvature = 2 * c2;
    s.size = std::abs(f.c0) + std::abs(f.c1) * x + std::abs(c2) * x * x;
    const auto add = [&](const DecayTerms& terms, double rate) {
        if (terms.count == 0) return;
        const double y = rate * x;
        const Local local = localOf(terms, y, x == 0 ? 1.0 : std::exp(-y));
        s.value += local.value;
        s.slope += rate * local.slope;
        s.curvature += rate * rate * local.curvature;
        s.leastCurvature += rate * rate * local.leastCurvature;
        s.size += local.size * (1 + y);
        s.fastest = std::max(s.fastest, rate);
    };
    add(f.primary, m_rates.primary);
    add(f.elastic, m_rates.elastic);
    return s;
}

/// First zero in (start, end] of f + c2 x², positive just after the start: steps from a lower bound on the
/// curvature pass no zero; once one is near beyond doubt, Halley's method takes it.
Zero<double> ExponentialBasis::firstZero(const Piece& f, double c2, double end, double start,
                                         bool zeroAtStart) {
    if (f.c0 >= 0 && f.c1 >= 0 && c2 >= 0 && f.primary.allAtLeastZero() && f.elastic.allAtLeastZero())
        return {};
    double x = start;
    ++m_count.searches;
    for (int step = 0; step < mostSteps; ++step) {
        Sample s = sample(f, c2, x);
        ++m_count.samples;
        const double noise = 4 * epsilon * s.size;
        if (step == 0 && (zeroAtStart || std::abs(s.value) <= noise)) {
            if (std::abs(s.slope) <= 16 * epsilon * (std::abs(f.c1) + s.size * s.fastest))
                break;  // tangential
            if (s.slope < 0) return Zero<double>::at(start);
            s.value = 0;
        } else if (s.value <= noise) {
            return Zero<double>::at(x);
        }
        double h;
        if (s.leastCurvature >= 0) {
            if (s.slope >= 0) return {};
            h = s.value / -s.slope;
        } else {
            const double root = std::sqrt(s.slope * s.slope - 2 * s.leastCurvature * s.value);
            h = s.slope > 0 ? (s.slope + root) / -s.leastCurvature : 2 * s.value / (root - s.slope);
        }
        const bool near =
            s.slope < 0 && h * s.fastest < nearInDecays && h * std::abs(s.curvature) < -nearInBend * s.slope;
        if (near) return closeIn(f, c2, x, s, end, x + 2 * h);
        x += std::max(h, 4 * epsilon * x);
        if (!(x <= end)) return {};
    }
    m_failed = true;
    return {};
}

/// Halley's method from x, where f is still positive, to the zero expected before `latest`. A step back
/// before x, or far beyond, finds no zero or a later one: the function turns within rounding.
Zero<double> ExponentialBasis::closeIn(const Piece& f, double c2, double x, Sample s, double end,
                                       double latest) {
    const double first = x;
    for (int step = 0; step < mostSteps; ++step) {
        const double h = -2 * s.value * s.slope / (2 * s.slope * s.slope - s.value * s.curvature);
        x += h;
        if (!(x >= first && x <= latest)) break;
        const double quickest = std::max(s.fastest, std::abs(s.curvature / s.slope));
        if (std::abs(h) * quickest < lastHalleyStep) return zeroUpTo(end, x);
        s = sample(f, c2, x);
        ++m_count.samples;
    }
    m_failed = true;
    return {};
}

Zero<double> ExponentialBasis::gapClosure(const Piece& g, double gap) {
    if (g.c0 <= 0 && g.c1 <= 0 && g.primary.allAtMostZero() && g.elastic.allAtMostZero())
        return gap < 0 ? Zero<double>::at(0) : Zero<double>{};
    const double most = std::max({0.0, g.c0, g.c0 + g.c1 * g.length}) * g.length +
                        g.primary.positivePart() / m_rates.primary +
                        g.elastic.positivePart() / m_rates.elastic;
    if (gap > 2 * most) return {};
    if (g.primary.count == 0 && g.elastic.count == 0 && g.c1 == 0) {
        const double x = gap / (2 * g.c0);
        return zeroUpTo(g.length, x);
    }
    // gap − 2∫g: ∫φ_m(λx) = (1 − φ_0 − … − φ_m)/λ
    Piece f = Piece::zero(g.length);
    f.c0 = gap;
    f.c1 = -2 * g.c0;
    const auto integrate = [&](const DecayTerms& terms, double rate, DecayTerms& out) {
        out.count = terms.count;
        double sum = 0;
        for (int m = terms.count - 1; m >= 0; --m) {
            sum += terms.c[m];
            out.c[m] = 2 * sum / rate;
        }
        f.c0 -= 2 * sum / rate;
    };
    integrate(g.primary, m_rates.primary, f.primary);
    integrate(g.elastic, m_rates.elastic, f.elastic);
    return firstZero(f, -g.c1, g.length, 0, gap == 0);
}

Zero<double> ExponentialBasis::forceVanishes(Response& r) {
    const Piece& g = r.incident;  // a compressive wave cannot pull the rod off: F is a positive mean of 2g
    if (g.c0 >= 0 && g.c0 + g.c1 * g.length >= 0 && g.primary.allAtLeastZero() && g.elastic.allAtLeastZero())
        return {};
    return firstZero(r.force, 0, r.length);
}

Zero<double> ExponentialBasis::driveVanishes(Response& r) {
    return firstZero(drive(r), 0, r.length);
}

Zero<double> ExponentialBasis::forceReaches(Response& r, double peak, bool tangential) {
    Piece& f = m_searched;
    double start = 0;
    if (tangential) {  // no return before the force has turned: F' = a·drive changes sign
        combine(-2, r.incident, 1, r.force, f);  // −drive
        const auto turn = firstZero(f, 0, r.length, 0, true);
        if (!turn.found || m_failed) return {};
        start = turn.u;
        if (start == 0) return Zero<double>::at(0);
    }
    // F ≤ max(F(0), 2 max g) as F' = a(2g − F)
    const Piece& g = r.incident;
    const double most =
        2 * (std::max(g.c0, g.c0 + g.c1 * g.length) + g.primary.positivePart() + g.elastic.positivePart());
    if (start == 0 && most <= peak) return {};
    combine(0, r.force, -1, r.force, f);
    f.c0 += peak;
    return firstZero(f, 0, r.length, start);
}

double ExponentialBasis::largestIntegral(const Piece& g) {
    if (g.c0 < 0 || g.c1 != 0 || g.primary.count || g.elastic.count) m_failed = true;  // slow drift
    return g.integral(g.length);
}

double ExponentialBasis::roundingError(const Response& r, double length) const {
    const double weighted =
        (std::abs(r.force.c0) + std::abs(r.force.c1) * length) * length +
        r.force.primary.magnitude() * std::min(length, DecayTerms::capacity / m_rates.primary) +
        r.force.elastic.magnitude() * std::min(length, DecayTerms::capacity / m_rates.elastic);
    const double persisting =
        r.size * epsilon / m_rates.primary;  // decays only as slowly as the contact force
    return 4 * (epsilon * weighted + persisting + m_negligible * length);
}

void ExponentialBasis::tidy(Piece& piece) const {
    piece.rates = &m_rates;
    piece.primary.trim(m_negligible);
    piece.elastic.trim(m_negligible);
    if (std::abs(piece.c0) + std::abs(piece.c1) * piece.length <= m_negligible) piece.c0 = piece.c1 = 0;
}

double ExponentialBasis::largest(const Response& r, double length) {
    double most = std::max(r.force.startValue(), r.force.value(length));
    const std::array<const Piece*, 2> functions{&r.force, &drive(r)};
    ExponentialStretches(functions, length, m_negligible).forEach([&](double, const auto& series) {
        const auto& [force, slope] = series;
        most = std::max(most, force.startValue());
        if (!forEachMaximum(slope, slope.length, [&](double x) { most = std::max(most, force.value(x)); }))
            m_failed = true;
    });
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
