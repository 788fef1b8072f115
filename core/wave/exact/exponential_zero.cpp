// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_zero.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wave/exact/exponential_algebra.h"

namespace drillwave {

namespace {

// An exponential sum at one point, as the search for its first zero looks at it.

// The slope c + Σ d_m φ_m(λx) over the rates of an exponential sum, but for its hammer terms.
template <int lines>
struct ExponentialSlope {
    double constant = 0;
    TermsOfLines<lines> decays;

    explicit ExponentialSlope(const ExponentialSum<lines>& f) {
        eachLine<lines>([&](int i) { differences(f.decays[i], (*f.rates)[i], decays[i]); });
        if (!f.isCurved) return;
        constant = f.curve.c1;
        eachLine<lines>([&](int i) { addRises(f.curve.rises[i], (*f.rates)[i], decays[i]); });
    }

  private:
    // The derivative of Σ q_m ω_m is Σ q_m φ_m, times the rate.
    static void addRises(const Coefficients& rises, double rate, Coefficients& slope) {
        const int common = std::min(slope.count, rises.count);
        for (int m = 0; m < common; ++m) slope.c[m] += rate * rises.c[m];
        for (int m = common; m < rises.count; ++m) slope.c[m] = rate * rises.c[m];
        slope.count = std::max(slope.count, rises.count);
    }
};

// A function at one point, with a lower bound of its curvature from there on.
struct ExponentialSample {
    double value = 0, slope = 0, curvature = 0, leastCurvature = 0;
    double size = 0;     // what the rounding of `value` is relative to
    double fastest = 0;  // the largest rate in it

    double noise() const { return 4 * std::numeric_limits<double>::epsilon() * size; }
};

// Adds the terms of one rate, of which `slopes` are the slope.
[[gnu::always_inline]] inline void addTerms(const Coefficients& decays, const Coefficients& rises,
                                            const Coefficients& slopes, double rate, double x,
                                            ExponentialSample& s) {
    const double y = rate * x;
    const double decay = x == 0 ? 1.0 : std::exp(-y);
    double bend = 0, leastBend = 0, size = 0, phi = decay;
    for (int m = 0; m < slopes.count; ++m) {
        if (m < decays.count) {
            s.value += decays.c[m] * phi;
            size += std::abs(decays.c[m]) * phi;
        }
        const double slope = slopes.c[m], curvature = slopes[m + 1] - slope;
        s.slope += slope * phi;
        bend += curvature * phi;
        if (curvature < 0) leastBend += curvature * (y >= m ? phi : largestDecays[m]);
        phi *= y / (m + 1);
    }
    if (rises.count && x > 0) {
        s.value += rises.rises(y, decay);
        size += rises.magnitude() * std::min(y, 1.0);
    }
    s.curvature += rate * bend;
    s.leastCurvature += rate * leastBend;
    s.size += size * (1 + y);
    s.fastest = std::max(s.fastest, rate);
}

// `amplitude` is that of the sine.
void addHammer(const HammerTerms& f, double amplitude, double x, ExponentialSample& s) {
    constexpr double pi = HammerTerms::pi;
    if (f.hasSine()) {
        const double sine = std::sin(pi * x), cosine = std::cos(pi * x);
        const double value = f.sine * sine + f.cosine * cosine;
        s.value += value;
        s.slope += pi * (f.sine * cosine - f.cosine * sine);
        s.curvature -= pi * pi * value;
        s.leastCurvature -= pi * pi * amplitude;
        s.size += f.amplitude();
        s.fastest = std::max(s.fastest, pi);
    }
    if (f.decay != 0) {
        const double value = f.decay * std::exp(-x);
        s.value += value;
        s.slope -= value;
        s.curvature += value;
        s.leastCurvature += std::min(value, 0.0);
        s.size += std::abs(value) * (1 + x);
        s.fastest = std::max(s.fastest, 1.0);
    }
}

// f + c2 x², as it is searched.
template <int lines>
struct SearchedSum {
    const ExponentialSum<lines>& f;
    double c2;
    ExponentialSlope<lines> slope{f};
    double amplitude = f.hasHammer() ? std::hypot(f.curve.hammer.sine, f.curve.hammer.cosine) : 0;

    ExponentialSample at(double x) const;
};

template <int lines>
ExponentialSample SearchedSum<lines>::at(double x) const {
    ExponentialSample s;
    s.value = f.c0;
    s.size = std::abs(f.c0);
    if (f.isCurved || c2 != 0) {
        s.value += x * (slope.constant + x * c2);
        s.slope = slope.constant + 2 * c2 * x;
        s.curvature = s.leastCurvature = 2 * c2;
        s.size += std::abs(slope.constant) * x + std::abs(c2) * x * x;
    }
    eachLine<lines>([&](int i) {
        if (slope.decays[i].count) addTerms(f.decays[i], f.risesOf(i), slope.decays[i], (*f.rates)[i], x, s);
    });
    if (f.hasHammer()) addHammer(f.curve.hammer, amplitude, x, s);
    return s;
}

constexpr int mostSteps = 200;

// A zero is near beyond doubt where the function falls, is hardly bent on the way to it, and no exponential
// of it changes much: then Halley's method converges.
constexpr double nearInDecays = 0.25;
constexpr double nearInBend = 0.4;

/// A last step so small, in units of the fastest change, leaves an error of its third power: rounding.
constexpr double lastHalleyStep = 1e-5;

/// An upper bound of |f'''|, x ≥ 0.
template <int lines>
double mostThirdDerivative(const ExponentialSum<lines>& f) {
    constexpr double pi = HammerTerms::pi;
    const auto cube = [](double rate) { return rate * rate * rate; };
    // differences of third and, for rises, of second order
    double most = 0;
    if (f.isCurved) most = f.curve.hammer.amplitude() * cube(pi) + std::abs(f.curve.hammer.decay);
    eachLine<lines>([&](int i) {
        most += (8 * f.decays[i].magnitude() + 4 * f.risesOf(i).magnitude()) * cube((*f.rates)[i]);
    });
    return most;
}

/// The largest step from s that passes no zero.
double safeStep(const ExponentialSample& s) {
    if (s.leastCurvature >= 0)
        return s.slope >= 0 ? std::numeric_limits<double>::infinity() : s.value / -s.slope;
    const double root = std::sqrt(s.slope * s.slope - 2 * s.leastCurvature * s.value);
    return s.slope > 0 ? (s.slope + root) / -s.leastCurvature : 2 * s.value / (root - s.slope);
}

double halleyStep(const ExponentialSample& s) {
    return -2 * s.value * s.slope / (2 * s.slope * s.slope - s.value * s.curvature);
}

bool isNear(const ExponentialSample& s, double step) {
    return s.slope < 0 && step > 0 && step * s.fastest < nearInDecays &&
           step * std::abs(s.curvature) < -nearInBend * s.slope;
}

/// Halley's method from x, where f is still positive, to the zero expected a `step` further. A step back
/// before x, or far beyond, finds no zero or a later one: the function turns within rounding.
template <int lines>
Zero<double> closeIn(const SearchedSum<lines>& f, double x, double step, const ExponentialSample& near,
                     long& samples) {
    const double first = x, latest = x + 2 * step;
    ExponentialSample s = near;
    for (int i = 0; i < mostSteps; ++i) {
        x += step;
        if (!(x >= first && x <= latest)) break;
        const double quickest = std::max(s.fastest, std::abs(s.curvature / s.slope));
        if (std::abs(step) * quickest < lastHalleyStep)
            return x <= f.f.length ? Zero<double>::at(x) : Zero<double>{};
        s = f.at(x);
        ++samples;
        step = halleyStep(s);
    }
    return {.found = false, .undecided = true, .u = x};
}

/// How a function goes on that is zero within rounding.
enum class Onward { down, up, tangentUp, unknown };

template <int lines>
Onward onwardFromZero(const SearchedSum<lines>& f, const ExponentialSample& s) {
    if (std::abs(s.slope) > 16 * doubleEpsilon * (std::abs(f.slope.constant) + s.size * s.fastest))
        return s.slope < 0 ? Onward::down : Onward::up;
    if (std::abs(s.curvature) > 64 * doubleEpsilon * (std::abs(f.c2) + s.size * s.fastest * s.fastest))
        return s.curvature < 0 ? Onward::down : Onward::tangentUp;
    return Onward::unknown;
}

/// An upper bound of |f| from x on, for sums that die away.
template <int lines>
double mostFrom(const ExponentialSum<lines>& f, double x) {
    const auto of = [x](const Coefficients& terms, double rate) {
        const double y = rate * x;
        double sum = 0, phi = std::exp(-y);
        for (int m = 0; m < terms.count; ++m) {
            sum += std::abs(terms.c[m]) * (y >= m ? phi : largestDecays[m]);
            phi *= y / (m + 1);
        }
        return sum;
    };
    double most = f.isCurved ? std::abs(f.curve.hammer.decay) * std::exp(-x) : 0;
    eachLine<lines>([&](int i) {
        if (f.decays[i].count) most += of(f.decays[i], (*f.rates)[i]);
    });
    return most;
}

template <int lines>
bool diesAway(const ExponentialSum<lines>& f, double c2) {
    if (f.c0 != 0 || c2 != 0) return false;
    return !f.isCurved || (f.curve.c1 == 0 && !f.curve.hasRises() && !f.curve.hammer.hasSine());
}

/// The first zero of e^{−y}(c_0 + c_1 y + c_2 y²/2) behind its start, where it is positive.
Zero<double> firstZeroOfShortDecay(const Coefficients& terms, double rate, double end) {
    const double c0 = terms.c[0];
    const double c1 = terms.count > 1 ? terms.c[1] : 0;
    const double c2 = terms.count > 2 ? terms.c[2] : 0;
    const double discriminant = c1 * c1 - 2 * c2 * c0;
    if (discriminant < 0 || (c1 >= 0 && c2 >= 0)) return {};
    const double root = std::sqrt(discriminant);
    const double y = c1 <= 0 ? 2 * c0 / (root - c1) : (c1 + root) / -c2;
    return y > 0 && y <= rate * end ? Zero<double>::at(std::min(y / rate, end)) : Zero<double>{};
}

/// The rate of which alone the sum consists, or −1.
template <int lines>
int onlyLine(const ExponentialSum<lines>& f) {
    if (f.isCurved || f.c0 != 0) return -1;
    int only = -1, count = 0;
    eachLine<lines>([&](int i) {
        if (f.decays[i].count == 0) return;
        only = i;
        ++count;
    });
    return count == 1 ? only : -1;
}

/// The search from a first sample on.
template <int lines>
Zero<double> marchToZero(const SearchedSum<lines>& f, double x, ExponentialSample s, double negligible,
                         long& samples) {
    const bool mayEndEarly = diesAway(f.f, f.c2);
    for (int step = 0; step < mostSteps; ++step) {
        const double safe = safeStep(s);
        if (!(x + safe <= f.f.length)) return {};
        const double halley = halleyStep(s);
        if (isNear(s, halley)) return closeIn(f, x, halley, s, samples);
        x += std::max(safe, 4 * doubleEpsilon * x);
        s = f.at(x);
        ++samples;
        if (mayEndEarly && s.size <= negligible && mostFrom(f.f, x) <= negligible) return {};
        if (s.value <= s.noise()) return Zero<double>::at(x);
    }
    return {.found = false, .undecided = true, .u = x};
}

/// From where the function is zero, or within rounding of it.
template <int lines>
Zero<double> firstZeroFromZero(const SearchedSum<lines>& f, double x, ExponentialSample s, double negligible,
                               long& samples) {
    switch (onwardFromZero(f, s)) {
        case Onward::down:
            return Zero<double>::at(x);
        case Onward::up:
            s.value = 0;
            return marchToZero(f, x, s, negligible, samples);
        case Onward::tangentUp: {
            // f ≥ curvature h²/2 − third h³/6 is at least half of the first of these until here
            const double third = mostThirdDerivative(f.f);
            if (!(x + 1.5 * s.curvature / third <= f.f.length)) return {};
            x += 1.5 * s.curvature / third;
            s = f.at(x);
            if (s.value > s.noise()) return marchToZero(f, x, s, negligible, samples);
            break;
        }
        case Onward::unknown:
            break;
    }
    return {.found = false, .undecided = true, .u = x};
}

}  // namespace

template <int lines>
bool hasZeroByFormula(const ExponentialSum<lines>& f) {
    constexpr int solvable = 3;
    const int line = onlyLine(f);
    return line >= 0 && f.decays[line].count <= solvable && f.decays[line].c[0] != 0;
}

template <int lines>
Zero<double> firstZero(const ExponentialSum<lines>& f, double c2, const Search& search, SearchCount& tally) {
    if (search.start == 0 && c2 == 0 && !search.startsAtZero && hasZeroByFormula(f)) {
        const int line = onlyLine(f);
        const Coefficients& only = f.decays[line];
        return only.c[0] < 0 ? Zero<double>::at(0) : firstZeroOfShortDecay(only, (*f.rates)[line], f.length);
    }
    if (c2 >= 0 && !f.hasHammer() && f.isAtLeastZero()) return {};
    const SearchedSum searched{f, c2};
    const ExponentialSample s = searched.at(search.start);
    ++tally.searches;
    ++tally.samples;
    if (search.startsAtZero || std::abs(s.value) <= s.noise())
        return firstZeroFromZero(searched, search.start, s, search.negligible, tally.samples);
    if (s.value < 0) return Zero<double>::at(search.start);
    return marchToZero(searched, search.start, s, search.negligible, tally.samples);
}

template bool hasZeroByFormula(const ExponentialSum<2>&);
template bool hasZeroByFormula(const ExponentialSum<3>&);
template Zero<double> firstZero(const ExponentialSum<2>&, double, const Search&, SearchCount&);
template Zero<double> firstZero(const ExponentialSum<3>&, double, const Search&, SearchCount&);

}  // namespace drillwave
