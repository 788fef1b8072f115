// SPDX-License-Identifier: GPL-3.0-or-later
// Roots and minima of functions of one variable, by Brent's methods. Boost.Math has equally good roots. Its
// minima are accurate to 4e-8 only, those here to 1e-9, and its headers take 140 MB.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace drillwave {

/// Returns the x between `a` and `b` at which f changes sign, to the last digits of x, also at a jump.
/// Requires f(a) = `fa` and f(b) = `fb`, not both positive and not both negative. Uses inverse quadratic
/// interpolation, secants and bisection (R. P. Brent, Algorithms for Minimization without Derivatives, 1973,
/// chapter 4).
template <class Function>
double brentRoot(const Function& f, double a, double fa, double b, double fb) {
    assert(!(fa > 0 && fb > 0) && !(fa < 0 && fb < 0));
    double c = a, fc = fa, d = b - a, e = d;
    for (int i = 0; i < 200; ++i) {
        if ((fb > 0) == (fc > 0)) {
            c = a;
            fc = fa;
            d = e = b - a;
        }
        if (std::abs(fc) < std::abs(fb)) {
            a = std::exchange(b, c);
            c = a;
            fa = std::exchange(fb, fc);
            fc = fa;
        }
        const double tolerance = 2 * std::numeric_limits<double>::epsilon() * std::abs(b) +
                                 std::numeric_limits<double>::denorm_min();
        const double half = (c - b) / 2;
        if (std::abs(half) <= tolerance || fb == 0) return b;
        const double previous = e;
        e = d;
        d = half;
        if (std::abs(previous) >= tolerance && std::abs(fa) > std::abs(fb)) {
            const double s = fb / fa, q = fa / fc, r = fb / fc;
            double p = a == c ? 2 * half * s : s * (2 * half * q * (q - r) - (b - a) * (r - 1));
            double denominator = a == c ? 1 - s : (q - 1) * (r - 1) * (s - 1);
            if (p > 0)
                denominator = -denominator;
            else
                p = -p;
            if (2 * p < std::min(3 * half * denominator - std::abs(tolerance * denominator),
                                 std::abs(previous * denominator)))
                d = p / denominator;
        }
        if (d == half) e = half;
        a = b;
        fa = fb;
        b += std::abs(d) > tolerance ? d : std::copysign(tolerance, half);
        fb = f(b);
    }
    return b;
}

/// Local minimum of a function f: its position x, and the value f(x).
struct Minimum {
    double x;
    double value;
};

/// Returns a local minimum of f between `a` and `b`, by parabolas and golden sections (Brent, chapter 5). The
/// relative error of x is about the square root of that of f. It is at best `tolerance`, relative to the
/// larger of |a| and |b|.
template <class Function>
Minimum brentMinimum(const Function& f, double a, double b, double tolerance = 1e-9) {
    constexpr double golden = 2 - std::numbers::phi;
    const double least = tolerance * std::max(std::abs(a), std::abs(b));
    double x = a + golden * (b - a), w = x, v = x;
    double fx = f(x), fw = fx, fv = fx, step = 0, previous = 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = (a + b) / 2;
        if (std::abs(x - middle) <= 2 * least - (b - a) / 2) break;
        bool parabola = false;
        if (std::abs(previous) > least) {
            const double r = (x - w) * (fx - fv);
            double q = (x - v) * (fx - fw);
            double p = (x - v) * q - (x - w) * r;
            q = 2 * (q - r);
            if (q > 0)
                p = -p;
            else
                q = -q;
            if (std::abs(p) < std::abs(q * previous / 2) && p > q * (a - x) && p < q * (b - x)) {
                previous = std::exchange(step, p / q);
                const double u = x + step;
                if (u - a < 2 * least || b - u < 2 * least) step = std::copysign(least, middle - x);
                parabola = true;
            }
        }
        if (!parabola) {
            previous = x < middle ? b - x : a - x;
            step = golden * previous;
        }
        const double u = x + (std::abs(step) >= least ? step : std::copysign(least, step));
        const double fu = f(u);
        if (fu <= fx) {
            (u < x ? b : a) = x;
            v = std::exchange(w, x);
            fv = std::exchange(fw, fx);
            x = u;
            fx = fu;
        } else {
            (u < x ? a : b) = u;
            if (fu <= fw || w == x) {
                v = std::exchange(w, u);
                fv = std::exchange(fw, fu);
            } else if (fu <= fv || v == x || v == w) {
                v = u;
                fv = fu;
            }
        }
    }
    return {x, fx};
}

}  // namespace drillwave
