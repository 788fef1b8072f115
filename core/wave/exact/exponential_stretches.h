// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of exponential sums to power series on short stretches, for histories, products and extremes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numeric/power_series.h"
#include "core/wave/exact/exponential_sum.h"

namespace drillwave {

/// Conversion of `count` exponential sums to power series. The interval [0, length] is divided into
/// stretches; on each, every sum becomes one power series. A stretch is at most 2/λ long, where λ is the
/// fastest rate of terms that are still above `negligible`. About 20 stretches follow one decay e^(−λx) to
/// its end. All sums must have the same rates.
template <int lines, std::size_t count>
class ExponentialStretches {
  public:
    /// Prepares the division of [0, length] (in t0) for the given exponential sums. Terms below `negligible`
    /// [F0] are dropped.
    ExponentialStretches(const std::array<const ExponentialSum<lines>*, count>& functions, double length,
                         double negligible)
        : m_length(length), m_negligible(negligible) {
        for (std::size_t i = 0; i < count; ++i) m_rest[i] = *functions[i];
        for (ExponentialSum<lines>& rest : m_rest) {
            rest.shorten(length);
            rest.trim(m_negligible);
        }
    }

    /// Calls visit(start, series) for each stretch in order. `start` is the start of the stretch in t0, and
    /// series[i] is function number i on this stretch.
    template <class Visit>
    void forEach(Visit visit) {
        double start = 0;
        while (start < m_length) {
            const double left = m_length - start;
            const double fastest = fastestDecay();
            const bool isLast = fastest * left <= 2;
            const double length = isLast ? left : 2 / fastest;
            std::array<PowerSeries<double>, count> series;
            for (std::size_t i = 0; i < count; ++i) series[i] = seriesOf(m_rest[i], length);
            visit(start, series);
            if (isLast) return;
            start += length;
            for (ExponentialSum<lines>& rest : m_rest) {
                rest.dropFront(length);
                rest.trim(m_negligible);
            }
        }
    }

  private:
    double fastestDecay() const {
        double fastest = 0;
        for (const ExponentialSum<lines>& f : m_rest) {
            eachLine<lines>([&](int i) {
                if (f.hasLine(i)) fastest = std::max(fastest, (*f.rates)[i]);
            });
            if (!f.hasHammer()) continue;
            if (f.curve.hammer.decay != 0) fastest = std::max(fastest, 1.0);
            if (f.curve.hammer.hasSine()) fastest = std::max(fastest, rateOfSine);
        }
        return fastest;
    }

    using Series = std::array<double, PowerSeries<double>::capacity>;

    /// Returns the power series in u of Σ c_m φ_m(y), φ_m(y) = e^(−y) y^m/m!, with y = reach·u. The
    /// coefficient of u^j is reach^j Σ_m c_m/m! (−1)^(j−m)/(j−m)!.
    static Series seriesOf(const Coefficients& terms, double reach) {
        static constexpr Series decay = [] {  // of e^{−y}
            Series c{};
            c[0] = 1;
            for (std::size_t j = 1; j < c.size(); ++j) c[j] = -c[j - 1] / double(j);
            return c;
        }();
        std::array<double, Coefficients::capacity> amplitudes;  // c_m/m!
        double factorial = 1;
        for (int m = 0; m < terms.count; ++m) {
            amplitudes[m] = terms.c[m] / factorial;
            factorial *= m + 1;
        }
        // all sums at once, each in the order of its terms
        Series series{};
        for (int m = 0; m < terms.count; ++m)
            for (int j = m; j < PowerSeries<double>::capacity; ++j) series[j] += amplitudes[m] * decay[j - m];
        double power = 1;
        for (double& coefficient : series) {
            coefficient *= power;
            power *= reach;
        }
        return series;
    }

    static void makeFull(PowerSeries<double>& f) {
        std::fill(f.c.begin() + f.count, f.c.end(), 0.0);
        f.count = PowerSeries<double>::capacity;
    }

    /// Adds Σ c_m φ_m(y) with y = reach·u to the power series f(u), where φ_m(y) = e^(−y) y^m/m! (decays).
    static void addDecays(const Coefficients& terms, double reach, PowerSeries<double>& f) {
        if (terms.count == 0) return;
        makeFull(f);
        const Series decays = seriesOf(terms, reach);
        for (int j = 0; j < f.count; ++j) f.c[j] += decays[j];
    }
    /// Adds Σ c_m ω_m(y) with y = reach·u to the power series f(u), where ω_m(y) = ∫0..y e^(−z) z^m/m! dz
    /// (rises).
    static void addRises(const Coefficients& terms, double reach, PowerSeries<double>& f) {
        if (terms.count == 0) return;
        makeFull(f);
        const Series slopes = seriesOf(terms, reach);
        for (int j = 1; j < f.count; ++j) f.c[j] += reach * slopes[j - 1] / j;
    }

    /// Adds s sin πx + k cos πx + d e^(−x) with x = length·u to the power series f(u).
    static void add(const HammerTerms& terms, double length, PowerSeries<double>& f) {
        const double reach = HammerTerms::pi * length;
        double turn = 1, decay = terms.decay;
        makeFull(f);
        for (int j = 0; j < PowerSeries<double>::capacity; ++j) {
            const double wave = j % 2 == 0 ? terms.cosine : terms.sine;
            f.c[j] += decay + (j % 4 < 2 ? wave : -wave) * turn;
            turn *= reach / (j + 1);
            decay *= -length / (j + 1);
        }
    }

    PowerSeries<double> seriesOf(const ExponentialSum<lines>& f, double length) const {
        auto series = PowerSeries<double>::zero(length);
        series.count = 2;
        series.c[0] = f.c0;
        series.c[1] = f.isCurved ? f.curve.c1 * length : 0;
        eachLine<lines>([&](int i) {
            if (f.hasLine(i)) addDecays(f.decays[i], (*f.rates)[i] * length, series);
        });
        if (f.isCurved) {
            eachLine<lines>([&](int i) {
                if (f.hasLine(i)) addRises(f.curve.rises[i], (*f.rates)[i] * length, series);
            });
            if (f.curve.hammer.present) add(f.curve.hammer, length, series);
        }
        series.trim(m_negligible);
        return series;
    }

    /// Rate [1/t0] that stands for sin πx and cos πx when the length of a stretch is chosen. It makes a
    /// stretch at most 0.5 t0 long, half of a half sine, as in SeriesBasis.
    static constexpr double rateOfSine = 4;

    double m_length, m_negligible;
    std::array<ExponentialSum<lines>, count> m_rest;
};

}  // namespace drillwave
