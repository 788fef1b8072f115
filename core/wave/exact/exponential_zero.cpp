// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/exact/exponential_zero.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drillwave {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

constexpr int mostSteps = 200;

// A zero is near beyond doubt where the function falls, is hardly bent on the way to it, and no exponential
// of it changes much: then Halley's method converges.
constexpr double nearInDecays = 0.25;
constexpr double nearInBend = 0.4;

/// A last step so small, in units of the fastest change, leaves an error of its third power: rounding.
constexpr double lastHalleyStep = 1e-5;

/// A function at one point, with a lower bound of its curvature from there on.
struct Sample {
    double value = 0, slope = 0, curvature = 0, leastCurvature = 0;
    double size = 0;     ///< what the rounding of `value` is relative to
    double fastest = 0;  ///< the largest rate in it

    double noise() const { return 4 * epsilon * size; }
};

/// Largest values of φ_m, at y = m.
constexpr double peaks[Coefficients::capacity] = {1,
                                                  0.36787944117144233,
                                                  0.27067056647322538,
                                                  0.22404180765538775,
                                                  0.19536681481316454,
                                                  0.17546736976785068,
                                                  0.16062314104798003,
                                                  0.14900277967433771};

/// Adds the terms of one rate. The slope of Σ c_m φ_m + Σ q_m ω_m is Σ (c_{m+1} − c_m + q_m) φ_m.
void add(const RateTerms& f, double rate, double x, Sample& s) {
    if (f.isZero()) return;
    const double y = rate * x;
    const double decay = x == 0 ? 1.0 : std::exp(-y);
    double value = 0, slope = 0, bend = 0, leastBend = 0, size = 0;
    double phi = decay;
    const int count = std::max(f.decays.count, f.rises.count);
    double here = f.decays[0], next = f.decays[1], slopeHere = next - here + f.rises[0];
    for (int m = 0; m < count; ++m) {
        const double afterNext = f.decays[m + 2];
        const double slopeNext = afterNext - next + f.rises[m + 1];
        value += here * phi;
        size += std::abs(here) * phi;
        slope += slopeHere * phi;
        const double curvature = slopeNext - slopeHere;
        bend += curvature * phi;
        if (curvature < 0) leastBend += curvature * (y >= m ? phi : peaks[m]);
        phi *= y / (m + 1);
        here = next;
        next = afterNext;
        slopeHere = slopeNext;
    }
    if (f.rises.count) {
        value += f.rises.rises(y, decay);
        size += f.rises.magnitude() * std::min(y, 1.0);
    }
    s.value += value;
    s.slope += rate * slope;
    s.curvature += rate * rate * bend;
    s.leastCurvature += rate * rate * leastBend;
    s.size += size * (1 + y);
    s.fastest = std::max(s.fastest, rate);
}

void add(const HammerTerms& f, double x, Sample& s) {
    constexpr double pi = HammerTerms::pi;
    if (f.hasSine()) {
        const double sine = std::sin(pi * x), cosine = std::cos(pi * x);
        const double value = f.sine * sine + f.cosine * cosine;
        s.value += value;
        s.slope += pi * (f.sine * cosine - f.cosine * sine);
        s.curvature -= pi * pi * value;
        s.leastCurvature -= pi * pi * std::hypot(f.sine, f.cosine);
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

Sample sample(const ExponentialSum& f, double c2, double x) {
    Sample s;
    s.value = f.c0 + x * (f.c1 + x * c2);
    s.slope = f.c1 + 2 * c2 * x;
    s.curvature = s.leastCurvature = 2 * c2;
    s.size = std::abs(f.c0) + std::abs(f.c1) * x + std::abs(c2) * x * x;
    if (!f.primary.isZero()) add(f.primary, f.rates->primary, x, s);
    if (!f.elastic.isZero()) add(f.elastic, f.rates->elastic, x, s);
    if (f.hammer.present) add(f.hammer, x, s);
    return s;
}

/// An upper bound of |f'''|, x ≥ 0.
double mostThirdDerivative(const ExponentialSum& f) {
    constexpr double pi = HammerTerms::pi;
    const auto of = [](const RateTerms& terms, double rate) {  // differences of third and second order
        return (8 * terms.decays.magnitude() + 4 * terms.rises.magnitude()) * rate * rate * rate;
    };
    double most = f.hammer.amplitude() * pi * pi * pi + std::abs(f.hammer.decay);
    if (!f.primary.isZero()) most += of(f.primary, f.rates->primary);
    if (!f.elastic.isZero()) most += of(f.elastic, f.rates->elastic);
    return most;
}

/// The largest step from s that passes no zero.
double safeStep(const Sample& s) {
    if (s.leastCurvature >= 0)
        return s.slope >= 0 ? std::numeric_limits<double>::infinity() : s.value / -s.slope;
    const double root = std::sqrt(s.slope * s.slope - 2 * s.leastCurvature * s.value);
    return s.slope > 0 ? (s.slope + root) / -s.leastCurvature : 2 * s.value / (root - s.slope);
}

double halleyStep(const Sample& s) {
    return -2 * s.value * s.slope / (2 * s.slope * s.slope - s.value * s.curvature);
}

bool isNear(const Sample& s, double step) {
    return s.slope < 0 && step > 0 && step * s.fastest < nearInDecays &&
           step * std::abs(s.curvature) < -nearInBend * s.slope;
}

/// Halley's method from x, where f is still positive, to the zero expected a `step` further. A step back
/// before x, or far beyond, finds no zero or a later one: the function turns within rounding.
Zero<double> closeIn(const ExponentialSum& f, double c2, double x, double step, const Sample& near,
                     long& samples) {
    const double first = x, latest = x + 2 * step;
    Sample s = near;
    for (int i = 0; i < mostSteps; ++i) {
        x += step;
        if (!(x >= first && x <= latest)) break;
        const double quickest = std::max(s.fastest, std::abs(s.curvature / s.slope));
        if (std::abs(step) * quickest < lastHalleyStep)
            return x <= f.length ? Zero<double>::at(x) : Zero<double>{};
        s = sample(f, c2, x);
        ++samples;
        step = halleyStep(s);
    }
    return {.found = false, .undecided = true, .u = x};
}

/// How a function goes on that is zero within rounding.
enum class Onward { down, up, tangentUp, unknown };

Onward onwardFromZero(const ExponentialSum& f, double c2, const Sample& s) {
    if (std::abs(s.slope) > 16 * epsilon * (std::abs(f.c1) + s.size * s.fastest))
        return s.slope < 0 ? Onward::down : Onward::up;
    if (std::abs(s.curvature) > 64 * epsilon * (std::abs(c2) + s.size * s.fastest * s.fastest))
        return s.curvature < 0 ? Onward::down : Onward::tangentUp;
    return Onward::unknown;
}

/// An upper bound of |f| from x on, for sums that die away.
double mostFrom(const ExponentialSum& f, double x) {
    const auto of = [x](const Coefficients& terms, double rate) {
        const double y = rate * x;
        double sum = 0, phi = std::exp(-y);
        for (int m = 0; m < terms.count; ++m) {
            sum += std::abs(terms.c[m]) * (y >= m ? phi : peaks[m]);
            phi *= y / (m + 1);
        }
        return sum;
    };
    double most = std::abs(f.hammer.decay) * std::exp(-x);
    if (f.primary.decays.count) most += of(f.primary.decays, f.rates->primary);
    if (f.elastic.decays.count) most += of(f.elastic.decays, f.rates->elastic);
    return most;
}

bool diesAway(const ExponentialSum& f, double c2) {
    return f.c0 == 0 && f.c1 == 0 && c2 == 0 && f.primary.rises.count == 0 && f.elastic.rises.count == 0 &&
           !f.hammer.hasSine();
}

/// The only family of a function that is e^{−y} times a polynomial; nullptr where there is more in it.
const Coefficients* onlyDecay(const ExponentialSum& f, double& rate) {
    if (f.hammer.present) return nullptr;
    if (f.elastic.isZero()) {
        rate = f.rates->primary;
        return &f.primary.decays;
    }
    rate = f.rates->elastic;
    return f.primary.isZero() ? &f.elastic.decays : nullptr;
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

}  // namespace

Zero<double> firstZero(const ExponentialSum& f, double c2, const Search& search, SearchCount& tally) {
    if (f.c0 >= 0 && f.c1 >= 0 && c2 >= 0 && f.primary.allAtLeastZero() && f.elastic.allAtLeastZero() &&
        !f.hammer.present)
        return {};
    const double end = f.length;
    double x = search.start;
    Sample s = sample(f, c2, x);
    ++tally.searches;
    ++tally.samples;
    if (search.startsAtZero || std::abs(s.value) <= s.noise()) {
        switch (onwardFromZero(f, c2, s)) {
            case Onward::down:
                return Zero<double>::at(x);
            case Onward::up:
                s.value = 0;
                break;
            case Onward::tangentUp: {
                // f ≥ curvature h²/2 − third h³/6 is at least half of the first of these until here
                const double third = mostThirdDerivative(f);
                if (!(x + 1.5 * s.curvature / third <= end)) return {};
                x += 1.5 * s.curvature / third;
                s = sample(f, c2, x);
                if (s.value <= s.noise()) return {.found = false, .undecided = true, .u = x};
                break;
            }
            case Onward::unknown:
                return {.found = false, .undecided = true, .u = x};
        }
    } else if (s.value < 0) {
        return Zero<double>::at(x);
    } else if (x == 0 && diesAway(f, c2)) {
        double rate = 0;
        const Coefficients* only = onlyDecay(f, rate);
        if (only && only->count <= 3) return firstZeroOfShortDecay(*only, rate, end);
    }
    for (int step = 0; step < mostSteps; ++step) {
        const double safe = safeStep(s);
        if (!(x + safe <= end)) return {};
        const double halley = halleyStep(s);
        if (isNear(s, halley)) return closeIn(f, c2, x, halley, s, tally.samples);
        x += std::max(safe, 4 * epsilon * x);
        s = sample(f, c2, x);
        ++tally.samples;
        if (s.size <= search.negligible && diesAway(f, c2) && mostFrom(f, x) <= search.negligible) return {};
        if (s.value <= s.noise()) return Zero<double>::at(x);
    }
    return {.found = false, .undecided = true, .u = x};
}

}  // namespace drillwave
