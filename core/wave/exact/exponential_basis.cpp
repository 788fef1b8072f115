// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_basis.h"

#include "core/wave/exact/exponential_algebra.h"
#include "core/wave/exact/exponential_stretches.h"

namespace drillwave {
namespace {

/// Ratio above which terms cancel: a sum of terms much larger than any wave force loses as many digits.
constexpr double mostCancellation = 1024;

/// Size of terms that are dropped, relative to the largest wave force: less than visible rounding.
constexpr double negligibleShare = 0x1p-62;

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
template <int lines>
double decayingIntegral(const ExponentialSum<lines>& f, double length) {
    const auto of = [length](Coefficients terms, double rate) {
        const double together = rate + 1;
        double power = 1;
        for (int m = 0; m < terms.count; ++m, power *= rate / together) terms.c[m] *= power;
        const double y = together * length;
        return terms.rises(y, std::exp(-y)) / together;
    };
    const double decayed = -std::expm1(-length);
    double sum = f.c0 * decayed;
    if (f.isCurved) {
        sum += f.curve.c1 * (decayed - length * std::exp(-length));
        sum -= f.curve.hammer.decay * std::expm1(-2 * length) / 2;
    }
    eachLine<lines>([&](int i) {
        if (f.decays[i].count) sum += of(f.decays[i], (*f.rates)[i]);
    });
    return sum;
}

/// Whether g does not rise through zero.
template <int lines>
bool neverComesBack(const ExponentialSum<lines>& g) {
    const ExponentialCourse course(g);
    return course.falls() || (course.isConvex() && g.value(g.length) <= 0) ||
           (course.isConcave() && g.startValue() >= 0);
}

/// Returns whether a force that is positive at the end has been so all the way: once it has vanished, which
/// takes g < 0, F' = a(2g − F) keeps it below zero until g returns. For sines this costs more than it saves.
template <class Response>
bool cannotVanish(const Response& r) {
    if (r.incident->hasSine()) return false;
    const double rounding = 16 * doubleEpsilon * r.force.magnitude();
    return neverComesBack(*r.incident) && r.force.value(r.length) > rounding;
}

}  // namespace

template <int lines>
void ExponentialBasis<lines>::begin(const Problem& problem, const ContactLaw<double>& law) {
    m_failed = false;
    m_count = {};
    m_rates = {law.slopes().primary, law.slopes().elastic};
    for (int i = 2; i < lines; ++i) m_rates[i] = law.loadingSlope(static_cast<std::size_t>(i) - 1);
    m_scale = std::max(problem.force().peak, problem.transitTime() < 0.5 || problem.force().isRigidBody()
                                                 ? 1 / (2 * problem.transitTime())
                                                 : 0.0);
    m_negligible = negligibleShare * m_scale;
}

template <int lines>
ExponentialSum<lines> ExponentialBasis<lines>::constant(double length, double value) const {
    Piece f = Piece::zero(length);
    f.c0 = value;
    return f;
}

template <int lines>
void ExponentialBasis<lines>::addHammer(const PulseSegment& segment, double into, double length,
                                        Piece& g) const {
    g.shorten(length);
    if (g.isCurved) g.curve.impulse = Curve::unknown;
    switch (segment.kind) {
        case PulseSegment::Kind::linear:
            g.c0 += segment.value + segment.slope * into;
            if (segment.slope != 0) g.makeCurved().c1 += segment.slope;
            break;
        case PulseSegment::Kind::sine: {
            const double phase = HammerTerms::pi * (segment.start + into);
            HammerTerms& hammer = g.makeCurved().hammer;
            hammer.sine += segment.value * std::cos(phase);
            hammer.cosine += segment.value * std::sin(phase);
            hammer.present = true;
            break;
        }
        case PulseSegment::Kind::exponential: {
            HammerTerms& hammer = g.makeCurved().hammer;
            hammer.decay += segment.value * std::exp(-into);
            hammer.present = true;
            break;
        }
    }
}

template <int lines>
double ExponentialBasis<lines>::hammerProduct(const PulseSegment& segment, double into, const Piece& g,
                                              double length) const {
    const bool isConstant = segment.kind == PulseSegment::Kind::linear && segment.slope == 0;
    if (isConstant) return segment.value * g.integral(length);
    if (segment.kind == PulseSegment::Kind::exponential && !(g.isCurved && g.curve.hammer.hasSine()))
        return segment.value * std::exp(-into) * decayingIntegral(g, length);
    Piece hammer = Piece::zero(length);
    addHammer(segment, into, length, hammer);
    return productIntegral(hammer, g, length);
}

template <int lines>
typename ExponentialBasis<lines>::Response& ExponentialBasis<lines>::respond(Piece& g, double rate,
                                                                             double force) {
    Response& r = m_response;
    g.rates = &m_rates;
    r.incident = &g;
    r.length = g.length;
    r.rate = rate;
    r.hasDrive = false;
    const int line = r.line = lineOf(rate);
    Coefficients& forceSame = r.force.decays[line];

    r.force.length = g.length;
    r.force.rates = &m_rates;
    r.force.c0 = 2 * g.c0;
    r.force.isCurved = g.isCurved;
    eachLine<lines>([&](int i) {
        if (i != line) nonResonant(g.decays[i], rate, m_rates[i], r.force.decays[i]);
    });
    if (!resonant(g.decays[line], forceSame) ||
        (g.isCurved && !respondToCurve(g.curve, line, r.force.curve))) {
        m_failed = true;
        return r;
    }
    // the layer in which the force joins the slow solution; on stiff rock its rounding would seem an event
    forceSame.c[0] = 0;
    const double layer = force - r.force.startValue();
    const bool isRounding = std::abs(layer) <= 4 * doubleEpsilon * (std::abs(force) + std::abs(r.force.c0));
    if (!isRounding) forceSame.c[0] = layer;
    r.start = isRounding ? force - layer : force;
    r.dropped = isRounding ? std::abs(layer) : 0;
    // the decays over the whole piece serve all functions of this piece
    eachLine<lines>([&](int i) {
        if (g.wholeDecays[i] < 0 && r.force.hasLine(i)) g.wholeDecays[i] = std::exp(-m_rates[i] * g.length);
    });
    r.force.wholeDecays = g.wholeDecays;
    if (r.force.magnitude() > mostCancellation * m_scale) m_failed = true;
    return r;
}

/// Adds the response to ramps and curved blows; false if that needs more terms than there is room for.
template <int lines>
bool ExponentialBasis<lines>::respondToCurve(const Curve& g, int line, Curve& force) const {
    const double rate = m_rates[line];
    force.c1 = 2 * g.c1;
    force.hammer = g.hammer.present ? forced(g.hammer, rate) : HammerTerms{};
    if (g.c1 == 0 && !g.hasRises()) {
        for (Coefficients& rises : force.rises) rises.count = 0;
        return true;
    }
    // F' = 0 at the start for all that begins at zero: 2x − 2ω_0(ax)/a for a ramp, −(λ/a) F_0 ω_0(ax) for
    // rises of another rate
    double slope = force.c1;
    eachLine<lines>([&](int i) {
        if (i == line) return;
        nonResonant(g.rises[i], rate, m_rates[i], force.rises[i]);
        slope += m_rates[i] * force.rises[i][0];
    });
    if (!resonant(g.rises[line], force.rises[line])) return false;
    force.rises[line].c[0] = -slope / rate;
    return true;
}

template <int lines>
void ExponentialBasis<lines>::reflect(const Response& r, Piece& reflected) const {
    combine(1, *r.incident, -1, r.force, reflected);
    reflected.length = r.length;
    reflected.wholeDecays = r.force.wholeDecays;
    if (reflected.isCurved) [[unlikely]]
        reflected.curve.impulse = r.left;
}

/// 2g − F; where both nearly cancel on stiff rock, term by term as F'/a.
template <int lines>
const ExponentialSum<lines>& ExponentialBasis<lines>::drive(Response& r) {
    if (r.hasDrive) return m_drive;
    r.hasDrive = true;
    if (r.force.isCurved) [[unlikely]]
        combineCurves(2, *r.incident, -1, r.force, m_drive);
    else
        m_drive.isCurved = false;
    m_drive.length = r.force.length;
    m_drive.c0 = 2 * r.incident->c0 - r.force.c0;
    m_drive.rates = &m_rates;
    m_drive.wholeDecays = r.force.wholeDecays;
    eachLine<lines>([&](int i) {
        differences(r.force.decays[i], i == r.line ? 1 : m_rates[i] / r.rate, m_drive.decays[i]);
    });
    if (r.force.hasHammer()) {
        const HammerTerms& force = r.force.curve.hammer;
        m_drive.curve.hammer = {-HammerTerms::pi / r.rate * force.cosine,
                                HammerTerms::pi / r.rate * force.sine, -force.decay / r.rate, true};
    }
    return m_drive;
}

template <int lines>
void ExponentialBasis<lines>::shorten(Response& r, double length) const {
    r.length = length;
    r.force.shorten(length);
    eachLine<lines>([&](int i) {
        if (r.force.hasLine(i)) r.force.wholeDecays[i] = std::exp(-m_rates[i] * length);
    });
}

template <int lines>
Zero<double> ExponentialBasis<lines>::gapClosure(const Piece& g, double gap) {
    if (g.isAtMostZero()) return gap < 0 ? Zero<double>::at(0) : Zero<double>{};
    if (gap > 2 * g.mostIntegral() || gap > 2 * mostIntegral(g, impulse(g), gap / 2)) return {};
    if (g.isConstant()) {
        const double x = gap / (2 * g.c0);
        return x <= g.length ? Zero<double>::at(x) : Zero<double>{};
    }
    return searchedGapClosure(g, gap);
}

/// Where gap − 2∫g vanishes: ∫φ_m = ω_m/λ, and ∫ω_m = x − Σ_{k≤m} ω_k/λ.
template <int lines>
Zero<double> ExponentialBasis<lines>::searchedGapClosure(const Piece& g, double gap) {
    Piece& f = m_searched;
    f.length = g.length;
    f.rates = &m_rates;
    f.wholeDecays = g.wholeDecays;
    f.c0 = gap;
    for (Coefficients& decays : f.decays) decays.count = 0;
    Curve& curve = f.makeCurved();
    curve.c1 = -2 * g.c0;
    curve.hammer = {};
    const Curve none;
    const Curve& arriving = g.isCurved ? g.curve : none;
    const auto integrate = [&](const Coefficients& decays, const Coefficients& rises, double rate,
                               Coefficients& out) {
        const Coefficients sums = rises.sumsFromEach();
        combine(-2 / rate, decays, 2 / rate, sums, out);
        curve.c1 -= 2 * sums[0];
    };
    eachLine<lines>([&](int i) { integrate(g.decays[i], arriving.rises[i], m_rates[i], curve.rises[i]); });
    if (arriving.hammer.present) {
        constexpr double pi = HammerTerms::pi;
        curve.hammer = {-2 * arriving.hammer.cosine / pi, 2 * arriving.hammer.sine / pi,
                        2 * arriving.hammer.decay, true};
        f.c0 -= curve.hammer.startValue();
    }
    return decided(firstZero(f, -arriving.c1, {.startsAtZero = gap == 0}, m_count));
}

template <int lines>
Zero<double> ExponentialBasis<lines>::forceVanishes(Response& r) {
    // a compressive wave cannot pull the rod off: F is a positive mean of 2g and of what it was
    if (r.incident->isAtLeastZero()) return {};
    if (!hasZeroByFormula(r.force) && cannotVanish(r)) return {};
    return decided(firstZero(r.force, 0, {.negligible = m_negligible}, m_count));
}

template <int lines>
Zero<double> ExponentialBasis<lines>::driveVanishes(Response& r) {
    return decided(firstZero(drive(r), 0, {.negligible = m_negligible}, m_count));
}

template <int lines>
Zero<double> ExponentialBasis<lines>::forceReaches(Response& r, double peak, bool tangential) {
    if (2 * r.incident->mostValue() <= peak) return {};  // F ≤ max(F(0), 2 max g)
    Piece& f = m_searched;
    double start = 0;
    if (tangential) {  // no return before the force has turned: F' = a·drive changes sign
        negate(drive(r), f);
        const auto turn =
            decided(firstZero(f, 0, {.startsAtZero = true, .negligible = m_negligible}, m_count));
        if (!turn.found || m_failed) return {};
        start = turn.u;
        if (start == 0) return Zero<double>::at(0);
    }
    negate(r.force, f);
    f.c0 += peak;
    return decided(firstZero(f, 0, {.start = start, .negligible = m_negligible}, m_count));
}

template <int lines>
double ExponentialBasis<lines>::largestIntegral(const Piece& g) {
    const double whole = g.integral(g.length);
    if (g.isAtLeastZero()) return whole;
    double most = std::max(whole, 0.0), before = 0;
    ExponentialStretches(std::array{&g}, g.length, m_negligible).forEach([&](double, const auto& series) {
        const PowerSeries<double>& f = series[0];
        const auto look = [&](double x) { most = std::max(most, before + f.integral(x)); };
        if (!forEachMaximum(f, f.length, look)) m_failed = true;
        before += f.integral(f.length);
    });
    return most;
}

/// The coefficients of the force have rounding errors, and so has the wave that they leave. An error δF of
/// the force at the end returns in 1/a: the bit is off by δF/a, and that persists. On soft rock constant and
/// decays cancel; then the change from the start has digits that their sum has not.
template <int lines>
StretchEnd<double> ExponentialBasis<lines>::endAt(Response& r, double length) const {
    const bool isCut = length != r.length;
    if (isCut) shorten(r, length);
    const Piece& force = r.force;
    double fastest = m_rates[primary];
    for (int i = elastic; i < lines; ++i)
        if (force.decays[i].count) fastest = std::max(fastest, m_rates[i]);
    const bool isSlow = fastest * length < 1 && !force.isCurved;
    const double constant = std::abs(force.c0);
    double stored = constant * length, integrated = 0, size = isSlow ? 0 : constant;
    StretchEnd<double> end{isSlow ? r.start : force.c0, force.c0 * length, 0};
    const auto add = [&](const Coefficients& terms, double rate, double decay) {
        const DecaysEnd decays(terms, rate, length, decay);
        end.force += isSlow ? decays.change() : decays.value();
        size += isSlow ? decays.changeSize() : decays.valueSize();
        end.impulse += decays.integral;
        stored += decays.stored;
        integrated += decays.integrated;
    };
    eachLine<lines>([&](int i) {
        if (force.decays[i].count) add(force.decays[i], m_rates[i], force.wholeDecays[i]);
    });
    if (force.isCurved) [[unlikely]] {
        const double curve = force.curveMagnitude();
        stored += curve * length;
        size += curve;
        end.force = force.value(length);
        end.impulse = force.integral(length);
        r.arrived = (end.impulse + (end.force - r.start) / r.rate) / 2;  // F' = a(2g − F)
        r.left = r.arrived - end.impulse;
    }
    // an event at a force that is given has been found by the sum
    if (isSlow && isCut && r.rate == m_rates[elastic]) size += 2 * constant;
    size += std::abs(end.force);
    end.error = 4 * (doubleEpsilon * (stored + integrated + size / r.rate) + m_negligible * length) +
                r.dropped / r.rate;
    return end;
}

/// The force turns where the drive changes its sign, and the drive U' = 2g' − aU, once below zero, returns
/// only after g has turned up.
template <int lines>
double ExponentialBasis<lines>::largest(Response& r, double length, double before) {
    const Piece& g = *r.incident;
    const double most2g = 2 * g.mostValue();  // F' = a(2g − F): F is drawn towards 2g, within its time
    if (most2g <= before) return before;
    if (r.start + std::max(most2g - r.start, 0.0) * -std::expm1(-r.rate * length) <= before) return before;
    const ExponentialCourse course(g);
    const Piece& slope = drive(r);
    if (slope.isAtLeastZero() || slope.isAtMostZero()) return before;
    double most = before;
    // less often than a sum of decays has terms
    int mostTurns = -1;
    for (const Coefficients& decays : slope.decays) mostTurns += decays.count;
    if (slope.isCurved) mostTurns = lines * Coefficients::capacity;
    Piece& turning = m_searched;
    turning = slope;
    turning.shorten(length);
    // a drive that starts at zero mostly rises, and if not, has its zero there
    bool isRising = turning.startValue() >= -4 * doubleEpsilon * turning.magnitude();
    if (!isRising) negate(turning, turning);
    double start = 0;
    for (int turn = 0; turn < mostTurns; ++turn) {
        if (!isRising && (course.falls() || (turn > 0 && course.isConcave()))) break;
        const auto zero =
            decided(firstZero(turning, 0, {.start = start, .negligible = m_negligible}, m_count));
        if (!zero.found || m_failed) break;
        if (isRising) most = std::max(most, r.force.value(zero.u));
        isRising = !isRising;
        negate(turning, turning);
        start = zero.u;
    }
    return most;
}

template <int lines>
double ExponentialBasis<lines>::productIntegral(const Piece& f, const Piece& g, double length) const {
    double sum = 0;
    const auto add = [&](const PowerSeries<double>& a, const PowerSeries<double>& b) {
        sum += PowerSeries<double>::productIntegral(a, b, a.length);
    };
    if (&f == &g)  // a square
        ExponentialStretches(std::array{&f}, length, m_negligible).forEach([&](double, const auto& series) {
            add(series[0], series[0]);
        });
    else
        ExponentialStretches(std::array{&f, &g}, length, m_negligible)
            .forEach([&](double, const auto& series) { add(series[0], series[1]); });
    return sum;
}

template <int lines>
void ExponentialBasis<lines>::record(const Piece& incident, const Piece* force, double length,
                                     Impact& impact) const {
    const auto used = [](const PowerSeries<double>& f) {
        return std::span<const double>(f.c.data(), static_cast<std::size_t>(f.count));
    };
    const Piece none;
    const std::array<const Piece*, 2> functions{&incident, force ? force : &none};
    ExponentialStretches(functions, length, m_negligible).forEach([&](double, const auto& series) {
        const auto& [g, F] = series;
        impact.incident.append(g.length, g.scale, used(g));
        impact.force.append(g.length, g.scale, used(F));
    });
}

template class ExponentialBasis<2>;
template class ExponentialBasis<3>;

}  // namespace drillwave
